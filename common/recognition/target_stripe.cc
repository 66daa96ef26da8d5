#include "recognition/target_stripe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "recognition/profile_noise.h"

namespace geon::recognition {
namespace {

using sensor::Laser;
using sensor::RangeProfile;

constexpr double kSpike = 5.0;          // sigmas
constexpr double kSmallSpike_m = 1e-3;  // less is no spike, however quiet the profile
constexpr size_t kSmoothed = 50;        // a stripe has so many windows of smoothing
constexpr size_t kWidestWindow = 7;     // points to each side

double MedianOfFive(std::array<double, 5> values) {
  std::nth_element(values.begin(), values.begin() + 2, values.end());
  return values[2];
}

// The profile without the points that stand apart from their neighbours on both sides.
RangeProfile WithoutSpikes(const RangeProfile& profile, const Eigen::Matrix3d& R_LB,
                           double noise_m) {
  const double spike_m = std::max(kSpike * noise_m, kSmallSpike_m);
  std::vector<double> z_m;
  z_m.reserve(profile.p_L_m.size());
  for (const Eigen::Vector3d& p_L : profile.p_L_m) z_m.push_back(R_LB.col(2).dot(p_L));
  RangeProfile clean = profile;
  clean.pixel.clear();
  clean.p_L_m.clear();
  for (size_t i = 0; i < z_m.size(); ++i) {
    if (i >= 2 && i + 2 < z_m.size()) {
      const double middle_m =
          MedianOfFive({z_m[i - 2], z_m[i - 1], z_m[i], z_m[i + 1], z_m[i + 2]});
      if (std::abs(z_m[i] - middle_m) > spike_m) continue;
    }
    clean.pixel.push_back(profile.pixel[i]);
    clean.p_L_m.push_back(profile.p_L_m[i]);
  }
  return clean;
}

// Moving average of a curve over `half` points to each side, less at its ends.
void AppendSmoothed(const std::vector<Eigen::Vector2d>& curve_m, size_t half,
                    std::vector<Eigen::Vector2d>* smooth_m) {
  for (size_t i = 0; i < curve_m.size(); ++i) {
    const size_t reach = std::min({half, i, curve_m.size() - 1 - i});
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (size_t k = i - reach; k <= i + reach; ++k) sum += curve_m[k];
    smooth_m->push_back(sum / (2.0 * static_cast<double>(reach) + 1.0));
  }
}

TargetStripe FindTargetStripe(const RangeProfile& profile, const sensor::ScanSet& scan,
                              const std::optional<VerticalRegion>& region,
                              const BackgroundOptions& background, const SegmentOptions& options) {
  TargetStripe stripe;
  stripe.laser = profile.laser;
  stripe.fraction = profile.fraction;
  const Eigen::Matrix3d R_LB = profile.rotation_LB.value_or(scan.rotation_LB);
  stripe.noise_m = DepthNoise(profile, scan.camera_position_L_m, R_LB);
  const RangeProfile target =
      RemoveBackground(WithoutSpikes(profile, R_LB, stripe.noise_m), scan, region, background);
  for (const RangeProfile& segment : SplitIntoSegments(target, options)) {
    stripe.segment_begins.push_back(stripe.p_L_m.size());
    stripe.p_L_m.insert(stripe.p_L_m.end(), segment.p_L_m.begin(), segment.p_L_m.end());
    const size_t half = std::clamp<size_t>(target.p_L_m.size() / (2 * kSmoothed), 1, kWidestWindow);
    AppendSmoothed(PlaneCurve(segment, R_LB), half, &stripe.curve_m);
  }
  return stripe;
}

}  // namespace

std::vector<TargetStripe> FindTargetStripes(const sensor::ScanSet& scan,
                                            const BackgroundOptions& background,
                                            const SegmentOptions& segments) {
  const std::optional<VerticalRegion> region = FindVerticalRegion(scan, background);
  std::vector<TargetStripe> stripes;
  for (Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    for (double fraction : {0.25, 0.5, 0.75}) {
      const RangeProfile* nearest = nullptr;
      for (const RangeProfile& profile : scan.profiles) {
        if (profile.laser != laser || std::abs(profile.fraction - fraction) > 0.125) continue;
        if (!nearest ||
            std::abs(profile.fraction - fraction) < std::abs(nearest->fraction - fraction)) {
          nearest = &profile;
        }
      }
      stripes.push_back(nearest ? FindTargetStripe(*nearest, scan, region, background, segments)
                                : TargetStripe{laser, fraction, {}, {}, {}, 0.0});
    }
  }
  return stripes;
}

}  // namespace geon::recognition
