#include "recognition/recognize_geon.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"
#include "recognition/decide_geon.h"
#include "recognition/explain_evidence.h"
#include "recognition/geon_forest.h"
#include "recognition/measure_evidence.h"
#include "recognition/target_profile.h"

namespace geon::recognition {
namespace {

using sensor::Laser;
using sensor::ProfileEvidence;
using sensor::RangeProfile;

void CheckScan(const sensor::ScanSet& scan) {
  for (const RangeProfile& profile : scan.profiles) {
    Require(profile.pixel.size() == profile.p_L_m.size(), "a profile's number of pixels",
            profile.pixel.size(), "must be that of its points");
  }
}

// A segment in its plane and the arc length to each of its points.
struct SegmentCurve {
  std::vector<Eigen::Vector2d> curve_m;
  std::vector<double> arc_m;
};

// Adds what one segment shows to the evidence of its profile; `offset_m` is the arc length before
// it.
void DescribeSegment(const SegmentCurve& segment, double noise_m, int samples, double offset_m,
                     const RecognitionOptions& options, ProfileEvidence* evidence) {
  const std::vector<Eigen::Vector2d> even_m =
      ResampleEqualArc(segment.curve_m, segment.arc_m, samples);
  const double step_m = ArcLength(even_m) / std::max(samples - 1, 1);
  ThetaPlot plot = ComputeThetaPlot(even_m, options.difference_of_slope);
  plot.noise_rad = ThetaNoise(noise_m, static_cast<double>(segment.curve_m.size()) / samples,
                              step_m, options.difference_of_slope);
  for (size_t i = 0; i < plot.theta_rad.size(); ++i) {
    evidence->arc_length_m.push_back(offset_m + (plot.first + static_cast<double>(i)) * step_m);
    evidence->theta_rad.push_back(plot.theta_rad[i]);
  }
  CurveFeatures features;
  switch (options.curvature) {
    case CurvatureMethod::kOGorman:
      features = FindFeatures(plot, options.difference_of_slope);
      break;
    case CurvatureMethod::kRamer:
      features = FindFeatures(even_m, RamerVertices(even_m, options.polyline.tolerance_m),
                              options.polyline);
      break;
    case CurvatureMethod::kWall:
      features = FindFeatures(even_m, WallVertices(even_m, options.polyline.tolerance_m),
                              options.polyline);
      break;
  }
  evidence->curves += features.curves;
  evidence->corners += features.corners;
  evidence->concavities += features.concavities;
}

ProfileEvidence DescribeProfile(const TargetProfile& target, const sensor::ScanSet& scan,
                                const RecognitionOptions& options) {
  ProfileEvidence evidence;
  evidence.laser = target.laser;
  evidence.fraction = target.fraction;
  evidence.segments = static_cast<int>(target.segments.size());
  if (target.segments.empty()) return evidence;
  const Eigen::Vector3d along_L = scan.rotation_LB.col(target.laser == Laser::kVertical ? 1 : 0);
  evidence.length_m = std::abs(along_L.dot(target.last_L() - target.first_L()));

  std::vector<SegmentCurve> segments;
  double total_m = 0.0;
  for (const PointRange& range : target.segments) {
    evidence.points += static_cast<int>(range.size());
    const auto points_L_m = std::span(target.p_L_m).subspan(range.begin, range.size());
    SegmentCurve& segment = segments.emplace_back();
    segment.curve_m = PlaneCurve(points_L_m, target.laser, target.R_LB);
    segment.arc_m = ArcLengths(segment.curve_m);
    total_m += segment.arc_m.back();
  }
  evidence.arc_length_m.reserve(static_cast<size_t>(options.samples));
  evidence.theta_rad.reserve(static_cast<size_t>(options.samples));
  double offset_m = 0.0;
  for (const SegmentCurve& segment : segments) {
    const double length_m = segment.arc_m.back();
    const int samples = static_cast<int>(std::lround(options.samples * length_m / total_m));
    if (samples >= 2) {
      DescribeSegment(segment, target.noise_m, samples, offset_m, options, &evidence);
    }
    offset_m += length_m;
  }
  return evidence;
}

bool BothDirectionsSeen(const std::vector<ProfileEvidence>& profiles) {
  const auto seen = [&profiles](Laser laser) {
    return std::any_of(profiles.begin(), profiles.end(), [laser](const ProfileEvidence& profile) {
      return profile.laser == laser && profile.segments > 0;
    });
  };
  return seen(Laser::kHorizontal) && seen(Laser::kVertical);
}

// The forest's answer.
void WeighEvidence(const TargetView& view, sensor::GeonVerdict* verdict) {
  const GeonForest& forest = TrainedForest();
  const EvidenceList evidence = MeasureEvidence(view);
  verdict->posterior = PosteriorOfVotes(CountVotes(forest, evidence.values()), forest.sharpness_1);
  const auto most = std::max_element(verdict->posterior.begin(), verdict->posterior.end());
  verdict->label = static_cast<GeonLabel>(most - verdict->posterior.begin());
  verdict->confidence = *most;
  verdict->decided = verdict->decided && *most >= forest.decided_1;
  verdict->reasons = ExplainEvidence(*verdict);
}

}  // namespace

sensor::GeonVerdict RecognizeGeon(const sensor::ScanSet& scan, const RecognitionOptions& options) {
  options.Validate();
  CheckScan(scan);
  sensor::GeonVerdict verdict;
  verdict.scan_id = scan.scan_id;
  verdict.method = ToString(options.method);

  // 1. and 2. Smoothing, background removal: sideways, then below.
  const BackgroundOptions background = options.BackgroundChosen();
  const std::optional<VerticalRegion> region = FindVerticalRegion(scan, background);
  const std::vector<RegionProfile> parts = FindRegionProfiles(scan, region);
  std::vector<TargetProfile> targets;
  targets.reserve(parts.size());
  const ScanLabels labels = LabelPoints(scan, region, parts, background);
  const bool fitted = background.method == BackgroundMethod::kFitted;
  for (size_t k = 0; k < parts.size(); ++k) {
    targets.push_back(FindTargetProfile(parts[k], options.smoothing, background, options.segments,
                                        fitted ? labels.on_target[k] : std::vector<bool>{}));
  }
  // 3. Corners, curves and lines.
  verdict.profiles.reserve(targets.size());
  for (const TargetProfile& target : targets) {
    verdict.profiles.push_back(DescribeProfile(target, scan, options));
  }
  // 4. Evidence of bending.
  const std::vector<ProfileEnds> horizontal =
      FindProfileEnds(targets, Laser::kHorizontal, CameraAtTarget(scan));
  const std::vector<ProfileEnds> vertical =
      FindProfileEnds(targets, Laser::kVertical, CameraAtTarget(scan));
  verdict.bending = FindBending(verdict.profiles, horizontal, vertical, options.bending);
  // 5. Evidence of tapering.
  verdict.tapering = FindTapering(horizontal, vertical, options.tapering);
  // 6. The decision tree, or the weighing of the same evidence.
  verdict.decided = BothDirectionsSeen(verdict.profiles);
  if (options.method == Method::kThesis) {
    DecideGeon(&verdict);
  } else {
    WeighEvidence(FindTargetView(scan, region, parts, labels, background, options.segments),
                  &verdict);
  }
  return verdict;
}

}  // namespace geon::recognition
