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

}  // namespace

Eyes::Eyes(const SeeingOptions& options, const geometry::SensorRig& rig)
    : options_(options),
      rig_(rig),
      head_finder_(options.target_color, options.head),
      floor_finder_(options.target_color, options.floor),
      floor_model_(options.floor_model) {
  std::string error;
  Require(options.IsValid(&error), error);
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
  sighting.seen =
      head_seen_ ? *std::exchange(head_seen_, std::nullopt) : head_finder_.Find(sighting.image);
  return sighting;
}

std::optional<FloorSighting> Eyes::LookFloor(const PoseHistory& history, bool patch_is_free) {
  if (!floor_image_ || !history.RobotKnownAfter(floor_image_->utime)) return std::nullopt;
  const sensor::Image image = *std::exchange(floor_image_, std::nullopt);
  const auto X_WR = history.RobotAt(image.utime);
  if (!X_WR) return std::nullopt;
  FloorSighting sighting =
      floor_seen_ ? *std::exchange(floor_seen_, std::nullopt) : LookAtFloor(image, patch_is_free);
  sighting.X_WR = *X_WR;
  return sighting;
}

FloorSighting Eyes::LookAtFloor(const sensor::Image& image, bool patch_is_free) {
  const cv::Mat bgr = AsBgr(image);
  if (options_.learn_floor && !floor_learned_ && patch_is_free) {
    const auto learned = navigation::LearnFloor(bgr, rig_.floor_camera, rig_.X_RF,
                                                options_.floor_model, options_.floor_obstacles);
    floor_learned_ = learned.has_value();
    floor_model_ = learned.value_or(options_.floor_model);
  }
  return {geometry::RigidTransform::Identity(), floor_finder_.Find(image),
          navigation::FloorObstacles(navigation::NotFloorMask(bgr, floor_model_), rig_.floor_camera,
                                     rig_.X_RF, options_.floor_obstacles)};
}

}  // namespace geon::mission
