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
  for (int k = 0; k < kDirections; ++k) {
    const double azimuth_rad = kHalfFan_rad * (1.0 - 2.0 * (k + 0.5) / kDirections);
    GroundDirection direction;
    direction.azimuth_R = {std::cos(azimuth_rad), std::sin(azimuth_rad)};
    for (int step = 1; step <= kSteps; ++step) {
      const GroundPlace place = PlaceAt(direction.azimuth_R, static_cast<double>(step) / kSteps);
      const std::optional<Eigen::Vector2d> pixel_px = PixelOf(place);
      if (!pixel_px && direction.places.empty()) continue;
      if (!pixel_px) break;
      if (direction.places.empty()) {
        direction.first_step = step;
        direction.begin_px = *pixel_px;
      }
      direction.end_px = *pixel_px;
      direction.places.push_back(place);
    }
    if (!direction.places.empty()) ground_.push_back(std::move(direction));
  }
}

bool Glancer::IsBright(int body) const {
  if (body < 0 || floor_body_ < 0) return false;
  constexpr float kWhite_1 = 0.2F;  // the least share that any channel falls behind the largest
  const Eigen::Vector3f& color_1 = scene_->bodies()[static_cast<size_t>(body)].material.color_1;
  const float floor_1 = scene_->bodies()[static_cast<size_t>(floor_body_)].material.color_1.mean();
  return color_1.mean() > 2.0F * floor_1 &&
         color_1.minCoeff() > (1.0F - kWhite_1) * color_1.maxCoeff();
}

bool Glancer::InGlare(const Eigen::Vector2d& p_W_m, const Eigen::Vector3d& p_WC_m) const {
  if (floor_body_ < 0) return false;
  const Material& floor = scene_->bodies()[static_cast<size_t>(floor_body_)].material;
  if (floor.mirror_1 <= 0.0F) return false;
  const Eigen::Vector3f place_W_m(static_cast<float>(p_W_m.x()), static_cast<float>(p_W_m.y()), 0);
  const Eigen::Vector3f lamp_W_m = scene_->lighting().lamp_W_m.cast<float>();
  const float mirrored_1 =
      kLampShare_1 * floor.mirror_1 * MirroredLamp_1(place_W_m, p_WC_m.cast<float>(), lamp_W_m);
  // Twice as bright as the floor is no floor's colour any more.
  if (mirrored_1 <= floor.color_1.mean()) return false;
  uint8_t lit = 0;
  scene_->Illuminate(lamp_W_m, {&place_W_m, 1}, {&lit, 1});
  return lit != 0;
}

Glancer::GroundPlace Glancer::PlaceAt(const Eigen::Vector2d& azimuth_R, double share_1) const {
  const double height_m = rig_.X_RF.translation().z();
  GroundPlace place;
  place.distance_m = height_m * std::tan(share_1 * std::atan2(options_.floor_range_m, height_m));
  place.p_F_m =
      rig_.X_RF.linear().transpose() * Eigen::Vector3d(place.distance_m * azimuth_R.x(),
                                                       place.distance_m * azimuth_R.y(), -height_m);
  return place;
}

std::optional<Eigen::Vector2d> Glancer::PixelOf(const GroundPlace& place) const {
  const geometry::PinholeCamera& camera = rig_.floor_camera.ideal;
  if (place.p_F_m.z() < 0.05 || !IsNearPicture(camera, camera.Project(place.p_F_m))) {
    return std::nullopt;
  }
  const Eigen::Vector2d pixel_px = rig_.floor_camera.Project(place.p_F_m);
  return camera.Contains(pixel_px) ? std::optional(pixel_px) : std::nullopt;
}

std::vector<Glancer::OpenWay> Glancer::OpenWays(const geometry::RigidTransform& X_WR) const {
  // Less than what is open, so that rays see no edge there by rounding. A robot that tilts does not
  // look straight along the ground.
  constexpr double kShort_m = 0.01;
  const bool level = X_WR.linear()(2, 2) == 1.0;
  const Eigen::Vector2d eye_W_m = (X_WR * rig_.X_RF.translation()).head<2>();
  std::vector<OpenWay> ways;
  for (const GroundDirection& direction : ground_) {
    const Eigen::Vector2d bearing_W = X_WR.linear().topLeftCorner<2, 2>() * direction.azimuth_R;
    ways.push_back(
        {eye_W_m, bearing_W, level ? scene_->OpenGround_m(eye_W_m, bearing_W) - kShort_m : 0.0});
  }
  return ways;
}

