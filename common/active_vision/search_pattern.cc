#include "active_vision/search_pattern.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::active_vision {
namespace {

// Centres of the fewest views that cover [min, max], evenly spread; one in the middle if one will
// do. Never beyond the limits.
std::vector<double> Centers(double min_rad, double max_rad, double view_rad, double step_rad,
                            double limit_min_rad, double limit_max_rad) {
  const double middle_rad = (min_rad + max_rad) / 2.0;
  const bool one_will_do = max_rad - min_rad <= view_rad;
  // The outermost views reach over the area's edge by half an overlap: a tilted view's edges are
  // not straight in pan and tilt.
  const double first_rad = one_will_do ? middle_rad : min_rad + step_rad / 2.0;
  const double last_rad = one_will_do ? middle_rad : std::max(max_rad - step_rad / 2.0, first_rad);
  const int steps = static_cast<int>(std::ceil((last_rad - first_rad) / step_rad - 1e-9));
  std::vector<double> centers_rad;
  for (int k = 0; k <= steps; ++k) {
    const double share = steps == 0 ? 0.5 : static_cast<double>(k) / steps;
    const double center_rad =
        std::clamp(first_rad + share * (last_rad - first_rad), limit_min_rad, limit_max_rad);
    if (centers_rad.empty() || center_rad > centers_rad.back()) centers_rad.push_back(center_rad);
  }
  return centers_rad;
}

// Degrees by which a view of `pixels` columns can turn without losing sight, seen at the image's
// middle.
double ViewAngle(int pixels, double focal_px) { return 2.0 * std::atan(0.5 * pixels / focal_px); }

}  // namespace

std::vector<HeadAngles> SearchPattern(const geometry::PinholeCamera& camera,
                                      const HeadLimits& limits, const HeadAngles& start,
                                      const SearchOptions& options) {
  Require(
      options.pan_min_rad <= options.pan_max_rad && options.tilt_min_rad <= options.tilt_max_rad,
      "SearchOptions: an area has its minimum below its maximum");
  for (const double overlap_1 : {options.pan_overlap_1, options.tilt_overlap_1}) {
    Require(overlap_1 >= 0.0 && overlap_1 < 1.0, "SearchOptions: overlaps in [0, 1)");
  }

  const double pan_view_rad = ViewAngle(camera.width_px, camera.fx_px);
  const double tilt_view_rad = ViewAngle(camera.height_px, camera.fy_px);
  const double pan_step_rad = (1.0 - options.pan_overlap_1) * pan_view_rad;
  const double tilt_step_rad = (1.0 - options.tilt_overlap_1) * tilt_view_rad;
  std::vector<double> pans_rad = Centers(options.pan_min_rad, options.pan_max_rad, pan_view_rad,
                                         pan_step_rad, limits.pan_min_rad, limits.pan_max_rad);
  const std::vector<double> tilts_rad =
      Centers(options.tilt_min_rad, options.tilt_max_rad, tilt_view_rad, tilt_step_rad,
              limits.tilt_min_rad, limits.tilt_max_rad);

  if (std::abs(pans_rad.back() - start.pan_rad) < std::abs(pans_rad.front() - start.pan_rad)) {
    std::reverse(pans_rad.begin(), pans_rad.end());
  }
  std::vector<HeadAngles> looks;
  for (const double tilt_rad : tilts_rad) {
    for (const double pan_rad : pans_rad) looks.push_back({pan_rad, tilt_rad});
    std::reverse(pans_rad.begin(), pans_rad.end());
  }
  return looks;
}

HeadAngles LookTolerance(const geometry::PinholeCamera& camera, const SearchOptions& options) {
  return {0.5 * options.pan_overlap_1 * ViewAngle(camera.width_px, camera.fx_px),
          0.5 * options.tilt_overlap_1 * ViewAngle(camera.height_px, camera.fy_px)};
}

}  // namespace geon::active_vision
