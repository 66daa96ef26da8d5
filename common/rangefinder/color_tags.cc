#include "rangefinder/color_tags.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/contracts.h"

namespace geon::rangefinder {
namespace {

constexpr double kNotSeen_1 = 0.5;

// How many pixels of the target lie in any window of the picture.
class MaskSums {
 public:
  explicit MaskSums(const sensor::TargetMask& mask)
      : box_(mask.box),
        stride_(static_cast<size_t>(mask.box.w_px) + 1),
        sums_(stride_ * (static_cast<size_t>(mask.box.h_px) + 1), 0) {
    const auto width = static_cast<size_t>(box_.w_px), height = static_cast<size_t>(box_.h_px);
    size_t at = 0;  // pixel of the box
    bool on_target = false;
    for (const int16_t run : mask.runs_px) {
      for (int k = 0; k < run && at < width * height; ++k, ++at) {
        sums_[(at / width + 1) * stride_ + at % width + 1] = on_target ? 1 : 0;
      }
      on_target = !on_target;
    }
    Require(at == width * height, "TagColors: the runs of the mask do not fill its box");
    for (size_t v = 1; v <= height; ++v) {
      for (size_t u = 1; u <= width; ++u) {
        sums_[v * stride_ + u] += sums_[(v - 1) * stride_ + u] + sums_[v * stride_ + u - 1] -
                                  sums_[(v - 1) * stride_ + u - 1];
      }
    }
  }

  // Of the window of `reach_px` to each side of a pixel.
  int Around(int u_px, int v_px, int reach_px) const {
    const size_t left = Clamp(u_px - reach_px - box_.u_px, box_.w_px);
    const size_t right = Clamp(u_px + reach_px + 1 - box_.u_px, box_.w_px);
    const size_t top = Clamp(v_px - reach_px - box_.v_px, box_.h_px);
    const size_t bottom = Clamp(v_px + reach_px + 1 - box_.v_px, box_.h_px);
    return sums_[bottom * stride_ + right] - sums_[top * stride_ + right] -
           sums_[bottom * stride_ + left] + sums_[top * stride_ + left];
  }

 private:
  static size_t Clamp(int at_px, int size_px) {
    return static_cast<size_t>(std::clamp(at_px, 0, size_px));
  }

  sensor::PixelBox box_;
  size_t stride_;
  std::vector<int> sums_;  // [v][u]: of all pixels above and to the left
};

}  // namespace

void TagColors(const sensor::TargetMask& mask, const sensor::ScanPlan& plan,
               const geometry::SensorRig& rig, sensor::RangeProfile* profile, int edge_px) {
  Require(mask.scan_id == plan.scan_id, "TagColors: the mask is of another scan");
  Require(mask.box.w_px > 0 && mask.box.h_px > 0, "TagColors: the mask has an empty box");
  Require(edge_px >= 0, "edge_px", edge_px, "must not be negative");
  const MaskSums sums(mask);
  const geometry::RigidTransform X_RL = geometry::LevelFrame(
      rig.StripeCameraPose(plan.pan_rad, plan.tilt_rad), plan.support_height_m);
  const geometry::RigidTransform X_CL =
      rig.ColorCameraPose(mask.pan_rad, mask.tilt_rad).inverse() * X_RL;
  const double window = (2.0 * edge_px + 1.0) * (2.0 * edge_px + 1.0);
  profile->on_color_1.clear();
  for (const Eigen::Vector3d& p_L : profile->p_L_m) {
    const Eigen::Vector3d p_C = X_CL * p_L;
    double& tag_1 = profile->on_color_1.emplace_back(kNotSeen_1);
    if (p_C.z() <= 0.0) continue;
    const Eigen::Vector2d pixel_px = rig.color_camera.Project(p_C);
    if (!rig.color_camera.Contains(pixel_px)) continue;
    tag_1 = sums.Around(static_cast<int>(std::lround(pixel_px.x())),
                        static_cast<int>(std::lround(pixel_px.y())), edge_px) /
            window;
  }
}

}  // namespace geon::rangefinder
