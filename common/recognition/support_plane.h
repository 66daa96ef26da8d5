#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "geometry/rigid_transform.h"
#include "recognition/stripe_blocks.h"

namespace geon::recognition {

// The plane that carries the target, as the scan's own points show it; frame L.
struct SupportPlane {
  Eigen::Vector3d p_L_m;     // on it, amid its points
  Eigen::Vector3d normal_L;  // unit, upward
  double sigma_m = 0.0;      // of the heights above it of its parts: how flat it is
  int points = 0;            // that lie on it

  double Above(const Eigen::Vector3d& p_L) const { return normal_L.dot(p_L - p_L_m); }
};

// Where the support lies: z = 0 in frame L, were head, wheels and table exact. Where it leans or
// lies off, support is taken for target and every slope of the target is wrong by as much. Nothing
// when fewer than 40 points lie on a plane that may be it, as on a scan whose support was cut away,
// or it is not flat.
//
// Steps: blocks that run level beside the target or at its foot count, those beside it alone if
// they are enough; planes through three of them are tried, each counting for the blocks on it and
// against those below it; the best is fitted to all blocks on it.
//
// Source: Torr and Davidson, "IMPSAC: synthesis of importance sampling and random sample
// consensus", 2003, for samples weighed with a prior; Holland and Welsch, "Robust regression using
// iteratively reweighted least-squares", 1977 (Tukey's biweight). The prior: the robot leans by 2
// degrees about the foot of its camera, where its height is known to 10 mm; sigmas. The thesis
// (5.1) trusts z = 0. Deviation: the samples are always the same ones.
//
// `foot_L_m`: where the target stands, within 3 cm, where that is known: what passes by it, or lies
// more than 1 m away, may carry something else.
std::optional<SupportPlane> FitSupportPlane(
    std::span<const StripeBlock> blocks,
    const std::optional<Eigen::Vector3d>& foot_L_m = std::nullopt);

// Takes points of frame L into frame S, level on the support: z = 0 on it, the heading kept.
geometry::RigidTransform LevelOn(const SupportPlane& plane);

}  // namespace geon::recognition
