#pragma once

#include <optional>
#include <vector>

#include "attention/find_target.h"
#include "geometry/sensor_rig.h"
#include "mission/mission_options.h"
#include "mission/pose_history.h"
#include "navigation/floor_model.h"
#include "navigation/floor_obstacles.h"
#include "sensor/image.h"

namespace geon::mission {

// One picture of the head's colour camera with what was seen in it and from where.
struct HeadSighting {
  sensor::Image image;  // kBgr8 or kRgb8
  active_vision::HeadAngles head;
  bool still = false;  // the head did not move through the exposure: angles are exact
  geometry::RigidTransform X_WR = geometry::RigidTransform::Identity();
  attention::TargetSighting seen;
};

// One picture of the floor camera.
struct FloorSighting {
  geometry::RigidTransform X_WR = geometry::RigidTransform::Identity();
  attention::TargetSighting seen;
  std::vector<navigation::FloorColumn> columns;
};

// Which of the things of the target's colour are meant, in W.
struct Focus {
  std::vector<Eigen::Vector3d> ignored_W_m;   // middles of targets that are done with
  std::vector<Eigen::Vector3d> expected_W_m;  // where the one that is driven to may be: preferred
};

// Looks at pictures once their poses are known. A picture waits for the base and PTU states that
// follow its exposure; a newer picture takes the place of a waiting one.
class Eyes {
 public:
  Eyes(const SeeingOptions& options, const geometry::SensorRig& rig);

  // Pictures must be kBgr8 or kRgb8; others are a broken contract. Floor pictures must have the
  // size that the rig states.
  // With what is seen in it, a picture is not looked at and need not have pixels: only its times
  // count. Where the robot was is told here all the same.
  void TakeHead(sensor::Image image, std::optional<attention::TargetSighting> seen = {}) {
    head_image_ = std::move(image);
    head_seen_ = std::move(seen);
  }
  void TakeFloor(sensor::Image image, std::optional<FloorSighting> seen = {}) {
    floor_image_ = std::move(image);
    floor_seen_ = std::move(seen);
  }

  void SetFocus(Focus focus) { focus_ = std::move(focus); }
  const Focus& focus() const { return focus_; }

  // The picture that waited, as soon as its pose is known; every picture is given once.
  std::optional<HeadSighting> LookHead(const PoseHistory& history);
  // `echoes`: where they leave the ground free its colour may be learned; not without them.
  std::optional<FloorSighting> LookFloor(const PoseHistory& history,
                                         const std::optional<navigation::RingEchoes>& echoes);

  // Whether the floor's colour was learned from the room (else the configured one is in use).
  bool floor_learned() const { return floor_learned_; }
  // Whether there is more to learn of it: sun and shade are the most.
  bool learns_floor() const {
    return options_.learn_floor && !light_doubted_ && floor_models_.size() < 2;
  }
  // The robot touched what no picture showed: the second light may be the colour of what stands
  // there. It is forgotten, and none is learned any more.
  void DoubtOtherLight();

 private:
  void LearnFloor(const cv::Mat& bgr, const navigation::RingEchoes& echoes);
  FloorSighting LookAtFloor(const sensor::Image& image, const geometry::RigidTransform& X_WR,
                            const std::optional<navigation::RingEchoes>& echoes);
  // The target in a picture taken from X_WC, of those that the focus allows.
  attention::TargetSighting Find(const attention::TargetFinder& finder, const sensor::Image& image,
                                 const geometry::PinholeCamera& camera,
                                 const geometry::RigidTransform& X_WC) const;
  // The same for what somebody else has seen.
  attention::TargetSighting Allowed(attention::TargetSighting seen,
                                    const geometry::PinholeCamera& camera,
                                    const geometry::RigidTransform& X_WC) const;

  SeeingOptions options_;
  geometry::SensorRig rig_;
  attention::TargetFinder head_finder_;
  attention::TargetFinder floor_finder_;
  std::vector<navigation::FloorModel> floor_models_;  // in one light, or in shade and in sun
  navigation::FloorModel first_floor_model_;          // learned before the second light
  bool floor_learned_ = false;
  bool light_doubted_ = false;
  Focus focus_;
  std::optional<sensor::Image> head_image_;
  std::optional<sensor::Image> floor_image_;
  std::optional<attention::TargetSighting> head_seen_;  // in head_image_
  std::optional<FloorSighting> floor_seen_;
};

}  // namespace geon::mission
