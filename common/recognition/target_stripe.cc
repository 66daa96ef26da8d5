#include "recognition/target_stripe.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angles.h"
#include "recognition/median.h"
#include "recognition/support_plane.h"
#include "recognition/target_extent.h"

namespace geon::recognition {
namespace {

using geometry::RigidTransform;
using sensor::Laser;

constexpr double kSpike = 5.0;          // sigmas
constexpr int kSpikeWindow = 2;         // points to each side
constexpr double kSmallSpike_m = 1e-3;  // less is no spike, however quiet the profile
constexpr size_t kSmoothed = 50;        // a stripe has so many windows of smoothing
constexpr size_t kWidestWindow = 7;     // points to each side
constexpr double kGrazing_rad = RadiansFromDegrees(4.0);  // less steep than this to the ray
constexpr size_t kGrazingShare = 40;                      // of a segment tells its end's direction
constexpr double kFarthestPlace_1 = 0.125;  // from 1/4, 1/2, 3/4: half of what is between them
// How far the target may reach beyond the box that the stripes' places tell, in boxes.
constexpr double kBeyond_1 = 0.25;
constexpr double kSegmentBeyond_1 = 0.02;  // ... for the middle of a segment

// The points of one profile that may lie on the target, frame L level on the support.
struct Candidates {
  std::vector<Eigen::Vector3d> p_L_m;
  std::vector<Eigen::Vector2d> tangent_B_1;  // x/z and y/z in the B/W camera
  double noise_m = 0.0;

  // Drops what lies far above or below the target.
  void KeepRows(const Extent& rows) {
    size_t kept = 0;
    for (size_t i = 0; i < p_L_m.size(); ++i) {
      if (!rows.Holds(tangent_B_1[i].y(), kBeyond_1)) continue;
      p_L_m[kept] = p_L_m[i];
      tangent_B_1[kept++] = tangent_B_1[i];
    }
    p_L_m.resize(kept);
    tangent_B_1.resize(kept);
  }
};

// The points of a profile that lie on the target and are no spikes.
Candidates FindCandidates(const RegionProfile& part, const std::vector<bool>& on_target,
                          const BwCamera& camera, const RigidTransform& level) {
  std::vector<double> middle_m(part.depth_m.size());
  RunningMedian(part.depth_m, kSpikeWindow, middle_m);
  const double spike_m = std::max(kSpike * part.noise_m, kSmallSpike_m);
  Candidates points;
  points.noise_m = part.noise_m;
  points.p_L_m.reserve(part.p_L_m.size());
  points.tangent_B_1.reserve(part.p_L_m.size());
  for (size_t i = 0; i < part.p_L_m.size(); ++i) {
    if (!on_target[i] || std::abs(part.depth_m[i] - middle_m[i]) > spike_m) continue;
    points.p_L_m.push_back(level * part.p_L_m[i]);
    points.tangent_B_1.push_back(Tangents(camera.InCamera(part.p_L_m[i])));
  }
  return points;
}

// One of the six stripes: where it should lie, and the profile nearest to there, if there is one.
struct Place {
  Laser laser = Laser::kHorizontal;
  double fraction = 0.5;
  const RegionProfile* profile = nullptr;
};

// Horizontal places first.
std::array<Place, 6> FindPlaces(std::span<const RegionProfile> profiles) {
  std::array<Place, 6> places;
  for (size_t k = 0; k < places.size(); ++k) {
    Place& place = places[k];
    place.laser = k < 3 ? Laser::kHorizontal : Laser::kVertical;
    place.fraction = 0.25 * static_cast<double>(k % 3 + 1);
    double nearest_1 = 0.0;
    for (const RegionProfile& profile : profiles) {
      const double off_1 = std::abs(profile.fraction - place.fraction);
      if (profile.laser != place.laser || off_1 > kFarthestPlace_1) continue;
      if (place.profile && off_1 >= nearest_1) continue;
      place.profile = &profile;
      nearest_1 = off_1;
    }
    if (place.profile) place.fraction = place.profile->fraction;
  }
  return places;
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

// The segments of the points whose middle lies on the target. `along` is the target's extent in the
// stripe's direction, `R_LB` the camera at the stripe.
TargetStripe MakeStripe(const Candidates& points, const Place& place,
                        const std::optional<Extent>& along, const Eigen::Vector3d& p_LB_m,
                        const Eigen::Matrix3d& R_LB, const SegmentOptions& options) {
  TargetStripe stripe;
  stripe.laser = place.laser;
  stripe.fraction = place.fraction;
  stripe.noise_m = points.noise_m;
  const int axis = place.laser == Laser::kVertical ? 1 : 0;
  const size_t fewest = static_cast<size_t>(options.fewest_points);
  for (const PointRange& segment : FindSegments(points.p_L_m, options)) {
    const Eigen::Vector2d& middle_1 = points.tangent_B_1[(segment.begin + segment.end) / 2];
    if (along && !along->Holds(middle_1[axis], kSegmentBeyond_1)) continue;
    AppendSegment(points, WithoutGrazingEnds(points, segment, p_LB_m, fewest), R_LB, &stripe);
  }
  return stripe;
}

}  // namespace

TargetView FindTargetView(const sensor::ScanSet& scan, const std::optional<VerticalRegion>& region,
                          std::span<const RegionProfile> profiles, const ScanLabels& labels,
                          const BackgroundOptions& background, const SegmentOptions& segments) {
  const BwCamera camera = CameraAtTarget(scan);
  const RigidTransform level =
      labels.support ? LevelOn(*labels.support) : RigidTransform::Identity();
  const std::array<Place, 6> places = FindPlaces(profiles);
  std::array<Candidates, 6> candidates;
  for (size_t k = 0; k < places.size(); ++k) {
    if (!places[k].profile) continue;
    const auto at = static_cast<size_t>(places[k].profile - profiles.data());
    candidates[k] = FindCandidates(*places[k].profile, labels.on_target[at], camera, level);
  }

  const std::optional<Extent> rows = FindRows(profiles, camera);
  const std::optional<Extent> columns = FindColumns(scan, region, background.margin_px);
  TargetView view;
  view.camera = {level * camera.p_LB_m, level.linear() * camera.R_LB};
  for (size_t k = 0; k < places.size(); ++k) {
    const bool vertical = places[k].laser == Laser::kVertical;
    if (rows && vertical) candidates[k].KeepRows(*rows);
    const Eigen::Matrix3d R_LB =
        level.linear() * (places[k].profile ? places[k].profile->camera.R_LB : camera.R_LB);
    view.stripes.push_back(MakeStripe(candidates[k], places[k], vertical ? rows : columns,
                                      view.camera.p_LB_m, R_LB, segments));
  }
  return view;
}

}  // namespace geon::recognition
