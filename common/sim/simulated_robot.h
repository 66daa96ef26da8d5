#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/status.h"
#include "geometry/sensor_rig.h"
#include "sim/rig_renderer.h"
#include "sim/sim_config.h"
#include "sim/world.h"

namespace geon::sim {

enum class DeviceId { kPtu = 0, kBase, kLasers };
inline constexpr std::array kDevices = {DeviceId::kPtu, DeviceId::kBase, DeviceId::kLasers};

enum class CameraId { kHeadColor = 0, kHeadBw, kFloorColor };
inline constexpr std::array kCameras = {CameraId::kHeadColor, CameraId::kHeadBw,
                                        CameraId::kFloorColor};

// A frame that has been exposed: all there is to know to develop it, at any later time.
struct Exposure {
  CameraId camera = CameraId::kHeadColor;
  int64_t seq = 0;       // counts from 1, also over frames that are dropped or nobody develops
  double start_s = 0.0;  // of the exposure
  double end_s = 0.0;
  RigPath path;
  LaserFractions lasers;
  double exposure_s = 0.0;  // its length, to the bit as asked for
  double exposure_1 = 1.0;  // the same in units of the camera's exposure_us
};

Frame Develop(const Exposure& exposure, RigRenderer* renderer);

// How things really are.
struct RobotTruth {
  double time_s = 0.0;
  double x_m = 0.0, y_m = 0.0;
  double heading_rad = 0.0;  // of the wheels
  double turret_rad = 0.0;
  double speed_m_s = 0.0;
  double turn_rate_rad_s = 0.0;
  double pan_rad = 0.0, tilt_rad = 0.0;
  bool horizontal_laser = false, vertical_laser = false;
  int contacts = 0;  // obstacles that touch the body
  bool bumper = false;
};

// The robot and its devices in a world, in virtual time: three serial lines and three cameras. No
// clock, no thread: the same bytes at the same times give the same answers and frames.
class SimulatedRobot {
 public:
  static constexpr double kStep_s = 0.001;
  // A frame that is exposed while the camera moves is the mean of this many at most.
  static constexpr size_t kMostPoses = 8;

  // Errors: a mesh of the world cannot be used.
  static Result<std::unique_ptr<SimulatedRobot>> Create(const World& world,
                                                        const geometry::SensorRig& rig,
                                                        const SimOptions& options, uint64_t seed);

  // What the host wrote, as of now.
  void Receive(DeviceId device, std::span<const uint8_t> bytes);
  void PortOpened(DeviceId device);
  // Lives on to `time_s` (never back), in steps of a millisecond.
  void Advance(double time_s);
  // What has reached the host since last asked.
  std::vector<uint8_t> Transmit(DeviceId device);
  // How long a camera exposes. As in a real one, the frame that is being taken and the next keep
  // the exposure before; the length is the nearest from 0.1 ms to 2 s. It takes fewer frames a
  // second if they would not leave time to read them out.
  void SetExposure(CameraId camera, double exposure_s);
  // Exposures that have ended since last asked. Which ones are dropped (CameraOptions::dropped_1)
  // depends on the seed, the camera and `seq` alone.
  std::vector<Exposure> TakeExposures();

  int baud(DeviceId device) const;
  RobotTruth truth() const;
  double time_s() const { return static_cast<double>(steps_) * kStep_s; }
  const std::shared_ptr<const Scene>& scene() const { return scene_; }
  uint64_t seed() const { return seed_; }
  // Develops the frames of this individual.
  RigRenderer MakeRenderer() const;

 private:
  struct Line {
    SerialDevice* device;
    LineFaults faults;
  };
  struct Shutter {
    CameraId camera;
    double focal_px;
    int64_t made_period_steps;
    double made_exposure_s;
    double dropped_1;
    double asked_exposure_s;  // of the frame after the next
    double next_exposure_s;   // of the next one
    int64_t exposure_steps;   // of this one
    int64_t next_start_step;
    int64_t start_step = 0;
    int64_t seq = 0;  // of this frame; 0: before the first
    int64_t lit_steps[2] = {0, 0};
    std::vector<RigPose> poses;  // at each step of the exposure
    Exposure exposure;
  };

  SimulatedRobot(const World& world, std::shared_ptr<const Scene> scene,
                 const geometry::SensorRig& rig, const SimOptions& options, uint64_t seed);
  void Step();
  void StepShutter(Shutter* shutter);
  Line& line(DeviceId device) { return lines_[static_cast<size_t>(device)]; }
  RigPose Pose() const;

  std::shared_ptr<const Scene> scene_;
  geometry::SensorRig rig_;
  SimOptions options_;
  uint64_t seed_;
  PtuEmulator ptu_;
  HorusEmulator laser_board_;
  NomadEmulator base_;
  std::array<Line, 3> lines_;
  std::array<Shutter, 3> shutters_;
  std::vector<Exposure> exposures_;
  int64_t steps_ = 0;
};

}  // namespace geon::sim
