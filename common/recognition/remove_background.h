#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "sensor/scan_set.h"

namespace geon::recognition {

// How background is told from the target: by the thesis's two tests (5.1), or by the planes that
// the scan's own points show (label_points.h).
enum class BackgroundMethod { kThesis, kFitted };
// What people write: thesis, fitted. Nothing for other names.
std::optional<BackgroundMethod> BackgroundMethodFromString(std::string_view name);

struct BackgroundOptions {
  BackgroundMethod method = BackgroundMethod::kFitted;
  // Added to each side of the target box: the two cameras do not see quite alike, and erosion has
  // shrunk the target ("several pixels"). At the level of a stripe's own columns.
  int margin_px = 8;
  // A point is floor when it lies lower than this above the supporting plane (5.1, 5.2: 1 cm).
  // Method kFitted takes its margin from the noise instead.
  double floor_margin_m = 0.01;
  // Throws ContractViolation with the value that breaks a rule.
  void Validate() const;
};

// The Vertical Region Of Interest: what lies between two planes through the camera's centre, given
// by the tangents x/z of their azimuth in the B/W camera as it stood when the target was measured.
struct VerticalRegion {
  double min_tangent_1 = 0.0;
  double max_tangent_1 = 0.0;
  // Whether a point before the camera lies in it.
  bool Holds(const Eigen::Vector3d& p_B_m) const {
    return p_B_m.z() > 0.0 && p_B_m.x() >= min_tangent_1 * p_B_m.z() &&
           p_B_m.x() <= max_tangent_1 * p_B_m.z();
  }
};

// The region of interest of a scan; nothing when the scan has no target box or not enough points on
// horizontal stripes to tell how columns belong to directions.
std::optional<VerticalRegion> FindVerticalRegion(const sensor::ScanSet& scan,
                                                 const BackgroundOptions& options);

// The thesis's two tests of each point of `profile`: whether it lies within the vertical region of
// interest and above the floor, and so on the target.
//
// Source: thesis section 5.1, figures 5.3 and 5.4, equations 5.1 and 5.2. There the height below
// the camera follows from the distance along the viewing ray; in frame L it is simply z, so that
// h_laser >= h_cam - 1 cm reads z <= 1 cm.
// Deviation: the region is turned into two planes, so that it also holds for vertical stripes, for
// which the head has panned. Columns become tangents by a line fitted through (x/z, column) of the
// scan's own horizontal stripes: a scan set does not carry the focal length.
std::vector<bool> TestTargetPoints(const sensor::RangeProfile& profile, const sensor::ScanSet& scan,
                                   const std::optional<VerticalRegion>& region,
                                   const BackgroundOptions& options);

// The profile without its background points; `on_target` has a label for each of its points.
sensor::RangeProfile RemoveBackground(const sensor::RangeProfile& profile,
                                      const std::vector<bool>& on_target);

}  // namespace geon::recognition
