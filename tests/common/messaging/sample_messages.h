#pragma once

// One filled value of every message, for round trips and for breaking.
#include <cmath>

#include "sensor/base.h"
#include "sensor/geon_finding.h"
#include "sensor/geon_verdict.h"
#include "sensor/health.h"
#include "sensor/image.h"
#include "sensor/laser_state.h"
#include "sensor/planner_state.h"
#include "sensor/ptu.h"
#include "sensor/scan_set.h"
#include "sensor/stripe.h"
#include "sensor/target_mask.h"
#include "sensor/target_view.h"

namespace geon::messaging::samples {

inline sensor::Image GreyImage(int width_px, int height_px) {
  sensor::Image image;
  image.utime = 1'700'000'000'000'001;
  image.seq = 7;
  image.width_px = width_px;
  image.height_px = height_px;
  image.row_stride_bytes = width_px;
  image.format = sensor::PixelFormat::kGray8;
  for (int i = 0; i < width_px * height_px; ++i) image.data.push_back(static_cast<uint8_t>(i * 31));
  return image;
}

inline sensor::Image CompressedImage(sensor::PixelFormat format) {
  sensor::Image image;
  image.width_px = 640;
  image.height_px = 480;
  image.format = format;
  image.data = {0x89, 'P', 'N', 'G'};
  return image;
}

inline sensor::Stripe Stripe() {
  sensor::Stripe stripe;
  stripe.utime = 11;
  stripe.seq = 2;
  stripe.scan_id = 1234567890123;
  stripe.stripe_index = 5;
  stripe.attempt = 1;
  stripe.laser = sensor::Laser::kVertical;
  stripe.status = sensor::StripeStatus::kLit;
  stripe.pan_rad = 0.1;
  stripe.tilt_rad = -0.2;
  stripe.x_m = 1.5;
  stripe.y_m = -2.5;
  stripe.heading_rad = 3.0;
  stripe.lit_utime = 10;
  stripe.unlit_utime = 9;
  stripe.lit_peak = 200.0;
  stripe.noise_level = 1.25;
  stripe.difference = CompressedImage(sensor::PixelFormat::kPng);
  return stripe;
}

inline sensor::PtuState PtuState() {
  return {12,   3, sensor::DeviceStatus::kReady, 0.1, -0.2, 0.3, -0.4, -2.7, 2.7, -0.8, 0.5,
          true, 42};
}

inline sensor::BaseState BaseState() {
  return {13,   4,    sensor::DeviceStatus::kReady, 1.0, 2.0, 0.5, 0.2,
          -0.1, true, sensor::BaseStop::kBumper,    43};
}

inline sensor::ScanPlan ScanPlan() {
  sensor::ScanPlan plan{14, 5, 77, {1, 2, 30, 40}, 0.1, -0.3, 0.7, 1.05, {}};
  plan.stripes = {{sensor::Laser::kHorizontal, 0.25, 0.1, -0.2},
                  {sensor::Laser::kVertical, 0.75, 0.15, -0.25}};
  return plan;
}

inline sensor::TargetMask TargetMask() {
  return {14, 5, 77, {1, 2, 3, 2}, 0.1, -0.3, {1, 2, 0, 3}};
}

inline sensor::RangeProfile RangeProfile() {
  sensor::RangeProfile profile;
  profile.utime = 15;
  profile.seq = 6;
  profile.scan_id = 77;
  profile.stripe_index = 2;
  profile.attempt = 1;
  profile.status = sensor::ProfileStatus::kMissing;
  profile.on_target = 1;
  profile.laser = sensor::Laser::kVertical;
  profile.fraction = 0.75;
  profile.pixel = {3, 5};
  profile.p_L_m = {{1.0, 0.1, 0.2}, {1.1, 0.1, 0.3}};
  profile.rotation_LB = Eigen::Matrix3d{{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}};
  profile.laser_origin_L_m = Eigen::Vector3d(0.0, 0.0, 1.2);
  return profile;
}

inline sensor::GeonVerdict Verdict() {
  sensor::GeonVerdict verdict;
  verdict.utime = 16;
  verdict.seq = 7;
  verdict.scan_id = 77;
  verdict.label = GeonLabel::kBentCylinder;
  verdict.confidence = 0.8;
  verdict.posterior = {0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.8};
  verdict.decided = true;
  verdict.method = "thesis";
  verdict.bending = {false, true, false, 0.01};
  verdict.tapering = {true, false, true, 0.02};
  sensor::ProfileEvidence profile;
  profile.points = 30;
  profile.curves = 2;
  profile.arc_length_m = {0.0, 0.01};
  profile.theta_rad = {0.5, 0.6};
  verdict.profiles = {profile, profile};
  verdict.reasons = {"two curves", ""};
  return verdict;
}

inline sensor::GeonFinding Finding() {
  sensor::GeonFinding finding;
  finding.label = GeonLabel::kBentCylinder;
  finding.confidence = 0.8;
  finding.decided = true;
  finding.posterior = {0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.8};
  finding.p_W_m = {1.5, -2.5};
  finding.support_height_m = 0.7;
  finding.views = 2;
  return finding;
}

inline sensor::PlannerState PlannerState() {
  sensor::PlannerState state;
  state.utime = 17;
  state.seq = 8;
  state.phase = "approach";
  state.text = "1.4 m to go";
  state.outcome = sensor::MissionOutcome::kRunning;
  state.x_m = 0.5;
  state.y_m = 0.6;
  state.heading_rad = 0.7;
  state.p_WTarget_m = Eigen::Vector2d(1.0, 2.0);
  state.p_WWaypoint_m = Eigen::Vector2d(0.8, 1.0);
  state.safe_polygon_W_m = {{0, 0}, {1, 0}, {1, 1}};
  state.obstacles_W_m = {{3, 3}};
  state.scan_id = 77;
  state.stripe_index = 3;
  state.findings = {Finding(), {}};
  state.findings[1].why = "unreachable";
  return state;
}

inline sensor::TargetView TargetView() {
  sensor::TargetView view;
  view.utime = 18;
  view.seq = 9;
  view.scan_id = 77;
  view.target_box = sensor::PixelBox{10, 20, 30, 40};
  view.target_pixels = 900;
  view.pan_rad = 0.1;
  view.tilt_rad = -0.1;
  view.view = CompressedImage(sensor::PixelFormat::kJpeg);
  view.mask = CompressedImage(sensor::PixelFormat::kPng);
  return view;
}

inline sensor::Health Health() {
  sensor::Health health;
  health.utime = 19;
  health.seq = 10;
  health.process = "geon-ptu";
  health.host = "robot";
  health.pid = 4711;
  health.version = "0.1.0";
  health.config_hash = "00ff";
  health.level = sensor::HealthLevel::kWarn;
  health.text = "slow";
  health.uptime_s = 5.0;
  health.loop_hz = 100.0;
  health.rx_lost = 1;
  health.decode_errors = 2;
  health.max_age_s = 0.1;
  health.cpu_s = 0.2;
  health.rss_bytes = 1'000'000;
  health.reconnects = 3;
  return health;
}

inline sensor::Session Session() {
  return {20, 11, "geon-recognizer", "desk", 19, "0.1.0", "00ff", "aa11", "lut.yaml", -5};
}

inline sensor::SonarScan SonarScan() {
  sensor::SonarScan scan{21, 12, 0.1, 0.2, 0.3, {}};
  scan.range_m.fill(2.5);
  scan.range_m[3] = std::nan("");
  return scan;
}

inline sensor::BumperState BumperState() {
  sensor::BumperState state;
  state.utime = 22;
  state.seq = 13;
  state.pressed[4] = true;
  state.bearing_rad.fill(0.25);
  state.contact_count = 1;
  return state;
}

inline sensor::InfraredScan InfraredScan() {
  sensor::InfraredScan scan{23, 14, {}};
  scan.level[15] = 15;
  return scan;
}

}  // namespace geon::messaging::samples
