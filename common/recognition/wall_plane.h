#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "recognition/stripe_blocks.h"
#include "recognition/support_plane.h"

namespace geon::recognition {

// An upright plane beside or behind the target, frame L.
struct WallPlane {
  Eigen::Vector3d p_L_m;     // on it, amid its points
  Eigen::Vector3d normal_L;  // unit, towards the camera
  double sigma_m = 0.0;      // of the distances from it of its parts: how flat it is

  double Before(const Eigen::Vector3d& p_L) const { return normal_L.dot(p_L - p_L_m); }
};

// The wall that most of what stands upright beside the target belongs to; nothing when fewer than
// two stripes show it. What stands on `support` stands upright.
//
// Steps: each block of a horizontal stripe beside the target and above the support gives the
// upright plane through it; the one with most blocks on it is fitted to them by least squares.
//
// Source: ours; the thesis (5.1) leaves what is above the floor and within the region of interest
// to the target.
std::optional<WallPlane> FindWallPlane(std::span<const StripeBlock> blocks,
                                       const SupportPlane& support, const Eigen::Vector3d& eye_L_m);

}  // namespace geon::recognition
