// Conversions of what planner and recognizer tell each other and the log.
#include <algorithm>
#include <limits>

#include "messaging/wire.h"
#include "messaging/wire_checks.h"

namespace geon::messaging {
namespace {

constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
constexpr int32_t kLargestPicture_px = 4096;
constexpr sensor::Laser kLastScanLaser = sensor::Laser::kVertical;

geon::point2_t ToPoint(const Eigen::Vector2d& p_m) {
  geon::point2_t point{};
  point.x_m = p_m.x();
  point.y_m = p_m.y();
  return point;
}

Eigen::Vector2d FromPoint(const geon::point2_t& point) { return {point.x_m, point.y_m}; }

std::vector<geon::point2_t> ToPoints(const std::vector<Eigen::Vector2d>& points) {
  std::vector<geon::point2_t> wire;
  wire.reserve(points.size());
  std::transform(points.begin(), points.end(), std::back_inserter(wire), ToPoint);
  return wire;
}

std::vector<Eigen::Vector2d> FromPoints(const std::vector<geon::point2_t>& wire) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(wire.size());
  std::transform(wire.begin(), wire.end(), std::back_inserter(points), FromPoint);
  return points;
}

geon::profile_evidence_t ToEvidence(const sensor::ProfileEvidence& evidence) {
  Require(evidence.arc_length_m.size() == evidence.theta_rad.size(),
          "profile evidence: arc_length_m and theta_rad differ in length");
  geon::profile_evidence_t wire{};
  wire.laser = static_cast<int32_t>(evidence.laser);
  wire.fraction_1 = evidence.fraction;
  wire.points = evidence.points;
  wire.segments = evidence.segments;
  wire.curves = evidence.curves;
  wire.corners = evidence.corners;
  wire.concavities = evidence.concavities;
  wire.length_m = evidence.length_m;
  wire.ntheta = WireCount(evidence.theta_rad);
  wire.arc_length_m = evidence.arc_length_m;
  wire.theta_rad = evidence.theta_rad;
  return wire;
}

Result<sensor::ProfileEvidence> FromEvidence(const geon::profile_evidence_t& wire) {
  FieldChecks checks;
  sensor::ProfileEvidence evidence;
  evidence.laser = checks.Enumeration("laser", wire.laser, kLastScanLaser);
  evidence.fraction = wire.fraction_1;
  evidence.points = wire.points;
  evidence.segments = wire.segments;
  evidence.curves = wire.curves;
  evidence.corners = wire.corners;
  evidence.concavities = wire.concavities;
  evidence.length_m = wire.length_m;
  evidence.arc_length_m = wire.arc_length_m;
  evidence.theta_rad = wire.theta_rad;
  return checks.Finish(std::move(evidence));
}

}  // namespace

geon::scan_plan_t ToWire(const sensor::ScanPlan& plan) {
  geon::scan_plan_t wire{};
  wire.utime = plan.utime;
  wire.seq = plan.seq;
  wire.scan_id = plan.scan_id;
  wire.box_u_px = plan.target_box.u_px;
  wire.box_v_px = plan.target_box.v_px;
  wire.box_w_px = plan.target_box.w_px;
  wire.box_h_px = plan.target_box.h_px;
  wire.pan_rad = plan.pan_rad;
  wire.tilt_rad = plan.tilt_rad;
  wire.support_height_m = plan.support_height_m;
  wire.distance_m = plan.distance_m;
  wire.nstripes = WireCount(plan.stripes);
  for (const sensor::PlannedStripe& stripe : plan.stripes) {
    geon::planned_stripe_t planned{};
    planned.laser = static_cast<int32_t>(stripe.laser);
    planned.fraction_1 = stripe.fraction;
    planned.pan_rad = stripe.pan_rad;
    planned.tilt_rad = stripe.tilt_rad;
    wire.stripes.push_back(planned);
  }
  return wire;
}

Result<sensor::ScanPlan> FromWire(const geon::scan_plan_t& wire) {
  FieldChecks checks;
  sensor::ScanPlan plan;
  plan.utime = wire.utime;
  plan.seq = wire.seq;
  plan.scan_id = wire.scan_id;
  plan.target_box = {wire.box_u_px, wire.box_v_px, wire.box_w_px, wire.box_h_px};
  plan.pan_rad = wire.pan_rad;
  plan.tilt_rad = wire.tilt_rad;
  plan.support_height_m = wire.support_height_m;
  plan.distance_m = wire.distance_m;
  checks.Finite("pan_rad", wire.pan_rad);
  checks.Finite("tilt_rad", wire.tilt_rad);
  checks.Finite("support_height_m", wire.support_height_m);
  checks.Finite("distance_m", wire.distance_m);
  for (const geon::planned_stripe_t& planned : wire.stripes) {
    plan.stripes.push_back({checks.Enumeration("stripes.laser", planned.laser, kLastScanLaser),
                            planned.fraction_1, planned.pan_rad, planned.tilt_rad});
    checks.Finite("stripes.fraction_1", planned.fraction_1);
    checks.Finite("stripes.pan_rad", planned.pan_rad);
    checks.Finite("stripes.tilt_rad", planned.tilt_rad);
  }
  return checks.Finish(std::move(plan));
}

