#pragma once

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "geometry/sensor_rig.h"
#include "mission/mission.h"
#include "tests/common/mission/block_picture.h"

namespace geon::mission {

// The thesis's head with pictures of a quarter of the size, so that missions in virtual time are
// cheap.
geometry::SensorRig SmallRig();
// Options that go with it.
MissionOptions FastOptions();

// A robot, its daemons and a recognizer, as far as a mission can tell: flat pictures of blocks,
// motion without inertia, stripes that answer with the true distance. Everything happens in virtual
// time; the robot's clock differs from the planner's by decades. Faults are switched by the tests.
class FakeWorld {
 public:
  explicit FakeWorld(const MissionOptions& options);

  // One twentieth of a second.
  void Step();
  // Until `done` or the virtual time is over; says whether `done` came true.
  bool RunUntil(const std::function<bool()>& done, double limit_s);
  bool RunUntil(Phase phase, double limit_s);
  bool RunToTheEnd(double limit_s = 400.0);

  Mission& mission() { return *mission_; }
  const Wishes& wishes() const { return wishes_; }
  double now_s() const { return now_s_; }
  std::string Text() const { return mission_->State().text; }
  // A geon on the floor.
  void AddGeon(const Eigen::Vector2d& center_W_m, GeonLabel label);
  // Walls round a square of this half side, in short pieces: a block that is partly behind a camera
  // is not in its picture.
  void Fence(const Eigen::Vector2d& center_W_m, double half_m, double top_m = 0.5);
  // Whether the robot's disc overlaps a block that stands on the floor.
  bool Touches() const;

  std::vector<Block> blocks;  // the first one is the target, unless `target_hidden`
  bool target_hidden = false;
  Eigen::Vector3d pose{0.0, 0.0, 0.0};  // x, y, heading in W
  active_vision::HeadAngles head;       // true angles

  // Faults.
  bool ptu_up = true, base_up = true, stripe_camera_up = true, recognizer_up = true;
  bool head_camera_up = true, floor_camera_up = true;
  double coast_rad_s = 0.0;  // it turns on so fast after it was told to stop
  bool bumper_pressed = false;
  double bumper_bearing_rad = 0.0;
  std::map<int, int> missing_attempts;  // stripe -> how often it is missing
  std::set<int> never_swept;            // planned stripes that no sweep measures
  double reach_m = 100.0;               // no stripe measures anything beyond
  bool decided = true;
  double confidence_1 = 0.9;   // of every verdict, whether it decides or not
  int32_t recognizer_seq = 0;  // set back to 0: it was restarted

  // What the mission asked for.
  std::vector<sensor::ScanPlan> plans;                  // one per scan id
  std::vector<sensor::TargetMask> masks;                // one per plan
  std::vector<size_t> scanned;                          // index in `blocks`, one per plan
  std::vector<Eigen::Vector3d> scan_poses;              // of the robot, one per plan
  std::vector<sensor::ScanCommand> stripe_calls;        // one per (scan, stripe, attempt)
  std::vector<active_vision::HeadAngles> stripe_heads;  // head angles of these
  std::vector<sensor::Laser> sweeps;                    // lasers that were swept, in order
  std::vector<Phase> phases;                            // as entered
  bool drove_while_scanning = false;

 private:
  int64_t RobotUtime() const;
  void Move();
  void TellStates();
  void TellPictures();
  std::vector<Block> Seen() const;
  void Obey(const Wishes& wishes);
  void AnswerStripe(const sensor::ScanCommand& command);
  void AnswerSweep();
  sensor::RangeProfile Measured(const sensor::ScanCommand& command) const;
  void TellProfiles();
  void GiveVerdict(int64_t scan_id);
  // The geon that the B/W camera points at, as its index in `blocks`.
  size_t GeonInView() const;
  double TrueDistance() const;

  MissionOptions options_;
  geometry::SensorRig rig_;
  std::unique_ptr<Mission> mission_;
  Wishes wishes_;
  double now_s_ = 100.0;
  int step_ = 0;
  int32_t base_seq_ = 0;
  int64_t head_command_id_ = 0;
  active_vision::HeadAngles head_target_;
  double head_speed_rad_s_ = 0.0;  // 0: its own
  bool head_moving_ = false;
  std::optional<sensor::ScanCommand> sweep_;
  std::vector<std::pair<double, sensor::RangeProfile>> pending_;  // due time
  std::map<int64_t, int> answered_;                               // scan id -> stripes measured
};

}  // namespace geon::mission
