#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "recognition/bw_camera.h"
#include "recognition/region_profile.h"
#include "recognition/remove_background.h"
#include "sensor/scan_set.h"

namespace geon::recognition {

// Source: ours; thesis section 5.1 has the columns and doubts that rows can be told.
//
// What lies between two tangents of the B/W camera as it stood when the target was measured: x/z
// of columns, y/z of rows.
struct Extent {
  double first_1 = 0.0;
  double last_1 = 0.0;
  // Whether the tangent lies between them, or beyond them by at most this part of the extent.
  bool Holds(double tangent_1, double beyond_1) const {
    const double more_1 = beyond_1 * (last_1 - first_1);
    return tangent_1 >= first_1 - more_1 && tangent_1 <= last_1 + more_1;
  }
};

// The columns of the target box, without the margin that belongs to its region of interest.
std::optional<Extent> FindColumns(const sensor::ScanSet& scan,
                                  const std::optional<VerticalRegion>& region, int margin_px);

// The rows of the target box: a line through (fraction, row) of the horizontal stripes, whose
// places in the box are known. Nothing when there are fewer than two. `camera`: at the target.
std::optional<Extent> FindRows(std::span<const RegionProfile> parts, const BwCamera& camera);

// Where the target stands, within a few centimetres: what the middle of the horizontal stripes'
// depth shows in the lowest row of the box, frame L. Nothing without a horizontal stripe.
std::optional<Eigen::Vector3d> FindFoot(std::span<const RegionProfile> parts,
                                        const BwCamera& camera, const Extent& rows);

}  // namespace geon::recognition
