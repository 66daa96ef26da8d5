#include "mission/senses.h"

#include <cmath>
#include <utility>

#include "base/angles.h"
#include "base/time.h"
#include "navigation/ring_obstacles.h"

namespace geon::mission {

namespace {

// The robot does 0.5 m/s and states come ten times a second: more is not motion.
constexpr double kJump_m = 0.5;
constexpr double kSonarRound_s = 1.2;  // in which every sonar has fired
constexpr double kAhead_m = 0.7;       // where the floor's colour is learned
constexpr double kMapReach_m = 2.8;    // obstacles of the map that matter to the next move

// What odometry says, state or sonar scan, with its pose taken from O to W.
template <typename Posed>
Posed InWorld(Posed posed, const geometry::RigidTransform& X_WO) {
  const Eigen::Vector2d p_W_m = geometry::OnGround(X_WO, {posed.x_m, posed.y_m});
  posed.x_m = p_W_m.x();
  posed.y_m = p_W_m.y();
  posed.heading_rad = WrapAngle(posed.heading_rad + geometry::HeadingOf(X_WO));
  return posed;
}

}  // namespace

Senses::Senses(const MissionOptions& options, const geometry::SensorRig& rig)
    : patience_(options.patience),
      rings_(options.driving.rings),
      p_RF_m_(rig.X_RF.translation()),
      body_radius_m_(options.driving.velocity.body_radius_m),
      eyes_(options.seeing, rig),
      memory_(options.driving.memory),
      localizer_(options.driving.localizer) {
  if (options.driving.planner == PlannerKind::kMap) map_.emplace(options.driving.map);
}

void Senses::Take(double now_s, const sensor::BaseState& state) {
  NoticeOdometryJump(state);
  odometry_ = state;
  base_ = InWorld(state, localizer_.X_WO());
  base_at_s_ = now_s;
  history_.Add(state);
}

void Senses::NoticeOdometryJump(const sensor::BaseState& next) {
  if (next.status != sensor::DeviceStatus::kReady ||
      odometry_.status != sensor::DeviceStatus::kReady) {
    return;
  }
  if (std::hypot(next.x_m - odometry_.x_m, next.y_m - odometry_.y_m) < kJump_m) return;
  memory_.Clear();
  if (map_) map_->Clear();
  localizer_.Reset();
  history_.SetOdometryPose(localizer_.X_WO());
  ++odometry_epoch_;
}

void Senses::Localize(FloorSighting* floor) {
  const geometry::RigidTransform X_OR = localizer_.X_WO().inverse() * floor->X_WR;
  localizer_.See(X_OR, floor->columns, p_RF_m_, *map_);
  floor->X_WR = localizer_.X_WO() * X_OR;
  history_.SetOdometryPose(localizer_.X_WO());
  base_ = InWorld(odometry_, localizer_.X_WO());
}

void Senses::Take(double now_s, const sensor::SonarScan& heard) {
  const sensor::SonarScan scan = InWorld(heard, localizer_.X_WO());
  echoes_R_m_ = navigation::SonarObstacles(scan, rings_);
  if (!heard_s_) heard_s_ = now_s;
  if (map_) {
    map_->Hear(now_s, scan, rings_);
  } else {
    memory_.Feel(now_s, geometry::PlanarPose(scan.x_m, scan.y_m, scan.heading_rad), echoes_R_m_);
  }
}

void Senses::Feel(double now_s, std::span<const Eigen::Vector2d> points_R_m) {
  if (map_) {
    map_->Feel(now_s, X_WR(), points_R_m);
  } else {
    memory_.Feel(now_s, X_WR(), points_R_m);
  }
}

void Senses::ForgetDoubtfulObstacles() {
  if (map_) map_->ForgetDoubtful();
}

bool Senses::DoubtBrightObstacles(double now_s) { return map_ && map_->DoubtBright(now_s); }

std::optional<navigation::RingEchoes> Senses::Echoes(double now_s) const {
  if (!heard_s_ || now_s - *heard_s_ <= kSonarRound_s || BaseLost(now_s)) return std::nullopt;
  const auto X_WThen = history_.RobotAt(odometry_.utime - MicrosecondsFromSeconds(kSonarRound_s));
  if (!X_WThen) return std::nullopt;
  const geometry::RigidTransform X_ThenR = X_WThen->inverse() * X_WR();
  navigation::RingEchoes echoes{echoes_R_m_, 0.0};
  echoes.points_R_m.insert(echoes.points_R_m.end(), felt_R_m_.begin(), felt_R_m_.end());
  const Eigen::Vector2d ahead_m(kAhead_m, 0.0);
  echoes.moved_m = (geometry::OnGround(X_ThenR, ahead_m) - ahead_m).norm();
  return echoes;
}

void Senses::Take(double now_s, const sensor::InfraredScan& infrared) {
  felt_R_m_ = navigation::InfraredObstacles(infrared, rings_);
  Feel(now_s, felt_R_m_);
}

void Senses::Take(double now_s, const sensor::BumperState& bumpers) {
  bumpers_ = bumpers;
  std::vector<Eigen::Vector2d> contacts_R_m;
  for (size_t i = 0; i < bumpers.pressed.size(); ++i) {
    if (!bumpers.pressed[i]) continue;
    contacts_R_m.emplace_back(body_radius_m_ * std::cos(bumpers.bearing_rad[i]),
                              body_radius_m_ * std::sin(bumpers.bearing_rad[i]));
  }
  if (!contacts_R_m.empty()) eyes_.DoubtOtherLight();
  Feel(now_s, contacts_R_m);
}

void Senses::Take(double now_s, const sensor::PtuState& state) {
  ptu_ = state;
  ptu_at_s_ = now_s;
  history_.Add(state);
}

void Senses::Take(double now_s, const sensor::LaserState& state) {
  laser_status_ = state.status;
  laser_at_s_ = now_s;
}

void Senses::TakeHeadImage(double now_s, sensor::Image image,
                           std::optional<attention::TargetSighting> seen) {
  head_at_s_ = now_s;
  eyes_.TakeHead(std::move(image), std::move(seen));
}

void Senses::TakeFloorImage(double now_s, sensor::Image image, std::optional<FloorSighting> seen) {
  floor_at_s_ = now_s;
  eyes_.TakeFloor(std::move(image), std::move(seen));
}

void Senses::Look(double now_s) {
  head_ = eyes_.LookHead(history_);
  floor_ = eyes_.LookFloor(history_, eyes_.learns_floor() ? Echoes(now_s) : std::nullopt);
  if (floor_) floor_looked_s_ = now_s;
  if (map_) {
    if (floor_) {
      Localize(&*floor_);
      map_->SeeFloor(now_s, floor_->X_WR, floor_->columns);
    }
    map_->ObstaclesNear(X_WR().translation().head<2>(), kMapReach_m, &obstacles_R_m_);
    const geometry::RigidTransform X_RW = X_WR().inverse();
    for (Eigen::Vector2d& p_m : obstacles_R_m_) p_m = geometry::OnGround(X_RW, p_m);
    return;
  }
  if (floor_) memory_.SeeFloor(now_s, floor_->X_WR, floor_->columns);
  memory_.Forget(now_s);
  memory_.In(X_WR().inverse(), &obstacles_R_m_);
}

active_vision::HeadLimits Senses::head_limits() const {
  return {ptu_.pan_min_rad, ptu_.pan_max_rad, ptu_.tilt_min_rad, ptu_.tilt_max_rad};
}

bool Senses::BaseLost(double now_s) const {
  return !Fresh(base_at_s_, now_s) || base_.status != sensor::DeviceStatus::kReady;
}

bool Senses::PtuLost(double now_s) const {
  return !Fresh(ptu_at_s_, now_s) || ptu_.status != sensor::DeviceStatus::kReady;
}

bool Senses::StripeCameraLost(double now_s) const {
  return !Fresh(laser_at_s_, now_s) || laser_status_ != sensor::DeviceStatus::kReady;
}

bool Senses::HeadCameraLost(double now_s) const { return now_s - head_at_s_ > patience_.image_s; }

bool Senses::FloorCameraLost(double now_s) const { return now_s - floor_at_s_ > patience_.image_s; }

std::optional<double> Senses::Contact() const {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  bool pressed = false;
  for (size_t i = 0; i < bumpers_.pressed.size(); ++i) {
    if (!bumpers_.pressed[i]) continue;
    pressed = true;
    sum += Eigen::Vector2d(std::cos(bumpers_.bearing_rad[i]), std::sin(bumpers_.bearing_rad[i]));
  }
  if (!pressed) return std::nullopt;
  return std::atan2(sum.y(), sum.x());
}

geometry::RigidTransform Senses::X_WR() const {
  return geometry::PlanarPose(base_.x_m, base_.y_m, base_.heading_rad);
}

}  // namespace geon::mission
