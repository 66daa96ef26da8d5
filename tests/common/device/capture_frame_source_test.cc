#include "device/capture_frame_source.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

namespace geon::device {
namespace {

using SourceKind = CaptureFrameSource::Kind;

// Three small pictures of levels 50, 100, 150.
class CaptureFrameSourceTest : public testing::Test {
 protected:
  CaptureFrameSourceTest()
      : folder_(std::filesystem::path(testing::TempDir()) /
                ("geon_capture_frame_source_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    for (int i = 0; i < 3; ++i) {
      cv::imwrite((folder_ / ("f_0000" + std::to_string(i) + ".png")).string(),
                  cv::Mat(6, 8, CV_8UC3, cv::Scalar::all(50.0 * (i + 1))));
    }
    options_.width_px = 8;
    options_.height_px = 6;
    options_.file_rate_hz = 200.0;
  }
  ~CaptureFrameSourceTest() override { std::filesystem::remove_all(folder_); }
  std::string Pictures() const { return (folder_ / "f_%05d.png").string(); }

  // Polls until a frame or an error has come; virtual time, so that nothing times out.
  static Result<std::optional<sensor::Image>> PollUntilSomething(CaptureFrameSource* source) {
    for (int i = 0; i < 200; ++i) {
      auto frame = source->Poll(1.0);
      if (!frame.ok() || frame->has_value()) return frame;
      pollfd fd{source->file_descriptor(), POLLIN, 0};
      poll(&fd, 1, 100);
    }
    return Status::Error("nothing came");
  }

  std::filesystem::path folder_;
  FrameSourceOptions options_;
};

TEST_F(CaptureFrameSourceTest, OnlyACameraChangesItsExposure) {
  CaptureFrameSource pictures(SourceKind::kImages, Pictures(), options_);
  EXPECT_NE(pictures.SetExposure(0.01).message().find("keep their exposure"), std::string::npos);
  EXPECT_FALSE(PollUntilSomething(&pictures).value()->exposure_s.has_value());
  CaptureFrameSource camera(SourceKind::kV4l2, "/dev/there-is-no-camera", options_);
  EXPECT_TRUE(camera.SetExposure(0.01).ok()) << "it may come";
}

TEST_F(CaptureFrameSourceTest, DeliversPicturesAgainAndAgain) {
  CaptureFrameSource source(SourceKind::kImages, Pictures(), options_);
  int32_t last_seq = 0;
  for (int i = 0; i < 8; ++i) {
    const auto frame = PollUntilSomething(&source);
    ASSERT_TRUE(frame.ok()) << frame.message();
    EXPECT_EQ((*frame)->width_px, 8);
    EXPECT_EQ((*frame)->row_stride_bytes, 24);
    EXPECT_EQ((*frame)->data[0] % 50, 0);
    EXPECT_GT((*frame)->seq, last_seq);
    last_seq = (*frame)->seq;
  }
  EXPECT_GE(last_seq, 8);  // more than the three there are
}

TEST_F(CaptureFrameSourceTest, ColourBecomesGreyWhereGreyIsWanted) {
  options_.format = sensor::PixelFormat::kGray8;
  CaptureFrameSource source(SourceKind::kImages, Pictures(), options_);
  const auto frame = PollUntilSomething(&source);
  ASSERT_TRUE(frame.ok()) << frame.message();
  EXPECT_EQ((*frame)->format, sensor::PixelFormat::kGray8);
  EXPECT_EQ((*frame)->data.size(), 48u);
}

TEST_F(CaptureFrameSourceTest, FramesOfAnotherSizeAreAnError) {
  options_.width_px = 9;
  CaptureFrameSource source(SourceKind::kImages, Pictures(), options_);
  const auto frame = PollUntilSomething(&source);
  ASSERT_FALSE(frame.ok());
  EXPECT_NE(frame.message().find("8x6, not 9x6"), std::string::npos) << frame.message();
}

TEST_F(CaptureFrameSourceTest, WhatDoesNotOpenIsTriedAgainWithBackOff) {
  CaptureFrameSource source(SourceKind::kImages, (folder_ / "none_%05d.png").string(), options_);
  ASSERT_FALSE(PollUntilSomething(&source).ok());
  const auto waiting = source.Poll(1.1);  // before the retry is due
  EXPECT_NE(waiting.message().find("does not open"), std::string::npos) << waiting.message();
  EXPECT_TRUE(source.Poll(1.3).ok());  // being opened
  EXPECT_EQ(source.reconnects(), 0);
}

TEST_F(CaptureFrameSourceTest, ASourceThatFallsSilentIsReopened) {
  options_.file_rate_hz = 20.0;
  CaptureFrameSource source(SourceKind::kImages, Pictures(), options_);
  ASSERT_TRUE(PollUntilSomething(&source).ok());
  Result<std::optional<sensor::Image>> frame = source.Poll(100.0);
  for (int i = 0; i < 50 && frame.ok() && frame->has_value(); ++i) frame = source.Poll(200.0 + i);
  EXPECT_FALSE(frame.ok());  // nothing came since: time is virtual and far on
  options_.first_retry_s = 0.0;
  for (int i = 0; i < 100 && (!frame.ok() || !frame->has_value()); ++i) {
    frame = source.Poll(300.0);
    pollfd fd{source.file_descriptor(), POLLIN, 0};
    if (frame.ok() && !frame->has_value()) poll(&fd, 1, 100);
  }
  ASSERT_TRUE(frame.ok()) << frame.message();
  EXPECT_EQ(source.reconnects(), 1);
}

}  // namespace
}  // namespace geon::device
