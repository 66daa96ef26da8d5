#include "attention/find_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "base/contracts.h"
#include "tests/common/attention/naive_segmentation.h"

namespace geon::attention {
namespace {

using sensor::PixelBox;

// A grey picture to paint red boxes on.
class SegmentedPicture {
 public:
  SegmentedPicture(int width_px, int height_px,
                   sensor::PixelFormat format = sensor::PixelFormat::kBgr8) {
    image_.width_px = width_px;
    image_.height_px = height_px;
    image_.row_stride_bytes = 3 * width_px + 5;  // rows are padded
    image_.format = format;
    image_.data.assign(static_cast<size_t>(image_.row_stride_bytes * height_px), 90);
  }
  SegmentedPicture& Paint(const PixelBox& box, const Rgb& color) {
    for (int v = box.v_px; v < box.v_px + box.h_px; ++v) {
      for (int u = box.u_px; u < box.u_px + box.w_px; ++u) {
        uint8_t* pixel = &image_.data[static_cast<size_t>(v * image_.row_stride_bytes + 3 * u)];
        const bool rgb = image_.format == sensor::PixelFormat::kRgb8;
        pixel[rgb ? 0 : 2] = color.red;
        pixel[1] = color.green;
        pixel[rgb ? 2 : 0] = color.blue;
      }
    }
    return *this;
  }
  const sensor::Image& image() const { return image_; }

