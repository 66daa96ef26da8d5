#pragma once

#include <cmath>
#include <numbers>

namespace geon {

inline constexpr double kPi = std::numbers::pi;

constexpr double RadiansFromDegrees(double angle_deg) { return angle_deg * kPi / 180.0; }
constexpr double DegreesFromRadians(double angle_rad) { return angle_rad * 180.0 / kPi; }

// The same direction in [-pi, pi].
inline double WrapAngle(double angle_rad) { return std::remainder(angle_rad, 2.0 * kPi); }

}  // namespace geon
