#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "base/status.h"
#include "sim/world.h"

namespace geon::cli {

// One world of the BARN kind: a course of some 10 m through cylinders.
struct BarnCourse {
  std::string id;
  std::string split;  // which part of the worlds it belongs to: dev, test, ...
  sim::World world;
  Eigen::Vector2d destination_W_m;  // in odometry: straight ahead of where the robot starts
  double shortest_m = 0.0;          // way there for a disc of 0.267 m
  double optimal_s = 0.0;           // that BARN's metric measures times by
};

// Reads the worlds of a folder, in the order of its worlds.csv.
//
// Source: Perille et al., "Benchmarking Metric Ground Navigation" (2020): the robot starts 3 m from
// the field's lower edge on its middle line, looks along it, and the goal lies on it
// `straight_len_m` ahead; time is measured by `opt_path_len_m` at 2 m/s.
//
// worlds.csv: world, n_cylinders, straight_len_m, opt_path_len_m, len_nomad_r0267, split;
// obstacles.csv: world, x_m, y_m, r_m; metres, further columns are left alone. The cylinders are as
// high as the pen's boards, and these stand round the field, but at least 1.5 m beyond the goal.
// Errors name file and line: what is missing, is no number, or does not fit together.
Result<std::vector<BarnCourse>> LoadBarnCourses(const std::filesystem::path& folder);

}  // namespace geon::cli
