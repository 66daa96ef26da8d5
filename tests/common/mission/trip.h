#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/angles.h"
#include "base/time.h"
#include "mission/map_drive.h"
#include "tests/common/mission/fake_world.h"

namespace geon::mission {

inline constexpr double kBody_m = 0.267;
inline constexpr double kStop_m = 0.93;
inline constexpr double kTolerance_m = 0.04;  // with which a mission takes the place as reached

struct Wall {
  Eigen::Vector2d from_W_m, to_W_m;
  bool lamp = false;  // its image in the floor: bright, and nothing to bump into
};

// How far along a ray a wall is; infinite when the ray passes by.
inline double Along(const Eigen::Vector2d& from_m, const Eigen::Vector2d& direction,
                    const Wall& wall) {
  const Eigen::Vector2d edge_m = wall.to_W_m - wall.from_W_m, to_wall_m = wall.from_W_m - from_m;
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const double slant = cross(direction, edge_m);
  if (std::abs(slant) < 1e-12) return std::numeric_limits<double>::infinity();
  const double share_1 = cross(to_wall_m, direction) / slant;
  const double along_m = cross(to_wall_m, edge_m) / slant;
  return share_1 < 0.0 || share_1 > 1.0 || along_m < 0.0 ? std::numeric_limits<double>::infinity()
                                                         : along_m;
}

inline double Distance(const Eigen::Vector2d& p_m, const Wall& wall) {
  const Eigen::Vector2d edge_m = wall.to_W_m - wall.from_W_m;
  const double share_1 = (p_m - wall.from_W_m).dot(edge_m) / edge_m.squaredNorm();
  return (wall.from_W_m + std::clamp(share_1, 0.0, 1.0) * edge_m - p_m).norm();
}

// A robot that drives as it is told and sees the floor before it up to the walls; nothing else.
class Trip {
 public:
  explicit Trip(const Eigen::Vector2d& target_W_m) : Trip(target_W_m, Way::kToward, 0.0) {}
  // To a place on the floor, where nothing stands.
  static Trip ToPlace(const Eigen::Vector2d& place_W_m) { return {place_W_m, Way::kTo, 0.0}; }
  // The same, sent there.
  static Trip ToDestination(const Eigen::Vector2d& place_W_m) {
    return {place_W_m, Way::kSent, 0.0};
  }
  // Round a target to this side of it.
  static Trip RoundTarget(const Eigen::Vector2d& target_W_m, double side_rad) {
    return {target_W_m, Way::kRound, side_rad};
  }

  void AddBlock(const Eigen::Vector2d& middle_m, const Eigen::Vector2d& half_m, bool lamp = false) {
    const Eigen::Vector2d other_m(half_m.x(), -half_m.y());
    const Eigen::Vector2d corners_m[] = {middle_m - half_m, middle_m + other_m, middle_m + half_m,
                                         middle_m - other_m};
    for (int k = 0; k < 4; ++k) walls_.push_back({corners_m[k], corners_m[(k + 1) % 4], lamp});
  }

  // Until `done`, it is said that it cannot be reached, or the time is over.
  template <typename Done>
  void RunUntil(Done done, double limit_s) {
    const double end_s = now_s_ + limit_s;
    while (now_s_ < end_s && !done() && !answer.unreachable) Step();
  }
  // Until the target is so near, it is said that it cannot be reached, or the time is over.
  void Run(double limit_s, double near_m = kStop_m + kTolerance_m) {
    RunUntil([&] { return Distance_m() <= near_m; }, limit_s);
  }
  void Step() {
    constexpr double kTick_s = 0.05;
    now_s_ += kTick_s;
    Move(kTick_s);
    sensor::BaseState base;
    base.utime = MicrosecondsFromSeconds(now_s_);
    base.status = sensor::DeviceStatus::kReady;
    base.x_m = pose.x();
    base.y_m = pose.y();
    base.heading_rad = pose.z();
    senses.Take(now_s_, base);
    if (step_++ % 4 == 0) {
      sensor::Image picture;
      picture.utime = base.utime;
      senses.TakeFloorImage(now_s_, picture, FloorSighting{{}, {}, Columns()});
    }
    senses.Look(now_s_);
    answer = Drive();
    if (!answer.text.empty() && (texts.empty() || texts.back() != answer.text)) {
      texts.push_back(answer.text);
    }
  }
  double now_s() const { return now_s_; }
  // In W, from the target to the robot.
  double Bearing_rad() const {
    const Eigen::Vector2d out_m = pose.head<2>() - target_W_m_;
    return std::atan2(out_m.y(), out_m.x());
  }
  double Distance_m() const { return (pose.head<2>() - target_W_m_).norm(); }
  // Since the start, from the robot's axis to the nearest wall.
  double nearest_m() const { return nearest_m_; }
  // What was tried to come nearer, in its order.
  std::vector<std::string> Tried() const {
    std::vector<std::string> tried;
    std::copy_if(texts.begin(), texts.end(), std::back_inserter(tried),
                 [](const std::string& text) { return text.starts_with("no nearer"); });
    return tried;
  }