geon::target_mask_t ToWire(const sensor::TargetMask& mask) {
  geon::target_mask_t wire{};
  wire.utime = mask.utime;
  wire.seq = mask.seq;
  wire.scan_id = mask.scan_id;
  wire.box_u_px = mask.box.u_px;
  wire.box_v_px = mask.box.v_px;
  wire.box_w_px = mask.box.w_px;
  wire.box_h_px = mask.box.h_px;
  wire.pan_rad = mask.pan_rad;
  wire.tilt_rad = mask.tilt_rad;
  wire.nruns = WireCount(mask.runs_px);
  wire.runs_px = mask.runs_px;
  return wire;
}

Result<sensor::TargetMask> FromWire(const geon::target_mask_t& wire) {
  FieldChecks checks;
  sensor::TargetMask mask;
  mask.utime = wire.utime;
  mask.seq = wire.seq;
  mask.scan_id = wire.scan_id;
  mask.box = {wire.box_u_px, wire.box_v_px, wire.box_w_px, wire.box_h_px};
  mask.pan_rad = wire.pan_rad;
  mask.tilt_rad = wire.tilt_rad;
  mask.runs_px = wire.runs_px;
  checks.Finite("pan_rad", wire.pan_rad);
  checks.Finite("tilt_rad", wire.tilt_rad);
  const auto fits = [](int32_t at_px, int32_t size_px) {
    return at_px >= 0 && at_px <= kLargestPicture_px && size_px > 0 &&
           size_px <= kLargestPicture_px;
  };
  checks.Require(fits(wire.box_u_px, wire.box_w_px) && fits(wire.box_v_px, wire.box_h_px), "box",
                 "is empty or lies in no picture");
  int64_t pixels = 0;
  for (const int16_t run : wire.runs_px) {
    checks.Require(run >= 0, "runs_px", "has a negative length");
    pixels += run;
  }
  checks.Require(pixels == int64_t{wire.box_w_px} * wire.box_h_px, "runs_px",
                 "do not fill the box");
  return checks.Finish(std::move(mask));
}

geon::range_profile_t ToWire(const sensor::RangeProfile& profile) {
  Require(profile.pixel.size() == profile.p_L_m.size(),
          "range profile: pixel and p_L_m differ in length");
  geon::range_profile_t wire{};
  wire.utime = profile.utime;
  wire.seq = profile.seq;
  wire.scan_id = profile.scan_id;
  wire.stripe_index = profile.stripe_index;
  wire.attempt = profile.attempt;
  wire.laser = static_cast<int32_t>(profile.laser);
  wire.status = static_cast<int32_t>(profile.status);
  wire.fraction_1 = profile.fraction;
  wire.on_target = profile.on_target;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      wire.rotation_LB[3 * row + column] =
          profile.rotation_LB ? (*profile.rotation_LB)(row, column) : kAbsent;
    }
    wire.laser_origin_L_m[row] =
        profile.laser_origin_L_m ? (*profile.laser_origin_L_m)(row) : kAbsent;
  }
  wire.npoints = WireCount(profile.pixel);
  wire.pixel.assign(profile.pixel.begin(), profile.pixel.end());
  for (const Eigen::Vector3d& p_m : profile.p_L_m) {
    wire.x_m.push_back(p_m.x());
    wire.y_m.push_back(p_m.y());
    wire.z_m.push_back(p_m.z());
  }
  return wire;
}

