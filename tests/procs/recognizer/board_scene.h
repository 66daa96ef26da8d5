#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "procs/recognizer/recognizer_config.h"
#include "sensor/stripe.h"

namespace geon::recognizer {

// A board before the camera, square to its axis, with a stripe across part of it: enough to put
// plans and stripes through the recognizer.

inline RecognizerConfig TestConfig() {
  auto config = LoadRecognizerConfig(
      std::filesystem::path(GEON_SOURCE_DIR) / "scripts/config/robot.yaml", "");
  return std::move(config).value();
}

// Row (column) in which the stripe lies in column (row) `line` when the board is at `distance_m`.
inline double StripePosition(const geometry::SensorRig& rig, sensor::Laser laser, int line,
                             double distance_m) {
  const bool horizontal = laser == sensor::Laser::kHorizontal;
  const geometry::LaserMount& mount = horizontal ? rig.horizontal_laser : rig.vertical_laser;
  const geometry::RigidTransform X_BT = rig.X_TB.inverse();
  const Eigen::Vector3d normal_B = X_BT.linear() * mount.normal_T;
  const double offset_m = normal_B.dot(X_BT * mount.p_TLaser_m);
  const geometry::PinholeCamera& camera = rig.stripe_camera;
  // normal . (x, y, z) = offset, with z and one of x, y known.
  if (horizontal) {
    const double x_m = (line - camera.cx_px) / camera.fx_px * distance_m;
    const double y_m = (offset_m - normal_B.x() * x_m - normal_B.z() * distance_m) / normal_B.y();
    return camera.cy_px + camera.fy_px * y_m / distance_m;
  }
  const double y_m = (line - camera.cy_px) / camera.fy_px * distance_m;
  const double x_m = (offset_m - normal_B.y() * y_m - normal_B.z() * distance_m) / normal_B.x();
  return camera.cx_px + camera.fx_px * x_m / distance_m;
}

inline rangefinder::LookUpTable TestTable(const geometry::SensorRig& rig, sensor::Laser laser) {
  rangefinder::LookUpTable table;
  table.laser = laser;
  table.date = "2026-01-31";
  table.width_px = rig.stripe_camera.width_px;
  table.height_px = rig.stripe_camera.height_px;
  table.frames = 1;
  table.first_distance_m = 0.7;
  table.step_m = 0.02;
  table.distances = 66;
  for (int line = 0; line < table.lines(); ++line) {
    for (int k = 0; k < table.distances; ++k) {
      table.position_px.push_back(StripePosition(rig, laser, line, 0.7 + 0.02 * k));
    }
  }
  return table;
}

inline StripeCalibration TestCalibration(const geometry::SensorRig& rig) {
  return {TestTable(rig, sensor::Laser::kHorizontal), TestTable(rig, sensor::Laser::kVertical),
          "test", "0123456789abcdef"};
}

// The plan of six stripes, the head level (the rig looks 15 degrees down).
inline sensor::ScanPlan TestPlan(int64_t scan_id) {
  sensor::ScanPlan plan;
  plan.utime = 1'000'000;
  plan.scan_id = scan_id;
  plan.target_box = {220, 140, 200, 200};
  plan.distance_m = 1.2;
  for (int k = 0; k < 6; ++k) {
    sensor::PlannedStripe stripe;
    stripe.laser = k < 3 ? sensor::Laser::kHorizontal : sensor::Laser::kVertical;
    stripe.fraction = 0.25 * (k % 3 + 1);
    stripe.tilt_rad = k < 3 ? 0.02 * (1 - k) : 0.0;
    stripe.pan_rad = k < 3 ? 0.0 : 0.02 * (4 - k);
    plan.stripes.push_back(stripe);
  }
  return plan;
}

// Stripe `k` of the plan on a board at 1.2 m that is as large as the target box.
inline sensor::Stripe TestStripe(const geometry::SensorRig& rig, const sensor::ScanPlan& plan,
                                 int32_t k, int32_t attempt = 0) {
  const sensor::PlannedStripe& planned = plan.stripes[static_cast<size_t>(k)];
  sensor::Stripe stripe;
  stripe.utime = 2'000'000 + 100'000 * k + 1000 * attempt;
  stripe.scan_id = plan.scan_id;
  stripe.stripe_index = k;
  stripe.attempt = attempt;
  stripe.laser = planned.laser;
  stripe.status = sensor::StripeStatus::kLit;
  stripe.pan_rad = planned.pan_rad;
  stripe.tilt_rad = planned.tilt_rad;
  stripe.lit_peak = 200.0;
  stripe.noise_level = 1.0;
  sensor::Image& image = stripe.difference;
  image.width_px = rig.stripe_camera.width_px;
  image.height_px = rig.stripe_camera.height_px;
  image.row_stride_bytes = image.width_px;
  image.format = sensor::PixelFormat::kGray8;
  image.data.assign(static_cast<size_t>(image.width_px * image.height_px), 0);
  const bool horizontal = planned.laser == sensor::Laser::kHorizontal;
  const int first = horizontal ? 220 : 140;
  for (int line = first; line < first + 200; ++line) {
    const double centre_px = StripePosition(rig, planned.laser, line, 1.2);
    for (int d = -4; d <= 4; ++d) {
      const int at = static_cast<int>(std::lround(centre_px)) + d;
      const double level = 200.0 * std::exp(-0.5 * (at - centre_px) * (at - centre_px) / 1.5 / 1.5);
      const int u = horizontal ? line : at;
      const int v = horizontal ? at : line;
      if (u < 0 || v < 0 || u >= image.width_px || v >= image.height_px) continue;
      image.data[static_cast<size_t>(v * image.width_px + u)] =
          static_cast<uint8_t>(std::lround(level));
    }
  }
  return stripe;
}

}  // namespace geon::recognizer
