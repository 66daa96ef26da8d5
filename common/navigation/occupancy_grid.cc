#include "navigation/occupancy_grid.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::navigation {
namespace {

constexpr double kFadeEvery_s = 0.5;

float Added(float evidence_1, double more_1, double most_1) {
  return static_cast<float>(std::clamp(evidence_1 + more_1, -most_1, most_1));
}

}  // namespace

std::optional<std::string> OccupancyGridOptions::Validate() const {
  if (!(cell_m > 0.0 && reach_m > cell_m)) return "cell_m must be positive and below reach_m";
  if (reach_m / cell_m > 2000.0) return "reach_m / cell_m must not be above 2000";
  if (!(seen_obstacle_1 > 0.0 && heard_1 > 0.0 && felt_1 > 0.0)) {
    return "evidence for an obstacle must be positive";
  }
  if (!(seen_floor_1 < 0.0 && silent_1 < 0.0)) return "evidence for floor must be negative";
  if (!(most_seen_1 > occupied_1 && most_heard_1 > occupied_1 && occupied_1 > free_again_1)) {
    return "the most evidence must be above occupied_1, and that above free_again_1";
  }
  if (!(half_arc_rad > 0.0 && arc_margin_m >= 0.0)) {
    return "half_arc_rad must be positive, arc_margin_m not negative";
  }
  if (!(near_m > 0.0 && floor_margin_m >= 0.0 && silence_margin_m >= 0.0)) {
    return "near_m must be positive, margins not negative";
  }
  if (!(seen_memory_s > 0.0 && heard_memory_s > 0.0 && felt_memory_s > 0.0)) {
    return "memory times must be positive";
  }
  if (!(doubt_s >= 0.0)) return "doubt_s must not be negative";
  return std::nullopt;
}

OccupancyGrid::OccupancyGrid(const OccupancyGridOptions& options) : options_(options) {
  const std::optional<std::string> error = options.Validate();
  Require(!error, "OccupancyGridOptions: " + error.value_or(""));
  half_ = static_cast<int>(std::ceil(options.reach_m / options.cell_m));
  cells_.resize(static_cast<size_t>(4) * static_cast<size_t>(half_) * static_cast<size_t>(half_));
  occupied_.resize(cells_.size(), 0);
}

void OccupancyGrid::Clear() {
  if (any_known_) {
    for (int y = known_.first.y; y <= known_.last.y; ++y) {
      for (int x = known_.first.x; x <= known_.last.x; ++x) {
        *At({x, y}) = {};
        occupied_[Index({x, y})] = 0;
      }
    }
  }
  any_known_ = heard_any_ = false;
  doubting_until_s_ = -1.0;
  ++revision_;
}

GridWindow OccupancyGrid::WindowWith(std::span<const Eigen::Vector2d> places_W_m,
                                     double margin_m) const {
  Require(!places_W_m.empty(), "OccupancyGrid::WindowWith: a place is needed");
  const Eigen::Vector2d margin(margin_m, margin_m);
  GridWindow window =
      known().value_or(GridWindow{CellAt(places_W_m.front()), CellAt(places_W_m.front())});
  const auto include = [&](GridCell cell) {
    window.first = {std::min(window.first.x, cell.x), std::min(window.first.y, cell.y)};
    window.last = {std::max(window.last.x, cell.x), std::max(window.last.y, cell.y)};
  };
  for (const Eigen::Vector2d& place_W_m : places_W_m) {
    include(CellAt(place_W_m - margin));
    include(CellAt(place_W_m + margin));
  }
  return window;
}

std::optional<GridWindow> OccupancyGrid::known() const {
  return any_known_ ? std::optional(known_) : std::nullopt;
}

std::optional<Eigen::Vector2d> OccupancyGrid::ObstacleIn(GridCell cell) const {
  if (!Covers(cell) || occupied_[Index(cell)] == 0) return std::nullopt;
  return cells_[Index(cell)].at_W_m.cast<double>();
}

