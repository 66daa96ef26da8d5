#include "procs/geon/experiment_objects.h"

#include <gtest/gtest.h>

#include "config/text_file.h"

namespace geon::cli {
namespace {

class ExperimentObjectsTest : public testing::Test {
 protected:
  ExperimentObjectsTest()
      : folder_(std::filesystem::path(testing::TempDir()) /
                testing::UnitTest::GetInstance()->current_test_info()->name()) {
    std::filesystem::create_directories(folder_);
  }
  ~ExperimentObjectsTest() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path Write(const std::string& name, const std::string& text) {
    EXPECT_TRUE(config::WriteFileAtomically(folder_ / name, text).ok());
    return folder_ / name;
  }
  const std::filesystem::path folder_;
};

TEST_F(ExperimentObjectsTest, ReadsObjectsAndTheirPositions) {
  const auto file =
      Write("objects.yaml",
            "objects:\n"
            "  - {name: post, geon: cylinder, size_m: [0.1, 0.1, 0.2], positions: [1, 2]}\n"
            "  - {name: hook, geon: bent_cuboid, size_m: [0.05, 0.06, 0.3], bend_deg: 90}\n");
  const auto shown = LoadShownObjects(file, evaluation::Family::kPolygon);
  ASSERT_TRUE(shown.ok()) << shown.message();
  ASSERT_EQ(shown->size(), 3U);
  EXPECT_EQ((*shown)[1].subject.object, "post");
  EXPECT_EQ((*shown)[1].subject.position, 2);
  EXPECT_NEAR(geons::Bounds((*shown)[1].mesh).sizes().z(), 0.1, 0.002);
  EXPECT_EQ((*shown)[2].subject.truth, GeonLabel::kBentCuboid);
}

TEST_F(ExperimentObjectsTest, RefusesImpossibleObjectsByLine) {
  const auto file =
      Write("objects.yaml",
            "objects:\n  - {name: a, geon: cuboid, size_m: [0.1, 0.1, 0.1], taper: 0.3}\n");
  const auto shown = LoadShownObjects(file, evaluation::Family::kPolygon);
  ASSERT_FALSE(shown.ok());
  EXPECT_NE(shown.message().find("objects.yaml:2"), std::string::npos) << shown.message();
}

TEST_F(ExperimentObjectsTest, ScalesMeshesToTheirLargestSide) {
  Write("labels.csv", "name,why,label\nwedge,\"thin, flat\",tapered_cuboid\n");
  Write("wedge.obj", "v 0 0 1\nv 4 0 1\nv 0 2 1\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const auto shown = LoadShownMeshes(folder_, 0.2);
  ASSERT_TRUE(shown.ok()) << shown.message();
  ASSERT_EQ(shown->size(), 1U);
  EXPECT_EQ((*shown)[0].subject.truth, GeonLabel::kTaperedCuboid);
  const Eigen::AlignedBox3d bounds = geons::Bounds((*shown)[0].mesh);
  EXPECT_NEAR(bounds.sizes().x(), 0.2, 1e-6);
  EXPECT_NEAR(bounds.sizes().z(), 0.05, 1e-6);
  EXPECT_NEAR(bounds.min().z(), 0.0, 1e-9);
}

TEST_F(ExperimentObjectsTest, RefusesUnknownLabelsByRow) {
  Write("labels.csv", "name,label\na,teapot\n");
  const auto shown = LoadShownMeshes(folder_, 0.2);
  ASSERT_FALSE(shown.ok());
  EXPECT_NE(shown.message().find("row 2"), std::string::npos);
}

TEST(ThesisShownObjects, AreSixty) {
  EXPECT_EQ(ThesisShownObjects(evaluation::Family::kPolygon).size(), 60U);
}

}  // namespace
}  // namespace geon::cli
