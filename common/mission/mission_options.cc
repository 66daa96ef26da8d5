#include "mission/mission_options.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace geon::mission {

namespace {

bool Fail(std::string* error, const std::string& rule) {
  if (error != nullptr) *error = rule;
  return false;
}

bool AllPositive(std::initializer_list<double> values) {
  return std::all_of(values.begin(), values.end(),
                     [](double value) { return std::isfinite(value) && value > 0.0; });
}

bool IsArea(const active_vision::SearchOptions& area) {
  return area.pan_min_rad < area.pan_max_rad && area.tilt_min_rad < area.tilt_max_rad &&
         area.pan_overlap_1 > 0.0 && area.pan_overlap_1 < 1.0 && area.tilt_overlap_1 > 0.0 &&
         area.tilt_overlap_1 < 1.0;
}

}  // namespace

std::string_view ToString(ScanMode mode) { return mode == ScanMode::kSweep ? "sweep" : "stop"; }

std::optional<ScanMode> ScanModeFromString(std::string_view name) {
  for (const ScanMode mode : {ScanMode::kStop, ScanMode::kSweep}) {
    if (name == ToString(mode)) return mode;
  }
  return std::nullopt;
}

std::string_view ToString(PlannerKind planner) {
  return planner == PlannerKind::kMap ? "map" : "thesis";
}

std::optional<PlannerKind> PlannerKindFromString(std::string_view name) {
  for (const PlannerKind planner : {PlannerKind::kThesis, PlannerKind::kMap}) {
    if (name == ToString(planner)) return planner;
  }
  return std::nullopt;
}

bool SeeingOptions::IsValid(std::string* error) const {
  for (const auto& attention : {head, floor}) {
    if (const auto wrong = attention.Validate()) return Fail(error, *wrong);
  }
  if (!AllPositive({exposure_s, still_rad})) {
    return Fail(error, "exposure_s and still_rad must be positive");
  }
  return floor_model.IsValid(error) && floor_obstacles.IsValid(error);
}

bool DrivingOptions::IsValid(std::string* error) const {
  if (!AllPositive(
          {wander_s, wander_min_move_m, back_off_m, back_off_speed_m_s, progress_m, progress_s})) {
    return Fail(error, "distances, speeds and times of driving must be positive");
  }
  for (const auto& polygon : {safe_polygon, map_polygon}) {
    if (polygon.clearance_m - polygon.slack_m <= velocity.body_radius_m) {
      return Fail(error, "clearance_m - slack_m must be greater than the robot's radius");
    }
  }
  for (const auto& wrong : {map.Validate(), localizer.Validate(), cost_to_go.Validate()}) {
    if (wrong) return Fail(error, *wrong);
  }
  return safe_polygon.IsValid(error) && map_polygon.IsValid(error) && velocity.IsValid(error) &&
         rings.IsValid(error) && memory.IsValid(error);
}

bool LookingOptions::IsValid(std::string* error) const {
  if (support_heights_m.empty()) return Fail(error, "support_heights_m must name a height");
  if (!std::all_of(support_heights_m.begin(), support_heights_m.end(),
                   [](double height_m) { return height_m >= 0.0 && height_m < 1.1; })) {
    return Fail(error, "support_heights_m must lie between 0 and 1.1, below the head");
  }
  if (!(stop_distance_m >= 0.7 && stop_distance_m <= 2.0)) {
    return Fail(error, "stop_distance_m must lie between 0.7 and 2.0");
  }
  if (!AllPositive(
          {stop_tolerance_m, min_range_m, max_target_distance_m, sector_rad, settle_s, sweep_s}) ||
      !(max_range_m > min_range_m)) {
    return Fail(error, "distances, angles and times of looking must be positive, min < max range");
  }
  if (!IsArea(sweep) || !IsArea(near)) return Fail(error, "a sweep must have min below max");
  if (centering_steps < 1 || lost_looks < 1) {
    return Fail(error, "centering_steps and lost_looks must be at least 1");
  }
  return true;
}

bool PatienceOptions::IsValid(std::string* error) const {
  if (!AllPositive({mission_s, device_s, stale_s, image_s, stripe_s, verdict_s})) {
    return Fail(error, "time limits must be positive");
  }
  if (stripe_attempts < 1 || min_stripes < 1 || min_stripes > 6 || scans < 1 || views < 1 ||
      back_offs < 0 || traps < 0 || bumps < 0 || losses < 0) {
    return Fail(
        error, "attempts, scans and views at least 1, min_stripes 1..6, other counts not negative");
  }
  return true;
}

bool MissionOptions::IsValid(std::string* error) const {
  if (!seeing.IsValid(error) || !driving.IsValid(error) || !looking.IsValid(error) ||
      !patience.IsValid(error)) {
    return false;
  }
  // The target itself is an obstacle; the place to stop must lie clear of it.
  if (looking.stop_distance_m <= driving.safe_polygon.clearance_m) {
    return Fail(error, "stop_distance_m must be greater than clearance_m");
  }
  if (destination_W_m) {
    // The map must hold the robot there, and something of what stands round about.
    constexpr double kBeyond_m = 1.0;
    const double most_m = driving.map.reach_m - kBeyond_m;
    if (!destination_W_m->allFinite() || destination_W_m->cwiseAbs().maxCoeff() > most_m) {
      return Fail(error, "the destination must lie within " + std::to_string(most_m).substr(0, 4) +
                             " m of where odometry started, along both axes");
    }
  }
  return true;
}

}  // namespace geon::mission
