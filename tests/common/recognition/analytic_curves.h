#pragma once

#include <Eigen/Core>
#include <cmath>
#include <random>
#include <vector>

#include "base/angles.h"

namespace geon::recognition {

// Curves at equal steps of arc length, walked as a profile is: convex ones turn clockwise.

// Straight pieces of equal length; at each joint the walk turns clockwise by the next angle.
inline std::vector<Eigen::Vector2d> PolylineCurve(double piece_m,
                                                  const std::vector<double>& turn_rad,
                                                  int samples) {
  std::vector<Eigen::Vector2d> curve_m;
  const double length_m = piece_m * static_cast<double>(turn_rad.size() + 1);
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();
  double heading_rad = 0.6;
  size_t piece = 0;
  for (int i = 0; i < samples; ++i) {
    const double s_m = length_m * i / (samples - 1);
    while (piece < turn_rad.size() && s_m > piece_m * static_cast<double>(piece + 1)) {
      corner += piece_m * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));
      heading_rad -= turn_rad[piece++];
    }
    const double rest_m = s_m - piece_m * static_cast<double>(piece);
    curve_m.push_back(corner +
                      rest_m * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad)));
  }
  return curve_m;
}

// A circular arc; a negative angle is concave.
inline std::vector<Eigen::Vector2d> ArcCurve(double radius_m, double angle_rad, int samples) {
  std::vector<Eigen::Vector2d> curve_m;
  const double sign = angle_rad < 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < samples; ++i) {
    const double a_rad = 0.5 * kPi + 0.5 * angle_rad - angle_rad * i / (samples - 1);
    curve_m.emplace_back(radius_m * std::cos(a_rad) * sign, radius_m * std::sin(a_rad) * sign);
  }
  return curve_m;
}

inline void AddNoise(double sigma_m, uint64_t seed, std::vector<Eigen::Vector2d>* curve_m) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> gauss(0.0, sigma_m);
  for (Eigen::Vector2d& p : *curve_m) p.y() += gauss(random);
}

}  // namespace geon::recognition
