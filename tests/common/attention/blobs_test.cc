#include "attention/blobs.h"

#include <gtest/gtest.h>

namespace geon::attention {
namespace {

TEST(BlobsTest, BoxAreaCenterAndBottomAreThoseOfTheGroup) {
  BitMask mask(100, 20);
  mask.Set(3, 10, 20);
  mask.Set(4, 12, 14);
  mask.Set(5, 12, 13);  // two feet
  mask.Set(5, 14, 15);
  mask.Set(9, 70, 71);
  const PixelGroups groups = GroupPixels(mask);
  const std::vector<Blob> blobs = MeasureBlobs(groups);
  ASSERT_EQ(blobs.size(), 2U);
  EXPECT_EQ(blobs[0].box, (sensor::PixelBox{10, 3, 10, 3}));
  EXPECT_EQ(blobs[0].pixels, 14);
  EXPECT_DOUBLE_EQ(blobs[0].center_px.x(), (145.0 + 25.0 + 26.0) / 14.0);
  EXPECT_DOUBLE_EQ(blobs[0].center_px.y(), (30.0 + 8.0 + 10.0) / 14.0);
  EXPECT_EQ(BottomPoint(groups, 0), Eigen::Vector2d(13.0, 5.0));
  EXPECT_EQ(blobs[1].box, (sensor::PixelBox{70, 9, 1, 1}));
  EXPECT_EQ(BottomPoint(groups, 1), Eigen::Vector2d(70.0, 9.0));
}

}  // namespace
}  // namespace geon::attention
