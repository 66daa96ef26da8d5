#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "procs/geon/report_figures.h"
#include "procs/geon/svg.h"
#include "procs/recognizer/scan_assembler.h"
#include "recognition/label_points.h"

namespace geon::cli {
namespace {

constexpr double kWidth_px = 320.0;
constexpr double kProfileHeight_px = 190.0;
constexpr double kThetaHeight_px = 96.0;

using Points = std::vector<Eigen::Vector2d>;

// The stripe's points as one looks at them: horizontal stripes from above (camera below the
// picture), vertical ones from the side (camera to the left, the floor as it lies).
Eigen::Vector2d InPicture(const Eigen::Vector3d& p_L_m, sensor::Laser laser) {
  if (laser == sensor::Laser::kVertical) return {p_L_m.x(), p_L_m.z()};
  return {-p_L_m.y(), p_L_m.x()};
}

std::string FractionName(double fraction) {
  if (fraction == 0.25) return "¼";
  if (fraction == 0.5) return "½";
  if (fraction == 0.75) return "¾";
  return Fixed(fraction, 2);
}

std::string ProfileSvg(const sensor::RangeProfile& profile, const std::vector<bool>& on_target) {
  Points target;
  Points background;
  for (size_t i = 0; i < profile.p_L_m.size(); ++i) {
    const Eigen::Vector2d p = InPicture(profile.p_L_m[i], profile.laser);
    (on_target[i] ? target : background).push_back(p);
  }
  const Points& framed = target.size() >= 2 ? target : background;
  if (framed.empty()) return "<p class=\"muted\">No points.</p>";
  Eigen::Vector2d low = framed.front();
  Eigen::Vector2d high = framed.front();
  for (const Eigen::Vector2d& p : framed) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(0.15 * (high - low).maxCoeff() + 0.005);
  Plot plot(kWidth_px, kProfileHeight_px, low - margin, high + margin, true);
  plot.Dots(background, 1.1, "background");
  plot.Dots(target, 1.5, "target");
  if (profile.laser == sensor::Laser::kVertical) {
    plot.Line({low.x() - 1.0, 0.0}, {high.x() + 1.0, 0.0}, "floor");
  }
  const Eigen::Vector2d corner = low - margin;
  const double bar_m = 0.05;
  const Eigen::Vector2d from =
      corner + Eigen::Vector2d(0.02, 0.04).cwiseProduct(high - low + 2 * margin);
  plot.Line(from, from + Eigen::Vector2d(bar_m, 0), "scale");
  plot.Text(from + Eigen::Vector2d(bar_m, 0), {4, 3}, "start", "small", "5 cm");
  return plot.Svg("profile of the stripe " + StripeName(profile.laser, profile.fraction));
}

std::string ThetaSvg(const sensor::ProfileEvidence& evidence) {
  if (evidence.theta_rad.empty()) return "<p class=\"muted\">Too short for a theta-plot.</p>";
  const double zero_range_rad = recognition::DifferenceOfSlopeOptions().zero_range_rad;
  double limit_rad = 1.0;
  for (const double theta_rad : evidence.theta_rad)
    limit_rad = std::max(limit_rad, std::abs(theta_rad));
  const double length_m = std::max(evidence.arc_length_m.back(), 1e-3);
  Plot plot(kWidth_px, kThetaHeight_px, {0.0, -1.08 * limit_rad},
            {1.02 * length_m, 1.08 * limit_rad}, false);
  plot.Band(-zero_range_rad, zero_range_rad, "zero-range");
  plot.Line({0, 0}, {1.02 * length_m, 0}, "axis");
  Points curve;
  for (size_t i = 0; i < evidence.theta_rad.size(); ++i) {
    const Eigen::Vector2d p(evidence.arc_length_m[i], evidence.theta_rad[i]);
    // A jump along the arc is a new segment.
    if (!curve.empty() && p.x() - curve.back().x() > 0.08 * length_m) {
      plot.Polyline(curve, "theta");
      curve.clear();
    }
    curve.push_back(p);
  }
  plot.Polyline(curve, "theta");
  plot.Text({0, limit_rad}, {3, 8}, "start", "small",
            "θ ±" + Fixed(DegreesFromRadians(limit_rad), 0) + "°");
  plot.Text({1.02 * length_m, -limit_rad}, {-3, -2}, "end", "small",
            Fixed(100.0 * length_m, 0) + " cm along the profile");
  return plot.Svg("theta-plot");
}

std::string Plural(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string Caption(const sensor::ProfileEvidence& evidence) {
  if (evidence.segments == 0) return "nothing of the target";
  std::string text = Plural(evidence.curves, "curve", "curves") + ", " +
                     Plural(evidence.corners, "corner", "corners");
  if (evidence.concavities > 0)
    text += ", " + Plural(evidence.concavities, "concavity", "concavities");
  if (evidence.segments > 1) text += ", " + std::to_string(evidence.segments) + " segments";
  return text + "; " + Fixed(1000.0 * evidence.length_m, 0) + " mm";
}

const sensor::ProfileEvidence* EvidenceOf(const RunRecord& run,
                                          const sensor::RangeProfile& profile) {
  if (!run.verdict || run.verdict->scan_id != profile.scan_id) return nullptr;
  for (const sensor::ProfileEvidence& evidence : run.verdict->profiles) {
    if (evidence.laser == profile.laser && evidence.fraction == profile.fraction) return &evidence;
  }
  return nullptr;
}

}  // namespace

std::string StripeName(sensor::Laser laser, double fraction_1) {
  const bool vertical = laser == sensor::Laser::kVertical;
  return std::string(vertical ? "Vertical " : "Horizontal ") + FractionName(fraction_1) +
         (vertical ? " from the left" : " from the top");
}

std::string StripeFigures(const RunRecord& run, const geometry::SensorRig& rig) {
  if (!run.plan || run.profiles.empty()) return "<p class=\"muted\">No stripe was measured.</p>";
  std::vector<sensor::RangeProfile> profiles;
  for (const auto& [index, profile] : run.profiles) profiles.push_back(profile);
  const sensor::ScanSet scan = recognizer::MakeScanSet(rig, *run.plan, profiles);
  const std::vector<std::vector<bool>> on_target = recognition::FindTargetPoints(scan, {});
  std::string html = "<div class=\"stripes\">";
  for (size_t k = 0; k < profiles.size(); ++k) {
    const sensor::RangeProfile& profile = profiles[k];
    html += "<figure class=\"card\"><h3>" + StripeName(profile.laser, profile.fraction) + "</h3>";
    html += ProfileSvg(profile, on_target[k]);
    if (const sensor::ProfileEvidence* evidence = EvidenceOf(run, profile)) {
      html += ThetaSvg(*evidence) + "<figcaption>" + Caption(*evidence) + "</figcaption>";
    }
    html += "</figure>";
  }
  return html + "</div>";
}

}  // namespace geon::cli
