#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sensor/geon_finding.h"

namespace geon::sensor {

enum class MissionOutcome {
  kRunning = 0,
  kNamed = 1,
  kFailed = 2,       // for another reason than the next
  kUnreachable = 3,  // no way leads to the geon
  kNoneFound = 4,    // all that can be seen from where the robot can go was looked at, in vain
  kSurveyed = 5,     // the same, and all geons that were found are done with
};
inline constexpr std::array<std::string_view, 6> kMissionOutcomeNames = {
    "running", "named", "failed", "unreachable", "none_found", "surveyed"};
inline std::string_view ToString(MissionOutcome outcome) {
  return kMissionOutcomeNames.at(static_cast<size_t>(outcome));
}
inline std::optional<MissionOutcome> MissionOutcomeFromString(std::string_view name) {
  for (size_t k = 0; k < kMissionOutcomeNames.size(); ++k) {
    if (kMissionOutcomeNames[k] == name) return static_cast<MissionOutcome>(k);
  }
  return std::nullopt;
}

// What the mission does and why. Points and polygons are in W (odometry).
struct PlannerState {
  int64_t utime = 0;
  int32_t seq = 0;
  std::string phase;  // "search", "approach", "centre", "scan", ...
  std::string text;   // one sentence
  MissionOutcome outcome = MissionOutcome::kRunning;
  double x_m = 0.0, y_m = 0.0, heading_rad = 0.0;
  std::optional<Eigen::Vector2d> p_WTarget_m;
  Eigen::Vector2d p_WWaypoint_m = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> safe_polygon_W_m;
  std::vector<Eigen::Vector2d> obstacles_W_m;
  int64_t scan_id = 0;
  int32_t stripe_index = 0;
  std::vector<GeonFinding> findings;  // geons that are done with
};

}  // namespace geon::sensor
