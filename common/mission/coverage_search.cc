#include "mission/coverage_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

#include "base/angles.h"

namespace geon::mission {
namespace {

constexpr double kMargin_m = 1.0;        // of the window, beyond all that is known
constexpr double kThere_m = 0.1;         // arrived
constexpr int kLooksHere = 4;            // from one place
constexpr double kAlmost_1 = 0.7;        // as good as going elsewhere
constexpr double kGivenUp_m = 0.4;       // round a place that could not be reached
constexpr double kWeighEvery_s = 1.0;    // whether the place driven to is still worth it
constexpr double kWorthIt_1 = 0.4;       // of what it promised
constexpr double kPanReach_rad = 1.05;   // of the head, from straight ahead
constexpr double kLookRate_rad_s = 0.9;  // pictures five times a second overlap by half
constexpr double kMuch_1 = 0.3;          // of the area: by the floor camera, the robot must turn
constexpr double kSpeck_1 = 0.1;         // of the fullest bearing: not worth a longer turn
constexpr double kRow_1 = 0.8;           // of the picture's height that one look counts on
constexpr double kSettled_rad = 0.03;
constexpr double kLookPatience_s = 8.0;  // beyond what the turn should take
constexpr double kAimRange_m = 2.0;
constexpr double kFar_rad = -0.3;  // an elevation that shows the floor from 3 m on, and desks

// The elevation from which a picture as high as `row_rad` shows most of what the head is to see.
std::optional<double> BestElevation(const std::vector<navigation::Unlooked>& unlooked,
                                    double row_rad) {
  constexpr double kStep_rad = 0.02;
  std::map<int, double> area_by_step_m2;
  for (const navigation::Unlooked& each : unlooked) {
    if (each.by_floor_camera) continue;
    area_by_step_m2[static_cast<int>(std::floor(each.elevation_rad / kStep_rad))] += each.area_m2;
  }
  std::optional<double> best_rad;
  double most_m2 = 0.0;
  const int steps = static_cast<int>(row_rad / kStep_rad);
  for (const auto& [first, unused] : area_by_step_m2) {
    double sum_m2 = 0.0;
    for (auto each = area_by_step_m2.lower_bound(first);
         each != area_by_step_m2.end() && each->first < first + steps; ++each) {
      sum_m2 += each->second;
    }
    if (sum_m2 <= most_m2) continue;
    most_m2 = sum_m2;
    best_rad = (first + 0.5 * steps) * kStep_rad;
  }
  return best_rad;
}

// Without the bearings in which next to nothing is left.
std::vector<navigation::Unlooked> WithoutSpecks(const std::vector<navigation::Unlooked>& unlooked) {
  std::map<double, double> area_by_bearing_m2;
  double most_m2 = 0.0;
  for (const navigation::Unlooked& each : unlooked) {
    double& area_m2 = area_by_bearing_m2[each.bearing_W_rad];
    area_m2 += each.area_m2;
    most_m2 = std::max(most_m2, area_m2);
  }
  std::vector<navigation::Unlooked> kept;
  std::copy_if(unlooked.begin(), unlooked.end(), std::back_inserter(kept), [&](const auto& each) {
    return area_by_bearing_m2[each.bearing_W_rad] >= kSpeck_1 * most_m2;
  });
  return kept;
}

std::string AreaText(double area_m2) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f m2", area_m2);
  return text;
}

double HeadingOf(const Context& context) { return context.senses.base().heading_rad; }

// The head straight ahead, its camera at this elevation.
active_vision::HeadAngles AheadAt(const Context& context, double elevation_rad) {
  const Eigen::Vector3d axis_R = context.rig.ColorCameraPose(0.0, 0.0).linear().col(2);
  return context.senses.head_limits().Clamp({0.0, elevation_rad - std::asin(axis_R.z())});
}

}  // namespace

void CoverageSearch::Enter() {
  leg_ = Leg::kChoose;
  given_up_W_m_.clear();
  drove_ = false;
}

navigation::NextViewOptions CoverageSearch::ViewOptions(const Context& context) const {
  navigation::NextViewOptions options = context.options.looking.next_view;
  options.camera_height_m = context.rig.ColorCameraPose(0.0, 0.0).translation().z();
  options.turn_rate_rad_s = kLookRate_rad_s;
  return options;
}

Transition CoverageSearch::Step(Context* context) {
  switch (leg_) {
    case Leg::kChoose:
      return Choose(context);
    case Leg::kDrive:
      Drive(context);
      break;
    case Leg::kLook:
      StepLook(context);
      break;
  }
  return std::nullopt;
}