void Glancer::LookForFloor(const geometry::RigidTransform& X_WR, std::span<const OpenWay> ways,
                           std::span<GroundQuestion> questions) {
  const geometry::RigidTransform X_WC = X_WR * rig_.X_RF;
  const Eigen::Matrix3f R_WC = X_WC.linear().cast<float>();
  const auto is_open = [&](const GroundQuestion& question) {
    return question.place.distance_m < ways[question.direction].open_m;
  };
  directions_.clear();
  for (const GroundQuestion& question : questions) {
    if (!is_open(question)) directions_.push_back(R_WC * question.place.p_F_m.cast<float>());
  }
  sightings_.resize(directions_.size());
  scene_->Look(X_WC.translation().cast<float>(), directions_, sightings_);
  auto sighting = sightings_.begin();
  for (GroundQuestion& question : questions) {
    const OpenWay& way = ways[question.direction];
    Eigen::Vector2d p_W_m = way.from_W_m + question.place.distance_m * way.bearing_W;
    question.floor = true;
    if (!is_open(question)) {
      question.floor = sighting->body == floor_body_;
      question.bright = !question.floor && IsBright(sighting->body);
      p_W_m = sighting->p_W_m.head<2>().cast<double>();
      ++sighting;
    }
    if (question.floor && InGlare(p_W_m, X_WC.translation())) {
      question.floor = false;
      question.bright = true;
    }
  }
}

std::vector<GroundGlance> Glancer::Floor(const RigPose& pose, int64_t seq) {
  const std::vector<OpenWay> ways = OpenWays(pose.X_WR);
  // Floor as far as one share of the way, something else from the other on ...
  struct Edge {
    size_t floor_places = 0;
    bool obstacle = false, bright = false;
    double floor_1 = 0.0, other_1 = 0.0;
  };
  std::vector<Edge> edges(ground_.size());
  std::vector<GroundQuestion> questions;
  for (size_t place = 0; place < kSteps; ++place) {
    questions.clear();
    for (size_t k = 0; k < edges.size(); ++k) {
      if (edges[k].obstacle || place >= ground_[k].places.size()) continue;
      questions.push_back({k, ground_[k].places[place]});
    }
    LookForFloor(pose.X_WR, ways, questions);
    for (const GroundQuestion& question : questions) {
      Edge& edge = edges[question.direction];
      edge.obstacle = !question.floor;
      edge.bright = question.bright;
      if (question.floor) ++edge.floor_places;
    }
  }
  for (size_t k = 0; k < edges.size(); ++k) {
    const double step = ground_[k].first_step + static_cast<double>(edges[k].floor_places);
    edges[k].floor_1 = (step - 1.0) / kSteps;
    edges[k].other_1 = step / kSteps;
  }
  // ... then the edge between them is halved until it is found.
  for (int round = 0; round < kHalvings; ++round) {
    questions.clear();
    for (size_t k = 0; k < edges.size(); ++k) {
      if (edges[k].floor_places == 0 || !edges[k].obstacle) continue;
      const double middle_1 = 0.5 * (edges[k].floor_1 + edges[k].other_1);
      questions.push_back({k, PlaceAt(ground_[k].azimuth_R, middle_1)});
    }
    LookForFloor(pose.X_WR, ways, questions);
    for (const GroundQuestion& question : questions) {
      Edge& edge = edges[question.direction];
      if (!question.floor) edge.bright = question.bright;
      (question.floor ? edge.floor_1 : edge.other_1) = 0.5 * (edge.floor_1 + edge.other_1);
    }
  }
  NoiseSource noise(HashMix(HashMix(seed_, 1), static_cast<uint64_t>(seq)));
  std::vector<GroundGlance> glances;
  for (size_t k = 0; k < edges.size(); ++k) {
    const GroundDirection& direction = ground_[k];
    GroundGlance glance;
    glance.any_floor = edges[k].floor_places > 0;
    glance.obstacle = edges[k].obstacle;
    glance.bright = edges[k].bright;
    glance.begin_px = direction.begin_px;
    glance.end_px = glance.any_floor ? direction.end_px : direction.begin_px;
    if (glance.any_floor && glance.obstacle) {
      const auto edge_px = PixelOf(PlaceAt(direction.azimuth_R, edges[k].floor_1));
      glance.end_px = edge_px.value_or(direction.end_px);
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
  // Vertices run round and round the body: the golden ratio takes them from all over it.
  constexpr double kGolden_1 = 0.6180339887498949;
  const geometry::RigidTransform X_CW = X_WC.inverse();
  std::vector<Eigen::Vector2d> pixels;
  directions_.clear();
  for (size_t n = 0; n < kPoints; ++n) {
    const double share_1 = kGolden_1 * static_cast<double>(n);
    const auto k = static_cast<size_t>((share_1 - std::floor(share_1)) *
                                       static_cast<double>(vertices_m.size()));
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
  if (glance.right_px < glance.left_px || glance.bottom_px < glance.top_px) return std::nullopt;
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
