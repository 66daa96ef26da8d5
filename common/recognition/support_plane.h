#pragma once

#include <Eigen/Core>
#include <optional>

#include "geometry/rigid_transform.h"
#include "recognition/remove_background.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// The plane that carries the target, as the scan's own points show it; frame L.
struct SupportPlane {
  Eigen::Vector3d p_L_m;     // on it, amid its points
  Eigen::Vector3d normal_L;  // unit, upward
  double sigma_m = 0.0;      // of its points' heights above it
  int points = 0;            // that lie on it
};

// Where the support lies: z = 0 in frame L, were head, wheels and table exact. Where it leans or
// lies off, support is taken for target and every slope of the target is wrong by as much. Nothing
// when fewer than 40 points lie near z = 0, as on a scan whose support was cut away.
//
// Source: Holland and Welsch, "Robust regression using iteratively reweighted least-squares", 1977
// (Tukey's biweight), with z = 0 as a prior of 3 degrees and 10 mm; the thesis (5.1) trusts z = 0.
// Points outside the region of interest count, and those within it that lie low.
std::optional<SupportPlane> FitSupportPlane(const sensor::ScanSet& scan,
                                            const std::optional<VerticalRegion>& region);

// Takes points of frame L into frame S, level on the support: z = 0 on it, the heading kept.
geometry::RigidTransform LevelOn(const SupportPlane& plane);

}  // namespace geon::recognition