void CoverageSearch::WeighDrives(const Context& context) {
  const navigation::OccupancyGrid& map = *context.senses.map();
  const Eigen::Vector2d here_W_m = context.senses.X_WR().translation().head<2>();
  clearance_.Compute(map, map.WindowWith(std::array{here_W_m}, kMargin_m));
  // From where the robot is; where it stands too tight, from round about.
  std::vector<navigation::CostToGo::Goal> starts;
  constexpr int kAround = 6;
  const navigation::GridCell here = map.CellAt(here_W_m);
  for (int y = -kAround; y <= kAround; ++y) {
    for (int x = -kAround; x <= kAround; ++x) {
      const double away_m = std::hypot(x, y) * map.cell_m();
      if (away_m <= kAround * map.cell_m()) starts.push_back({{here.x + x, here.y + y}, away_m});
    }
  }
  if (!drive_) drive_.emplace(context.options.driving.cost_to_go);
  drive_->Compute(map, clearance_, starts);
  weighed_s_ = context.time_s;
}

std::optional<navigation::NextPlace> CoverageSearch::BestPlace(const Context& context) {
  WeighDrives(context);
  const auto is_given_up = [&](const Eigen::Vector2d& p_W_m) {
    return std::any_of(given_up_W_m_.begin(), given_up_W_m_.end(), [&](const auto& other_W_m) {
      return (p_W_m - other_W_m).norm() < kGivenUp_m;
    });
  };
  return navigation::NextPlaceToLookFrom(*context.senses.map(), context.coverage, clearance_,
                                         *drive_, is_given_up, ViewOptions(context));
}

bool CoverageSearch::IsStillWorthIt(const Context& context) {
  WeighDrives(context);
  const navigation::OccupancyGrid& map = *context.senses.map();
  if (!std::isfinite(drive_->At(map.CellAt(place_.place_W_m)))) return false;
  return navigation::AreaOf(navigation::UnlookedFrom(place_.place_W_m, map, context.coverage,
                                                     ViewOptions(context))) >=
         kWorthIt_1 * place_.area_m2;
}

Transition CoverageSearch::Choose(Context* context) {
  const Eigen::Vector2d here_W_m = context->senses.X_WR().translation().head<2>();
  leg_s_ = context->time_s;
  const auto next = BestPlace(*context);
  // The places that are weighed lie on a lattice, and the robot hardly ever on one of them.
  if ((here_W_m - looked_W_m_).norm() > kThere_m) looks_here_ = 0;
  navigation::NextViewOptions options = ViewOptions(*context);
  options.over_obstacles = !drove_;  // once is enough: farther on the robot sees behind them
  auto unlooked =
      navigation::UnlookedFrom(here_W_m, *context->senses.map(), context->coverage, options);
  const double here_m2_s = navigation::Utility(unlooked, 0.0, options);
  if (looks_here_ < kLooksHere && here_m2_s > 0.0 &&
      here_m2_s >= kAlmost_1 * (next ? next->utility_m2_s : 0.0)) {
    looked_W_m_ = here_W_m;
    ++looks_here_;
    StartLook(context, std::move(unlooked));
    return std::nullopt;
  }
  if (!next) {
    Next end{Phase::kDone,
             "there is no geon in the reachable pen: all that can be seen from where the robot "
             "can go was looked at"};
    end.outcome = sensor::MissionOutcome::kNoneFound;
    return end;
  }
  place_ = *next;
  drove_ = true;
  leg_ = Leg::kDrive;
  context->map_drive.Rest();
  return std::nullopt;
}

void CoverageSearch::Drive(Context* context) {
  context->text = "driving to where " + AreaText(place_.area_m2) + " can be looked at";
  const Eigen::Vector2d here_W_m = context->senses.X_WR().translation().head<2>();
  if ((place_.place_W_m - here_W_m).norm() < kThere_m) {
    // What cannot be seen from here now never will.
    given_up_W_m_.push_back(place_.place_W_m);
    StopDriving(context);
    return;
  }
  if (context->time_s - weighed_s_ > kWeighEvery_s && !IsStillWorthIt(*context)) {
    StopDriving(context);
    return;
  }
  context->head.Point(AheadAt(*context, kFar_rad));
  const MapDrive::Answer answer =
      context->map_drive.To(context->time_s, place_.place_W_m, &context->senses);
  context->wishes.velocity = answer.velocity;
  if (!answer.unreachable) return;
  given_up_W_m_.push_back(place_.place_W_m);
  StopDriving(context);
}

void CoverageSearch::StopDriving(Context* context) {
  leg_ = Leg::kChoose;
  context->map_drive.Rest();
}

