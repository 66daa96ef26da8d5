#include "procs/geon/board_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "config/text_file.h"
#include "procs/geon/image_file.h"

namespace geon::cli {
namespace {

using rangefinder::LaserColor;
using sensor::Laser;
using testing::HasSubstr;

class RecordedBoardTest : public testing::Test {
 protected:
  void SetUp() override {
    dir_ = std::filesystem::temp_directory_path() /
           ("geon_board_frames_" + std::to_string(::getpid()));
    std::filesystem::create_directories(dir_);
    Picture("dark.png", 10);
    Picture("dim.png", 60);
    Picture("bright.png", 110);
  }
  void TearDown() override { std::filesystem::remove_all(dir_); }
  void Picture(const std::string& name, uint8_t level, int width_px = 8) {
    const std::vector<uint8_t> gray(static_cast<size_t>(width_px) * 6, level);
    ASSERT_TRUE(SaveGrayPng(dir_ / name, gray, width_px, 6).ok());
  }
  void List(const std::string& lines) {
    ASSERT_TRUE(
        config::WriteFileAtomically(dir_ / "frames.csv", "laser,distance_m,lit,unlit\n" + lines)
            .ok());
  }
  std::string Error(const std::string& lines) {
    List(lines);
    return RecordedBoard(dir_, Laser::kHorizontal, LaserColor::kMono).message();
  }
  std::filesystem::path dir_;
};

TEST_F(RecordedBoardTest, FramesOfOneDistanceComeTogetherNearestFirst) {
  List(
      "horizontal,0.9,dim.png,dark.png\n"
      "vertical,0.8,dim.png,dark.png\n"
      "horizontal,0.7,dim.png,dark.png\n"
      "horizontal,0.7,bright.png,dark.png\n");
  const auto series = RecordedBoard(dir_, Laser::kHorizontal, LaserColor::kMono);
  ASSERT_TRUE(series.ok()) << series.message();
  EXPECT_EQ(series->distances, 2);
  EXPECT_EQ(series->frames, 1) << "the fewest at a distance";
  const auto nearest = series->at(0);
  ASSERT_TRUE(nearest.ok()) << nearest.message();
  EXPECT_EQ(nearest->distance_m, 0.7);
  ASSERT_EQ(nearest->light.size(), 2U);
  EXPECT_EQ(nearest->light[0].data[0], 50) << "lit minus unlit";
  EXPECT_EQ(nearest->light[1].data[0], 100);
  EXPECT_EQ(series->at(1)->distance_m, 0.9);
}

TEST_F(RecordedBoardTest, BadListingsAreReportedByLine) {
  EXPECT_THAT(Error("diagonal,0.9,dim.png,\n"), HasSubstr("frames.csv:2: laser must be"));
  EXPECT_THAT(Error("horizontal,near,dim.png,\n"), HasSubstr("frames.csv:2: distance_m must be"));
  EXPECT_THAT(Error("horizontal,0.9,,\n"), HasSubstr("frames.csv:2: expected laser"));
  EXPECT_THAT(Error("horizontal,0.9,dim.png\n"), HasSubstr("frames.csv:2: expected laser"));
  EXPECT_THAT(Error("vertical,0.9,dim.png,\n"), HasSubstr("no frames of the horizontal laser"));
}

TEST_F(RecordedBoardTest, MissingAndMisfitFramesAreErrorsOfTheirDistance) {
  Picture("wide.png", 10, 9);
  List("horizontal,0.7,none.png,\nhorizontal,0.8,dim.png,wide.png\n");
  const auto series = RecordedBoard(dir_, Laser::kHorizontal, LaserColor::kMono);
  ASSERT_TRUE(series.ok());
  EXPECT_THAT(series->at(0).message(), HasSubstr("none.png"));
  EXPECT_THAT(series->at(1).message(), HasSubstr("differs in size from dim.png"));
}

}  // namespace
}  // namespace geon::cli
