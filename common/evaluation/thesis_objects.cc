#include "evaluation/thesis_objects.h"

#include "base/angles.h"

namespace geon::evaluation {
namespace {

constexpr double Degrees(double angle_deg) { return RadiansFromDegrees(angle_deg); }

}  // namespace

std::vector<ExperimentObject> ThesisObjects() {
  using enum GeonLabel;
  return {
      // Larger end and height; how far it tapers: upright, lying, inverted.
      {"1", {kTaperedCuboid, {0.170, 0.170, 0.180}, 0.60}, {1, 2, 3}},
      {"2", {kTaperedCuboid, {0.160, 0.160, 0.180}, 0.40}, {1, 2, 3}},
      {"3", {kTaperedCuboid, {0.150, 0.150, 0.180}, 0.25}, {1, 2, 3}},
      {"4", {kTaperedCuboid, {0.140, 0.140, 0.180}, 0.15}, {1, 2, 3}},
      {"1", {kTaperedCylinder, {0.170, 0.170, 0.180}, 0.60}, {1, 2, 3}},
      {"2", {kTaperedCylinder, {0.160, 0.160, 0.180}, 0.40}, {1, 2, 3}},
      {"3", {kTaperedCylinder, {0.150, 0.150, 0.180}, 0.25}, {1, 2, 3}},
      {"4", {kTaperedCylinder, {0.140, 0.140, 0.180}, 0.15}, {1, 2, 3}},
      // Thickness, width, length along the axis; bend: on its side, arch "n", arch "u".
      {"1", {kBentCuboid, {0.060, 0.070, 0.300}, 0.0, Degrees(150)}, {1, 2, 3}},
      {"2", {kBentCuboid, {0.060, 0.070, 0.290}, 0.0, Degrees(110)}, {1, 2, 3}},
      {"3", {kBentCuboid, {0.060, 0.070, 0.270}, 0.0, Degrees(80)}, {1, 2, 3}},
      {"4", {kBentCuboid, {0.060, 0.070, 0.250}, 0.0, Degrees(55)}, {1, 2, 3}},
      {"1", {kBentCylinder, {0.070, 0.070, 0.280}, 0.0, Degrees(180)}, {1, 2}},
      {"2", {kBentCylinder, {0.070, 0.070, 0.280}, 0.0, Degrees(120)}, {1}},
      {"3", {kBentCylinder, {0.070, 0.070, 0.270}, 0.0, Degrees(85)}, {1}},
      {"4", {kBentCylinder, {0.070, 0.070, 0.250}, 0.0, Degrees(60)}, {1}},
      // A cube looks the same from all sides; the others stand and lie.
      {"1", {kCuboid, {0.150, 0.150, 0.150}}, {1}},
      {"2", {kCuboid, {0.130, 0.130, 0.180}}, {1, 2}},
      {"3", {kCuboid, {0.110, 0.110, 0.200}}, {1, 2}},
      {"4", {kCuboid, {0.090, 0.090, 0.215}}, {1, 2}},
      {"1", {kCylinder, {0.160, 0.160, 0.130}}, {1, 2}},
      {"2", {kCylinder, {0.140, 0.140, 0.160}}, {1, 2}},
      {"3", {kCylinder, {0.120, 0.120, 0.190}}, {1, 2}},
      {"4", {kCylinder, {0.100, 0.100, 0.215}}, {1, 2}},
      // A sphere, then longer ones that lie.
      {"1", {kEllipsoid, {0.170, 0.170, 0.170}}, {1}},
      {"2", {kEllipsoid, {0.190, 0.150, 0.150}}, {1}},
      {"3", {kEllipsoid, {0.215, 0.125, 0.125}}, {1}},
      {"4", {kEllipsoid, {0.240, 0.100, 0.100}}, {1}},
  };
}

}  // namespace geon::evaluation