Result<sensor::RangeProfile> FromWire(const geon::range_profile_t& wire) {
  FieldChecks checks;
  sensor::RangeProfile profile;
  profile.utime = wire.utime;
  profile.seq = wire.seq;
  profile.scan_id = wire.scan_id;
  profile.stripe_index = wire.stripe_index;
  profile.attempt = wire.attempt;
  profile.laser = checks.Enumeration("laser", wire.laser, kLastScanLaser);
  profile.status = checks.Enumeration("status", wire.status, sensor::ProfileStatus::kRefused);
  profile.fraction = wire.fraction_1;
  profile.on_target = wire.on_target;
  if (std::all_of(wire.rotation_LB, wire.rotation_LB + 9,
                  [](double v) { return std::isfinite(v); })) {
    profile.rotation_LB =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(wire.rotation_LB);
  }
  if (std::all_of(wire.laser_origin_L_m, wire.laser_origin_L_m + 3,
                  [](double v) { return std::isfinite(v); })) {
    profile.laser_origin_L_m = Eigen::Map<const Eigen::Vector3d>(wire.laser_origin_L_m);
  }
  profile.pixel.assign(wire.pixel.begin(), wire.pixel.end());
  const bool increasing =
      std::adjacent_find(wire.pixel.begin(), wire.pixel.end(),
                         [](int32_t a, int32_t b) { return a >= b; }) == wire.pixel.end();
  checks.Require(increasing, "pixel", "is not strictly increasing");
  for (size_t i = 0; i < wire.pixel.size(); ++i) {
    profile.p_L_m.emplace_back(wire.x_m[i], wire.y_m[i], wire.z_m[i]);
    checks.Require(profile.p_L_m.back().allFinite(), "points", "are not finite numbers");
  }
  return checks.Finish(std::move(profile));
}

geon::verdict_t ToWire(const sensor::GeonVerdict& verdict) {
  geon::verdict_t wire{};
  wire.utime = verdict.utime;
  wire.seq = verdict.seq;
  wire.scan_id = verdict.scan_id;
  wire.label = static_cast<int32_t>(verdict.label);
  wire.confidence_1 = verdict.confidence;
  std::copy(verdict.posterior.begin(), verdict.posterior.end(), wire.posterior_1);
  wire.decided = verdict.decided ? 1 : 0;
  wire.method = verdict.method;
  wire.two_segments = verdict.bending.two_segments ? 1 : 0;
  wire.concavity = verdict.bending.concavity ? 1 : 0;
  wire.concave_edge = verdict.bending.concave_edge ? 1 : 0;
  wire.concave_edge_m = verdict.bending.concave_edge_m;
  wire.monotone_horizontal = verdict.tapering.monotone_horizontal ? 1 : 0;
  wire.monotone_vertical = verdict.tapering.monotone_vertical ? 1 : 0;
  wire.asymmetric_ends = verdict.tapering.asymmetric_ends ? 1 : 0;
  wire.asymmetry_m = verdict.tapering.asymmetry_m;
  wire.nprofiles = WireCount(verdict.profiles);
  for (const sensor::ProfileEvidence& profile : verdict.profiles) {
    wire.profiles.push_back(ToEvidence(profile));
  }
  wire.nreasons = WireCount(verdict.reasons);
  wire.reasons = verdict.reasons;
  return wire;
}

Result<sensor::GeonVerdict> FromWire(const geon::verdict_t& wire) {
  FieldChecks checks;
  sensor::GeonVerdict verdict;
  verdict.utime = wire.utime;
  verdict.seq = wire.seq;
  verdict.scan_id = wire.scan_id;
  verdict.label = checks.Enumeration("label", wire.label, GeonLabel::kBentCylinder);
  verdict.confidence = wire.confidence_1;
  checks.Finite("confidence_1", wire.confidence_1);
  std::copy(wire.posterior_1, wire.posterior_1 + kGeonLabelCount, verdict.posterior.begin());
  verdict.decided = wire.decided != 0;
  verdict.method = wire.method;
  verdict.bending = {wire.two_segments != 0, wire.concavity != 0, wire.concave_edge != 0,
                     wire.concave_edge_m};
  verdict.tapering = {wire.monotone_horizontal != 0, wire.monotone_vertical != 0,
                      wire.asymmetric_ends != 0, wire.asymmetry_m};
  for (const geon::profile_evidence_t& profile : wire.profiles) {
    verdict.profiles.push_back(checks.Part("profiles", FromEvidence(profile)));
  }
  verdict.reasons = wire.reasons;
  return checks.Finish(std::move(verdict));
}

geon::finding_t ToFinding(const sensor::GeonFinding& finding) {
  geon::finding_t wire{};
  wire.label = finding.label ? static_cast<int32_t>(*finding.label) : -1;
  wire.confidence_1 = finding.confidence;
  wire.decided = finding.decided ? 1 : 0;
  std::copy(finding.posterior.begin(), finding.posterior.end(), wire.posterior_1);
  wire.place = ToPoint(finding.p_W_m);
  wire.support_height_m = finding.support_height_m;
  wire.views = finding.views;
  wire.why = finding.why;
  return wire;
}