void OccupancyGrid::ObstaclesNear(const Eigen::Vector2d& p_W_m, double reach_m,
                                  std::vector<Eigen::Vector2d>* points_W_m) const {
  points_W_m->clear();
  const Eigen::Vector2d reach(reach_m, reach_m);
  VisitObstacles({CellAt(p_W_m - reach), CellAt(p_W_m + reach)},
                 [&](GridCell, const Eigen::Vector2d& at_W_m) { points_W_m->push_back(at_W_m); });
}

// What follows from all that is known of a cell.
void OccupancyGrid::Judge(Evidence* evidence) {
  uint8_t& was_occupied = Occupied(evidence);
  const double limit_1 = was_occupied != 0 ? options_.free_again_1 : options_.occupied_1;
  const bool heard = evidence->heard_1 > limit_1 && evidence->seen_1 > options_.surely_floor_1;
  const uint8_t occupied = evidence->seen_1 > limit_1 || evidence->felt_1 > limit_1 || heard;
  if (occupied == was_occupied) return;
  was_occupied = occupied;
  ++revision_;
}

// Remembers where an obstacle was met: the mean of these places, which what is seen from near soon
// outweighs.
void OccupancyGrid::Meet(const Eigen::Vector2d& p_W_m, double weight_1, Evidence* evidence) {
  constexpr float kMost_1 = 2.0F;
  const Eigen::Vector2f p_m = p_W_m.cast<float>();
  const auto more_1 = static_cast<float>(weight_1);
  if (Occupied(evidence) == 0) evidence->met_1 = 0.0F;
  evidence->met_1 = std::min(evidence->met_1 + more_1, kMost_1);
  evidence->at_W_m += more_1 / evidence->met_1 * (p_m - evidence->at_W_m);
}

template <typename Visit>
void OccupancyGrid::AlongRay(const Eigen::Vector2d& from_W_m, const Eigen::Vector2d& to_W_m,
                             Visit visit) {
  const double length_m = (to_W_m - from_W_m).norm();
  const int steps = static_cast<int>(std::ceil(length_m / (0.7 * options_.cell_m)));
  GridCell last{INT32_MIN, 0};
  for (int i = 0; i <= steps; ++i) {
    const GridCell cell = CellAt(from_W_m + (steps == 0 ? 0.0 : static_cast<double>(i) / steps) *
                                                (to_W_m - from_W_m));
    if (cell == last || !Covers(cell)) continue;
    last = cell;
    visit(cell);
  }
}

bool OccupancyGrid::IsJustBeside(GridCell cell) {
  if (Occupied(At(cell)) == 0) return false;
  for (int y = cell.y - 1; y <= cell.y + 1; ++y) {
    for (int x = cell.x - 1; x <= cell.x + 1; ++x) {
      if (Covers({x, y}) && At({x, y})->met_in == pictures_) return true;
    }
  }
  return false;
}

void OccupancyGrid::SeeFloor(double now_s, const geometry::RigidTransform& X_WR,
                             std::span<const FloorColumn> columns) {
  Fade(now_s);
  ++pictures_;
  const auto weight = [&](double distance_m) {
    const double near_1 = options_.near_m / std::max(distance_m, options_.near_m);
    return near_1 * near_1;
  };
  // Obstacles first: a cell that one of them is in is not floor, whatever the next column says.
  for (const FloorColumn& column : columns) {
    // Without any floor below it, an obstacle is nearer than the picture shows: nobody knows where.
    if (!column.obstacle || column.begin_R_m == column.end_R_m) continue;
    if (column.bright && now_s < doubting_until_s_) continue;
    const Eigen::Vector2d p_W_m = geometry::OnGround(X_WR, column.end_R_m);
    const GridCell cell = CellAt(p_W_m);
    if (!Covers(cell)) continue;
    Evidence* evidence = Touch(cell);
    if (evidence->picture == pictures_) continue;
    evidence->picture = evidence->met_in = pictures_;
    const double weight_1 = weight(column.end_R_m.norm());
    Meet(p_W_m, weight_1, evidence);
    evidence->bright = column.bright;
    evidence->seen_1 =
        Added(evidence->seen_1, options_.seen_obstacle_1 * weight_1, options_.most_seen_1);
    Judge(evidence);
  }
  for (const FloorColumn& column : columns) {
    const Eigen::Vector2d along_m = column.end_R_m - column.begin_R_m;
    const double length_m = along_m.norm() - options_.floor_margin_m;
    if (length_m <= 0.0) continue;
    const Eigen::Vector2d end_R_m = column.begin_R_m + along_m * (length_m / along_m.norm());
    AlongRay(geometry::OnGround(X_WR, column.begin_R_m), geometry::OnGround(X_WR, end_R_m),
             [&](GridCell cell) {
               if (At(cell)->picture == pictures_ || IsJustBeside(cell)) return;
               Evidence* evidence = Touch(cell);
               evidence->picture = pictures_;
               const double distance_m = (Middle(cell) - X_WR.translation().head<2>()).norm();
               evidence->seen_1 =
                   Added(evidence->seen_1, options_.seen_floor_1 * weight(distance_m),
                         options_.most_seen_1);
               Judge(evidence);
             });
  }
}

