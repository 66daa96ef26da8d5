#include "mission/scan_geometry.h"

#include <algorithm>
#include <cmath>

#include "base/median.h"

namespace geon::mission {

namespace {

constexpr size_t kMinPoints = 10;

}  // namespace

std::optional<StandingTarget> Standing(const geometry::SensorRig& rig, const HeadSighting& view,
                                       double support_height_m) {
  const auto foot =
      active_vision::LocateTargetFoot(rig, view.head, view.seen.bottom_px, support_height_m);
  if (!foot) return std::nullopt;
  const double camera_z_m =
      rig.StripeCameraPose(view.head.pan_rad, view.head.tilt_rad).translation().z();
  return StandingTarget{*foot, std::hypot(foot->distance_from_camera_m,
                                          camera_z_m - support_height_m - kTargetMiddle_m)};
}

Next ChooseScan(Context* context) {
  const auto& looking = context->options.looking;
  for (size_t tries = 0; tries < looking.support_heights_m.size(); ++tries) {
    const SupportHypothesis* best = context->target.Best();
    if (best == nullptr) break;
    const auto standing = Standing(context->rig, *context->view, best->support_height_m);
    if (standing && standing->range_m < looking.min_range_m) {
      return StepBack(context, "the target is nearer than the range finder reaches");
    }
    if (standing && standing->range_m <= looking.max_range_m) {
      return {Phase::kScan, "the whole target is in view and within range"};
    }
    context->target.Refute(best->support_height_m);
  }
  return {Phase::kDone, "the target is out of the range finder's reach on every known support"};
}

bool RefuteForAnother(Context* context, double support_height_m) {
  for (const SupportHypothesis& other : context->target.hypotheses()) {
    if (other.sightings == 0 || other.support_height_m == support_height_m) continue;
    const auto standing = Standing(context->rig, *context->view, other.support_height_m);
    if (!standing || standing->range_m > context->options.looking.max_range_m ||
        standing->range_m < context->options.looking.min_range_m) {
      continue;
    }
    context->target.Refute(support_height_m);
    return true;
  }
  return false;
}

std::optional<double> HeightByDistance(const Context& context, double distance_m,
                                       double tolerance_m) {
  std::optional<double> best_height_m;
  double best_error_m = tolerance_m;
  for (const SupportHypothesis& hypothesis : context.target.hypotheses()) {
    if (hypothesis.sightings == 0) continue;
    const auto standing = Standing(context.rig, *context.view, hypothesis.support_height_m);
    if (!standing) continue;
    const double error_m = std::abs(standing->foot.distance_from_camera_m - distance_m);
    if (error_m > best_error_m) continue;
    best_error_m = error_m;
    best_height_m = hypothesis.support_height_m;
  }
  return best_height_m;
}

std::optional<double> MeasuredDistance(const sensor::RangeProfile& profile,
                                       const geometry::PinholeCamera& stripe_camera, int box_w_px) {
  std::vector<double> distances_m;
  for (size_t i = 0; i < profile.pixel.size(); ++i) {
    if (std::abs(profile.pixel[i] - stripe_camera.cx_px) > 0.4 * box_w_px) continue;
    distances_m.push_back(profile.p_L_m[i].x());
  }
  if (distances_m.size() < kMinPoints) return std::nullopt;
  return Median(std::move(distances_m));
}

}  // namespace geon::mission
