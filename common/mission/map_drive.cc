#include "mission/map_drive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/angles.h"
#include "navigation/safe_polygon.h"
#include "navigation/viewing_positions.h"
#include "navigation/waypoint.h"

namespace geon::mission {
namespace {

constexpr double kMapEvery_s = 0.3;  // at most so often, and when the map changed
constexpr double kSameTarget_m = 0.05;
constexpr double kBeyond_m = 1.0;   // of the window, beyond all that is known
constexpr double kNearer_m = 0.05;  // progress
constexpr double kWithin_s = 3.0;
constexpr double kInside_m = 0.04;       // of the stopping distance: half a cell's diagonal
constexpr double kRecovered_m = 0.5;     // moved: the next trouble is a new one
constexpr double kRing_s = 1.3;          // all sonars have fired
constexpr double kTurnRate_rad_s = 0.8;  // for the floor camera's pictures to overlap
constexpr double kStepBack_s = 3.0;

// Gaps look narrower from afar than they are: where nothing else leads on, the robot goes and looks
// whether one that seems a little too tight lets it pass. The safe polygon decides.
navigation::CostToGoOptions Tight(const DrivingOptions& options) {
  constexpr double kTight_1 = 0.85;  // of the body's radius
  navigation::CostToGoOptions tight = options.cost_to_go;
  tight.least_clearance_m =
      std::min(tight.least_clearance_m, kTight_1 * options.velocity.body_radius_m);
  return tight;
}

// Ways that the safe polygon is sure to leave open, however the obstacles beside them lie.
navigation::CostToGoOptions Wide(const DrivingOptions& options) {
  navigation::CostToGoOptions wide = options.cost_to_go;
  wide.least_clearance_m =
      std::max(wide.least_clearance_m, options.map_polygon.clearance_m + 0.5 * options.map.cell_m);
  wide.easy_clearance_m = std::max(wide.easy_clearance_m, 1.5 * wide.least_clearance_m);
  return wide;
}

// How far obstacles may lie from where the map has them: the first that leaves a way on counts.
constexpr double kDrifts_m[] = {0.05, 0.03, 0.0};
constexpr size_t kInsisting = 1;  // the first of them for a goal that has no other in its place

navigation::SafePolygonOptions Roomy(navigation::SafePolygonOptions polygon, double drift_m) {
  polygon.clearance_m += drift_m;
  return polygon;
}

}  // namespace

MapDrive::MapDrive(const MissionOptions& options)
    : options_(options.driving),
      wide_cost_(Wide(options.driving)),
      easy_cost_(options.driving.cost_to_go),
      tight_cost_(Tight(options.driving)) {}

void MapDrive::Rest() {
  follower_.Rest();
  polygon_R_ = {};
  mapped_W_m_.reset();
  started_ = recovering_ = false;
  recovery_ = Recovery::kNone;
}

MapDrive::Answer MapDrive::Drive(double now_s, const Goal& goal, Senses* senses) {
  goal_ = goal;
  own_m_ =
      goal.side_rad ? 0.0 : std::max(0.0, goal.stop_distance_m - options_.map_polygon.clearance_m);
  Map(now_s, *senses);
  const geometry::RigidTransform X_WR = senses->X_WR();
  const Eigen::Vector2d goal_R_m = geometry::OnGround(X_WR.inverse(), goal.p_W_m);
  bending_R_m_.clear();
  std::copy_if(senses->obstacles_R_m().begin(), senses->obstacles_R_m().end(),
               std::back_inserter(bending_R_m_),
               [&](const auto& p_m) { return (p_m - goal_R_m).norm() >= own_m_; });
  const navigation::OccupancyGrid& map = *senses->map();
  std::optional<Eigen::Vector2d> waypoint_R_m;
  for (const double drift_m : std::span(kDrifts_m).subspan(goal_.insists ? kInsisting : 0)) {
    polygon_R_ = navigation::SafePolygon(bending_R_m_, Roomy(options_.map_polygon, drift_m));
    waypoint_R_m = navigation::WaypointByCost(polygon_R_, X_WR, map, *cost_);
    squeezes_ = drift_m <= 0.0;
    if (waypoint_R_m) break;
  }
  if (recovering_) {
    if (auto answer = Recover(now_s, senses)) return *std::move(answer);
  }
  if ((X_WR.translation().head<2>() - recovered_W_m_).norm() > kRecovered_m) {
    recovery_ = Recovery::kNone;
  }
  const double cost_m = cost_->At(map.CellAt(X_WR.translation().head<2>()));
  if (!Progresses(now_s, cost_m)) {
    StartRecovery(now_s, *senses);
    return Recover(now_s, senses).value_or(Answer{});
  }
  if (!waypoint_R_m) {
    follower_.Rest();
    return {{}, "no way on is known", {}};
  }
  return {Careful(follower_.Go(now_s, *waypoint_R_m, senses->obstacles_R_m(), options_.velocity),
                  *senses),
          "",
          {}};
}

// Whether a picture showed the ground there.
bool MapDrive::IsKnown(const Eigen::Vector2d& p_R_m, const Senses& senses) const {
  // The camera sees no ground nearer than this, and what stands there reaches farther out.
  constexpr double kNearest_m = 0.375;
  const auto is_seen = [&](const Eigen::Vector2d& p_m) {
    const navigation::OccupancyGrid& map = *senses.map();
    return map.IsSeen(map.CellAt(geometry::OnGround(senses.X_WR(), p_m)));
  };
  const double distance_m = p_R_m.norm();
  return is_seen(p_R_m) || (distance_m < kNearest_m && is_seen(p_R_m * (kNearest_m / distance_m)));
}

// On the arc that the velocity leads along.
bool MapDrive::IsUnknownAhead(const navigation::DriveVelocity& velocity,
                              const Senses& senses) const {
  constexpr double kAhead_m = 0.15;
  constexpr double kBeside_m = 0.06;
  constexpr double kMost_per_m = 1.5;
  const double curvature_per_m =
      std::clamp(velocity.turn_rate_rad_s / velocity.speed_m_s, -kMost_per_m, kMost_per_m);
  const auto on_arc = [&](double along_m, double beside_m) -> Eigen::Vector2d {
    const double turn_rad = curvature_per_m * along_m;
    const double chord_rad = 0.5 * turn_rad;  // as long as the arc, nearly: it is short
    return along_m * Eigen::Vector2d(std::cos(chord_rad), std::sin(chord_rad)) +
           beside_m * Eigen::Vector2d(-std::sin(turn_rad), std::cos(turn_rad));
  };
  const double radius_m = options_.velocity.body_radius_m;
  const double cell_m = senses.map()->cell_m();
  for (double y_m = -radius_m - kBeside_m; y_m <= radius_m + kBeside_m; y_m += cell_m) {
    const double rim_m = std::sqrt(std::max(0.0, radius_m * radius_m - y_m * y_m));
    for (double x_m = rim_m + cell_m; x_m <= rim_m + kAhead_m; x_m += cell_m) {
      if (!IsKnown(on_arc(x_m, y_m), senses)) return true;
    }
  }
  return false;
}

navigation::DriveVelocity MapDrive::Careful(navigation::DriveVelocity velocity,
                                            const Senses& senses) const {
  constexpr double kSlow_m_s = 0.1;
  if (velocity.speed_m_s <= kSlow_m_s) return velocity;
  // What stands round here may have been forgotten.
  const bool forgot = recovery_ >= Recovery::kForget;
  if (forgot || squeezes_ || IsUnknownAhead(velocity, senses)) velocity.speed_m_s = kSlow_m_s;
  return velocity;
}

std::vector<navigation::CostToGo::Goal> MapDrive::GoalCells(
    const navigation::OccupancyGrid& map) const {
  if (goal_.stop_distance_m <= 0.0) return {{map.CellAt(goal_.p_W_m), 0.0}};
  navigation::ViewingOptions viewing;
  viewing.distance_m = goal_.stop_distance_m - kInside_m;
  viewing.side_rad = goal_.side_rad;
  const double own_m = goal_.stop_distance_m - options_.map_polygon.clearance_m;
  return navigation::ViewingPositions(map, clearance_, goal_.p_W_m, own_m, viewing);
}

void MapDrive::Map(double now_s, const Senses& senses) {
  const navigation::OccupancyGrid& map = *senses.map();
  const bool moved = !mapped_W_m_ || (*mapped_W_m_ - goal_.p_W_m).norm() > kSameTarget_m;
  if (!moved && (map.revision() == mapped_revision_ || now_s - mapped_s_ < kMapEvery_s)) return;
  mapped_W_m_ = goal_.p_W_m;
  mapped_revision_ = map.revision();
  mapped_s_ = now_s;
  const std::array<Eigen::Vector2d, 2> ends_W_m = {senses.X_WR().translation().head<2>(),
                                                   goal_.p_W_m};
  const navigation::GridCell here = map.CellAt(ends_W_m[0]);
  clearance_.Compute(map, map.WindowWith(ends_W_m, kBeyond_m), [&](const Eigen::Vector2d& p_W_m) {
    return (p_W_m - goal_.p_W_m).norm() < own_m_;
  });
  const auto goals = GoalCells(map);
  wide_cost_.Compute(map, clearance_, goals);
  cost_ = &wide_cost_;
  if (std::isfinite(wide_cost_.At(here))) return;
  easy_cost_.Compute(map, clearance_, goals);
  cost_ = &easy_cost_;
  if (std::isfinite(easy_cost_.At(here))) return;
  tight_cost_.Compute(map, clearance_, goals);
  cost_ = &tight_cost_;
}

bool MapDrive::Progresses(double now_s, double cost_m) {
  // A way that is longer than was thought is a new one to make progress on.
  constexpr double kNewWay_m = 0.15;
  if (!started_ || cost_m < best_cost_m_ - kNearer_m || cost_m > best_cost_m_ + kNewWay_m) {
    const bool better = !started_ || std::isfinite(cost_m) || std::isfinite(best_cost_m_);
    best_cost_m_ = cost_m;
    started_ = true;
    if (better) better_s_ = now_s;
  }
  if (!std::isfinite(cost_m)) return now_s - better_s_ <= 0.5 * kWithin_s;
  return now_s - better_s_ <= kWithin_s;
}

void MapDrive::StartRecovery(double now_s, const Senses& senses) {
  const Recovery last = goal_.insists ? Recovery::kStepBack : Recovery::kDoubtBright;
  recovery_ = recovery_ >= last ? Recovery::kGiveUp
                                : static_cast<Recovery>(static_cast<int>(recovery_) + 1);
  recovering_ = true;
  recovery_s_ = now_s;
  turned_rad_ = 0.0;
  last_heading_rad_ = senses.base().heading_rad;
  recovered_cost_m_ = best_cost_m_;
  recovered_W_m_ = senses.X_WR().translation().head<2>();
  follower_.Rest();
}

std::optional<MapDrive::Answer> MapDrive::Recover(double now_s, Senses* senses) {
  const auto end = [&]() -> std::optional<Answer> {
    recovering_ = started_ = false;
    return std::nullopt;
  };
  switch (recovery_) {
    case Recovery::kListen:
      if (now_s - recovery_s_ > kRing_s) return end();
      return Answer{{}, "no nearer: listening to all sonars again", {}};
    case Recovery::kForget:
      senses->ForgetDoubtfulObstacles();
      return end();
    case Recovery::kDoubtBright:
      if (senses->DoubtBrightObstacles(now_s)) return end();
      StartRecovery(now_s, *senses);
      return Recover(now_s, senses);
    case Recovery::kLookRound: {
      const double heading_rad = senses->base().heading_rad;
      turned_rad_ += WrapAngle(heading_rad - last_heading_rad_);
      last_heading_rad_ = heading_rad;
      if (turned_rad_ > 2.0 * kPi || now_s - recovery_s_ > 20.0) return end();
      return Answer{{0.0, kTurnRate_rad_s}, "no nearer: looking all round", {}};
    }
    case Recovery::kStepBack:
      if (now_s - recovery_s_ > kStepBack_s) return end();
      return Answer{navigation::Creep(-1.0, options_.back_off_m, options_.back_off_speed_m_s,
                                      senses->obstacles_R_m(), options_.velocity),
                    "no nearer: stepping back",
                    {}};
    case Recovery::kGiveUp:
      return Answer{{}, "", WhyUnreachable()};
    case Recovery::kNone:
      break;
  }
  return end();
}

std::string MapDrive::WhyUnreachable() const {
  if (std::isfinite(recovered_cost_m_)) {
    return "unreachable: the robot comes no nearer on the way that the map shows";
  }
  const bool place = goal_.stop_distance_m <= 0.0;
  return std::string("unreachable: obstacles close every way to ") +
         (place ? "the place" : "where the target can be seen");
}

}  // namespace geon::mission
