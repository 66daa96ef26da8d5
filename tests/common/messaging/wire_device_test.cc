// Conversions of images, stripes, head and lasers (messaging/wire.h).
#include <gtest/gtest.h>

#include "base/contracts.h"
#include "messaging/codec.h"
#include "messaging/wire.h"
#include "tests/common/messaging/sample_messages.h"

namespace geon::messaging {
namespace {

TEST(WireDevice, ImageSurvivesTheRoundTrip) {
  const sensor::Image sent = samples::GreyImage(5, 3);
  const Result<sensor::Image> got = Decode<sensor::Image>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_EQ(got->utime, sent.utime);
  EXPECT_EQ(got->seq, sent.seq);
  EXPECT_EQ(got->width_px, 5);
  EXPECT_EQ(got->height_px, 3);
  EXPECT_EQ(got->row_stride_bytes, 5);
  EXPECT_EQ(got->format, sensor::PixelFormat::kGray8);
  EXPECT_EQ(got->data, sent.data);
}

TEST(WireDevice, AnImageCarriesItsExposureAsANote) {
  sensor::Image image = samples::GreyImage(5, 3);
  EXPECT_EQ(ToWire(image).nmetadata, 0);
  image.exposure_s = 0.0125;
  geon::image_t wire = ToWire(image);
  ASSERT_EQ(wire.nmetadata, 1);
  EXPECT_EQ(wire.metadata[0].key, "exposure_us");
  EXPECT_EQ(std::string(wire.metadata[0].value.begin(), wire.metadata[0].value.end()), "12500");
  const auto got = Decode<sensor::Image>(Encode(image));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_DOUBLE_EQ(got->exposure_s.value(), 0.0125);

  for (const std::string text : {"", "-5", "0", "12500 us", "99999999999"}) {
    wire.metadata[0].value.assign(text.begin(), text.end());
    EXPECT_FALSE(FromWire(wire).ok()) << text;
  }
  wire.metadata[0].key = "camera";  // other notes are left alone
  EXPECT_TRUE(FromWire(wire).ok());
}

TEST(WireDevice, EveryPixelFormatSurvives) {
  using sensor::PixelFormat;
  for (const PixelFormat format : {PixelFormat::kJpeg, PixelFormat::kPng}) {
    const auto got = Decode<sensor::Image>(Encode(samples::CompressedImage(format)));
    ASSERT_TRUE(got.ok()) << got.message();
    EXPECT_EQ(got->format, format);
  }
  for (const PixelFormat format : {PixelFormat::kBgr8, PixelFormat::kRgb8}) {
    sensor::Image image = samples::GreyImage(6, 2);
    image.width_px = 2;
    image.format = format;
    const auto got = Decode<sensor::Image>(Encode(image));
    ASSERT_TRUE(got.ok()) << got.message();
    EXPECT_EQ(got->format, format);
  }
}

TEST(WireDevice, AnImageWhoseBytesDoNotMatchItsSizeIsNotSent) {
  sensor::Image image = samples::GreyImage(5, 3);
  image.data.pop_back();
  EXPECT_THROW(Encode(image), ContractViolation);
  image = samples::GreyImage(5, 3);
  image.row_stride_bytes = 4;
  EXPECT_THROW(Encode(image), ContractViolation);
}

TEST(WireDevice, AnImageWhoseBytesDoNotMatchItsSizeIsRefused) {
  geon::image_t wire = ToWire(samples::GreyImage(5, 3));
  wire.height = 4;
  EXPECT_FALSE(FromWire(wire).ok());
  wire = ToWire(samples::GreyImage(5, 3));
  wire.row_stride = 1 << 30;
  wire.height = 16;
  EXPECT_FALSE(FromWire(wire).ok());
  wire = ToWire(samples::GreyImage(5, 3));
  wire.width = -5;
  EXPECT_FALSE(FromWire(wire).ok());
  wire = ToWire(samples::GreyImage(5, 3));
  wire.pixelformat = 12;
  EXPECT_NE(FromWire(wire).message().find("pixelformat"), std::string::npos);
}

TEST(WireDevice, StripeSurvivesTheRoundTrip) {
  const sensor::Stripe sent = samples::Stripe();
  const auto got = Decode<sensor::Stripe>(Encode(sent));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_EQ(got->scan_id, sent.scan_id);
  EXPECT_EQ(got->stripe_index, 5);
  EXPECT_EQ(got->attempt, 1);
  EXPECT_EQ(got->laser, sensor::Laser::kVertical);
  EXPECT_EQ(got->status, sensor::StripeStatus::kLit);
  EXPECT_EQ(got->pan_rad, 0.1);
  EXPECT_EQ(got->tilt_rad, -0.2);
  EXPECT_EQ(got->heading_rad, 3.0);
  EXPECT_EQ(got->lit_utime, 10);
  EXPECT_EQ(got->unlit_utime, 9);
  EXPECT_EQ(got->lit_peak, 200.0);
  EXPECT_EQ(got->noise_level, 1.25);
  EXPECT_EQ(got->difference.data, sent.difference.data);
}

TEST(WireDevice, ARefusedStripeCarriesNoImage) {
  sensor::Stripe stripe = samples::Stripe();
  stripe.status = sensor::StripeStatus::kMoving;
  stripe.difference = {};
  const auto got = Decode<sensor::Stripe>(Encode(stripe));
  ASSERT_TRUE(got.ok()) << got.message();
  EXPECT_TRUE(got->difference.data.empty());
}

TEST(WireDevice, UnknownEnumerationsAreRefusedByName) {
  geon::stripe_t stripe = ToWire(samples::Stripe());
  stripe.laser = 3;
  EXPECT_EQ(FromWire(stripe).message(), "laser has the unknown value 3");
  geon::ptu_state_t ptu = ToWire(samples::PtuState());
  ptu.status = -1;
  EXPECT_FALSE(FromWire(ptu).ok());
  geon::scan_command_t command = ToWire(sensor::ScanCommand{});
  command.laser = 99;
  EXPECT_FALSE(FromWire(command).ok());
  geon::laser_state_t lasers = ToWire(sensor::LaserState{});
  lasers.laser = 4;
  EXPECT_FALSE(FromWire(lasers).ok());
}

TEST(WireDevice, HeadStateAndCommandSurviveTheRoundTrip) {
  const auto state = Decode<sensor::PtuState>(Encode(samples::PtuState()));
  ASSERT_TRUE(state.ok()) << state.message();
  EXPECT_EQ(state->pan_target_rad, 0.3);
  EXPECT_EQ(state->tilt_max_rad, 0.5);
  EXPECT_TRUE(state->moving);
  EXPECT_EQ(state->command_id, 42);
  const auto command =
      Decode<sensor::PtuCommand>(Encode(sensor::PtuCommand{1, 2, 3, 0.4, 0.5, 0.6}));
  ASSERT_TRUE(command.ok()) << command.message();
  EXPECT_EQ(command->command_id, 3);
  EXPECT_EQ(command->speed_rad_s, 0.6);
  const auto scan = Decode<sensor::ScanCommand>(
      Encode(sensor::ScanCommand{1, 2, 3, 4, 5, sensor::Laser::kHorizontal}));
  ASSERT_TRUE(scan.ok()) << scan.message();
  EXPECT_EQ(scan->attempt, 5);
  const auto lasers = Decode<sensor::LaserState>(Encode(
      sensor::LaserState{1, 2, sensor::DeviceStatus::kReady, sensor::Laser::kHorizontal, 12.5}));
  ASSERT_TRUE(lasers.ok()) << lasers.message();
  EXPECT_EQ(lasers->on_time_s, 12.5);
}

TEST(WireDevice, ACommandThatIsNoNumberIsRefused) {
  geon::ptu_command_t command = ToWire(sensor::PtuCommand{});
  command.tilt_rad = std::nan("");
  EXPECT_EQ(FromWire(command).message(), "tilt_rad is not a finite number");
  command.tilt_rad = 0.0;
  command.speed_rad_s = -1.0;
  EXPECT_FALSE(FromWire(command).ok());
}

}  // namespace
}  // namespace geon::messaging