Result<sensor::GeonFinding> FromFinding(const geon::finding_t& wire) {
  FieldChecks checks;
  sensor::GeonFinding finding;
  if (wire.label != -1) {
    finding.label = checks.Enumeration("label", wire.label, GeonLabel::kBentCylinder);
  }
  finding.confidence = wire.confidence_1;
  checks.Finite("confidence_1", wire.confidence_1);
  finding.decided = wire.decided != 0;
  std::copy(wire.posterior_1, wire.posterior_1 + kGeonLabelCount, finding.posterior.begin());
  finding.p_W_m = FromPoint(wire.place);
  finding.support_height_m = wire.support_height_m;
  finding.views = wire.views;
  finding.why = wire.why;
  return checks.Finish(std::move(finding));
}

geon::planner_state_t ToWire(const sensor::PlannerState& state) {
  geon::planner_state_t wire{};
  wire.utime = state.utime;
  wire.seq = state.seq;
  wire.phase = state.phase;
  wire.text = state.text;
  wire.outcome = static_cast<int32_t>(state.outcome);
  wire.x_m = state.x_m;
  wire.y_m = state.y_m;
  wire.heading_rad = state.heading_rad;
  wire.target_known = state.p_WTarget_m ? 1 : 0;
  wire.target = ToPoint(state.p_WTarget_m.value_or(Eigen::Vector2d::Zero()));
  wire.waypoint = ToPoint(state.p_WWaypoint_m);
  wire.nsafe = WireCount(state.safe_polygon_W_m);
  wire.safe_polygon = ToPoints(state.safe_polygon_W_m);
  wire.nobstacles = WireCount(state.obstacles_W_m);
  wire.obstacles = ToPoints(state.obstacles_W_m);
  wire.scan_id = state.scan_id;
  wire.stripe_index = state.stripe_index;
  wire.nfindings = WireCount(state.findings);
  for (const sensor::GeonFinding& finding : state.findings) {
    wire.findings.push_back(ToFinding(finding));
  }
  return wire;
}

Result<sensor::PlannerState> FromWire(const geon::planner_state_t& wire) {
  FieldChecks checks;
  sensor::PlannerState state;
  state.utime = wire.utime;
  state.seq = wire.seq;
  state.phase = wire.phase;
  state.text = wire.text;
  state.outcome = checks.Enumeration("outcome", wire.outcome, sensor::MissionOutcome::kSurveyed);
  state.x_m = wire.x_m;
  state.y_m = wire.y_m;
  state.heading_rad = wire.heading_rad;
  if (wire.target_known != 0) state.p_WTarget_m = FromPoint(wire.target);
  state.p_WWaypoint_m = FromPoint(wire.waypoint);
  state.safe_polygon_W_m = FromPoints(wire.safe_polygon);
  state.obstacles_W_m = FromPoints(wire.obstacles);
  state.scan_id = wire.scan_id;
  state.stripe_index = wire.stripe_index;
  for (const geon::finding_t& finding : wire.findings) {
    state.findings.push_back(checks.Part("findings", FromFinding(finding)));
  }
  return checks.Finish(std::move(state));
}

geon::target_view_t ToWire(const sensor::TargetView& view) {
  const sensor::PixelBox box = view.target_box.value_or(sensor::PixelBox{});
  geon::target_view_t wire{};
  wire.utime = view.utime;
  wire.seq = view.seq;
  wire.scan_id = view.scan_id;
  wire.found = view.target_box ? 1 : 0;
  wire.box_u_px = box.u_px;
  wire.box_v_px = box.v_px;
  wire.box_w_px = box.w_px;
  wire.box_h_px = box.h_px;
  wire.target_pixels = view.target_pixels;
  wire.pan_rad = view.pan_rad;
  wire.tilt_rad = view.tilt_rad;
  wire.view = ToWire(view.view);
  wire.mask = ToWire(view.mask);
  return wire;
}

Result<sensor::TargetView> FromWire(const geon::target_view_t& wire) {
  FieldChecks checks;
  sensor::TargetView view;
  view.utime = wire.utime;
  view.seq = wire.seq;
  view.scan_id = wire.scan_id;
  if (wire.found != 0) {
    view.target_box = sensor::PixelBox{wire.box_u_px, wire.box_v_px, wire.box_w_px, wire.box_h_px};
  }
  view.target_pixels = wire.target_pixels;
  view.pan_rad = wire.pan_rad;
  view.tilt_rad = wire.tilt_rad;
  view.view = checks.Part("view", FromWire(wire.view));
  view.mask = checks.Part("mask", FromWire(wire.mask));
  return checks.Finish(std::move(view));
}

}  // namespace geon::messaging
