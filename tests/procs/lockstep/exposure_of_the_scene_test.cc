// The colour camera's node before a simulated scene: its exposure follows the light.
#include <gtest/gtest.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "attention/expose_for_target.h"
#include "attention/find_target.h"
#include "base/time.h"
#include "config/daemon_arguments.h"
#include "messaging/channels.h"
#include "procs/color_camera/color_camera_node.h"
#include "procs/lockstep/frame_image.h"
#include "procs/lockstep/lockstep_settings.h"
#include "sim/simulated_robot.h"
#include "sim/world_file.h"

namespace geon::lockstep {
namespace {

constexpr size_t kFrames = 20;

// The head's colour camera of a robot that stands before a red geon on a box: every poll is its
// next frame.
class SceneSource : public device::FrameSource {
 public:
  SceneSource(const LockstepSettings& settings, const std::string& light)
      : fd_(eventfd(1, EFD_NONBLOCK)),
        robot_(sim::SimulatedRobot::Create(
                   *sim::ParseWorld("pen: {size_m: [3.0, 4.5], wall_height_m: 0.65}\n"
                                    "floor: {color_rgb: [150, 150, 140]}\n"
                                    "robot: {x_m: 1.5, y_m: 0.6, heading_deg: 90}\n"
                                    "light: " +
                                        light +
                                        "\nobjects:\n"
                                        "  - {box: [0.6, 0.6, 0.7], x_m: 1.5, y_m: 2.6}\n"
                                        "  - {geon: cuboid, size_m: [0.14, 0.11, 0.18], "
                                        "x_m: 1.5, y_m: 2.5, color_rgb: [150, 40, 40]}\n",
                                    "world.yaml", "."),
                   settings.drawn_rig, settings.sim, 1)
                   .value()),
        renderer_(robot_->MakeRenderer()) {}
  ~SceneSource() override { close(fd_); }

  int file_descriptor() const override { return fd_; }
  int reconnects() const override { return 0; }
  Status SetExposure(double exposure_s) override {
    robot_->SetExposure(sim::CameraId::kHeadColor, exposure_s);
    return Status::Ok();
  }
  Result<std::optional<sensor::Image>> Poll(double) override {
    while (true) {
      robot_->Advance(robot_->time_s() + 0.01);
      for (const sim::Exposure& exposure : robot_->TakeExposures()) {
        if (exposure.camera == sim::CameraId::kHeadColor) return Taken(exposure);
      }
    }
  }

 private:
  std::optional<sensor::Image> Taken(const sim::Exposure& exposure) {
    sensor::Image image = ImageOf(sim::Develop(exposure, &renderer_));
    image.seq = static_cast<int32_t>(exposure.seq);
    image.utime = 1'000'000'000 + MicrosecondsFromSeconds(exposure.start_s);
    image.exposure_s = exposure.exposure_s;
    return image;
  }

  int fd_;
  std::unique_ptr<sim::SimulatedRobot> robot_;
  sim::RigRenderer renderer_;
};

class ExposureOfTheSceneTest : public testing::Test {
 protected:
  ExposureOfTheSceneTest()
      : settings_(*LoadLockstepSettings(config::InstalledFile("scripts/config/robot.yaml"),
                                        config::InstalledFile("scripts/config/sim.yaml"))) {
    settings_.color_camera.max_rate_hz = 100.0;
    settings_.color_camera.exposure->law.most_exposure_s = 0.2;
  }