void CoverageSearch::StartLook(Context* context, std::vector<navigation::Unlooked> unlooked) {
  leg_ = Leg::kLook;
  leg_s_ = context->time_s;
  at_start_ = false;
  turned_rad_ = 0.0;
  last_heading_rad_ = HeadingOf(*context);
  const geometry::PinholeCamera& camera = context->rig.color_camera;
  const double row_rad = kRow_1 * 2.0 * std::atan2(0.5 * camera.height_px, camera.fy_px);
  const auto elevation_rad = BestElevation(unlooked, row_rad);
  look_ = {};
  look_.elevation_rad = elevation_rad.value_or(kFar_rad);
  std::erase_if(unlooked, [&](const navigation::Unlooked& each) {
    return !each.by_floor_camera &&
           std::abs(each.elevation_rad - look_.elevation_rad) > 0.5 * row_rad;
  });
  look_.unlooked = std::move(unlooked);
  look_.area_m2 = navigation::AreaOf(look_.unlooked);

  const auto wanted = WithoutSpecks(look_.unlooked);
  const double by_floor_camera_m2 =
      std::accumulate(wanted.begin(), wanted.end(), 0.0, [](double sum, const auto& each) {
        return sum + (each.by_floor_camera ? each.area_m2 : 0.0);
      });
  const navigation::Arc arc = navigation::ArcOf(wanted);
  const double heading_rad = HeadingOf(*context);
  const double right_rad = WrapAngle(arc.first_rad - heading_rad);
  const double left_rad = right_rad + arc.span_rad;
  look_.by_head = by_floor_camera_m2 < kMuch_1 * look_.area_m2 && right_rad >= -kPanReach_rad &&
                  left_rad <= kPanReach_rad;
  // From the end that is nearer to where the gaze is now.
  const double gaze_rad = look_.by_head ? context->senses.ptu().pan_rad : 0.0;
  const bool from_right =
      std::abs(WrapAngle(right_rad - gaze_rad)) <= std::abs(WrapAngle(left_rad - gaze_rad));
  look_.from_W_rad = heading_rad + (from_right ? right_rad : left_rad);
  look_.over_rad = from_right ? arc.span_rad : -arc.span_rad;
}

void CoverageSearch::StepLook(Context* context) {
  context->text = (look_.by_head ? "looking with the head at " : "turning round to look at ") +
                  AreaText(look_.area_m2);
  if (context->time_s - leg_s_ >
      kLookPatience_s + (kPi + std::abs(look_.over_rad)) / kLookRate_rad_s) {
    EndLook(context);
    return;
  }
  look_.by_head ? TurnHead(context) : TurnRobot(context);
}

void CoverageSearch::TurnHead(Context* context) {
  const double camera_z_m = ViewOptions(*context).camera_height_m;
  const Eigen::Vector2d here_W_m = context->senses.X_WR().translation().head<2>();
  const auto aim = [&](double bearing_W_rad) {
    return AimAt(
        *context,
        here_W_m + kAimRange_m * Eigen::Vector2d(std::cos(bearing_W_rad), std::sin(bearing_W_rad)),
        camera_z_m + kAimRange_m * std::tan(look_.elevation_rad));
  };
  const auto to = aim(at_start_ ? look_.from_W_rad + look_.over_rad : look_.from_W_rad);
  if (!to) {
    EndLook(context);
    return;
  }
  context->head.Point(*to, kLookRate_rad_s);
  const auto& ptu = context->senses.ptu();
  if (std::abs(ptu.pan_rad - to->pan_rad) > kSettled_rad ||
      std::abs(ptu.tilt_rad - to->tilt_rad) > kSettled_rad) {
    return;
  }
  // A last picture from there, then on.
  if (!context->senses.head() || !Same(context->senses.head()->head, *to)) return;
  if (at_start_) {
    EndLook(context);
  } else {
    at_start_ = true;
  }
}

void CoverageSearch::TurnRobot(Context* context) {
  context->head.Point(AheadAt(*context, look_.elevation_rad));
  const double heading_rad = HeadingOf(*context);
  const double step_rad = WrapAngle(heading_rad - last_heading_rad_);
  last_heading_rad_ = heading_rad;
  if (!at_start_) {
    const double rest_rad = WrapAngle(look_.from_W_rad - heading_rad);
    at_start_ = std::abs(rest_rad) < 2.0 * kSettled_rad;
    context->wishes.velocity = {0.0, std::clamp(2.0 * rest_rad, -kLookRate_rad_s, kLookRate_rad_s)};
    return;
  }
  turned_rad_ += look_.over_rad < 0.0 ? -step_rad : step_rad;
  if (turned_rad_ >= std::abs(look_.over_rad)) {
    EndLook(context);
    return;
  }
  context->wishes.velocity = {0.0, look_.over_rad < 0.0 ? -kLookRate_rad_s : kLookRate_rad_s};
}

// What a look did not show cannot be seen from here, whatever the reason: once more is enough.
void CoverageSearch::EndLook(Context* context) {
  leg_ = Leg::kChoose;
  double left_m2 = 0.0;
  for (const navigation::Unlooked& each : look_.unlooked) {
    if (!context->coverage.IsLooked(each.plane, each.p_W_m)) left_m2 += each.area_m2;
  }
  if (left_m2 < 0.5 * look_.area_m2) return;
  for (const navigation::Unlooked& each : look_.unlooked) {
    context->coverage.Mark(each.plane, each.p_W_m);
  }
}

}  // namespace geon::mission
