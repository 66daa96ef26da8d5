#include "recognition/target_stripe.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "base/angles.h"
#include "recognition/profile_noise.h"
#include "recognition/support_plane.h"

namespace geon::recognition {
namespace {

using geometry::RigidTransform;
using sensor::Laser;
using sensor::RangeProfile;

constexpr double kSpike = 5.0;          // sigmas
constexpr double kSmallSpike_m = 1e-3;  // less is no spike, however quiet the profile
constexpr size_t kSmoothed = 50;        // a stripe has so many windows of smoothing
constexpr size_t kWidestWindow = 7;     // points to each side
constexpr double kSupportSigmas = 3.0;
constexpr double kMostMargin_m = 0.02;
constexpr double kGrazing_rad = RadiansFromDegrees(4.0);  // less steep than this to the ray
constexpr size_t kGrazingShare = 40;                      // of a segment tells its end's direction
// How far the target may reach beyond the box that the stripes' places tell, in boxes.
constexpr double kBeyond_1 = 0.25;
constexpr double kSegmentBeyond_1 = 0.02;  // ... for the middle of a segment

// The points of one profile that may lie on the target, frame L level on the support.
struct Candidates {
  std::vector<Eigen::Vector3d> p_L_m;
  std::vector<Eigen::Vector2d> tangent_B_1;  // x/z and y/z in the B/W camera
  double noise_m = 0.0;

