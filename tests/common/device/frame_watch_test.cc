#include "device/frame_watch.h"

#include <gtest/gtest.h>

#include "device/back_off.h"

namespace geon::device {
namespace {

TEST(FrameWatch, AStampMustGrow) {
  FrameWatch watch;
  EXPECT_TRUE(watch.IsFreshStamp(100));
  EXPECT_FALSE(watch.IsFreshStamp(100));
  EXPECT_FALSE(watch.IsFreshStamp(90));
  EXPECT_TRUE(watch.IsFreshStamp(101));
  watch.Reset();
  EXPECT_TRUE(watch.IsFreshStamp(5));
}

TEST(FrameWatch, ContentMustDiffer) {
  FrameWatch watch;
  EXPECT_TRUE(watch.IsFreshContent({1, 2, 3}));
  EXPECT_FALSE(watch.IsFreshContent({1, 2, 3}));
  EXPECT_TRUE(watch.IsFreshContent({1, 2, 4}));
}

TEST(BackOff, WaitsDoubleUpToTheLongest) {
  BackOff back_off(0.5, 1.5);
  EXPECT_TRUE(back_off.Due(0.0));
  back_off.Failed(10.0);
  EXPECT_FALSE(back_off.Due(10.4));
  EXPECT_TRUE(back_off.Due(10.5));
  back_off.Failed(10.5);
  EXPECT_FALSE(back_off.Due(11.4));
  back_off.Failed(11.5);
  EXPECT_FALSE(back_off.Due(12.9));
  EXPECT_TRUE(back_off.Due(13.0));
  back_off.Succeeded();
  back_off.Failed(20.0);
  EXPECT_TRUE(back_off.Due(20.5));
}

}  // namespace
}  // namespace geon::device
