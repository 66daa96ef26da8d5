#include "procs/lockstep/glanced_eyes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angles.h"

namespace geon::lockstep {
namespace {

// As the target finder tells it; the mask is the whole box.
attention::TargetSighting SightingOf(const std::optional<sim::GeonGlance>& glance,
                                     const geometry::PinholeCamera& camera, int min_target_pixels) {
  attention::TargetSighting seen;
  seen.width_px = camera.width_px;
  seen.height_px = camera.height_px;
  if (!glance || glance->pixels < min_target_pixels) return seen;
  constexpr double kEdge_px = 1.5;
  attention::Blob blob;
  blob.pixels = glance->pixels;
  const auto clamped = [](double value, int size) {
    return std::clamp(static_cast<int>(std::lround(value)), 0, size - 1);
  };
  const int left = clamped(glance->left_px, camera.width_px);
  const int right = clamped(glance->right_px, camera.width_px);
  const int top = clamped(glance->top_px, camera.height_px);
  const int bottom = clamped(glance->bottom_px, camera.height_px);
  blob.box = {left, top, right - left + 1, bottom - top + 1};
  blob.center_px = {0.5 * (left + right), 0.5 * (top + bottom)};
  seen.blobs = {blob};
  seen.color_pixels = blob.pixels;
  seen.target = blob;
  seen.mask.assign(static_cast<size_t>(camera.width_px) * static_cast<size_t>(camera.height_px), 0);
  for (int v = top; v <= bottom; ++v) {
    const auto row = seen.mask.begin() + static_cast<ptrdiff_t>(v) * camera.width_px;
    std::fill(row + left, row + right + 1, uint8_t{255});
  }
  seen.bottom_px = glance->lowest_px;
  seen.touched = {left<kEdge_px, right> camera.width_px - 1 - kEdge_px,
                  top<kEdge_px, bottom> camera.height_px - 1 - kEdge_px};
  return seen;
}

}  // namespace

GlancedEyes::GlancedEyes(sim::Glancer glancer, const geometry::SensorRig& rig,
                         const mission::SeeingOptions& options)
    : glancer_(std::move(glancer)), rig_(rig), options_(options) {}

attention::TargetSighting GlancedEyes::Head(const sim::Exposure& exposure) {
  return SightingOf(glancer_.GeonByHead(exposure.path.middle(), exposure.seq), rig_.color_camera,
                    options_.head.min_target_pixels);
}

mission::FloorSighting GlancedEyes::Floor(const sim::Exposure& exposure) {
  const sim::RigPose& pose = exposure.path.middle();
  const geometry::PinholeCamera& camera = rig_.floor_camera;
  mission::FloorSighting sighting;
  sighting.seen = SightingOf(glancer_.GeonByFloorCamera(pose, exposure.seq), camera,
                             options_.floor.min_target_pixels);
  for (const sim::GroundGlance& glance : glancer_.Floor(pose, exposure.seq)) {
    auto column = navigation::FloorBetween(glance.begin_px, glance.end_px, glance.obstacle, camera,
                                           rig_.X_RF, options_.floor_obstacles.max_range_m);
    if (!column) continue;
    column->bright = glance.bright;
    sighting.columns.push_back(*column);
  }
  return sighting;
}

mission::FloorSighting GlancedEyes::FloorAllRound(const sim::Exposure& exposure,
                                                  double farthest_m) {
  constexpr int kDirections = 360;
  constexpr double kAnkle_m = 0.05;  // whatever is lower the robot drives over
  const sim::RigPose& pose = exposure.path.middle();
  const Eigen::Vector2d from_W_m = pose.X_WR.translation().head<2>();
  const auto distances_m = glancer_.AllRound(from_W_m, kAnkle_m, kDirections, farthest_m);
  const Eigen::Vector3d forward_W = pose.X_WR.linear().col(0);
  const double heading_rad = std::atan2(forward_W.y(), forward_W.x());
  mission::FloorSighting sighting;
  sighting.seen = SightingOf(glancer_.GeonByFloorCamera(pose, exposure.seq), rig_.floor_camera,
                             options_.floor.min_target_pixels);
  for (int k = kDirections - 1; k >= 0; --k) {  // from left to right
    const double bearing_rad = 2.0 * kPi * k / kDirections - heading_rad;
    const double distance_m = distances_m[static_cast<size_t>(k)];
    navigation::FloorColumn column;
    column.end_R_m = distance_m * Eigen::Vector2d(std::cos(bearing_rad), std::sin(bearing_rad));
    column.obstacle = distance_m < farthest_m;
    sighting.columns.push_back(column);
  }
  return sighting;
}

}  // namespace geon::lockstep