  template <typename Keep>
  void KeepIf(const Keep& keep) {
    size_t kept = 0;
    for (size_t i = 0; i < p_L_m.size(); ++i) {
      if (!keep(i)) continue;
      p_L_m[kept] = p_L_m[i];
      tangent_B_1[kept++] = tangent_B_1[i];
    }
    p_L_m.resize(kept);
    tangent_B_1.resize(kept);
  }
};

// What lies between two values of a tangent: 0 at the first, 1 at the last.
struct Extent {
  double first_1 = 0.0;
  double last_1 = 0.0;
  double Fraction(double tangent_1) const { return (tangent_1 - first_1) / (last_1 - first_1); }
  bool Holds(double tangent_1, double beyond_1) const {
    const double fraction = Fraction(tangent_1);
    return fraction >= -beyond_1 && fraction <= 1.0 + beyond_1;
  }
};

double MedianOfFive(double a, double b, double c, double d, double e) {
  const double low = std::max(std::min(a, b), std::min(c, d));
  const double high = std::min(std::max(a, b), std::max(c, d));
  return std::max(std::min(low, high), std::min(e, std::max(low, high)));
}

// Whether point i stands apart from its neighbours on both sides.
bool IsSpike(std::span<const double> depth_m, size_t i, double spike_m) {
  if (i < 2 || i + 2 >= depth_m.size()) return false;
  const double middle_m =
      MedianOfFive(depth_m[i - 2], depth_m[i - 1], depth_m[i], depth_m[i + 1], depth_m[i + 2]);
  return std::abs(depth_m[i] - middle_m) > spike_m;
}

// The points of the region of interest without spikes.
Candidates FindCandidates(const RangeProfile& profile, const sensor::ScanSet& scan,
                          const std::optional<VerticalRegion>& region,
                          const RigidTransform& level) {
  const PointRange range = FindRegionRange(profile.p_L_m, scan, region);
  const auto p_L_m = std::span(profile.p_L_m).subspan(range.begin, range.size());
  const std::vector<double> depth_m = ProfileDepths(p_L_m, scan.camera_position_L_m,
                                                    profile.rotation_LB.value_or(scan.rotation_LB));
  Candidates points;
  points.noise_m = DepthNoise(std::span(profile.pixel).subspan(range.begin, range.size()), depth_m);
  points.p_L_m.reserve(p_L_m.size());
  points.tangent_B_1.reserve(p_L_m.size());
  const double spike_m = std::max(kSpike * points.noise_m, kSmallSpike_m);
  const Eigen::Matrix3d R_BL = scan.rotation_LB.transpose();
  for (size_t i = 0; i < p_L_m.size(); ++i) {
    if (IsSpike(depth_m, i, spike_m)) continue;
    const Eigen::Vector3d p_B_m = R_BL * (p_L_m[i] - scan.camera_position_L_m);
    if (p_B_m.z() <= 0.0) continue;
    const Eigen::Vector2d tangent_1 = p_B_m.head<2>() / p_B_m.z();
    if (region &&
        (tangent_1.x() < region->min_tangent_1 || tangent_1.x() > region->max_tangent_1)) {
      continue;
    }
    points.p_L_m.push_back(level * p_L_m[i]);
    points.tangent_B_1.push_back(tangent_1);
  }
  return points;
}

// The rows of the target box: a line through (fraction, row) of the horizontal stripes.
std::optional<Extent> FindRows(std::span<const Candidates> horizontal,
                               std::span<const double> fractions) {
  double n = 0.0, sum_f = 0.0, sum_t = 0.0, sum_ff = 0.0, sum_ft = 0.0;
  for (size_t k = 0; k < horizontal.size(); ++k) {
    if (horizontal[k].p_L_m.empty()) continue;
    const double tangent_1 = horizontal[k].tangent_B_1[horizontal[k].p_L_m.size() / 2].y();
    n += 1.0;
    sum_f += fractions[k];
    sum_t += tangent_1;
    sum_ff += fractions[k] * fractions[k];
    sum_ft += fractions[k] * tangent_1;
  }
  const double spread = sum_ff - sum_f * sum_f / std::max(n, 1.0);
  if (n < 2.0 || spread < 1e-6) return std::nullopt;
  const double slope = (sum_ft - sum_f * sum_t / n) / spread;
  if (slope <= 0.0) return std::nullopt;
  const double first_1 = (sum_t - slope * sum_f) / n;
  return Extent{first_1, first_1 + slope};
}

// The columns of the target box, without the margin that belongs to its region of interest.
std::optional<Extent> FindColumns(const sensor::ScanSet& scan,
                                  const std::optional<VerticalRegion>& region, int margin_px) {
  if (!region || !scan.target_box) return std::nullopt;
  const double margin_1 = margin_px / (scan.target_box->w_px - 1.0 + 2.0 * margin_px);
  const double width_1 = region->max_tangent_1 - region->min_tangent_1;
  return Extent{region->min_tangent_1 + margin_1 * width_1,
                region->max_tangent_1 - margin_1 * width_1};
}

// Whether the points run along the viewing rays between `outer` and `inner`.
bool Grazes(const Candidates& points, size_t outer, size_t inner, const Eigen::Vector3d& p_LB_m) {
  static const double square_cosine = std::pow(std::cos(kGrazing_rad), 2);
  const Eigen::Vector3d along_L = points.p_L_m[inner] - points.p_L_m[outer];
  const Eigen::Vector3d ray_L = points.p_L_m[outer] - p_LB_m;
  return std::pow(along_L.dot(ray_L), 2) >
         square_cosine * along_L.squaredNorm() * ray_L.squaredNorm();
}

PointRange WithoutGrazingEnds(const Candidates& points, PointRange segment,
                              const Eigen::Vector3d& p_LB_m, size_t fewest) {
  const size_t reach = std::max<size_t>(segment.size() / kGrazingShare, 2);
  while (segment.size() > fewest + reach &&
         Grazes(points, segment.begin, segment.begin + reach, p_LB_m)) {
    ++segment.begin;
  }
  while (segment.size() > fewest + reach &&
         Grazes(points, segment.end - 1, segment.end - 1 - reach, p_LB_m)) {
    --segment.end;
  }
  return segment;
}

// Moving average over `half` points to each side, less at the ends.
void AppendSmoothed(std::span<const Eigen::Vector2d> curve_m, size_t half,
                    std::vector<Eigen::Vector2d>* smooth_m) {
  for (size_t i = 0; i < curve_m.size(); ++i) {
    const size_t reach = std::min({half, i, curve_m.size() - 1 - i});
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (size_t k = i - reach; k <= i + reach; ++k) sum += curve_m[k];
    smooth_m->push_back(sum / (2.0 * static_cast<double>(reach) + 1.0));
  }
}

void AppendSegment(const Candidates& points, PointRange segment, const Eigen::Matrix3d& R_LB,
                   TargetStripe* stripe) {
  const auto append = [&segment](const auto& from, auto* to) {
    to->insert(to->end(), from.begin() + static_cast<std::ptrdiff_t>(segment.begin),
               from.begin() + static_cast<std::ptrdiff_t>(segment.end));
  };
  stripe->segment_begins.push_back(stripe->p_L_m.size());
  append(points.p_L_m, &stripe->p_L_m);
  append(points.tangent_B_1, &stripe->tangent_B_1);
  const size_t half = std::clamp<size_t>(points.p_L_m.size() / (2 * kSmoothed), 1, kWidestWindow);
  AppendSmoothed(PlaneCurve(std::span(points.p_L_m).subspan(segment.begin, segment.size()),
                            stripe->laser, R_LB),
                 half, &stripe->curve_m);
}

// The profiles nearest to 1/4, 1/2 and 3/4, horizontal ones first; nullptr where there is none.
std::vector<const RangeProfile*> SixProfiles(const sensor::ScanSet& scan) {
  std::vector<const RangeProfile*> six;
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
      six.push_back(nearest);
    }
  }
  return six;
}

}  // namespace

