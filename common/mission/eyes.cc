#include "mission/eyes.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <utility>

#include "base/contracts.h"
#include "base/time.h"

namespace geon::mission {

namespace {

// The picture's bytes as OpenCV sees them, channels in the order blue, green, red.
cv::Mat AsBgr(const sensor::Image& image) {
  Require(sensor::ChannelCount(image.format) == 3, "a picture in colour is needed");
  const cv::Mat view(image.height_px, image.width_px, CV_8UC3,
                     const_cast<uint8_t*>(image.data.data()),
                     static_cast<size_t>(image.row_stride_bytes));
  if (image.format == sensor::PixelFormat::kBgr8) return view;
  cv::Mat bgr(view.size(), CV_8UC3);
  const int swap[] = {0, 2, 1, 1, 2, 0};
  cv::mixChannels(&view, 1, &bgr, 1, swap, 3);
  return bgr;
}

constexpr double kIgnored_m = 0.28;   // so near to one that is done with it is that one
constexpr double kExpected_m = 0.50;  // so near to where it may be it is the one expected

// Whether a thing seen at a pixel may be one of these places.
bool IsAt(const std::vector<Eigen::Vector3d>& places_W_m, double radius_m,
          const Eigen::Vector2d& pixel_px, const geometry::PinholeCamera& camera,
          const geometry::RigidTransform& X_WC) {
  const Eigen::Vector3d ray_W =
      (X_WC.linear() * camera.Ray(pixel_px.x(), pixel_px.y())).normalized();
  return std::any_of(places_W_m.begin(), places_W_m.end(), [&](const Eigen::Vector3d& place_W_m) {
    const Eigen::Vector3d away_m = place_W_m - X_WC.translation();
    const double along_m = away_m.dot(ray_W);
    return along_m > 0.0 && (away_m - along_m * ray_W).norm() < radius_m;
  });
}

}  // namespace

Eyes::Eyes(const SeeingOptions& options, const geometry::SensorRig& rig)
    : options_(options),
      rig_(rig),
      head_finder_(options.target_color, options.head),
      floor_finder_(options.target_color, options.floor),
      floor_models_{options.floor_model} {
  std::string error;
  Require(options.IsValid(&error), error);
}

attention::TargetSighting Eyes::Find(const attention::TargetFinder& finder,
                                     const sensor::Image& image,
                                     const geometry::PinholeCamera& camera,
                                     const geometry::RigidTransform& X_WC) const {
  const auto is_new = [&](const attention::Blob& blob) {
    return !IsAt(focus_.ignored_W_m, kIgnored_m, blob.center_px, camera, X_WC);
  };
  if (!focus_.expected_W_m.empty()) {
    auto seen = finder.Find(image, [&](const attention::Blob& blob) {
      return is_new(blob) && IsAt(focus_.expected_W_m, kExpected_m, blob.center_px, camera, X_WC);
    });
    if (seen.target) return seen;
  }
  return finder.Find(image, is_new);
}

attention::TargetSighting Eyes::Allowed(attention::TargetSighting seen,
                                        const geometry::PinholeCamera& camera,
                                        const geometry::RigidTransform& X_WC) const {
  if (!seen.target || !IsAt(focus_.ignored_W_m, kIgnored_m, seen.target->center_px, camera, X_WC)) {
    return seen;
  }
  attention::TargetSighting nothing;
  nothing.width_px = seen.width_px;
  nothing.height_px = seen.height_px;
  return nothing;
}

std::optional<HeadSighting> Eyes::LookHead(const PoseHistory& history) {
  if (!head_image_) return std::nullopt;
  const int64_t utime = head_image_->utime;
  const double exposure_s = std::max(options_.exposure_s, head_image_->exposure_s.value_or(0.0));
  if (!history.RobotKnownAfter(utime) ||
      !history.HeadKnownAfter(utime + MicrosecondsFromSeconds(exposure_s))) {
    return std::nullopt;
  }
  HeadSighting sighting;
  sighting.image = *std::exchange(head_image_, std::nullopt);
  const auto head = history.HeadAt(utime, exposure_s, options_.still_rad);
  const auto X_WR = history.RobotAt(utime);
  if (!head || !X_WR) return std::nullopt;
  sighting.head = head->head;
  sighting.still = head->still;
  sighting.X_WR = *X_WR;
  const geometry::RigidTransform X_WC =
      *X_WR * rig_.ColorCameraPose(head->head.pan_rad, head->head.tilt_rad);
  sighting.seen = head_seen_
                      ? Allowed(*std::exchange(head_seen_, std::nullopt), rig_.color_camera, X_WC)
                      : Find(head_finder_, sighting.image, rig_.color_camera, X_WC);
  return sighting;
}

std::optional<FloorSighting> Eyes::LookFloor(const PoseHistory& history,
                                             const std::optional<navigation::RingEchoes>& echoes) {
  if (!floor_image_ || !history.RobotKnownAfter(floor_image_->utime)) return std::nullopt;
  const sensor::Image image = *std::exchange(floor_image_, std::nullopt);
  const auto X_WR = history.RobotAt(image.utime);
  if (!X_WR) return std::nullopt;
  if (!floor_seen_) return LookAtFloor(image, *X_WR, echoes);
  FloorSighting sighting = *std::exchange(floor_seen_, std::nullopt);
  sighting.X_WR = *X_WR;
  sighting.seen = Allowed(std::move(sighting.seen), rig_.floor_camera, *X_WR * rig_.X_RF);
  return sighting;
}

void Eyes::LearnFloor(const cv::Mat& bgr, const navigation::RingEchoes& echoes) {
  if (!floor_learned_) {
    const auto learned =
        navigation::LearnFloor(bgr, rig_.floor_camera, rig_.X_RF, options_.floor_model, echoes);
    floor_learned_ = learned.has_value();
    if (learned) floor_models_ = {*learned};
    return;
  }
  const auto lights = navigation::LearnOtherLight(
      bgr, rig_.floor_camera, rig_.X_RF, floor_models_.front(), options_.floor_model, echoes);
  if (!lights) return;
  first_floor_model_ = floor_models_.front();
  floor_models_.assign(lights->begin(), lights->end());
}

void Eyes::DoubtOtherLight() {
  if (floor_models_.size() < 2) return;
  floor_models_ = {first_floor_model_};
  light_doubted_ = true;
}

FloorSighting Eyes::LookAtFloor(const sensor::Image& image, const geometry::RigidTransform& X_WR,
                                const std::optional<navigation::RingEchoes>& echoes) {
  const cv::Mat bgr = AsBgr(image);
  if (learns_floor() && echoes) LearnFloor(bgr, *echoes);
  return {X_WR, Find(floor_finder_, image, rig_.floor_camera, X_WR * rig_.X_RF),
          navigation::FloorObstacles(navigation::NotFloorMask(bgr, floor_models_),
                                     rig_.floor_camera, rig_.X_RF, options_.floor_obstacles)};
}

}  // namespace geon::mission