  // What the node publishes, kFrames of it.
  std::vector<sensor::Image> FramesIn(const std::string& light) {
    messaging::BusOptions bus_options;
    bus_options.url = "memq://";
    auto bus = std::move(*messaging::Bus::Open(bus_options));
    messaging::PollLoop loop;
    messaging::HealthReporter health(bus.get(), &loop, {"geon-test", "", ""});
    const color_camera::ColorCameraNode node(settings_.color_camera, messaging::kColorImage,
                                             std::make_unique<SceneSource>(settings_, light),
                                             bus.get(), &loop, &health);
    std::vector<sensor::Image> frames;
    bus->Subscribe<sensor::Image>(messaging::kColorImage, [&](const sensor::Image& image) {
      if (frames.size() < kFrames) frames.push_back(image);
      if (frames.size() == kFrames) loop.Stop();
    });
    loop.Watch(bus->file_descriptor(), [&] { bus->HandlePending(); });
    loop.Run();
    EXPECT_EQ(health.level(), sensor::HealthLevel::kOk);
    return frames;
  }

  attention::TargetSighting Find(const sensor::Image& image) const {
    return attention::FindTarget(image, settings_.color_camera.exposure->target_color);
  }
  double LevelOfTarget(const sensor::Image& image) const {
    return attention::MeasureLight(image, Find(image).mask).level_1;
  }

  // At the end of the frames the target is well lit, and found where it stands.
  void ExpectWellLit(const std::vector<sensor::Image>& frames) {
    ASSERT_EQ(frames.size(), kFrames);
    const attention::ExposureOptions& law = settings_.color_camera.exposure->law;
    const auto seen = Find(frames.back());
    ASSERT_TRUE(seen.target.has_value());
    EXPECT_GE(LevelOfTarget(frames.back()), law.low_level_1);
    EXPECT_LE(LevelOfTarget(frames.back()), law.high_level_1);
    EXPECT_EQ(seen.clipped_pixels, 0);
    const auto true_box = Find(FramesIn("{kelvin: 4000, level: 1.0}").front()).target->box;
    EXPECT_NEAR(seen.target->box.u_px, true_box.u_px, 3);
    EXPECT_NEAR(seen.target->box.v_px, true_box.v_px, 3);
    EXPECT_NEAR(seen.target->box.w_px, true_box.w_px, 6);
    EXPECT_NEAR(seen.target->box.h_px, true_box.h_px, 6);
  }

  LockstepSettings settings_;
};

TEST_F(ExposureOfTheSceneTest, ADarkSceneIsExposedLonger) {
  const auto frames = FramesIn("{kelvin: 4000, level: 0.3}");
  EXPECT_LT(LevelOfTarget(frames.front()), 110.0);
  EXPECT_DOUBLE_EQ(frames.front().exposure_s.value(), 0.020);
  EXPECT_GT(frames.back().exposure_s.value(), 0.100);
  ExpectWellLit(frames);
}

TEST_F(ExposureOfTheSceneTest, ABlindingSceneIsExposedShorter) {
  const auto frames = FramesIn("{kelvin: 4000, level: 40.0}");
  EXPECT_FALSE(Find(frames.front()).target.has_value()) << "its red is clipped";
  EXPECT_LT(frames.back().exposure_s.value(), 0.002);
  ExpectWellLit(frames);
}

TEST_F(ExposureOfTheSceneTest, OldFramesAreNotJudgedAndGoodOnesChangeNothing) {
  const auto frames = FramesIn("{kelvin: 4000, level: 4.0}");
  int changes = 0;
  size_t since = 0;
  for (size_t k = 1; k < frames.size(); ++k) {
    ++since;
    if (frames[k].exposure_s == frames[k - 1].exposure_s) continue;
    EXPECT_TRUE(changes == 0 || since >= 4) << "frame " << k;
    ++changes;
    since = 0;
  }
  EXPECT_GE(changes, 1);
  EXPECT_LE(changes, 3);
  EXPECT_GE(since, 4U) << "it has come to rest";
}

TEST_F(ExposureOfTheSceneTest, FixedIsFixed) {
  settings_.color_camera.exposure.reset();
  for (const sensor::Image& frame : FramesIn("{kelvin: 4000, level: 8.0}")) {
    EXPECT_DOUBLE_EQ(frame.exposure_s.value(), 0.020);
  }
}

}  // namespace
}  // namespace geon::lockstep
