#include "recognition/stripe_evidence.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "recognition/difference_of_slope.h"
#include "recognition/line_moments.h"
#include "recognition/quantiles.h"

namespace geon::recognition {
namespace {

constexpr int kFineSamples = 110;
constexpr int kCoarseSamples = 60;

using Curve = std::vector<Eigen::Vector2d>;

// A stripe's segments with their arc lengths.
struct Segments {
  std::vector<std::span<const Eigen::Vector2d>> curves_m;
  std::vector<std::vector<double>> arcs_m;
  double total_m = 0.0;
};

Segments FindArcs(const TargetStripe& stripe) {
  Segments segments;
  const std::span<const Eigen::Vector2d> all = stripe.curve_m;
  for (size_t s = 0; s < stripe.segment_begins.size(); ++s) {
    const size_t begin = stripe.segment_begins[s];
    segments.curves_m.push_back(all.subspan(begin, stripe.SegmentEnd(s) - begin));
    segments.arcs_m.push_back(ArcLengths(segments.curves_m.back()));
    segments.total_m += segments.arcs_m.back().back();
  }
  return segments;
}

// Resampled to about `samples` points in all.
std::vector<Curve> Resample(const Segments& segments, int samples) {
  std::vector<Curve> pieces;
  for (size_t s = 0; s < segments.curves_m.size(); ++s) {
    const double share = segments.arcs_m[s].back() / segments.total_m;
    const auto own = static_cast<int>(std::lround(samples * share));
    pieces.push_back(ResampleEqualArc(segments.curves_m[s], segments.arcs_m[s], std::max(own, 2)));
  }
  return pieces;
}

// How the stripe turns: quantiles of theta, its place of most turning, how much it turns in all.
void AddTurning(std::string_view name, const std::vector<Curve>& pieces, EvidenceList* evidence) {
  std::vector<double> theta_rad;
  double sum_rad = 0.0, magnitude_rad = 0.0;
  for (const Curve& piece : pieces) {
    const ThetaPlot plot = ComputeThetaPlot(piece, DifferenceOfSlopeOptions());
    theta_rad.insert(theta_rad.end(), plot.theta_rad.begin(), plot.theta_rad.end());
  }
  for (double theta : theta_rad) {
    sum_rad += theta;
    magnitude_rad += std::abs(theta);
  }
  const auto most = std::max_element(theta_rad.begin(), theta_rad.end());
  const double count = std::max(1.0, static_cast<double>(theta_rad.size()));
  evidence->Add(name, "place", static_cast<double>(most - theta_rad.begin()) / count);
  evidence->Add(name, "mean", sum_rad / count);
  evidence->Add(name, "one_sided", magnitude_rad > 0.0 ? std::abs(sum_rad) / magnitude_rad : 0.0);
  AddQuantiles(name, std::move(theta_rad), evidence);
}

// How far the points lie from a line, from two lines, from a circle: rms over the stripe's length.
void AddFits(const Curve& points, double length_m, double scale_m, EvidenceList* evidence) {
  const std::vector<LineMoments> until = RunningMoments(points);
  const double n = static_cast<double>(points.size());
  const auto relative = [&](double squares) { return std::sqrt(squares / n) / length_m; };
  double two_lines = until.back().LineResidual();
  size_t corner = points.size() / 2;
  for (size_t k = 4; k + 4 < until.size(); ++k) {
    const double both = until[k].LineResidual() + (until.back() - until[k]).LineResidual();
    if (both < two_lines) {
      two_lines = both;
      corner = k;
    }
  }
  // Circle x^2 + y^2 + a x + b y + c = 0 about the mean, by least squares (Kasa).
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& p : points) mean += p / n;
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  double square = 0.0;
  for (const Eigen::Vector2d& p : points) square += (p - mean).squaredNorm() / n;
  for (const Eigen::Vector2d& p : points) {
    const Eigen::Vector2d d = p - mean;
    A += d * d.transpose();
    b += 0.5 * d * (d.squaredNorm() - square);
  }
  A.diagonal().array() += 1e-9 * A.trace() + 1e-15;
  const Eigen::Vector2d centre = A.ldlt().solve(b);
  const double radius_m = std::sqrt(centre.squaredNorm() + square);
  double circle = 0.0;
  for (const Eigen::Vector2d& p : points) {
    circle += std::pow((p - mean - centre).norm() - radius_m, 2);
  }
  const double line = relative(until.back().LineResidual());
  evidence->Add("line", line);
  evidence->Add("two_lines", relative(two_lines));
  evidence->Add("circle", relative(circle));
  evidence->Add("circle_to_lines", relative(circle) / (relative(two_lines) + 1e-3));
  evidence->Add("corner_place", static_cast<double>(corner) / n);
  const double side = centre.y() < 0.0 ? 1.0 : -1.0;  // convex: the centre lies behind
  evidence->Add("curvature", side * scale_m / radius_m);
}

// How far the stripe rises above and falls below its chord, and where.
void AddSagitta(const Curve& points, double length_m, EvidenceList* evidence) {
  const Eigen::Vector2d chord = points.back() - points.front();
  const Eigen::Vector2d normal = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
  double highest_m = 0.0, lowest_m = 0.0;
  size_t place = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double height_m = normal.dot(points[i] - points.front());
    lowest_m = std::min(lowest_m, height_m);
    if (height_m > highest_m) {
      highest_m = height_m;
      place = i;
    }
  }
  evidence->Add("rise", highest_m / length_m);
  evidence->Add("fall", lowest_m / length_m);
  evidence->Add("rise_place", static_cast<double>(place) / static_cast<double>(points.size()));
  evidence->Add("chord_slope", std::atan2(chord.y(), std::abs(chord.x())));
}

