#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "active_vision/head_angles.h"
#include "geometry/rigid_transform.h"
#include "sensor/base.h"
#include "sensor/ptu.h"

namespace geon::mission {

// Where robot and head were at an instant of the robot's clock: a picture is worth what its pose is
// worth. Cameras, PTU and base are on one host, so their utimes compare; nothing here uses the
// planner's own clock.
class PoseHistory {
 public:
  void Add(const sensor::BaseState& state);
  void Add(const sensor::PtuState& state);

  // Where the map has the origin of odometry, for all states, past and to come; at first in its
  // own.
  void SetOdometryPose(const geometry::RigidTransform& X_WO) { X_WO_ = X_WO; }

  // X_WR, interpolated; the newest pose for instants up to 0.15 s after it. Nothing when the base
  // was not known then.
  std::optional<geometry::RigidTransform> RobotAt(int64_t utime) const;

  // Whether the history reaches the instant, so that RobotAt need not extrapolate and HeadAt can
  // judge.
  bool RobotKnownAfter(int64_t utime) const;
  bool HeadKnownAfter(int64_t utime) const;
  // Where the head looked from `utime` on for `exposure_s`. `still` is set when it did not move,
  // judged by the states around the interval.
  struct HeadPose {
    active_vision::HeadAngles head;
    bool still = false;
  };
  std::optional<HeadPose> HeadAt(int64_t utime, double exposure_s, double still_rad) const;

 private:
  static constexpr size_t kLength = 128;
  geometry::RigidTransform X_WO_ = geometry::RigidTransform::Identity();
  std::deque<sensor::BaseState> base_;
  std::deque<sensor::PtuState> ptu_;
};

}  // namespace geon::mission
