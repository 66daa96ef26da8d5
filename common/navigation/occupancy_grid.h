#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/rigid_transform.h"
#include "navigation/floor_obstacles.h"
#include "navigation/ring_obstacles.h"
#include "sensor/base.h"

namespace geon::navigation {

// Evidence in log-odds: above 0 an obstacle, below 0 free floor.
struct OccupancyGridOptions {
  double cell_m = 0.05;
  double reach_m = 12.0;  // of the map from the origin of W, along both axes; what is farther is
                          // not kept

  // One floor picture, for what is at most `near_m` away; farther off it counts less, with the
  // square of the distance, as the camera's tilt moves far things more.
  double seen_obstacle_1 = 1.2;
  double seen_floor_1 = -0.7;
  double near_m = 1.5;
  double most_seen_1 = 3.0;
  // Floor is believed up to so much before an obstacle, or before the end of what was seen.
  double floor_margin_m = 0.08;

  // One firing of a sonar. Silence says little: a smooth surface met at a slant does not answer.
  double heard_1 = 0.9;
  double silent_1 = -0.35;
  double most_heard_1 = 1.8;
  double half_cone_rad = 0.14;     // in which silence counts as free
  double silence_reach_m = 2.0;    // and how far
  double silence_margin_m = 0.20;  // and how far before an echo
  // An echo may come from anywhere on an arc: of this half width, and so much nearer or farther.
  double half_arc_rad = 0.22;
  double arc_margin_m = 0.10;

  double felt_1 = 2.0;  // infrared and bumpers

  double occupied_1 = 0.6;       // from here on a cell is an obstacle ...
  double free_again_1 = 0.2;     // ... until it falls below this
  double surely_floor_1 = -0.5;  // seen so: echoes from there are of something else
  double seen_memory_s = 90.0;   // evidence falls to 1/e in this time: odometry drifts
  double heard_memory_s = 8.0;
  double felt_memory_s = 6.0;
  double doubt_s = 20.0;  // of what is bright

  std::optional<std::string> Validate() const;
};

// A cell of the map; (0, 0) has its corner at the origin of W.
struct GridCell {
  int x = 0;
  int y = 0;
  friend bool operator==(const GridCell&, const GridCell&) = default;
};

// Cells [first, last], both included.
struct GridWindow {
  GridCell first;
  GridCell last;
  int width() const { return last.x - first.x + 1; }
  int height() const { return last.y - first.y + 1; }
  size_t size() const { return static_cast<size_t>(width()) * static_cast<size_t>(height()); }
  bool Contains(GridCell cell) const {
    return cell.x >= first.x && cell.x <= last.x && cell.y >= first.y && cell.y <= last.y;
  }
  // Of a cell in it, row by row.
  size_t Index(GridCell cell) const {
    return static_cast<size_t>(cell.y - first.y) * static_cast<size_t>(width()) +
           static_cast<size_t>(cell.x - first.x);
  }
};

// A map of where obstacles are, in frame W, from all sensors that feel or see them.
//
// Source: Moravec and Elfes (1985), Thrun et al., "Probabilistic Robotics" (2005), ch. 9: evidence
// adds up as log-odds, free space from a sensor to what it met, an obstacle there.
//
// Deviations: the three kinds of sensor are kept apart and only their conclusions meet, for one
// must not erase what another knows better: what the floor camera saw stands whatever the sonars
// say; what they heard stands only where the camera has not seen floor. An echo comes from an arc:
// what the camera saw on it explains it; else it counts on the sensor's axis. A sonar's reading
// counts once, when it changes: each is up to a ring's round old. Every occupied cell remembers
// where in it the obstacle was met, so that gaps are not narrowed by the cells' size. Evidence
// fades to "unknown".
//
// Time is the caller's, in seconds, and must not run backwards. The map does not move with the
// robot; it must be cleared when odometry starts anew.
class OccupancyGrid {
 public:
  explicit OccupancyGrid(const OccupancyGridOptions& options);

  // One floor picture. Columns run from left to right as FloorObstacles gives them, frame R.
  void SeeFloor(double now_s, const geometry::RigidTransform& X_WR,
                std::span<const FloorColumn> columns);
  void Hear(double now_s, const sensor::SonarScan& scan, const RingOptions& rings);
  // Points of R that the infrared ring or a bumper met.
  void Feel(double now_s, const geometry::RigidTransform& X_WR,
            std::span<const Eigen::Vector2d> points_R_m);
  // Forgets what may be a mistake: all obstacles but those that the camera saw twice near by, and
  // those that were felt.
  void ForgetDoubtful();
  // What only the camera tells of and is brighter than the floor may be a lamp's image in it: takes
  // such obstacles off the map, and no new ones in, for `doubt_s` from `now_s` on. What is heard or
  // felt there stays. False, and nothing done, where there are none.
  bool DoubtBright(double now_s);
  void Clear();

