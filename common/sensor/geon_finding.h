#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "base/geon_label.h"

namespace geon::sensor {

// A geon of the room that the mission has finished with.
struct GeonFinding {
  std::optional<GeonLabel> label;  // nothing: it was never scanned, `why` tells the reason
  double confidence = 0.0;         // these three of all views together
  bool decided = false;
  std::array<double, kGeonLabelCount> posterior{};
  Eigen::Vector2d p_W_m = Eigen::Vector2d::Zero();  // its middle from above; W is odometry's
  double support_height_m = 0.0;
  int views = 0;  // scans that led to a verdict
  std::string why;
};

}  // namespace geon::sensor
