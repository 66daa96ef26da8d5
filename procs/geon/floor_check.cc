#include "procs/geon/floor_check.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/angles.h"
#include "base/median.h"
#include "calibration/fit_floor.h"
#include "messaging/channels.h"
#include "messaging/codec.h"
#include "messaging/log_reader.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

using sensor::Laser;
using State = SetupCheck::State;

std::string Millimetres(double length_m) { return Fixed(1000.0 * length_m, 1) + " mm"; }

}  // namespace

FloorAgreement MeasureFloor(const std::vector<sensor::RangeProfile>& profiles,
                            const FloorCheckOptions& options) {
  FloorAgreement floor;
  std::set<int64_t> scans;
  std::vector<Eigen::Vector3d> points_L_m;
  std::vector<double> heights_m[2];
  for (const sensor::RangeProfile& profile : profiles) {
    scans.insert(profile.scan_id);
    for (const Eigen::Vector3d& p_L : profile.p_L_m) {
      if (std::abs(p_L.z()) > options.window_m) continue;
      points_L_m.push_back(p_L);
      heights_m[profile.laser == Laser::kVertical ? 1 : 0].push_back(p_L.z());
    }
  }
  floor.scans = static_cast<int>(scans.size());
  floor.horizontal_points = static_cast<int>(heights_m[0].size());
  floor.vertical_points = static_cast<int>(heights_m[1].size());
  floor.horizontal_m = Median(heights_m[0]);
  floor.vertical_m = Median(heights_m[1]);
  // As if L were where the head stands: only how the plane leans is asked for.
  const auto fit = calibration::FitFloorPoints(points_L_m, geometry::SensorRig());
  if (fit.ok()) {
    floor.leans_known = true;
    floor.pitch_rad = fit->pitch_rad;
    floor.roll_rad = fit->roll_rad;
  }
  return floor;
}

SetupCheck JudgeFloor(const FloorAgreement& floor, const FloorCheckOptions& options) {
  SetupCheck check{"floor stripe", State::kGood, ""};
  if (floor.horizontal_points < options.min_points && floor.vertical_points < options.min_points) {
    check.state = State::kNote;
    check.text = std::to_string(floor.scans) + " scans show no floor within " +
                 Millimetres(options.window_m) +
                 " of where it should be: record a scan with bare floor beside the geon; if there "
                 "was floor, the head was knocked: geon calibrate rig";
    return check;
  }
  check.text = "by " + std::to_string(floor.scans) + " scans the floor is " +
               Millimetres(floor.horizontal_m) + " high by the horizontal laser (" +
               std::to_string(floor.horizontal_points) + " points), " +
               Millimetres(floor.vertical_m) + " by the vertical (" +
               std::to_string(floor.vertical_points) + ")";
  if (floor.leans_known) {
    check.text += ", and leans " + Fixed(DegreesFromRadians(floor.pitch_rad), 2) +
                  " degrees forward, " + Fixed(DegreesFromRadians(floor.roll_rad), 2) +
                  " to the left";
  }
  const bool both =
      floor.horizontal_points >= options.min_points && floor.vertical_points >= options.min_points;
  const double apart_m = floor.horizontal_m - floor.vertical_m;
  const double middle_m =
      floor.horizontal_points >= options.min_points ? floor.horizontal_m : floor.vertical_m;
  if (both && std::abs(apart_m) > options.laser_m) {
    check.state = State::kBad;
    check.text += "; the lasers disagree by " + Millimetres(std::abs(apart_m)) +
                  ": one of them was turned; fasten it and geon calibrate rig (and lut)";
  } else if (std::abs(middle_m) > options.height_m) {
    check.state = State::kBad;
    check.text +=
        "; both lasers agree, so the head's height or tilt has changed: geon calibrate rig";
  } else if (floor.leans_known && std::hypot(floor.pitch_rad, floor.roll_rad) > options.slope_rad) {
    check.state = State::kBad;
    check.text += "; the head leans: level the robot, or geon calibrate rig";
  }
  return check;
}

Result<std::vector<sensor::RangeProfile>> FloorProfiles(const std::filesystem::path& file) {
  Result<messaging::LogReader> log = messaging::LogReader::Open(file);
  if (!log.ok()) return log.status();
  std::set<int64_t> on_floor;
  std::vector<sensor::RangeProfile> profiles;
  while (const std::optional<messaging::LogEvent> event = log->Next()) {
    if (event->channel == messaging::kScanPlan) {
      const auto plan = messaging::Decode<sensor::ScanPlan>(event->bytes);
      if (plan.ok() && plan->support_height_m == 0.0) on_floor.insert(plan->scan_id);
    } else if (event->channel == messaging::kRangeProfile) {
      auto profile = messaging::Decode<sensor::RangeProfile>(event->bytes);
      if (profile.ok() && profile->status == sensor::ProfileStatus::kOk) {
        profiles.push_back(*std::move(profile));
      }
    }
  }
  std::erase_if(profiles, [&](const sensor::RangeProfile& profile) {
    return on_floor.count(profile.scan_id) == 0;
  });
  return profiles;
}

}  // namespace geon::cli
