#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace geon::recognition {

// A circular cylinder whose radius may grow along its axis.
struct Cone {
  Eigen::Vector3d p_L_m = Eigen::Vector3d::Zero();    // on the axis, level with the points' middle
  Eigen::Vector3d axis_L = Eigen::Vector3d::UnitZ();  // unit
  double radius_m = 0.0;                              // at p_L_m
  double slope_1 = 0.0;                               // radius gained per length along the axis
  double slope_sigma_1 = 0.0;  // standard deviation, from how far the points lie off the cone
  double misfit_1 = 1.0;       // mean over the points of min(1, (distance / tolerance)^2)
};

// A point with the surface's normal, outward.
struct OrientedPoint {
  Eigen::Vector3d p_L_m;
  Eigen::Vector3d normal_L;
};

// The cone that most of the points lie on. It starts from upright and from the axis that is at
// right angles to most of `oriented` (or along the rest, which lie on its ends), each improved by
// robust Gauss-Newton; points that lie on no side of it (flat ends, what is not round at all) count
// as far off, but do not bend it. `tolerance_m` is how far a point may lie off and still belong.
// misfit_1 is 1 when there are fewer than 12 points or no start converges.
//
// Source: Lukacs, Martin and Marshall, "Faithful least-squares fitting of spheres, cylinders, cones
// and tori", 1998, for the distance; Schnabel, Wahl and Klein, "Efficient RANSAC for point-cloud
// shape detection", 2007, for axes from pairs of normals (here all pairs); Tukey's biweight.
// Deviation: the cone is given by its radius and slope at the points' middle, so that a cylinder is
// no limit but slope 0.
Cone FitCone(std::span<const Eigen::Vector3d> points_m, std::span<const OrientedPoint> oriented,
             double tolerance_m);

}  // namespace geon::recognition
