#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/world.h"

namespace geon::cli {

// A run seen from above, in the pen's frame: what stands there and the way the robot took.
struct DrawnRun {
  int t = 0;
  Eigen::Vector2d pen_m = Eigen::Vector2d::Zero();
  std::vector<std::vector<Eigen::Vector2d>> outlines_m;  // of boxes and cylinders
  std::vector<Eigen::Vector2d> geons_m;
  std::vector<Eigen::Vector2d> path_m;
  std::string picture_uri;  // what the camera saw when it mattered, as a data URI; empty: nothing
};

DrawnRun DrawRun(int t, const sim::World& world, const std::vector<Eigen::Vector2d>& path_m);

// A page draws so many runs at most: the first of those that it is given.
inline constexpr size_t kMostDrawnRuns = 24;
void AddDrawnRun(DrawnRun run, std::vector<DrawnRun>* runs);

// Points of the world as results.json has them: [x, y].
nlohmann::json PointJson(const Eigen::Vector2d& p_m);
Eigen::Vector2d ParsePoint(const nlohmann::json& value);

// {t, pen_m, outlines_m, geons_m, path_m, picture}, the last only where there is one.
nlohmann::json ToJson(const DrawnRun& run);
DrawnRun ParseDrawnRun(const nlohmann::json& value);  // throws what nlohmann::json does

// The map as SVG of class names that kDrawnRunStyle knows. `stops_m` are numbered from 1.
std::string RunMap(const DrawnRun& run, const std::vector<Eigen::Vector2d>& stops_m = {});
extern const char* const kDrawnRunStyle;  // and a table of class `runs`

}  // namespace geon::cli
