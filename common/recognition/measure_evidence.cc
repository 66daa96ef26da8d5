#include "recognition/measure_evidence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "recognition/face_evidence.h"
#include "recognition/outline_evidence.h"
#include "recognition/round_evidence.h"
#include "recognition/stripe_evidence.h"
#include "recognition/surface_evidence.h"

namespace geon::recognition {
namespace {

constexpr double kSmallestScale_m = 0.01;

double Length(const TargetStripe& stripe) {
  return stripe.empty() ? 0.0 : (stripe.p_L_m.back() - stripe.p_L_m.front()).norm();
}

// Mean length of the stripes that are there.
double Scale(const std::vector<TargetStripe>& stripes) {
  double sum_m = 0.0, count = 0.0;
  for (const TargetStripe& stripe : stripes) {
    if (stripe.empty()) continue;
    sum_m += Length(stripe);
    count += 1.0;
  }
  return std::max(kSmallestScale_m, count > 0.0 ? sum_m / count : 0.0);
}

void AddViewEvidence(const std::vector<TargetStripe>& stripes, const BwCamera& camera,
                     double scale_m, EvidenceList* evidence) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double lowest_m = kInfinity, highest_m = -kInfinity, nearest_m = kInfinity, farthest_m = 0.0;
  double noise_m = 0.0, seen = 0.0, segments = 0.0;
  for (const TargetStripe& stripe : stripes) {
    for (const Eigen::Vector3d& p_L : stripe.p_L_m) {
      const double depth_m = camera.InCamera(p_L).z();
      nearest_m = std::min(nearest_m, depth_m);
      farthest_m = std::max(farthest_m, depth_m);
      lowest_m = std::min(lowest_m, p_L.z());
      highest_m = std::max(highest_m, p_L.z());
    }
    if (stripe.empty()) continue;
    seen += 1.0;
    noise_m += stripe.noise_m;
    segments = std::max(segments, static_cast<double>(stripe.segment_begins.size()));
  }
  const bool any = seen > 0.0;
  evidence->Add("scale_m", scale_m);
  evidence->Add("seen", seen);
  evidence->Add("segments", segments);
  evidence->Add("noise", any ? noise_m / seen / scale_m : 0.0);
  evidence->Add("distance_m", any ? nearest_m : 0.0);
  evidence->Add("depth", any ? (farthest_m - nearest_m) / scale_m : 0.0);
  evidence->Add("height", any ? (highest_m - lowest_m) / scale_m : 0.0);
  evidence->Add("elevation", std::asin(std::clamp(-camera.R_LB(2, 2), -1.0, 1.0)));
}

}  // namespace

EvidenceList MeasureEvidence(const TargetView& view, bool with_names) {
  const std::vector<TargetStripe>& stripes = view.stripes;
  static const char* const kGroups[] = {"horizontal_1", "horizontal_2", "horizontal_3",
                                        "vertical_1",   "vertical_2",   "vertical_3"};
  EvidenceList evidence(with_names);
  const double scale_m = Scale(stripes);
  for (size_t k = 0; k < stripes.size(); ++k) {
    evidence.BeginGroup(kGroups[k]);
    AddStripeEvidence(stripes[k], scale_m, &evidence);
  }
  AddOutlineEvidence(stripes, view.camera, scale_m, &evidence);
  const CrossingGrid grid = FindCrossings(view);
  evidence.BeginGroup("surface");
  AddSurfaceEvidence(grid, scale_m, &evidence);
  evidence.BeginGroup("faces");
  AddFaceEvidence(stripes, grid, &evidence);
  evidence.BeginGroup("round");
  AddRoundEvidence(stripes, grid, scale_m, &evidence);
  evidence.BeginGroup("view");
  AddViewEvidence(stripes, view.camera, scale_m, &evidence);
  return evidence;
}

EvidenceList MeasureScan(const sensor::ScanSet& scan, const RecognitionOptions& options,
                         bool with_names) {
  const BackgroundOptions background = options.BackgroundChosen();
  const auto region = FindVerticalRegion(scan, background);
  const std::vector<RegionProfile> parts = FindRegionProfiles(scan, region);
  const TargetView view =
      FindTargetView(scan, region, parts, LabelPoints(scan, region, parts, background), background,
                     options.segments);
  return MeasureEvidence(view, with_names);
}

}  // namespace geon::recognition