TargetView FindTargetView(const sensor::ScanSet& scan, const BackgroundOptions& background,
                          const SegmentOptions& options) {
  const std::optional<VerticalRegion> region = FindVerticalRegion(scan, background);
  const std::optional<SupportPlane> support = FitSupportPlane(scan, region);
  const RigidTransform level = support ? LevelOn(*support) : RigidTransform::Identity();
  double margin_m = background.floor_margin_m;
  if (support) {
    margin_m = std::max(margin_m, std::min(kSupportSigmas * support->sigma_m, kMostMargin_m));
  }
  TargetView view;
  view.p_LB_m = level * scan.camera_position_L_m;
  view.R_LB = level.linear() * scan.rotation_LB;

  const std::vector<const RangeProfile*> six = SixProfiles(scan);
  std::vector<Candidates> candidates(six.size());
  std::vector<double> fractions;
  for (size_t k = 0; k < six.size(); ++k) {
    fractions.push_back(six[k] ? six[k]->fraction : 0.25 * static_cast<double>(k % 3 + 1));
    if (!six[k]) continue;
    candidates[k] = FindCandidates(*six[k], scan, region, level);
    candidates[k].KeepIf([&](size_t i) { return candidates[k].p_L_m[i].z() > margin_m; });
  }
  const std::optional<Extent> rows = FindRows(std::span(candidates).first(3), fractions);
  const std::optional<Extent> columns = FindColumns(scan, region, background.margin_px);

  for (size_t k = 0; k < six.size(); ++k) {
    Candidates& points = candidates[k];
    const bool vertical = k >= 3;
    if (rows && vertical) {
      points.KeepIf([&](size_t i) { return rows->Holds(points.tangent_B_1[i].y(), kBeyond_1); });
    }
    TargetStripe stripe;
    stripe.laser = vertical ? Laser::kVertical : Laser::kHorizontal;
    stripe.fraction = fractions[k];
    stripe.noise_m = points.noise_m;
    const std::optional<Extent>& along = vertical ? rows : columns;
    const Eigen::Matrix3d R_LB =
        level.linear() *
        (six[k] ? six[k]->rotation_LB.value_or(scan.rotation_LB) : scan.rotation_LB);
    for (const PointRange& segment : FindSegments(points.p_L_m, options)) {
      const Eigen::Vector2d& middle_1 = points.tangent_B_1[(segment.begin + segment.end) / 2];
      if (along && !along->Holds(middle_1[vertical ? 1 : 0], kSegmentBeyond_1)) continue;
      AppendSegment(points,
                    WithoutGrazingEnds(points, segment, view.p_LB_m,
                                       static_cast<size_t>(options.fewest_points)),
                    R_LB, &stripe);
    }
    view.stripes.push_back(std::move(stripe));
  }
  return view;
}

}  // namespace geon::recognition
