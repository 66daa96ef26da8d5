#include "navigation/obstacle_memory.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::navigation {

namespace {

double Bearing(const Eigen::Vector2d& p_m) { return std::atan2(p_m.y(), p_m.x()); }

// Whether both columns beside the direction of p showed floor well beyond it. What is nearer than
// the lowest row of the picture, or outside of it, is not seen.
bool SeenAsFloor(const Eigen::Vector2d& p_R_m, std::span<const FloorColumn> columns,
                 double margin_m) {
  const double bearing_rad = Bearing(p_R_m);
  const double distance_m = p_R_m.norm();
  for (size_t i = 1; i < columns.size(); ++i) {
    const FloorColumn& left = columns[i - 1];
    const FloorColumn& right = columns[i];
    if (Bearing(left.end_R_m) < bearing_rad || bearing_rad < Bearing(right.end_R_m)) continue;
    return distance_m >= std::max(left.begin_R_m.norm(), right.begin_R_m.norm()) &&
           distance_m + margin_m < std::min(left.end_R_m.norm(), right.end_R_m.norm());
  }
  return false;
}

}  // namespace

bool ObstacleMemoryOptions::IsValid(std::string* error) const {
  const bool valid =
      floor_memory_s > 0.0 && sonar_memory_s > 0.0 && cell_m > 0.0 && erase_margin_m >= 0.0;
  if (!valid && error != nullptr) *error = "memory times and cell size must be positive";
  return valid;
}

ObstacleMemory::ObstacleMemory(const ObstacleMemoryOptions& options) : options_(options) {
  std::string error;
  Require(options.IsValid(&error), error);
}

void ObstacleMemory::SeeFloor(double now_s, const geometry::RigidTransform& X_WR,
                              std::span<const FloorColumn> columns) {
  Forget(now_s);
  const geometry::RigidTransform X_RW = X_WR.inverse();
  std::erase_if(points_, [&](const Remembered& point) {
    return point.from_floor &&
           SeenAsFloor(geometry::OnGround(X_RW, point.p_W_m), columns, options_.erase_margin_m);
  });
  for (const FloorColumn& column : columns) {
    if (!column.obstacle) continue;
    Add(geometry::OnGround(X_WR, column.end_R_m), now_s + options_.floor_memory_s, true);
  }
}

void ObstacleMemory::Feel(double now_s, const geometry::RigidTransform& X_WR,
                          std::span<const Eigen::Vector2d> points_R_m) {
  Forget(now_s);
  for (const Eigen::Vector2d& p_R_m : points_R_m) {
    Add(geometry::OnGround(X_WR, p_R_m), now_s + options_.sonar_memory_s, false);
  }
}

void ObstacleMemory::Forget(double now_s) {
  std::erase_if(points_, [&](const Remembered& point) { return point.until_s < now_s; });
}

void ObstacleMemory::In(const geometry::RigidTransform& X_RW,
                        std::vector<Eigen::Vector2d>* points_R_m) const {
  points_R_m->clear();
  for (const Remembered& point : points_)
    points_R_m->push_back(geometry::OnGround(X_RW, point.p_W_m));
}

void ObstacleMemory::Add(const Eigen::Vector2d& p_W_m, double until_s, bool from_floor) {
  const auto cell = [&](const Eigen::Vector2d& p_m) {
    return Eigen::Vector2i((p_m / options_.cell_m).array().floor().cast<int>());
  };
  const Eigen::Vector2i here = cell(p_W_m);
  for (Remembered& point : points_) {
    if (point.from_floor == from_floor && cell(point.p_W_m) == here) {
      point = {p_W_m, until_s, from_floor};
      return;
    }
  }
  points_.push_back({p_W_m, until_s, from_floor});
}

}  // namespace geon::navigation
