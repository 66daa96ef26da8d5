#include "recognition/remove_background.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"
#include "recognition/bw_camera.h"

namespace geon::recognition {
namespace {

// How image columns belong to x/z: column = centre_px + focal_px * x/z.
struct ColumnScale {
  double centre_px = 0.0;
  double focal_px = 0.0;
};

// The smallest spread of x/z that fixes the scale: a third of a degree.
constexpr double kSmallestSpread = 0.005;
// Of a stripe's points about so many tell the scale: they lie on their columns' viewing rays.
constexpr size_t kEnoughOfStripe = 32;

std::optional<ColumnScale> FitColumnScale(const sensor::ScanSet& scan) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;  // sums of tangents x and columns y
  for (const sensor::RangeProfile& profile : scan.profiles) {
    if (profile.laser != sensor::Laser::kHorizontal) continue;
    const BwCamera camera = CameraAtStripe(scan, profile);
    const size_t step = std::max<size_t>(profile.p_L_m.size() / kEnoughOfStripe, 1);
    for (size_t i = 0; i < profile.p_L_m.size(); i += step) {
      const Eigen::Vector3d p_B_m = camera.InCamera(profile.p_L_m[i]);
      if (p_B_m.z() <= 0.0) continue;
      const double tangent = Tangents(p_B_m).x();
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

}  // namespace

std::optional<BackgroundMethod> BackgroundMethodFromString(std::string_view name) {
  if (name == "thesis") return BackgroundMethod::kThesis;
  if (name == "fitted") return BackgroundMethod::kFitted;
  return std::nullopt;
}

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

std::vector<bool> TestTargetPoints(const sensor::RangeProfile& profile, const sensor::ScanSet& scan,
                                   const std::optional<VerticalRegion>& region,
                                   const BackgroundOptions& options) {
  const BwCamera camera = CameraAtTarget(scan);
  std::vector<bool> on_target(profile.p_L_m.size());
  for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
    const Eigen::Vector3d& p_L = profile.p_L_m[i];
    on_target[i] =
        p_L.z() > options.floor_margin_m && (!region || region->Holds(camera.InCamera(p_L)));
  }
  return on_target;
}

sensor::RangeProfile RemoveBackground(const sensor::RangeProfile& profile,
                                      const std::vector<bool>& on_target) {
  Require(on_target.size() == profile.p_L_m.size(), "RemoveBackground: the number of labels",
          on_target.size(), "must be that of the profile's points");
  sensor::RangeProfile target = profile;
  target.pixel.clear();
  target.p_L_m.clear();
  target.on_color_1.clear();
  for (size_t i = 0; i < on_target.size(); ++i) {
    if (!on_target[i]) continue;
    target.pixel.push_back(profile.pixel[i]);
    target.p_L_m.push_back(profile.p_L_m[i]);
    if (!profile.on_color_1.empty()) target.on_color_1.push_back(profile.on_color_1[i]);
  }
  target.on_target = static_cast<int32_t>(target.pixel.size());
  return target;
}

}  // namespace geon::recognition
