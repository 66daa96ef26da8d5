#include "sim/glance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/geon_label.h"
#include "sim/hash_noise.h"
#include "sim/lamp_mirror.h"
#include "sim/noise_source.h"

namespace geon::sim {
namespace {

constexpr int kDirections = 80;       // of the ground that the floor camera sees
constexpr double kHalfFan_rad = 1.1;  // to either side
constexpr int kSteps = 18;            // along each of them, to begin with
constexpr int kHalvings = 5;          // of such a step, to find an edge

bool IsGeon(const Body& body) {
  return body.name == "mesh" || GeonLabelFromString(body.name).has_value();
}

// The lens's formula holds in the picture and a little beyond; from far outside it leads back.
bool IsNearPicture(const geometry::PinholeCamera& camera, const Eigen::Vector2d& ideal_px) {
  return std::abs(ideal_px.x() - camera.cx_px) < camera.width_px &&
         std::abs(ideal_px.y() - camera.cy_px) < camera.height_px;
}

}  // namespace

Glancer::Glancer(std::shared_ptr<const Scene> scene, const BuiltRig& rig,
                 const GlanceOptions& options, uint64_t seed)
    : scene_(std::move(scene)), rig_(rig), options_(options), seed_(seed) {
  for (size_t k = 0; k < scene_->bodies().size(); ++k) {
    const Body& body = scene_->bodies()[k];
    if (body.name == "floor") {
      floor_body_ = static_cast<int>(k);
    } else if (IsGeon(body)) {
      geon_bodies_.push_back(static_cast<int>(k));
    }
  }
  for (int direction = 0; direction < kDirections; ++direction) {
    GroundSteps steps{direction, 0, {}};
    for (int step = 1; step <= kSteps; ++step) {
      const GroundPlace place = PlaceAt(direction, static_cast<double>(step) / kSteps);
      if (place.in_picture) {
        if (steps.places.empty()) steps.first = step;
        steps.places.push_back(place);
      } else if (!steps.places.empty()) {
        break;
      }
    }
    if (!steps.places.empty()) ground_.push_back(std::move(steps));
  }
}

bool Glancer::InGlare(const Sighting& sighting, const Eigen::Vector3f& eye_W_m) const {
  if (floor_body_ < 0) return false;
  constexpr float kSeen_1 = 0.1F;  // of white: enough to be of another colour than the floor
  const float mirror_1 = scene_->bodies()[static_cast<size_t>(floor_body_)].material.mirror_1;
  const Eigen::Vector3f lamp_W_m = scene_->lighting().lamp_W_m.cast<float>();
  if (mirror_1 * MirroredLamp_1(sighting.p_W_m, eye_W_m, lamp_W_m) < kSeen_1) return false;
  uint8_t lit = 0;
  scene_->Illuminate(lamp_W_m, {&sighting.p_W_m, 1}, {&lit, 1});
  return lit != 0;
}

Glancer::GroundPlace Glancer::PlaceAt(int direction, double share_1) const {
  const Eigen::Vector3d& p_RC_m = rig_.X_RF.translation();
  const double azimuth_rad = kHalfFan_rad * (1.0 - 2.0 * (direction + 0.5) / kDirections);
  const double distance_m =
      p_RC_m.z() * std::tan(share_1 * std::atan2(options_.floor_range_m, p_RC_m.z()));
  const Eigen::Vector3d down_R_m(distance_m * std::cos(azimuth_rad),
                                 distance_m * std::sin(azimuth_rad), -p_RC_m.z());
  const Eigen::Vector3d p_F_m = rig_.X_RF.linear().transpose() * down_R_m;
  GroundPlace place;
  place.ray_F = p_F_m.cast<float>();
  const geometry::PinholeCamera& camera = rig_.floor_camera.ideal;
  if (p_F_m.z() < 0.05 || !IsNearPicture(camera, camera.Project(p_F_m))) return place;
  place.pixel_px = rig_.floor_camera.Project(p_F_m);
  place.in_picture = camera.Contains(place.pixel_px);
  return place;
}

std::vector<GroundGlance> Glancer::Floor(const RigPose& pose, int64_t seq) {
  const geometry::RigidTransform X_WC = pose.X_WR * rig_.X_RF;
  const Eigen::Matrix3f R_WC = X_WC.linear().cast<float>();
  const auto look = [&] {
    sightings_.resize(directions_.size());
    scene_->Look(X_WC.translation().cast<float>(), directions_, sightings_);
  };
  const auto is_floor = [&](const Sighting& sighting) {
    return sighting.body == floor_body_ && !InGlare(sighting, X_WC.translation().cast<float>());
  };
  directions_.clear();
  for (const GroundSteps& steps : ground_) {
    for (const GroundPlace& place : steps.places) directions_.push_back(R_WC * place.ray_F);
  }
  look();
  // Floor as far as one share of the way, something else from the other on; then the edge between
  // them is halved until it is found.
  struct Edge {
    double floor_1, other_1;
    bool any_floor, obstacle;
  };
  std::vector<Edge> edges;
  auto sighting = sightings_.begin();
  for (const GroundSteps& steps : ground_) {
    const auto end = sighting + static_cast<ptrdiff_t>(steps.places.size());
    const auto other = std::find_if_not(sighting, end, is_floor);
    const double step = steps.first + static_cast<double>(other - sighting);
    edges.push_back({(step - 1.0) / kSteps, step / kSteps, other != sighting, other != end});
    sighting = end;
  }
  for (int round = 0; round < kHalvings; ++round) {
    directions_.clear();
    for (size_t k = 0; k < edges.size(); ++k) {
      const double middle_1 = 0.5 * (edges[k].floor_1 + edges[k].other_1);
      directions_.push_back(R_WC * PlaceAt(ground_[k].direction, middle_1).ray_F);
    }
    look();
    for (size_t k = 0; k < edges.size(); ++k) {
      const double middle_1 = 0.5 * (edges[k].floor_1 + edges[k].other_1);
      (is_floor(sightings_[k]) ? edges[k].floor_1 : edges[k].other_1) = middle_1;
    }
  }
  NoiseSource noise(HashMix(HashMix(seed_, 1), static_cast<uint64_t>(seq)));
  std::vector<GroundGlance> glances;
  for (size_t k = 0; k < edges.size(); ++k) {
    const Edge& edge = edges[k];
    GroundGlance glance;
    glance.begin_px = ground_[k].places.front().pixel_px;
    glance.any_floor = edge.any_floor;
    glance.obstacle = edge.obstacle;
    glance.end_px = glance.begin_px;
    if (edge.any_floor) {
      const GroundPlace end = PlaceAt(ground_[k].direction, edge.floor_1);
      glance.end_px =
          edge.obstacle && end.in_picture ? end.pixel_px : ground_[k].places.back().pixel_px;
    }
    if (edge.any_floor && edge.obstacle) {
      const Eigen::Vector2d outward_px = (glance.end_px - glance.begin_px).stableNormalized();
      glance.end_px += options_.edge_sigma_px * noise.Gaussian() * outward_px;
    }
    glances.push_back(glance);
  }
  return glances;
}

std::optional<GeonGlance> Glancer::GeonByHead(const RigPose& pose, int64_t seq) {
  return Geon(rig_.color_camera, pose.X_WR * rig_.ColorCameraPose(pose.pan_rad, pose.tilt_rad),
              HashMix(HashMix(seed_, 2), static_cast<uint64_t>(seq)));
}

std::optional<GeonGlance> Glancer::GeonByFloorCamera(const RigPose& pose, int64_t seq) {
  return Geon(rig_.floor_camera, pose.X_WR * rig_.X_RF,
              HashMix(HashMix(seed_, 3), static_cast<uint64_t>(seq)));
}

std::optional<GeonGlance> Glancer::Geon(const BuiltCamera& camera,
                                        const geometry::RigidTransform& X_WC, uint64_t noise_seed) {
  NoiseSource noise(noise_seed);
  std::optional<GeonGlance> largest;
  for (const int body : geon_bodies_) {
    const auto glance = OneGeon(body, camera, X_WC, &noise);
    if (glance && (!largest || glance->pixels > largest->pixels)) largest = glance;
  }
  return largest;
}

std::optional<GeonGlance> Glancer::OneGeon(int body, const BuiltCamera& camera,
                                           const geometry::RigidTransform& X_WC,
                                           NoiseSource* noise) {
  constexpr size_t kPoints = 96;
  const auto& vertices_m = scene_->bodies()[static_cast<size_t>(body)].surface_W.vertices_m;
  const size_t step = std::max<size_t>(1, vertices_m.size() / kPoints);
  const geometry::RigidTransform X_CW = X_WC.inverse();
  std::vector<Eigen::Vector2d> pixels;
  directions_.clear();
  for (size_t k = 0; k < vertices_m.size(); k += step) {
    const Eigen::Vector3d p_C_m = X_CW * vertices_m[k];
    if (p_C_m.z() < 0.05) continue;
    if (!IsNearPicture(camera.ideal, camera.ideal.Project(p_C_m))) continue;
    const Eigen::Vector2d pixel = camera.Project(p_C_m);
    if (pixel.x() < 0.0 || pixel.x() > camera.ideal.width_px - 1.0 || pixel.y() < 0.0 ||
        pixel.y() > camera.ideal.height_px - 1.0) {
      continue;
    }
    pixels.push_back(pixel);
    directions_.push_back((vertices_m[k] - X_WC.translation()).cast<float>());
  }
  sightings_.resize(directions_.size());
  scene_->Look(X_WC.translation().cast<float>(), directions_, sightings_);
  GeonGlance glance{1e9, -1e9, 1e9, -1e9, {}, 0};
  for (size_t k = 0; k < pixels.size(); ++k) {
    if (sightings_[k].body != body) continue;
    glance.left_px = std::min(glance.left_px, pixels[k].x());
    glance.right_px = std::max(glance.right_px, pixels[k].x());
    glance.top_px = std::min(glance.top_px, pixels[k].y());
    if (pixels[k].y() > glance.bottom_px) glance.lowest_px = pixels[k];
    glance.bottom_px = std::max(glance.bottom_px, pixels[k].y());
  }
  if (glance.right_px < glance.left_px) return std::nullopt;
  constexpr double kFilled_1 = 0.75;  // of its box
  glance.pixels = static_cast<int>(kFilled_1 * (glance.right_px - glance.left_px) *
                                   (glance.bottom_px - glance.top_px));
  for (double* edge_px : {&glance.left_px, &glance.right_px, &glance.top_px, &glance.bottom_px}) {
    *edge_px += options_.edge_sigma_px * noise->Gaussian();
  }
  glance.lowest_px.y() = glance.bottom_px;
  return glance;
}

std::vector<double> Glancer::AllRound(const Eigen::Vector2d& from_W_m, double height_m, int count,
                                      double farthest_m) {
  directions_.clear();
  for (int k = 0; k < count; ++k) {
    const double angle_rad = 2.0 * kPi * k / count;
    directions_.emplace_back(static_cast<float>(std::cos(angle_rad)),
                             static_cast<float>(std::sin(angle_rad)), 0.0F);
  }
  const Eigen::Vector3d origin_W_m(from_W_m.x(), from_W_m.y(), height_m);
  sightings_.resize(directions_.size());
  scene_->Look(origin_W_m.cast<float>(), directions_, sightings_);
  std::vector<double> distances_m;
  for (const Sighting& sighting : sightings_) {
    const double distance_m =
        sighting.body < 0 ? farthest_m : (sighting.p_W_m.cast<double>() - origin_W_m).norm();
    distances_m.push_back(std::min(distance_m, farthest_m));
  }
  return distances_m;
}

}  // namespace geon::sim