// Where the stripe leads in the level frame: how steeply, and at which azimuth.
void AddDirections(const TargetStripe& stripe, EvidenceList* evidence) {
  std::vector<double> slopes_rad, azimuths_rad;
  const size_t step = std::max<size_t>(stripe.p_L_m.size() / 12, 1);
  for (size_t i = 0; i + 2 * step <= stripe.p_L_m.size(); i += step) {
    Eigen::Vector3d before = Eigen::Vector3d::Zero(), after = before;
    for (size_t k = 0; k < step; ++k) {
      before += stripe.p_L_m[i + k];
      after += stripe.p_L_m[i + step + k];
    }
    const Eigen::Vector3d d = after - before;
    slopes_rad.push_back(std::atan2(d.z(), d.head<2>().norm()));
    azimuths_rad.push_back(std::atan2(d.x(), std::abs(d.y()) + 1e-9));
  }
  AddQuantiles("slope_", std::move(slopes_rad), evidence);
  AddQuantiles("azimuth_", std::move(azimuths_rad), evidence);
}

double LargestStep(const TargetStripe& stripe) {
  double largest_m = 0.0;
  for (size_t i = 1; i < stripe.p_L_m.size(); ++i) {
    largest_m = std::max(largest_m, (stripe.p_L_m[i] - stripe.p_L_m[i - 1]).squaredNorm());
  }
  return std::sqrt(largest_m);
}

// A short flat stripe: no evidence of anything.
TargetStripe FlatStripe(double scale_m) {
  TargetStripe stripe;
  stripe.p_L_m = {Eigen::Vector3d::Zero(), Eigen::Vector3d(0.0, -0.01 * scale_m, 0.0)};
  stripe.curve_m = {Eigen::Vector2d::Zero(), Eigen::Vector2d(0.01 * scale_m, 0.0)};
  stripe.segment_begins = {0};
  return stripe;
}

}  // namespace

void AddStripeEvidence(const TargetStripe& given, double scale_m, EvidenceList* evidence) {
  const TargetStripe flat = given.empty() ? FlatStripe(scale_m) : TargetStripe();
  const TargetStripe& stripe = given.empty() ? flat : given;
  const Segments segments = FindArcs(stripe);
  const std::vector<Curve> fine = Resample(segments, kFineSamples);
  const std::vector<Curve> coarse = Resample(segments, kCoarseSamples);
  Curve all;
  for (const Curve& piece : coarse) all.insert(all.end(), piece.begin(), piece.end());
  const double length_m = std::max((all.back() - all.front()).norm(), 0.01 * scale_m);
  evidence->Add("segments", static_cast<double>(given.segment_begins.size()));
  evidence->Add("gap", LargestStep(stripe) / scale_m);
  evidence->Add("length", length_m / scale_m);
  evidence->Add("noise", stripe.noise_m / length_m);
  AddTurning("fine_", fine, evidence);
  AddTurning("coarse_", coarse, evidence);
  AddFits(all, length_m, scale_m, evidence);
  AddSagitta(all, length_m, evidence);
  AddDirections(stripe, evidence);
}

}  // namespace geon::recognition