void OccupancyGrid::Hear(double now_s, const sensor::SonarScan& scan, const RingOptions& rings) {
  Fade(now_s);
  for (int i = 0; i < sensor::kSonarCount; ++i) {
    const double range_m = scan.range_m[static_cast<size_t>(i)];
    const double last_m = last_range_m_[static_cast<size_t>(i)];
    last_range_m_[static_cast<size_t>(i)] = range_m;
    const bool same = range_m == last_m || (std::isnan(range_m) && std::isnan(last_m));
    if (!heard_any_ || !same) HearOne(scan, i, rings);
  }
  heard_any_ = true;
}

bool OccupancyGrid::IsExplained(const Eigen::Vector2d& center_W_m, double bearing_rad,
                                double distance_m) const {
  const double step_rad = options_.cell_m / distance_m;
  for (double from_axis_rad = -options_.half_arc_rad; from_axis_rad <= options_.half_arc_rad;
       from_axis_rad += step_rad) {
    const double angle_rad = bearing_rad + from_axis_rad;
    const Eigen::Vector2d along(std::cos(angle_rad), std::sin(angle_rad));
    for (double off_m = -options_.arc_margin_m; off_m <= options_.arc_margin_m;
         off_m += options_.cell_m) {
      const GridCell cell = CellAt(center_W_m + (distance_m + off_m) * along);
      if (Covers(cell) && cells_[Index(cell)].seen_1 > options_.occupied_1) return true;
    }
  }
  return false;
}

void OccupancyGrid::HearOne(const sensor::SonarScan& scan, int sensor, const RingOptions& rings) {
  const double range_m = scan.range_m[static_cast<size_t>(sensor)];
  const bool echo = std::isfinite(range_m);
  const double bearing_rad = scan.heading_rad + 2.0 * kPi * sensor / sensor::kSonarCount;
  const Eigen::Vector2d center_W_m(scan.x_m, scan.y_m);
  const auto place = [&](double from_axis_rad, double distance_m) -> Eigen::Vector2d {
    const double angle_rad = bearing_rad + from_axis_rad;
    return center_W_m + distance_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
  };
  const double near_m = rings.sonar_radius_m;
  const double silent_m =
      std::min(echo ? range_m - options_.silence_margin_m : options_.silence_reach_m,
               options_.silence_reach_m);
  // Nearer than its blanking distance a sonar hears nothing of the first echo.
  ++pictures_;
  if (silent_m > rings.sonar_min_m) {
    for (const double from_axis_1 : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const double from_axis_rad = from_axis_1 * options_.half_cone_rad;
      AlongRay(place(from_axis_rad, near_m + rings.sonar_min_m),
               place(from_axis_rad, near_m + silent_m), [&](GridCell cell) {
                 if (At(cell)->picture == pictures_) return;
                 Evidence* evidence = Touch(cell);
                 evidence->picture = pictures_;
                 evidence->heard_1 =
                     Added(evidence->heard_1, options_.silent_1, options_.most_heard_1);
                 Judge(evidence);
               });
    }
  }
  if (!echo || range_m > rings.sonar_max_m) return;
  // At its blanking distance a sonar does not say how near it is.
  if (range_m > rings.sonar_min_m && IsExplained(center_W_m, bearing_rad, near_m + range_m)) return;
  const Eigen::Vector2d p_W_m = place(0.0, near_m + std::max(range_m, rings.sonar_min_m));
  const GridCell cell = CellAt(p_W_m);
  if (!Covers(cell)) return;
  Evidence* evidence = Touch(cell);
  if (evidence->seen_1 < options_.free_again_1) Meet(p_W_m, 1.0, evidence);
  evidence->heard_1 = std::max(evidence->heard_1, 0.0F);
  evidence->heard_1 = Added(evidence->heard_1, options_.heard_1, options_.most_heard_1);
  Judge(evidence);
}

