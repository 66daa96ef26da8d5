#include "attention/choose_target.h"

#include <gtest/gtest.h>

namespace geon::attention {
namespace {

constexpr int kWidth_px = 640, kHeight_px = 480;

Blob BlobOf(const sensor::PixelBox& box, double fill_1) {
  return {box, static_cast<int>(fill_1 * box.w_px * box.h_px), {}};
}

double Score(const Blob& blob) { return GeonScore(blob, kWidth_px, kHeight_px, {}); }

std::optional<size_t> Choose(const std::vector<Blob>& blobs, int min_pixels = 60) {
  return ChooseTarget(blobs, kWidth_px, kHeight_px, min_pixels, {});
}

TEST(ChooseTargetTest, OfTwoGeonsTheLargerIsChosen) {
  const Blob small = BlobOf({100, 100, 30, 40}, 0.9), large = BlobOf({300, 100, 40, 40}, 0.8);
  EXPECT_EQ(Choose({small, large}), 1U);
  EXPECT_EQ(Choose({large, small}), 0U);
  EXPECT_EQ(Choose({large, large}), 0U) << "of equal ones the first";
}

TEST(ChooseTargetTest, ShapesThatGeonsShowCountInFull) {
  for (const Blob& geon : {BlobOf({100, 100, 60, 60}, 1.0), BlobOf({100, 100, 60, 60}, 0.45),
                           BlobOf({100, 100, 20, 90}, 0.9), BlobOf({100, 100, 90, 20}, 0.9)}) {
    EXPECT_EQ(Score(geon), geon.pixels);
  }
}

TEST(ChooseTargetTest, LineOnTheFloorAndDoorFrameGiveWayToASmallerGeon) {
  const Blob geon = BlobOf({300, 200, 40, 40}, 0.9);
  const Blob line = BlobOf({50, 400, 500, 20}, 0.8);    // four times the pixels
  const Blob frame = BlobOf({10, 10, 200, 300}, 0.08);  // three times the pixels
  EXPECT_EQ(Choose({line, frame, geon}), 2U);
}

TEST(ChooseTargetTest, BlobThatLeavesTheImageGivesWayToAWholeOneOfSixTenthsItsSize) {
  const Blob whole = BlobOf({300, 200, 60, 60}, 0.9);
  for (const sensor::PixelBox& box : {sensor::PixelBox{0, 200, 60, 100},
                                      {580, 200, 60, 100},
                                      {300, 0, 60, 100},
                                      {300, 380, 60, 100}}) {
    EXPECT_EQ(Choose({BlobOf(box, 0.9), whole}), 1U);
  }
  EXPECT_EQ(Choose({BlobOf({0, 200, 60, 100}, 0.9)}), 0U) << "alone it is the target all the same";
}

TEST(ChooseTargetTest, NothingLargeEnoughIsNothing) {
  EXPECT_FALSE(Choose({}).has_value());
  EXPECT_FALSE(Choose({BlobOf({10, 10, 7, 7}, 1.0)}).has_value());
  EXPECT_EQ(Choose({BlobOf({10, 10, 7, 7}, 1.0)}, 49), 0U);
}

TEST(ChooseTargetTest, BadOptionsAreNamed) {
  ChoiceOptions options;
  EXPECT_FALSE(options.Validate().has_value());
  options.geon_fill_1 = 0.0;
  EXPECT_TRUE(options.Validate().has_value());
  options = {};
  options.geon_aspect_1 = 0.5;
  EXPECT_TRUE(options.Validate().has_value());
  options = {};
  options.cut_off_1 = 1.5;
  EXPECT_TRUE(options.Validate().has_value());
}

}  // namespace
}  // namespace geon::attention
