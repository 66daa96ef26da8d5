#include "recognition/remove_background.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

// How image columns belong to x/z: column = centre_px + focal_px * x/z.
struct ColumnScale {
  double centre_px = 0.0;
  double focal_px = 0.0;
};

// The smallest spread of x/z that fixes the scale: a third of a degree.
constexpr double kSmallestSpread = 0.005;

std::optional<ColumnScale> FitColumnScale(const sensor::ScanSet& scan) {
  double n = 0.0;
  double mean_tangent = 0.0;
  double mean_column_px = 0.0;
  double tangent_variance = 0.0;
  double covariance = 0.0;
  for (const sensor::RangeProfile& profile : scan.profiles) {
    if (profile.laser != sensor::Laser::kHorizontal) continue;
    const Eigen::Matrix3d R_BL = profile.rotation_LB.value_or(scan.rotation_LB).transpose();
    for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
      const Eigen::Vector3d p_B = R_BL * (profile.p_L_m[i] - scan.camera_position_L_m);
      if (p_B.z() <= 0.0) continue;
      const double tangent = p_B.x() / p_B.z();
      const double column_px = profile.pixel[i];
      n += 1.0;
      const double tangent_step = tangent - mean_tangent;
      mean_tangent += tangent_step / n;
      mean_column_px += (column_px - mean_column_px) / n;
      tangent_variance += tangent_step * (tangent - mean_tangent);
      covariance += tangent_step * (column_px - mean_column_px);
    }
  }
  if (n < 10.0 || tangent_variance < n * kSmallestSpread * kSmallestSpread) return std::nullopt;
  const double focal_px = covariance / tangent_variance;
  if (focal_px <= 0.0) return std::nullopt;
  return ColumnScale{mean_column_px - focal_px * mean_tangent, focal_px};
}

}  // namespace

void BackgroundOptions::Validate() const {
  Require(margin_px >= 0,
          "background margin_px is " + std::to_string(margin_px) + ", must not be negative");
  Require(std::isfinite(floor_margin_m),
          "floor_margin_m is " + std::to_string(floor_margin_m) + ", must be finite");
}

std::optional<VerticalRegion> FindVerticalRegion(const sensor::ScanSet& scan,
                                                 const BackgroundOptions& options) {
  if (!scan.target_box) return std::nullopt;
  const std::optional<ColumnScale> scale = FitColumnScale(scan);
  if (!scale) return std::nullopt;
  const double left_px = scan.target_box->u_px - options.margin_px;
  const double right_px = scan.target_box->u_px + scan.target_box->w_px - 1 + options.margin_px;
  return VerticalRegion{(left_px - scale->centre_px) / scale->focal_px,
                        (right_px - scale->centre_px) / scale->focal_px};
}

std::vector<bool> FindTargetPoints(const sensor::RangeProfile& profile, const sensor::ScanSet& scan,
                                   const std::optional<VerticalRegion>& region,
                                   const BackgroundOptions& options) {
  std::vector<bool> on_target(profile.p_L_m.size());
  for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
    const Eigen::Vector3d& p_L = profile.p_L_m[i];
    const bool above_floor = p_L.z() > options.floor_margin_m;  // (5.1), (5.2)
    bool in_region = true;
    if (region) {
      const Eigen::Vector3d p_B = scan.rotation_LB.transpose() * (p_L - scan.camera_position_L_m);
      in_region = p_B.z() > 0.0 && p_B.x() >= region->min_tangent_1 * p_B.z() &&
                  p_B.x() <= region->max_tangent_1 * p_B.z();
    }
    on_target[i] = above_floor && in_region;
  }
  return on_target;
}

sensor::RangeProfile RemoveBackground(const sensor::RangeProfile& profile,
                                      const sensor::ScanSet& scan,
                                      const std::optional<VerticalRegion>& region,
                                      const BackgroundOptions& options) {
  const std::vector<bool> on_target = FindTargetPoints(profile, scan, region, options);
  sensor::RangeProfile target = profile;
  target.pixel.clear();
  target.p_L_m.clear();
  for (size_t i = 0; i < on_target.size(); ++i) {
    if (!on_target[i]) continue;
    target.pixel.push_back(profile.pixel[i]);
    target.p_L_m.push_back(profile.p_L_m[i]);
  }
  target.on_target = static_cast<int32_t>(target.pixel.size());
  return target;
}

}  // namespace geon::recognition