void OccupancyGrid::Feel(double now_s, const geometry::RigidTransform& X_WR,
                         std::span<const Eigen::Vector2d> points_R_m) {
  Fade(now_s);
  for (const Eigen::Vector2d& p_R_m : points_R_m) {
    const Eigen::Vector2d p_W_m = geometry::OnGround(X_WR, p_R_m);
    const GridCell cell = CellAt(p_W_m);
    if (!Covers(cell)) continue;
    Evidence* evidence = Touch(cell);
    if (evidence->seen_1 < options_.free_again_1) Meet(p_W_m, 1.0, evidence);
    evidence->felt_1 = static_cast<float>(options_.felt_1);
    Judge(evidence);
  }
}

void OccupancyGrid::Fade(double now_s) {
  if (!fading_) {
    fading_ = true;
    faded_s_ = now_s;
  }
  const double step_s = now_s - faded_s_;
  if (step_s < kFadeEvery_s) return;
  faded_s_ = now_s;
  if (!any_known_) return;
  const auto kept = [&](double memory_s) {
    return static_cast<float>(std::exp(-step_s / memory_s));
  };
  const float seen_1 = kept(options_.seen_memory_s);
  const float heard_1 = kept(options_.heard_memory_s);
  const float felt_1 = kept(options_.felt_memory_s);
  for (int y = known_.first.y; y <= known_.last.y; ++y) {
    for (int x = known_.first.x; x <= known_.last.x; ++x) {
      Evidence* evidence = At(GridCell{x, y});
      evidence->seen_1 *= seen_1;
      evidence->heard_1 *= heard_1;
      evidence->felt_1 *= felt_1;
      if (Occupied(evidence) != 0) Judge(evidence);
    }
  }
}

void OccupancyGrid::ForgetDoubtful() {
  if (!any_known_) return;
  constexpr float kFirm_1 = 2.0F;  // two pictures of one obstacle, near by
  for (int y = known_.first.y; y <= known_.last.y; ++y) {
    for (int x = known_.first.x; x <= known_.last.x; ++x) {
      Evidence* evidence = At(GridCell{x, y});
      evidence->heard_1 = std::min(evidence->heard_1, 0.0F);
      if (evidence->seen_1 < kFirm_1) evidence->seen_1 = std::min(evidence->seen_1, 0.0F);
      if (Occupied(evidence) != 0) Judge(evidence);
    }
  }
}

bool OccupancyGrid::DoubtBright(double now_s) {
  if (!any_known_) return false;
  bool any = false;
  for (int y = known_.first.y; y <= known_.last.y; ++y) {
    for (int x = known_.first.x; x <= known_.last.x; ++x) {
      Evidence* evidence = At(GridCell{x, y});
      if (!evidence->bright || evidence->seen_1 <= 0.0F) continue;
      any = any || Occupied(evidence) != 0;
      evidence->seen_1 = 0.0F;
      Judge(evidence);
    }
  }
  if (any) doubting_until_s_ = now_s + options_.doubt_s;
  return any;
}

OccupancyGrid::Evidence* OccupancyGrid::Touch(GridCell cell) {
  if (!any_known_) known_ = {cell, cell};
  any_known_ = true;
  known_.first = {std::min(known_.first.x, cell.x), std::min(known_.first.y, cell.y)};
  known_.last = {std::max(known_.last.x, cell.x), std::max(known_.last.y, cell.y)};
  return At(cell);
}

}  // namespace geon::navigation
