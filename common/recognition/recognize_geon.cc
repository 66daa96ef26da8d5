#include "recognition/recognize_geon.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/contracts.h"
#include "recognition/decide_geon.h"
#include "recognition/explain_evidence.h"
#include "recognition/geon_forest.h"
#include "recognition/measure_evidence.h"
#include "recognition/profile_noise.h"

namespace geon::recognition {
namespace {

using sensor::Laser;
using sensor::ProfileEvidence;
using sensor::RangeProfile;

void CheckScan(const sensor::ScanSet& scan) {
  for (const RangeProfile& profile : scan.profiles) {
    Require(profile.pixel.size() == profile.p_L_m.size(),
            "profile " + std::to_string(profile.stripe_index) + " has " +
                std::to_string(profile.pixel.size()) + " pixels and " +
                std::to_string(profile.p_L_m.size()) + " points");
  }
}

// One profile on the target, split where it does not hang together.
struct TargetProfile {
  double noise_m = 0.0;  // of its depths before smoothing
  RangeProfile profile;  // from the first point of the first segment to the last of the last
  std::vector<RangeProfile> segments;
};

TargetProfile FindTarget(const RangeProfile& profile, const sensor::ScanSet& scan,
                         const std::optional<VerticalRegion>& region,
                         const RecognitionOptions& options) {
  TargetProfile target;
  target.profile = RemoveBackground(profile, scan, region, options.background);
  target.segments = SplitIntoSegments(target.profile, options.segments);
  target.profile.pixel.clear();
  target.profile.p_L_m.clear();
  for (const RangeProfile& segment : target.segments) {
    auto& pixel = target.profile.pixel;
    auto& p_L_m = target.profile.p_L_m;
    pixel.insert(pixel.end(), segment.pixel.begin(), segment.pixel.end());
    p_L_m.insert(p_L_m.end(), segment.p_L_m.begin(), segment.p_L_m.end());
  }
  target.profile.on_target = static_cast<int32_t>(target.profile.pixel.size());
  return target;
}

// Adds what one segment shows to the evidence of its profile; `offset_m` is the arc length before
// it.
void DescribeSegment(const std::vector<Eigen::Vector2d>& curve_m, double noise_m, int samples,
                     double offset_m, const RecognitionOptions& options,
                     ProfileEvidence* evidence) {
  const std::vector<Eigen::Vector2d> even_m = ResampleEqualArc(curve_m, samples);
  const double step_m = ArcLength(even_m) / std::max(samples - 1, 1);
  ThetaPlot plot = ComputeThetaPlot(even_m, options.difference_of_slope);
  plot.noise_rad = ThetaNoise(noise_m, static_cast<double>(curve_m.size()) / samples, step_m,
                              options.difference_of_slope);
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
  const Eigen::Matrix3d R_LB = target.profile.rotation_LB.value_or(scan.rotation_LB);
  ProfileEvidence evidence;
  evidence.laser = target.profile.laser;
  evidence.fraction = target.profile.fraction;
  evidence.points = target.profile.on_target;
  evidence.segments = static_cast<int>(target.segments.size());
  if (target.segments.empty()) return evidence;
  const Eigen::Vector3d along_L = scan.rotation_LB.col(evidence.laser == Laser::kVertical ? 1 : 0);
  evidence.length_m =
      std::abs(along_L.dot(target.profile.p_L_m.back() - target.profile.p_L_m.front()));

  std::vector<std::vector<Eigen::Vector2d>> curves_m;
  double total_m = 0.0;
  for (const RangeProfile& segment : target.segments) {
    curves_m.push_back(PlaneCurve(segment, R_LB));
    total_m += ArcLength(curves_m.back());
  }
  double offset_m = 0.0;
  for (const std::vector<Eigen::Vector2d>& curve_m : curves_m) {
    const double length_m = ArcLength(curve_m);
    const int samples = static_cast<int>(std::lround(options.samples * length_m / total_m));
    if (samples >= 2) {
      DescribeSegment(curve_m, target.noise_m, samples, offset_m, options, &evidence);
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
void WeighEvidence(const sensor::ScanSet& scan, const RecognitionOptions& options,
                   sensor::GeonVerdict* verdict) {
  const GeonForest& forest = TrainedForest();
  const EvidenceList evidence = MeasureScan(scan, options);
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

  // 1. Smoothing.
  std::vector<RangeProfile> smooth;
  for (const RangeProfile& profile : scan.profiles) {
    smooth.push_back(SmoothProfile(profile, scan.camera_position_L_m,
                                   profile.rotation_LB.value_or(scan.rotation_LB),
                                   options.smoothing));
  }
  // 2. Background removal.
  const std::optional<VerticalRegion> region = FindVerticalRegion(scan, options.background);
  std::vector<RangeProfile> on_target;
  std::vector<TargetProfile> targets;
  for (size_t i = 0; i < smooth.size(); ++i) {
    targets.push_back(FindTarget(smooth[i], scan, region, options));
    targets.back().noise_m = DepthNoise(scan.profiles[i], scan.camera_position_L_m,
                                        scan.profiles[i].rotation_LB.value_or(scan.rotation_LB));
    on_target.push_back(targets.back().profile);
  }
  // 3. Corners, curves and lines.
  for (const TargetProfile& target : targets) {
    verdict.profiles.push_back(DescribeProfile(target, scan, options));
  }
  // 4. Evidence of bending.
  const std::vector<ProfileEnds> horizontal =
      FindProfileEnds(on_target, Laser::kHorizontal, scan.camera_position_L_m, scan.rotation_LB);
  const std::vector<ProfileEnds> vertical =
      FindProfileEnds(on_target, Laser::kVertical, scan.camera_position_L_m, scan.rotation_LB);
  verdict.bending = FindBending(verdict.profiles, horizontal, vertical, options.bending);
  // 5. Evidence of tapering.
  verdict.tapering = FindTapering(horizontal, vertical, options.tapering);
  // 6. The decision tree, or the weighing of the same evidence.
  verdict.decided = BothDirectionsSeen(verdict.profiles);
  if (options.method == Method::kThesis) {
    DecideGeon(&verdict);
  } else {
    WeighEvidence(scan, options, &verdict);
  }
  return verdict;
}

EvidenceList MeasureScan(const sensor::ScanSet& scan, const RecognitionOptions& options,
                         bool with_names) {
  return MeasureEvidence(FindTargetStripes(scan, options.background, options.segments),
                         scan.camera_position_L_m, scan.rotation_LB, with_names);
}

}  // namespace geon::recognition
