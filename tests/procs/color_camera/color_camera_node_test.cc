#include "procs/color_camera/color_camera_node.h"

#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <deque>
#include <functional>
#include <utility>

#include "messaging/channels.h"
#include "sensor/laser_state.h"

namespace geon::color_camera {
namespace {

// Hands over prepared frames, one a poll; the loop calls once more to see that nothing is left.
class PreparedFrames : public device::FrameSource {
 public:
  PreparedFrames() : fd_(eventfd(1, EFD_NONBLOCK)) {}
  ~PreparedFrames() override { close(fd_); }
  int file_descriptor() const override { return fd_; }
  Result<std::optional<sensor::Image>> Poll(double) override {
    if (frames.empty()) {
      if (on_end) std::exchange(on_end, nullptr)();
      eventfd_t value = 0;
      eventfd_read(fd_, &value);
      return Status::Error("no more");
    }
    std::optional<sensor::Image> frame = frames.front();
    frames.pop_front();
    return frame;
  }
  int reconnects() const override { return 0; }
  Status SetExposure(double) override { return Status::Error("pictures keep theirs"); }
  std::string refused() const override { return refusal; }

  std::deque<sensor::Image> frames;
  std::string refusal;
  std::function<void()> on_end;  // called once, when the last frame has been dealt with

 private:
  int fd_;
};

sensor::Image Frame(int32_t seq, int64_t utime) {
  sensor::Image image;
  image.seq = seq;
  image.utime = utime;
  image.width_px = 16;
  image.height_px = 16;
  image.row_stride_bytes = 48;
  image.format = sensor::PixelFormat::kBgr8;
  image.data.assign(16 * 48, 77);
  return image;
}

// What the node publishes of these frames; `level` becomes its health after the last.
std::vector<sensor::Image> Carry(const ColorCameraConfig& config,
                                 const std::vector<sensor::Image>& frames,
                                 const std::string& refusal = "",
                                 sensor::HealthLevel* level = nullptr,
                                 sensor::Laser laser = sensor::Laser::kNone) {
  messaging::BusOptions bus_options;
  bus_options.url = "memq://";
  auto bus = std::move(*messaging::Bus::Open(bus_options));
  messaging::PollLoop loop;
  messaging::HealthReporter health(bus.get(), &loop, {"geon-test", "", ""});
  auto source = std::make_unique<PreparedFrames>();
  source->frames.assign(frames.begin(), frames.end());
  source->refusal = refusal;
  source->on_end = [&] {
    if (level != nullptr) *level = health.level();
  };
  const ColorCameraNode node(config, messaging::kColorImage, std::move(source), bus.get(), &loop,
                             &health);
  sensor::LaserState lasers;
  lasers.laser = laser;
  bus->Publish(messaging::kLaserState, lasers);
  bus->HandlePending();
  std::vector<sensor::Image> published;
  bus->Subscribe<sensor::Image>(messaging::kColorImage,
                                [&](const sensor::Image& image) { published.push_back(image); });
  loop.Watch(bus->file_descriptor(), [&] {
    bus->HandlePending();
    if (health.level() == sensor::HealthLevel::kFault) loop.Stop();
  });
  loop.Every(0.05, [&] {
    if (health.level() == sensor::HealthLevel::kFault) loop.Stop();
  });
  loop.Run();
  bus->HandlePending();
  return published;
}

TEST(ColorCameraNode, CarriesFramesUnchangedAndNumbersThemAnew) {
  const auto published = Carry({}, {Frame(10, 1'000'000), Frame(13, 2'000'000)});
  ASSERT_EQ(published.size(), 2u);
  EXPECT_EQ(published[0].seq, 1);
  EXPECT_EQ(published[1].seq, 2);
  EXPECT_EQ(published[1].utime, 2'000'000);
  EXPECT_EQ(published[0].data, Frame(0, 0).data);
}

TEST(ColorCameraNode, LeavesOutFramesThatComeTooFast) {
  ColorCameraConfig config;
  config.max_rate_hz = 5.0;
  std::vector<sensor::Image> frames;
  for (int32_t i = 0; i < 31; ++i) frames.push_back(Frame(i, 1'000'000 + i * 33'333));
  EXPECT_EQ(Carry(config, frames).size(), 6u);  // one second, and the first
}

TEST(ColorCameraNode, AClockThatIsSetBackDoesNotStopTheStream) {
  const auto published = Carry({}, {Frame(1, 9'000'000), Frame(2, 1'000'000), Frame(3, 2'000'000)});
  EXPECT_EQ(published.size(), 3u);
}

TEST(ColorCameraNode, FramesAreCarriedWhateverTheCameraRefuses) {
  const std::vector<sensor::Image> frames = {Frame(1, 1'000'000), Frame(9, 2'000'000)};
  sensor::HealthLevel level = sensor::HealthLevel::kStarting;
  EXPECT_EQ(Carry({}, frames, "", &level).size(), 2u);
  EXPECT_EQ(level, sensor::HealthLevel::kOk);
  EXPECT_EQ(Carry({}, frames, "the camera refuses gain = 0", &level).size(), 2u);
  EXPECT_EQ(level, sensor::HealthLevel::kWarn);
}

TEST(ColorCameraNode, ASourceWhoseExposureCannotBeSetIsAWarning) {
  ColorCameraConfig config;
  config.exposure.emplace().target_color = *attention::NamedColorModel("super-red");
  const std::vector<sensor::Image> frames = {Frame(1, 1'000'000), Frame(9, 2'000'000)};
  sensor::HealthLevel level = sensor::HealthLevel::kStarting;
  EXPECT_EQ(Carry(config, frames, "", &level).size(), 2u);
  EXPECT_EQ(level, sensor::HealthLevel::kWarn);
}

TEST(ColorCameraNode, AStripeOnTheTargetChangesNoExposure) {
  ColorCameraConfig config;
  config.exposure.emplace().target_color = *attention::NamedColorModel("super-red");
  sensor::HealthLevel level = sensor::HealthLevel::kStarting;
  EXPECT_EQ(Carry(config, {Frame(1, 1'000'000), Frame(9, 2'000'000)}, "", &level,
                  sensor::Laser::kVertical)
                .size(),
            2u);
  EXPECT_EQ(level, sensor::HealthLevel::kOk) << "nothing was asked of a source that can do nothing";
}

TEST(ColorCameraNode, CompressesWhereAsked) {
  ColorCameraConfig config;
  config.encoding = sensor::PixelFormat::kJpeg;
  const auto published = Carry(config, {Frame(1, 1'000'000)});
  ASSERT_EQ(published.size(), 1u);
  EXPECT_EQ(published[0].format, sensor::PixelFormat::kJpeg);
  EXPECT_EQ(published[0].width_px, 16);
  ASSERT_GT(published[0].data.size(), 2u);
  EXPECT_EQ(published[0].data[0], 0xff);
  EXPECT_EQ(published[0].data[1], 0xd8);
}

}  // namespace
}  // namespace geon::color_camera
