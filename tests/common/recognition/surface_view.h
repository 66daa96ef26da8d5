#pragma once

#include <functional>

#include "geometry/rigid_transform.h"
#include "recognition/target_stripe.h"

namespace geon::recognition {

// Six stripes of 20 cm on a surface about 1 m before a level camera 0.5 m high, that stands out
// towards it by height_m(y, z - 0.5).
inline TargetView ViewOfSurface(const std::function<double(double, double)>& height_m) {
  TargetView view;
  view.camera = {Eigen::Vector3d(0.0, 0.0, 0.5), geometry::CameraAxesInBody()};
  view.stripes.resize(6);
  for (size_t k = 0; k < 6; ++k) {
    TargetStripe& stripe = view.stripes[k];
    stripe.laser = k < 3 ? sensor::Laser::kHorizontal : sensor::Laser::kVertical;
    stripe.segment_begins = {0};
    const double at_m = 0.05 * (1.0 - static_cast<double>(k % 3));
    for (int i = 0; i <= 200; ++i) {
      const double along_m = 0.1 - 0.001 * i;  // from left to right, from above to below
      const double y_m = k < 3 ? along_m : at_m, z_m = k < 3 ? at_m : along_m;
      stripe.p_L_m.emplace_back(1.0 - height_m(y_m, z_m), y_m, 0.5 + z_m);
      stripe.curve_m.emplace_back(-along_m, height_m(y_m, z_m) - 1.0);
      const double depth_m = 1.0 - height_m(y_m, z_m);
      stripe.tangent_B_1.emplace_back(-y_m / depth_m, -z_m / depth_m);
    }
  }
  return view;
}

}  // namespace geon::recognition