 private:
  sensor::Image image_;
};

constexpr Rgb kRed{160, 40, 40};

TargetSighting FindRed(const SegmentedPicture& picture, const AttentionOptions& options = {}) {
  return FindTarget(picture.image(), *NamedColorModel("super-red"), options);
}

TEST(FindTargetTest, BoxIsTheTargetsLessTheErodedRim) {
  const auto sighting = FindRed(SegmentedPicture(100, 80).Paint({20, 30, 22, 12}, kRed));
  ASSERT_TRUE(sighting.target);
  EXPECT_EQ(sighting.target->box, (PixelBox{21, 31, 20, 10}));
  EXPECT_EQ(sighting.target->pixels, 200);
  EXPECT_EQ(sighting.color_pixels, 22 * 12);
  EXPECT_NEAR(sighting.target->center_px.x(), 30.5, 1e-9);
  EXPECT_NEAR(sighting.target->center_px.y(), 35.5, 1e-9);
  EXPECT_NEAR(sighting.bottom_px.x(), 30.5, 1e-9);
  EXPECT_NEAR(sighting.bottom_px.y(), 40.0, 1e-9);
  EXPECT_FALSE(sighting.touched.any());
  EXPECT_EQ(std::count(sighting.mask.begin(), sighting.mask.end(), 255), 200);
  EXPECT_EQ(sighting.mask[35 * 100 + 30], 255);
}

TEST(FindTargetTest, ChannelOrderFollowsTheFormat) {
  EXPECT_TRUE(
      FindRed(SegmentedPicture(64, 64, sensor::PixelFormat::kRgb8).Paint({20, 20, 20, 20}, kRed))
          .target);
  EXPECT_FALSE(FindRed(SegmentedPicture(64, 64).Paint({20, 20, 20, 20}, {40, 40, 160})).target);
}

TEST(FindTargetTest, LargestBlobWinsAndAllAreListedBySize) {
  const auto sighting = FindRed(SegmentedPicture(200, 100)
                                    .Paint({10, 10, 20, 20}, kRed)
                                    .Paint({60, 10, 40, 40}, kRed)
                                    .Paint({150, 10, 10, 10}, kRed));
  ASSERT_EQ(sighting.blobs.size(), 3U);
  EXPECT_EQ(sighting.target->box, (PixelBox{61, 11, 38, 38}));
  EXPECT_EQ(sighting.blobs[1].pixels, 18 * 18);
  EXPECT_EQ(sighting.blobs[2].pixels, 8 * 8);
}

TEST(FindTargetTest, ChosenBlobComesFirstThoughALineOnTheFloorHasMorePixels) {
  const auto sighting = FindRed(
      SegmentedPicture(200, 100).Paint({10, 80, 180, 14}, kRed).Paint({60, 10, 34, 34}, kRed));
  ASSERT_EQ(sighting.blobs.size(), 2U);
  EXPECT_EQ(sighting.target->box, (PixelBox{61, 11, 32, 32}));
  EXPECT_EQ(sighting.blobs[0].pixels, 32 * 32);
  EXPECT_EQ(sighting.blobs[1].pixels, 178 * 12);
  EXPECT_EQ(sighting.mask[20 * 200 + 70], 255);
  EXPECT_EQ(sighting.mask[85 * 200 + 100], 0);
}

TEST(FindTargetTest, OnlyBlobsThatAreAcceptedMayBeTheTarget) {
  const SegmentedPicture picture = SegmentedPicture(200, 100)
                                       .Paint({10, 10, 20, 20}, kRed)
                                       .Paint({60, 10, 40, 40}, kRed)
                                       .Paint({150, 10, 10, 10}, kRed);
  AttentionOptions options;
  options.min_target_pixels = 50;
  const TargetFinder finder(*NamedColorModel("super-red"), options);
  const auto at = [](double u_px) {
    return [u_px](const Blob& blob) { return std::abs(blob.center_px.x() - u_px) < 20.0; };
  };
  for (const auto& [u_px, box] : std::vector<std::pair<double, PixelBox>>{
           {80.0, {61, 11, 38, 38}}, {20.0, {11, 11, 18, 18}}, {155.0, {151, 11, 8, 8}}}) {
    SCOPED_TRACE(u_px);
    const auto sighting = finder.Find(picture.image(), at(u_px));
    ASSERT_TRUE(sighting.target);
    EXPECT_EQ(sighting.target->box, box);
    ASSERT_EQ(sighting.blobs.size(), 3U) << "all are listed";
    EXPECT_EQ(sighting.blobs[0].box, box);
    EXPECT_GT(sighting.blobs[1].pixels, sighting.blobs[2].pixels);
    EXPECT_EQ(std::count(sighting.mask.begin(), sighting.mask.end(), 255), box.w_px * box.h_px);
    EXPECT_EQ(sighting.mask[static_cast<size_t>(200 * box.v_px + box.u_px)], 255);
  }
  const auto none = finder.Find(picture.image(), [](const Blob&) { return false; });
  EXPECT_FALSE(none.target);
  EXPECT_EQ(none.blobs.size(), 3U);
  EXPECT_EQ(finder.Find(picture.image()).target->box, (PixelBox{61, 11, 38, 38}));
}

TEST(FindTargetTest, SpecksAndLinesThinnerThanThreePixelsAreEroded) {
  const auto sighting =
      FindRed(SegmentedPicture(100, 100).Paint({10, 0, 2, 100}, kRed).Paint({50, 50, 2, 2}, kRed));
  EXPECT_EQ(sighting.color_pixels, 204);
  EXPECT_TRUE(sighting.blobs.empty());
  EXPECT_FALSE(sighting.target);
  EXPECT_EQ(std::count(sighting.mask.begin(), sighting.mask.end(), 0), 100 * 100);
}

TEST(FindTargetTest, FourNeighborErosionSparesPixelsWithOnlyDiagonalBackground) {
  AttentionOptions four;
  four.erosion_neighbors = 4;
  four.min_target_pixels = 1;
  AttentionOptions eight = four;
  eight.erosion_neighbors = 8;
  const SegmentedPicture hole =
      SegmentedPicture(50, 50).Paint({10, 10, 21, 21}, kRed).Paint({20, 20, 1, 1}, {});
  EXPECT_EQ(FindRed(hole, four).target->pixels, 19 * 19 - 5);
  EXPECT_EQ(FindRed(hole, eight).target->pixels, 19 * 19 - 9);
}

TEST(FindTargetTest, TargetThatLeavesTheImageTouchesItsEdges) {
  const auto sighting = FindRed(SegmentedPicture(100, 80).Paint({60, 40, 40, 40}, kRed));
  EXPECT_TRUE(sighting.touched.right);
  EXPECT_TRUE(sighting.touched.bottom);
  EXPECT_FALSE(sighting.touched.left);
  EXPECT_FALSE(sighting.touched.top);
  EXPECT_EQ(sighting.target->box, (PixelBox{61, 41, 39, 39}));
}

TEST(FindTargetTest, BlobSmallerThanAGeonIsNoTarget) {
  AttentionOptions options;
  options.min_target_pixels = 100;
  const SegmentedPicture picture = SegmentedPicture(100, 80).Paint({20, 30, 11, 11}, kRed);
  EXPECT_FALSE(FindRed(picture, options).target);
  EXPECT_EQ(FindRed(picture, options).blobs.size(), 1U);
  options.min_target_pixels = 81;
  EXPECT_TRUE(FindRed(picture, options).target);
}

TEST(FindTargetTest, ClippedPixelsAreCountedInsideTheBoxOnly) {
  const auto sighting = FindRed(SegmentedPicture(100, 80)
                                    .Paint({20, 30, 22, 12}, kRed)
                                    .Paint({25, 35, 4, 2}, {255, 250, 251})
                                    .Paint({80, 10, 5, 5}, {255, 255, 255}));
  EXPECT_EQ(sighting.clipped_pixels, 8);
}

TEST(FindTargetTest, RandomPicturesAreSegmentedAsPixelByPixel) {
  std::mt19937 random(5);
  int targets = 0;
  for (int k = 0; k < 60; ++k) {
    const int width = 1 + static_cast<int>(random() % 150);
    const int height = 1 + static_cast<int>(random() % 40);
    const ColorModel model = RandomModel(k % 2 == 0, random);
    AttentionOptions options;
    options.erosion_neighbors = k % 3 == 0 ? 4 : 8;
    options.min_target_pixels = 1;
    options.choice = {1e-9, 1e9, 1.0};  // whatever the shape: the largest
    const auto format = k % 2 == 0 ? sensor::PixelFormat::kRgb8 : sensor::PixelFormat::kBgr8;
    const sensor::Image image = RandomImage(width, height, format, random);
    NaiveSegmentation naive = SegmentNaively(image, model, options.erosion_neighbors);
    std::stable_sort(naive.blobs.begin(), naive.blobs.end(), [](const auto& a, const auto& b) {
      return a.pixels.size() > b.pixels.size();
    });
    const TargetSighting sighting = TargetFinder(model, options).Find(image);
    EXPECT_EQ(sighting.color_pixels, std::count(naive.target.begin(), naive.target.end(), true));
    ASSERT_EQ(sighting.blobs.size(), naive.blobs.size());
    ASSERT_EQ(sighting.target.has_value(), !naive.blobs.empty());
    std::vector<uint8_t> mask(static_cast<size_t>(width * height), 0);
    if (sighting.target) {
      ++targets;
      for (const auto& [u, v] : naive.blobs[0].pixels)
        mask[static_cast<size_t>(v * width + u)] = 255;
    }
    EXPECT_EQ(sighting.mask, mask) << k;
    for (size_t i = 0; i < naive.blobs.size(); ++i) {
      const auto& pixels = naive.blobs[i].pixels;
      EXPECT_EQ(sighting.blobs[i].pixels, static_cast<int>(pixels.size()));
      EXPECT_EQ(sighting.blobs[i].box.v_px, pixels.front().second);
      EXPECT_EQ(sighting.blobs[i].box.v_px + sighting.blobs[i].box.h_px - 1, pixels.back().second);
    }
  }
  EXPECT_GT(targets, 20);
}

TEST(FindTargetTest, BrokenContractsThrow) {
  SegmentedPicture picture(10, 10);
  AttentionOptions options;
  options.erosion_neighbors = 6;
  EXPECT_THROW(FindRed(picture, options), ContractViolation);
  sensor::Image short_of_data = picture.image();
  short_of_data.data.pop_back();
  EXPECT_THROW(FindTarget(short_of_data, *NamedColorModel("super-red")), ContractViolation);
  short_of_data.format = sensor::PixelFormat::kGray8;
  EXPECT_THROW(FindTarget(short_of_data, *NamedColorModel("super-red")), ContractViolation);
}

}  // namespace
}  // namespace geon::attention
