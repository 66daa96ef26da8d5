#include "recognition/target_extent.h"

#include <algorithm>

#include "recognition/median.h"

namespace geon::recognition {

std::optional<Extent> FindColumns(const sensor::ScanSet& scan,
                                  const std::optional<VerticalRegion>& region, int margin_px) {
  if (!region || !scan.target_box) return std::nullopt;
  const double margin_1 = margin_px / (scan.target_box->w_px - 1.0 + 2.0 * margin_px);
  const double width_1 = region->max_tangent_1 - region->min_tangent_1;
  return Extent{region->min_tangent_1 + margin_1 * width_1,
                region->max_tangent_1 - margin_1 * width_1};
}

std::optional<Extent> FindRows(std::span<const RegionProfile> parts, const BwCamera& camera) {
  double n = 0.0, sum_f = 0.0, sum_t = 0.0, sum_ff = 0.0, sum_ft = 0.0;
  for (const RegionProfile& part : parts) {
    if (part.laser != sensor::Laser::kHorizontal || part.p_L_m.empty()) continue;
    const double row_1 = Tangents(camera.InCamera(part.p_L_m[part.p_L_m.size() / 2])).y();
    n += 1.0;
    sum_f += part.fraction;
    sum_t += row_1;
    sum_ff += part.fraction * part.fraction;
    sum_ft += part.fraction * row_1;
  }
  const double spread = sum_ff - sum_f * sum_f / std::max(n, 1.0);
  if (n < 2.0 || spread < 1e-6) return std::nullopt;
  const double slope = (sum_ft - sum_f * sum_t / n) / spread;
  if (slope <= 0.0) return std::nullopt;
  const double first_1 = (sum_t - slope * sum_f) / n;
  return Extent{first_1, first_1 + slope};
}

std::optional<Eigen::Vector3d> FindFoot(std::span<const RegionProfile> parts,
                                        const BwCamera& camera, const Extent& rows) {
  std::vector<double> columns_1, depths_m;
  for (const RegionProfile& part : parts) {
    if (part.laser != sensor::Laser::kHorizontal || part.p_L_m.empty()) continue;
    const Eigen::Vector3d middle_B_m = camera.InCamera(part.p_L_m[part.p_L_m.size() / 2]);
    columns_1.push_back(Tangents(middle_B_m).x());
    depths_m.push_back(middle_B_m.z());
  }
  if (depths_m.empty()) return std::nullopt;
  const double depth_m = Median(std::move(depths_m));
  const Eigen::Vector3d ray_B(Median(std::move(columns_1)), rows.last_1, 1.0);
  return camera.p_LB_m + depth_m * (camera.R_LB * ray_B);
}

}  // namespace geon::recognition