  double cell_m() const { return options_.cell_m; }
  GridCell CellAt(const Eigen::Vector2d& p_W_m) const {
    // What std::floor says, which is a call where the processor need not have it.
    const auto floor = [](double value) {
      const auto towards_zero = static_cast<int>(value);
      return towards_zero - (value < towards_zero ? 1 : 0);
    };
    return {floor(p_W_m.x() / options_.cell_m), floor(p_W_m.y() / options_.cell_m)};
  }
  Eigen::Vector2d Middle(GridCell cell) const {
    return {(cell.x + 0.5) * options_.cell_m, (cell.y + 0.5) * options_.cell_m};
  }
  bool Covers(GridCell cell) const {
    return cell.x >= -half_ && cell.x < half_ && cell.y >= -half_ && cell.y < half_;
  }
  // Where in the cell an obstacle is; nothing where there is none, or off the map.
  std::optional<Eigen::Vector2d> ObstacleIn(GridCell cell) const;
  // Calls visit(cell, place) for all obstacles of a window, row by row.
  template <typename Visit>
  void VisitObstacles(const GridWindow& window, Visit visit) const;
  // The same for those that the floor camera sees and that are no lamp's image: it knows best where
  // they are.
  template <typename Visit>
  void VisitSeenObstacles(const GridWindow& window, Visit visit) const {
    VisitObstacles(window, [&](GridCell cell, const Eigen::Vector2d& at_W_m) {
      const Evidence& evidence = cells_[Index(cell)];
      if (evidence.seen_1 > options_.free_again_1 && !evidence.bright) visit(cell, at_W_m);
    });
  }
  // Whether the floor camera has ever looked there and its evidence is not forgotten.
  bool IsSeen(GridCell cell) const {
    constexpr float kForgotten_1 = 0.1F;
    return Covers(cell) && std::abs(cells_[Index(cell)].seen_1) > kForgotten_1;
  }
  // All obstacles within a square of half side `reach_m` round a place, into `points_W_m`.
  void ObstaclesNear(const Eigen::Vector2d& p_W_m, double reach_m,
                     std::vector<Eigen::Vector2d>* points_W_m) const;
  // The cells that anything is known of; nothing before the first evidence.
  std::optional<GridWindow> known() const;
  // Of all that is known, and of these places of W with `margin_m` round them.
  GridWindow WindowWith(std::span<const Eigen::Vector2d> places_W_m, double margin_m) const;
  // Grows whenever a cell becomes an obstacle or ceases to be one.
  int64_t revision() const { return revision_; }

 private:
  struct Evidence {
    float seen_1 = 0.0F;
    float heard_1 = 0.0F;
    float felt_1 = 0.0F;
    Eigen::Vector2f at_W_m = Eigen::Vector2f::Zero();  // where it was met, on average
    float met_1 = 0.0F;                                // the weight of that
    int64_t picture = 0;                               // the last, or firing, that told of it
    int64_t met_in = 0;                                // the last picture of an obstacle there
    bool bright = false;                               // what was seen there
  };
  Evidence* Touch(GridCell cell);  // is known of from now on
  Evidence* At(GridCell cell) { return &cells_[Index(cell)]; }
  size_t Index(GridCell cell) const {
    return static_cast<size_t>(cell.y + half_) * static_cast<size_t>(2 * half_) +
           static_cast<size_t>(cell.x + half_);
  }
  uint8_t& Occupied(const Evidence* evidence) {
    return occupied_[static_cast<size_t>(evidence - cells_.data())];
  }
  void Meet(const Eigen::Vector2d& p_W_m, double weight_1, Evidence* evidence);
  void Judge(Evidence* evidence);
  // An obstacle, of which this picture shows a neighbouring cell: a line of sight that grazes a
  // wall passes through cells that the wall is in.
  bool IsJustBeside(GridCell cell);
  void Fade(double now_s);
  template <typename Visit>
  void AlongRay(const Eigen::Vector2d& from_W_m, const Eigen::Vector2d& to_W_m, Visit visit);
  // Whether the camera saw what may have sent this echo, of a sonar at the robot's `distance_m`.
  bool IsExplained(const Eigen::Vector2d& center_W_m, double bearing_rad, double distance_m) const;
  void HearOne(const sensor::SonarScan& scan, int sensor, const RingOptions& rings);

  OccupancyGridOptions options_;
  int half_;  // cells from the origin to a side
  std::vector<Evidence> cells_;
  std::vector<uint8_t> occupied_;  // 1: by an obstacle; apart from the evidence, to be found fast
  GridWindow known_;
  bool any_known_ = false;
  double faded_s_ = 0.0;
  double doubting_until_s_ = -1.0;
  bool fading_ = false;
  int64_t pictures_ = 0;
  int64_t revision_ = 0;
  std::array<double, sensor::kSonarCount> last_range_m_{};
  bool heard_any_ = false;
};

template <typename Visit>
void OccupancyGrid::VisitObstacles(const GridWindow& window, Visit visit) const {
  if (!any_known_) return;
  const GridCell first{std::max(window.first.x, known_.first.x),
                       std::max(window.first.y, known_.first.y)};
  const GridCell last{std::min(window.last.x, known_.last.x),
                      std::min(window.last.y, known_.last.y)};
  if (first.x > last.x) return;
  for (int y = first.y; y <= last.y; ++y) {
    const uint8_t* const row = &occupied_[Index({first.x, y})];
    const uint8_t* const end = row + (last.x - first.x + 1);
    for (const uint8_t* at = row; at != end; ++at) {
      at = static_cast<const uint8_t*>(std::memchr(at, 1, static_cast<size_t>(end - at)));
      if (at == nullptr) break;
      const GridCell cell{first.x + static_cast<int>(at - row), y};
      visit(cell, Eigen::Vector2d(cells_[Index(cell)].at_W_m.template cast<double>()));
    }
  }
}

}  // namespace geon::navigation
