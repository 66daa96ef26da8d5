#include "mission/pose_history.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/time.h"

namespace geon::mission {

namespace {

constexpr int64_t kExtrapolate_us = 150'000;

double Between(double a, double b, double share_1) { return a + (b - a) * share_1; }

// Newest last and in order: a device daemon that restarts with an older clock starts a new history.
template <typename State>
void Append(const State& state, size_t length, std::deque<State>* states) {
  if (!states->empty() && state.utime <= states->back().utime) {
    if (state.utime == states->back().utime) return;
    states->clear();
  }
  states->push_back(state);
  if (states->size() > length) states->pop_front();
}

// First state at or after the instant.
template <typename State>
auto FirstAt(const std::deque<State>& states, int64_t utime) {
  return std::lower_bound(states.begin(), states.end(), utime,
                          [](const State& state, int64_t t) { return state.utime < t; });
}

double Share(int64_t from, int64_t to, int64_t utime) {
  return static_cast<double>(utime - from) / static_cast<double>(to - from);
}

}  // namespace

void PoseHistory::Add(const sensor::BaseState& state) {
  if (state.status == sensor::DeviceStatus::kReady) Append(state, kLength, &base_);
}

void PoseHistory::Add(const sensor::PtuState& state) {
  if (state.status == sensor::DeviceStatus::kReady) {
    Append(state, kLength, &ptu_);
  } else {
    ptu_.clear();  // whatever it did meanwhile is not known
  }
}

std::optional<geometry::RigidTransform> PoseHistory::RobotAt(int64_t utime) const {
  const auto after = FirstAt(base_, utime);
  if (after == base_.end()) {
    if (base_.empty() || utime - base_.back().utime > kExtrapolate_us) return std::nullopt;
    return X_WO_ *
           geometry::PlanarPose(base_.back().x_m, base_.back().y_m, base_.back().heading_rad);
  }
  if (after->utime == utime)
    return X_WO_ * geometry::PlanarPose(after->x_m, after->y_m, after->heading_rad);
  if (after == base_.begin()) return std::nullopt;
  const auto before = std::prev(after);
  const double share_1 = Share(before->utime, after->utime, utime);
  const double turn_rad = WrapAngle(after->heading_rad - before->heading_rad);
  return X_WO_ * geometry::PlanarPose(Between(before->x_m, after->x_m, share_1),
                                      Between(before->y_m, after->y_m, share_1),
                                      before->heading_rad + share_1 * turn_rad);
}

bool PoseHistory::RobotKnownAfter(int64_t utime) const {
  return !base_.empty() && base_.back().utime >= utime;
}

bool PoseHistory::HeadKnownAfter(int64_t utime) const {
  return !ptu_.empty() && ptu_.back().utime >= utime;
}

std::optional<PoseHistory::HeadPose> PoseHistory::HeadAt(int64_t utime, double exposure_s,
                                                         double still_rad) const {
  const auto after = FirstAt(ptu_, utime);
  if (after == ptu_.end() || (after == ptu_.begin() && after->utime != utime)) return std::nullopt;
  const auto before = after->utime == utime ? after : std::prev(after);
  HeadPose pose;
  const double share_1 = before == after ? 0.0 : Share(before->utime, after->utime, utime);
  pose.head = {Between(before->pan_rad, after->pan_rad, share_1),
               Between(before->tilt_rad, after->tilt_rad, share_1)};

  // Still: every state from the one before the exposure to the one after its end says so and
  // agrees.
  const int64_t end_utime = utime + MicrosecondsFromSeconds(exposure_s);
  pose.still = HeadKnownAfter(end_utime);
  for (auto state = before; state != ptu_.end(); ++state) {
    pose.still = pose.still && !state->moving &&
                 std::abs(state->pan_rad - before->pan_rad) <= still_rad &&
                 std::abs(state->tilt_rad - before->tilt_rad) <= still_rad;
    if (state->utime >= end_utime) break;
  }
  return pose;
}

}  // namespace geon::mission
