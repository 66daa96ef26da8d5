#include "recognition/profile_curve.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

double EndToEnd(std::span<const Eigen::Vector3d> p_L_m, PointRange range) {
  return (p_L_m[range.end - 1] - p_L_m[range.begin]).norm();
}

}  // namespace

void SegmentOptions::Validate() const {
  Require(split_m > 0.0, "split_m", split_m, "must be positive");
  Require(shortest_m >= 0.0, "shortest_m", shortest_m, "must not be negative");
  Require(shortest_share_1 >= 0.0 && shortest_share_1 < 1.0, "shortest_share_1", shortest_share_1,
          "must be in [0, 1)");
  Require(fewest_points >= 2, "fewest_points", fewest_points, "must be at least 2");
}

std::vector<PointRange> FindSegments(std::span<const Eigen::Vector3d> p_L_m,
                                     const SegmentOptions& options) {
  std::vector<PointRange> segments;
  double longest_m = 0.0;
  const double square_split_m2 = options.split_m * options.split_m;
  size_t begin = 0;
  for (size_t i = 0; i < p_L_m.size(); ++i) {
    const bool last = i + 1 == p_L_m.size();
    if (!last && (p_L_m[i + 1] - p_L_m[i]).squaredNorm() <= square_split_m2) continue;
    segments.push_back({begin, i + 1});
    longest_m = std::max(longest_m, EndToEnd(p_L_m, segments.back()));
    begin = i + 1;
  }
  const double shortest_m = std::max(options.shortest_m, options.shortest_share_1 * longest_m);
  std::erase_if(segments, [&](PointRange part) {
    return static_cast<int>(part.size()) < options.fewest_points ||
           EndToEnd(p_L_m, part) < shortest_m;
  });
  return segments;
}

std::vector<Eigen::Vector2d> PlaneCurve(std::span<const Eigen::Vector3d> p_L_m, sensor::Laser laser,
                                        const Eigen::Matrix3d& R_LB) {
  const Eigen::Vector3d along_L = R_LB.col(laser == sensor::Laser::kVertical ? 1 : 0);
  const Eigen::Vector3d forward_L = R_LB.col(2);
  std::vector<Eigen::Vector2d> curve_m(p_L_m.size());
  for (size_t i = 0; i < p_L_m.size(); ++i) {
    curve_m[i] = {along_L.dot(p_L_m[i]), -forward_L.dot(p_L_m[i])};
  }
  return curve_m;
}

std::vector<Eigen::Vector2d> ResampleEqualArc(std::span<const Eigen::Vector2d> curve_m,
                                              std::span<const double> arc_m, int samples) {
  Require(samples >= 2, "the number of samples", samples, "must be at least 2");
  Require(curve_m.size() >= 2, "ResampleEqualArc needs at least 2 points");
  const double step_m = arc_m.back() / samples;
  std::vector<Eigen::Vector2d> resampled_m(static_cast<size_t>(samples), curve_m[0]);
  if (!(step_m > 0.0)) return resampled_m;
  // One walk: `from` is where it has come to, at the arc length from_m, on the way to point `next`.
  size_t next = 1;
  double from_m = 0.0;
  Eigen::Vector2d from = curve_m[0];
  for (size_t k = 0; k < resampled_m.size(); ++k) {
    const double end_m = static_cast<double>(k + 1) * step_m;
    Eigen::Vector2d doubled_integral = Eigen::Vector2d::Zero();
    while (next + 1 < curve_m.size() && arc_m[next] < end_m) {
      doubled_integral += (arc_m[next] - from_m) * (from + curve_m[next]);
      from_m = arc_m[next];
      from = curve_m[next++];
    }
    const double piece_m = arc_m[next] - from_m;
    const double t = piece_m > 0.0 ? (end_m - from_m) / piece_m : 0.0;
    const Eigen::Vector2d end = from + t * (curve_m[next] - from);
    doubled_integral += (end_m - from_m) * (from + end);
    resampled_m[k] = doubled_integral * (0.5 / step_m);
    from_m = end_m;
    from = end;
  }
  return resampled_m;
}

std::vector<double> ArcLengths(std::span<const Eigen::Vector2d> curve_m) {
  std::vector<double> arc_m(curve_m.size(), 0.0);
  for (size_t i = 1; i < curve_m.size(); ++i) {
    arc_m[i] = arc_m[i - 1] + (curve_m[i] - curve_m[i - 1]).norm();
  }
  return arc_m;
}

double ArcLength(std::span<const Eigen::Vector2d> curve_m) {
  double length_m = 0.0;
  for (size_t i = 1; i < curve_m.size(); ++i) length_m += (curve_m[i] - curve_m[i - 1]).norm();
  return length_m;
}

}  // namespace geon::recognition
