#include "navigation/map_localizer.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::navigation {
namespace {

constexpr int kRounds = 4;
constexpr double kSettled = 1e-4;                        // metres or radians of a round's step
constexpr size_t kFewestPoints = 6;                      // on lines of the map, to say anything
constexpr double kNearest_m = 0.10, kFarthest_m = 0.35;  // a point's line is looked for as far off
constexpr double kSigmas = 3.0;                          // as its place is uncertain by so many
constexpr double kLeastSigma = 1e-4;                     // a robot yet unmoved is in one place

// What one picture leaves to be found: changes of x_m, y_m, heading_rad and the turns' scale from
// what odometry predicts, and how the camera was tilted, about x and y of R.
using Unknowns = Eigen::Matrix<double, 6, 1>;
using Information = Eigen::Matrix<double, 6, 6>;

Eigen::Vector2d TurnedLeft(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

// How a point on the floor seems to move, in metres for a radian, when the camera is tilted about x
// (first column) and y of R.
Eigen::Matrix2d ShiftByTilt(const Eigen::Vector2d& point_R_m, const Eigen::Vector3d& p_RF_m) {
  const Eigen::Vector2d p_m = point_R_m - p_RF_m.head<2>();
  const double height_m = p_RF_m.z();
  Eigen::Matrix2d shift_m;
  shift_m.col(0) = Eigen::Vector2d(0.0, height_m) + p_m * (p_m.y() / height_m);
  shift_m.col(1) = Eigen::Vector2d(-height_m, 0.0) - p_m * (p_m.x() / height_m);
  return shift_m;
}

GridWindow Around(const OccupancyGrid& map, const Eigen::Vector2d& p_W_m, double half_m) {
  const Eigen::Vector2d half(half_m, half_m);
  return {map.CellAt(p_W_m - half), map.CellAt(p_W_m + half)};
}

std::optional<Eigen::Vector2d> NearestObstacle(const OccupancyGrid& map,
                                               const Eigen::Vector2d& p_W_m, double reach_m) {
  std::optional<Eigen::Vector2d> nearest_W_m;
  double least_m = reach_m;
  map.VisitSeenObstacles(Around(map, p_W_m, reach_m), [&](GridCell, const Eigen::Vector2d& at_m) {
    const double distance_m = (at_m - p_W_m).norm();
    if (distance_m >= least_m) return;
    least_m = distance_m;
    nearest_W_m = at_m;
  });
  return nearest_W_m;
}

struct Line {
  Eigen::Vector2d p_W_m;
  Eigen::Vector2d normal_W;
};

// The line through the map's obstacles round the one that is nearest to a place; nothing where none
// is near enough, or they do not lie on a line.
std::optional<Line> NearestLine(const OccupancyGrid& map, const Eigen::Vector2d& p_W_m,
                                double reach_m) {
  constexpr double kRound_m = 0.16;
  constexpr int kFewest = 3;
  constexpr double kFlat_1 = 0.15;  // variance across the line, as a part of that along it
  const auto nearest_W_m = NearestObstacle(map, p_W_m, reach_m);
  if (!nearest_W_m) return std::nullopt;
  int count = 0;
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares_m2 = Eigen::Matrix2d::Zero();
  map.VisitSeenObstacles(Around(map, *nearest_W_m, kRound_m),
                         [&](GridCell, const Eigen::Vector2d& at_m) {
                           const Eigen::Vector2d off_m = at_m - *nearest_W_m;
                           if (off_m.norm() > kRound_m) return;
                           ++count;
                           sum_m += off_m;
                           squares_m2 += off_m * off_m.transpose();
                         });
  if (count < kFewest) return std::nullopt;
  const Eigen::Vector2d mean_m = sum_m / count;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread;
  spread.computeDirect(squares_m2 / count - mean_m * mean_m.transpose());
  if (!(spread.eigenvalues()(0) <= kFlat_1 * spread.eigenvalues()(1))) return std::nullopt;
  return Line{*nearest_W_m + mean_m, spread.eigenvectors().col(0)};
}

}  // namespace

std::optional<std::string> MapLocalizerOptions::Validate() const {
  if (!(turn_scale_1 > 0.0 && slip_m > 0.0 && slip_rad > 0.0)) {
    return "what odometry errs by must be positive";
  }
  if (!(tilt_rad > 0.0 && point_m > 0.0 && point_per_m >= 0.0 && independent_1 > 0.0)) {
    return "what pictures err by must be positive";
  }
  if (!(every_m > 0.0 && every_rad > 0.0)) return "every_m and every_rad must be positive";
  return std::nullopt;
}

MapLocalizer::MapLocalizer(const MapLocalizerOptions& options) : options_(options) {
  const std::optional<std::string> error = options.Validate();
  Require(!error, "MapLocalizerOptions: " + error.value_or(""));
  Reset();
}

void MapLocalizer::Reset() {
  X_WO_ = geometry::RigidTransform::Identity();
  X_OR_.reset();
  state_ = State::Zero();
  covariance_ = Covariance::Zero();
  covariance_(3, 3) = options_.turn_scale_1 * options_.turn_scale_1;
  moved_m_ = turned_rad_ = 0.0;
}

void MapLocalizer::See(const geometry::RigidTransform& X_OR, std::span<const FloorColumn> columns,
                       const Eigen::Vector3d& p_RF_m, const OccupancyGrid& map) {
  Require(p_RF_m.z() > 0.0, "MapLocalizer::See: the camera must be above the floor");
  Predict(X_OR);
  if (moved_m_ >= options_.every_m || turned_rad_ >= options_.every_rad) {
    std::vector<Eigen::Vector2d> points_R_m;
    for (const FloorColumn& column : columns) {
      if (column.obstacle && !column.bright && column.begin_R_m != column.end_R_m) {
        points_R_m.push_back(column.end_R_m);
      }
    }
    Correct(points_R_m, p_RF_m, map);
    moved_m_ = turned_rad_ = 0.0;
  }
  // From numbers: a product of what was a product would in the end be no rotation.
  const double turn_rad = WrapAngle(state_(2) - geometry::HeadingOf(X_OR));
  const Eigen::Vector2d p_WO_m =
      state_.head<2>() - Eigen::Rotation2Dd(turn_rad) * X_OR.translation().head<2>();
  X_WO_ = geometry::PlanarPose(p_WO_m.x(), p_WO_m.y(), turn_rad);
}

void MapLocalizer::Predict(const geometry::RigidTransform& X_OR) {
  if (!X_OR_) {
    X_OR_ = X_OR;
    state_.head<2>() = X_OR.translation().head<2>();
    state_(2) = geometry::HeadingOf(X_OR);
    return;
  }
  const geometry::RigidTransform X_RNext = X_OR_->inverse() * X_OR;
  X_OR_ = X_OR;
  const Eigen::Vector2d step_m = X_RNext.translation().head<2>();
  const double turn_rad = geometry::HeadingOf(X_RNext);
  moved_m_ += step_m.norm();
  turned_rad_ += std::abs(turn_rad);

  // Of what the scale adds to the turn, half is turned before the step.
  const Eigen::Vector2d step_W_m =
      Eigen::Rotation2Dd(state_(2) + 0.5 * state_(3) * turn_rad) * step_m;
  state_.head<2>() += step_W_m;
  state_(2) = WrapAngle(state_(2) + (1.0 + state_(3)) * turn_rad);
  Covariance slope = Covariance::Identity();
  slope.block<2, 1>(0, 2) = TurnedLeft(step_W_m);
  slope.block<2, 1>(0, 3) = 0.5 * turn_rad * TurnedLeft(step_W_m);
  slope(2, 3) = turn_rad;
  covariance_ = slope * covariance_ * slope.transpose();
  const double slip_m2 = options_.slip_m * options_.slip_m * step_m.norm();
  const double slip_rad2 = options_.slip_rad * options_.slip_rad * std::abs(turn_rad);
  covariance_.diagonal().head<3>() += Eigen::Vector3d(slip_m2, slip_m2, slip_rad2);
}

void MapLocalizer::Correct(std::span<const Eigen::Vector2d> points_R_m,
                           const Eigen::Vector3d& p_RF_m, const OccupancyGrid& map) {
  Information spread = kLeastSigma * kLeastSigma * Information::Identity();
  spread.topLeftCorner<4, 4>() += covariance_;
  spread.diagonal().tail<2>().array() += options_.tilt_rad * options_.tilt_rad;
  const Information prior = spread.inverse();
  const double place_m2 = spread.topLeftCorner<2, 2>().trace();
  const double bearing_rad2 = spread(2, 2) + options_.tilt_rad * options_.tilt_rad;

  Unknowns change = Unknowns::Zero();
  Information information = prior;
  for (int round = 0; round < kRounds; ++round) {
    const Eigen::Rotation2Dd turn(state_(2) + change(2));
    Information seen = Information::Zero();
    Unknowns pull = Unknowns::Zero();
    size_t count = 0;
    for (const Eigen::Vector2d& point_R_m : points_R_m) {
      const Eigen::Matrix2d shift_m = ShiftByTilt(point_R_m, p_RF_m);
      const Eigen::Vector2d off_W_m = turn * (point_R_m + shift_m * change.tail<2>());
      const Eigen::Vector2d p_W_m = state_.head<2>() + change.head<2>() + off_W_m;
      const double reach_m = kSigmas * std::sqrt(place_m2 + bearing_rad2 * off_W_m.squaredNorm());
      const auto line = NearestLine(map, p_W_m, std::clamp(reach_m, kNearest_m, kFarthest_m));
      if (!line) continue;
      ++count;
      const double error_m = line->normal_W.dot(p_W_m - line->p_W_m);
      Unknowns slope = Unknowns::Zero();
      slope.head<2>() = line->normal_W;
      slope(2) = line->normal_W.dot(TurnedLeft(off_W_m));
      slope.tail<2>() = (turn * shift_m).transpose() * line->normal_W;
      // Cauchy's weight: what is many sigmas off is of something else.
      const double sigma_m = options_.point_m + options_.point_per_m * off_W_m.norm();
      const double weight = 1.0 / (sigma_m * sigma_m + 0.25 * error_m * error_m);
      seen += weight * slope * slope.transpose();
      pull -= weight * error_m * slope;
    }
    if (count < kFewestPoints) return;
    const double share_1 = std::min(1.0, options_.independent_1 / static_cast<double>(count));
    information = prior + share_1 * seen;
    const Unknowns step = information.ldlt().solve(share_1 * pull - prior * change);
    change += step;
    if (step.cwiseAbs().maxCoeff() < kSettled) break;
  }
  state_ += change.head<4>();
  state_(2) = WrapAngle(state_(2));
  const Covariance after = information.inverse().topLeftCorner<4, 4>();
  covariance_ = 0.5 * (after + after.transpose());
}

}  // namespace geon::navigation