  Eigen::Vector3d pose{0.0, 0.0, 0.0};  // x, y, heading
  bool stuck = false;                   // nothing moves it
  Senses senses{FastOptions(), SmallRig()};
  MapDrive drive{FastOptions()};
  MapDrive::Answer answer;
  std::vector<std::string> texts;
  double fastest_in_image_m_s = 0.0;  // onto a lamp's image

 private:
  enum class Way { kToward, kRound, kTo, kSent };
  Trip(const Eigen::Vector2d& goal_W_m, Way way, double side_rad)
      : target_W_m_(goal_W_m), way_(way), side_rad_(side_rad) {
    if (way == Way::kToward || way == Way::kRound) AddBlock(goal_W_m, {0.1, 0.1});
  }
  MapDrive::Answer Drive() {
    switch (way_) {
      case Way::kRound:
        return drive.Round(now_s_, target_W_m_, kStop_m, side_rad_, &senses);
      case Way::kTo:
        return drive.To(now_s_, target_W_m_, &senses);
      case Way::kSent:
        return drive.ToDestination(now_s_, target_W_m_, &senses);
      case Way::kToward:
        break;
    }
    return drive.Toward(now_s_, target_W_m_, kStop_m, &senses);
  }
  void Move(double step_s) {
    if (stuck) return;
    pose.z() = WrapAngle(pose.z() + answer.velocity.turn_rate_rad_s * step_s);
    pose.head<2>() += answer.velocity.speed_m_s * step_s *
                      Eigen::Vector2d(std::cos(pose.z()), std::sin(pose.z()));
    for (const Wall& wall : walls_) {
      const double away_m = Distance(pose.head<2>(), wall);
      if (!wall.lamp) nearest_m_ = std::min(nearest_m_, away_m);
      const Eigen::Vector2d ahead(std::cos(pose.z()), std::sin(pose.z()));
      if (wall.lamp && Along(pose.head<2>(), ahead, wall) < kBody_m) {
        fastest_in_image_m_s = std::max(fastest_in_image_m_s, answer.velocity.speed_m_s);
      }
    }
  }
  std::vector<navigation::FloorColumn> Columns() const {
    constexpr int kColumns = 81;
    constexpr double kHalfFan_rad = 0.9, kBegin_m = 0.32, kRange_m = 2.8;
    std::vector<navigation::FloorColumn> columns;
    for (int k = 0; k < kColumns; ++k) {
      const double bearing_rad = kHalfFan_rad * (1.0 - 2.0 * k / (kColumns - 1));
      const double angle_rad = pose.z() + bearing_rad;
      double free_m = kRange_m;
      bool bright = false;
      for (const Wall& wall : walls_) {
        const double wall_m =
            Along(pose.head<2>(), {std::cos(angle_rad), std::sin(angle_rad)}, wall);
        if (wall_m >= free_m) continue;
        free_m = wall_m;
        bright = wall.lamp;
      }
      const Eigen::Vector2d along(std::cos(bearing_rad), std::sin(bearing_rad));
      columns.push_back(
          {kBegin_m * along, std::max(kBegin_m, free_m) * along, free_m < kRange_m, bright});
    }
    return columns;
  }

  Eigen::Vector2d target_W_m_;
  Way way_;
  double side_rad_;
  std::vector<Wall> walls_;
  double now_s_ = 100.0;
  int step_ = 0;
  double nearest_m_ = std::numeric_limits<double>::infinity();
};

}  // namespace geon::mission
