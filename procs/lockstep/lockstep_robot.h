#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "device/laser_driver.h"
#include "device/ptu_driver.h"
#include "mission/mission.h"
#include "procs/base/base_control.h"
#include "procs/color_camera/exposure_control.h"
#include "procs/lockstep/glanced_eyes.h"
#include "procs/lockstep/lockstep_settings.h"
#include "procs/recognizer/scan_assembler.h"
#include "procs/stripe_camera/stripe_capture.h"
#include "sim/simulated_robot.h"

namespace geon::lockstep {

// The robot's and the workstation's daemons without their processes: the same drivers, guards,
// capture, recognizer and mission, stepped together with the simulated devices in virtual time.
// Bytes cross the devices' lines as they do on ptys; what would cross the bus is handed over within
// the turn. No clock, no thread: the same settings, world and seed give the same mission, bit for
// bit, at whatever speed the machine has.
//
// Frames are rendered only when somebody looks at them: the B/W camera's when the stripe camera
// waits for one, the colour cameras' while no scan runs and Sensing is kPictures.
class LockstepRobot {
 public:
  static constexpr double kTurn_s = 0.005;

  // Without a calibration, distances come from the rig. Errors: a mesh of the world cannot be used.
  static Result<std::unique_ptr<LockstepRobot>> Create(
      const LockstepSettings& settings,
      const std::optional<recognizer::StripeCalibration>& calibration, const sim::World& world,
      uint64_t seed);

  // Every daemon has one turn; kTurn_s go by.
  void Turn();

  double time_s() const { return time_s_; }
  const mission::Mission& mission() const { return *mission_; }
  // What the recognizer has of the present scan.
  sensor::ScanSet scan() const { return assembler_.CurrentScan(); }
  // The picture on which the last decision was taken; nothing before the first.
  const std::optional<mission::Decision>& decision() const { return decision_; }
  // The newest picture of the head's colour camera that was rendered; empty before the first.
  const sensor::Image& head_image() const { return head_image_; }
  // How things really are: for judging a run, never for running it.
  sim::RobotTruth truth() const { return simulated_->truth(); }

 private:
  LockstepRobot(const LockstepSettings& settings,
                const std::optional<recognizer::StripeCalibration>& calibration,
                std::unique_ptr<sim::SimulatedRobot> simulated);

  std::string Hear(sim::DeviceId device);
  void Say(sim::DeviceId device, std::string_view bytes);
  int64_t Utime() const;

  void TurnPtu();
  void TurnBase();
  void TurnStripeCamera();
  void TakeStripe(sensor::Stripe stripe);
  void TurnCameras();
  void Deliver(const sim::Exposure& exposure);
  void Glance(const sim::Exposure& exposure);
  void TakeHeadImage(sensor::Image image);
  void TurnPlanner();
  void Obey(const mission::Wishes& wishes);

  LockstepSettings settings_;
  std::unique_ptr<sim::SimulatedRobot> simulated_;
  sim::RigRenderer renderer_;
  std::optional<GlancedEyes> glanced_;  // in place of pictures
  double time_s_ = 0.0;
  int64_t turns_ = 0;

  device::PtuDriver ptu_;
  int ptu_samples_ = 0;
  int32_t ptu_seq_ = 0;
  base::BaseControl base_;
  device::LaserDriver lasers_;
  sensor::LaserState laser_state_;
  std::optional<color_camera::ExposureControl> exposure_;
  stripe_camera::StripeCapture capture_;
  int32_t stripe_seq_ = 0;
  recognizer::ScanAssembler assembler_;
  int32_t profile_seq_ = 0;
  std::unique_ptr<mission::Mission> mission_;
  int32_t command_seq_ = 0;
  std::optional<mission::Decision> decision_;
  sensor::Image head_image_;
  std::deque<sim::Exposure> exposed_;  // not yet delivered
};

}  // namespace geon::lockstep
