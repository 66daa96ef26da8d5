#include "procs/geon/truth_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "config/text_file.h"

namespace geon::cli {
namespace {

std::filesystem::path Write(const std::string& text) {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / (std::string("geon_truth_") + info->name());
  EXPECT_TRUE(config::WriteFileAtomically(file, text).ok());
  return file;
}

TEST(TruthFile, TellsObjectsInTheFrameOfTheOdometry) {
  const auto truth = LoadTruth(Write(
      R"({"event":"start","format":"geon.truth.v1","robot":{"x_m":1,"y_m":2,"heading_rad":1.5707963267948966},)"
      R"("objects":[{"kind":"geon","label":"ellipsoid","x_m":1,"y_m":4},)"
      R"({"kind":"box","label":null,"x_m":0,"y_m":2}]})"
      "\n{\"event\":\"state\"}\n"));
  ASSERT_TRUE(truth.ok()) << truth.message();
  ASSERT_EQ(truth->objects.size(), 2U);
  EXPECT_EQ(truth->objects[0].label, GeonLabel::kEllipsoid);
  EXPECT_NEAR(truth->objects[0].x_m, 2.0, 1e-12);
  EXPECT_NEAR(truth->objects[0].y_m, 0.0, 1e-12);
  EXPECT_NEAR(truth->objects[1].y_m, 1.0, 1e-12);
  EXPECT_FALSE(truth->objects[1].label.has_value());
  EXPECT_EQ(truth->LabelNear(0, 1), GeonLabel::kEllipsoid);
}

TEST(TruthFile, RefusesWhatIsNone) {
  EXPECT_THAT(LoadTruth(Write("{\"event\":\"stop\"}\n")).message(),
              testing::HasSubstr("no truth file"));
  EXPECT_FALSE(LoadTruth("/no/such/truth").ok());
}

}  // namespace
}  // namespace geon::cli
