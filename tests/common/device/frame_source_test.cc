#include "device/frame_source.h"

#include <gtest/gtest.h>

#include "base/contracts.h"

namespace geon::device {
namespace {

Result<std::unique_ptr<FrameSource>> Open(const std::string& source) {
  FrameSourceOptions options;
  options.source = source;
  return OpenFrameSource(options);
}

TEST(FrameSource, EveryKindOpens) {
  for (const char* source :
       {"sim:ipc:///tmp/geon_frame_source_test", "v4l2:/dev/there-is-no-camera",
        "images:/tmp/none_%05d.png", "video:/tmp/none.avi", "gst:videotestsrc ! appsink"}) {
    const auto opened = Open(source);
    EXPECT_TRUE(opened.ok()) << opened.message();
    if (opened.ok()) {
      EXPECT_GE((*opened)->file_descriptor(), 0) << source;
    }
  }
}

TEST(FrameSource, WhatIsNoSourceIsRefusedWithAHint) {
  for (const char* source : {"", "sim", "sim:", "sim:/tmp/x", "webcam:0", "v4l2:", ":x"}) {
    const auto opened = Open(source);
    ASSERT_FALSE(opened.ok()) << source;
    EXPECT_NE(opened.message().find("v4l2:/dev/videoN"), std::string::npos);
  }
}

TEST(FrameSource, OnlyRawFormatsCanBeAskedFor) {
  FrameSourceOptions options;
  options.source = "sim:ipc:///tmp/geon_frame_source_test";
  options.format = sensor::PixelFormat::kPng;
  EXPECT_THROW((void)OpenFrameSource(options), ContractViolation);
}

}  // namespace
}  // namespace geon::device
