#include "recognition/remove_background.h"

#include <algorithm>
#include <cmath>

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
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;  // sums of tangents x and columns y
  for (const sensor::RangeProfile& profile : scan.profiles) {
    if (profile.laser != sensor::Laser::kHorizontal) continue;
    const Eigen::Matrix3d R_LB = profile.rotation_LB.value_or(scan.rotation_LB);
    const Eigen::Vector3d right_L = R_LB.col(0), forward_L = R_LB.col(2);
    for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
      const Eigen::Vector3d p_BoP_L = profile.p_L_m[i] - scan.camera_position_L_m;
      const double depth_m = forward_L.dot(p_BoP_L);
      if (depth_m <= 0.0) continue;
      const double tangent = right_L.dot(p_BoP_L) / depth_m;
      const double column_px = profile.pixel[i];
      n += 1.0;
      x += tangent;
      y += column_px;
      xx += tangent * tangent;
      xy += tangent * column_px;
    }
  }
  const double variance = xx - x * x / n, covariance = xy - x * y / n;  // n times
  if (n < 10.0 || variance < n * kSmallestSpread * kSmallestSpread) return std::nullopt;
  const double focal_px = covariance / variance;
  if (focal_px <= 0.0) return std::nullopt;
  return ColumnScale{(y - focal_px * x) / n, focal_px};
}

// FindTargetPoints for one point. Source: (5.1), (5.2) for the floor.
class TargetTest {
 public:
  TargetTest(const sensor::ScanSet& scan, const std::optional<VerticalRegion>& region)
      : p_LB_m_(scan.camera_position_L_m),
        right_L_(scan.rotation_LB.col(0)),
        forward_L_(scan.rotation_LB.col(2)),
        region_(region) {}

  bool InRegion(const Eigen::Vector3d& p_L) const {
    if (!region_) return true;
    const Eigen::Vector3d p_BoP_L = p_L - p_LB_m_;
    const double x_m = right_L_.dot(p_BoP_L), z_m = forward_L_.dot(p_BoP_L);
    return z_m > 0.0 && x_m >= region_->min_tangent_1 * z_m && x_m <= region_->max_tangent_1 * z_m;
  }
  bool OnTarget(const Eigen::Vector3d& p_L, const BackgroundOptions& options) const {
    return p_L.z() > options.floor_margin_m && InRegion(p_L);
  }

 private:
  Eigen::Vector3d p_LB_m_, right_L_, forward_L_;
  std::optional<VerticalRegion> region_;
};

}  // namespace

void BackgroundOptions::Validate() const {
  Require(margin_px >= 0, "background margin_px", margin_px, "must not be negative");
  Require(std::isfinite(floor_margin_m), "floor_margin_m", floor_margin_m, "must be finite");
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
  const TargetTest test(scan, region);
  std::vector<bool> on_target(profile.p_L_m.size());
  for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
    on_target[i] = test.OnTarget(profile.p_L_m[i], options);
  }
  return on_target;
}

PointRange FindRegionRange(std::span<const Eigen::Vector3d> p_L_m, const sensor::ScanSet& scan,
                           const std::optional<VerticalRegion>& region) {
  const TargetTest test(scan, region);
  PointRange range{0, p_L_m.size()};
  while (range.begin < range.end && !test.InRegion(p_L_m[range.begin])) ++range.begin;
  while (range.begin < range.end && !test.InRegion(p_L_m[range.end - 1])) --range.end;
  return range;
}

void DropBackground(const sensor::ScanSet& scan, const std::optional<VerticalRegion>& region,
                    const BackgroundOptions& options, std::vector<Eigen::Vector3d>* p_L_m) {
  const TargetTest test(scan, region);
  std::erase_if(*p_L_m, [&](const Eigen::Vector3d& p_L) { return !test.OnTarget(p_L, options); });
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
