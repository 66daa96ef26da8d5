#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "base/geon_label.h"
#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"

namespace geon::mission {

// A box of the fake world: an upright block on the floor or on another one.
struct Block {
  Eigen::Vector2d center_W_m{0.0, 0.0};
  Eigen::Vector2d half_m{0.1, 0.1};
  double bottom_m = 0.0;
  double top_m = 0.25;
  cv::Scalar color_bgr{40, 40, 150};
  std::optional<GeonLabel> label = {};  // of a geon: what the recognizer takes it for
};

// What a camera sees of them, flat: far blocks first. A block that is partly behind the camera is
// left out.
cv::Mat BlockPicture(std::vector<Block> blocks, const geometry::PinholeCamera& camera,
                     const geometry::RigidTransform& X_WC);

}  // namespace geon::mission
