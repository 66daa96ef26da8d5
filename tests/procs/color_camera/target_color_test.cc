#include "procs/color_camera/target_color.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "attention/color_model_text.h"

namespace geon::color_camera {
namespace {

Status ReadFrom(const std::string& yaml, attention::ColorModel* color) {
  auto document = config::YamlDocument::Parse(yaml, "robot.yaml");
  const auto folder = std::filesystem::path(testing::TempDir());
  ReadTargetColor(document->root(), folder / "robot.yaml", color);
  return document->Finish();
}

TEST(TargetColor, ANameOrAFileBesideTheRobotFile) {
  attention::ColorModel color;
  EXPECT_TRUE(ReadFrom("target_color: super-red\n", &color).ok());
  EXPECT_EQ(color.name, "super-red");
  const auto file = std::filesystem::path(testing::TempDir()) / "geon_target_color_test.txt";
  std::ofstream(file) << attention::SerializeColorModel(*attention::NamedColorModel("thesis-lab"),
                                                        {});
  EXPECT_TRUE(ReadFrom("target_color: geon_target_color_test.txt\n", &color).ok());
  EXPECT_EQ(color.name, "thesis-lab");
  std::filesystem::remove(file);
}

TEST(TargetColor, AnotherTextIsRefusedByName) {
  attention::ColorModel color;
  const Status status = ReadFrom("target_color: no-such-colour\n", &color);
  EXPECT_NE(status.message().find("robot.yaml:1"), std::string::npos) << status.message();
  EXPECT_NE(status.message().find("no-such-colour"), std::string::npos) << status.message();
}

}  // namespace
}  // namespace geon::color_camera
