#include "recognition/wall_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "recognition/median.h"

namespace geon::recognition {
namespace {

constexpr double kClear_m = 0.02;  // of the support: what is higher may be a wall
constexpr double kFlat_m = 0.003;  // what a wall is expected to be off a plane
constexpr double kOnSigmas = 3.0;  // of flatness and noise: what lies on a plane
constexpr size_t kFewestBlocks = 10;
constexpr size_t kHypotheses = 40;
constexpr double kSpread_m = 0.05;  // over which a wall must be seen, up and along
constexpr double kShare_1 = 0.35;   // of what stands upright beside the target

double SigmaOf(const StripeBlock& block) {
  return std::hypot(kFlat_m, block.noise_m / std::sqrt(block.points));
}

// The blocks of a plane: upright through `p_m`, normal `normal`.
std::vector<const StripeBlock*> BlocksOn(std::span<const StripeBlock* const> blocks,
                                         const Eigen::Vector3d& p_m,
                                         const Eigen::Vector3d& normal) {
  std::vector<const StripeBlock*> on;
  for (const StripeBlock* block : blocks) {
    if (std::abs(normal.dot(block->p_L_m - p_m)) < kOnSigmas * SigmaOf(*block)) on.push_back(block);
  }
  return on;
}

// Upright plane through the blocks by least squares: the line through them as seen from above.
WallPlane Fit(std::span<const StripeBlock* const> blocks, const Eigen::Vector3d& up) {
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  for (const StripeBlock* block : blocks) middle_m += block->p_L_m;
  middle_m /= static_cast<double>(blocks.size());
  const Eigen::Vector3d x = up.unitOrthogonal(), y = up.cross(x);
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (const StripeBlock* block : blocks) {
    const Eigen::Vector3d off_m = block->p_L_m - middle_m;
    const Eigen::Vector2d flat_m(x.dot(off_m), y.dot(off_m));
    scatter += flat_m * flat_m.transpose();
  }
  // Direction of the larger axis of the scatter.
  const double angle_rad = 0.5 * std::atan2(2.0 * scatter(0, 1), scatter(0, 0) - scatter(1, 1));
  WallPlane wall;
  wall.p_L_m = middle_m;
  wall.normal_L = -std::sin(angle_rad) * x + std::cos(angle_rad) * y;
  return wall;
}

// How far the blocks reach in a direction.
double Spread(std::span<const StripeBlock* const> blocks, const Eigen::Vector3d& direction) {
  double low_m = 0.0, high_m = 0.0;
  for (const StripeBlock* block : blocks) {
    const double at_m = direction.dot(block->p_L_m - blocks.front()->p_L_m);
    low_m = std::min(low_m, at_m);
    high_m = std::max(high_m, at_m);
  }
  return high_m - low_m;
}

// All points of one stripe lie on a plane, whatever they belong to.
bool TooFew(std::span<const StripeBlock* const> on, size_t upright) {
  const double fewest = std::max<double>(kFewestBlocks, kShare_1 * static_cast<double>(upright));
  if (static_cast<double>(on.size()) < fewest) return true;
  return std::all_of(on.begin(), on.end(),
                     [&](const StripeBlock* block) { return block->stripe == on.front()->stripe; });
}

}  // namespace

std::optional<WallPlane> FindWallPlane(std::span<const StripeBlock> blocks,
                                       const SupportPlane& support,
                                       const Eigen::Vector3d& eye_L_m) {
  const Eigen::Vector3d& up = support.normal_L;
  std::vector<const StripeBlock*> upright;
  for (const StripeBlock& block : blocks) {
    const bool beside = block.place == BlockPlace::kBeside;
    if (beside && support.Above(block.p_L_m) > kClear_m) upright.push_back(&block);
  }
  if (upright.size() < kFewestBlocks) return std::nullopt;

  std::vector<const StripeBlock*> best;
  const size_t every = (upright.size() + kHypotheses - 1) / kHypotheses;
  for (size_t k = 0; k < upright.size(); k += every) {
    const Eigen::Vector3d across = up.cross(upright[k]->along_L);
    if (across.norm() < 0.5) continue;  // the stripe runs up: no direction along the wall
    auto on = BlocksOn(upright, upright[k]->p_L_m, across.normalized());
    if (on.size() > best.size()) best = std::move(on);
  }
  if (TooFew(best, upright.size())) return std::nullopt;
  WallPlane wall = Fit(best, up);
  best = BlocksOn(upright, wall.p_L_m, wall.normal_L);
  if (TooFew(best, upright.size())) return std::nullopt;
  wall = Fit(best, up);
  if (Spread(best, up) < kSpread_m || Spread(best, up.cross(wall.normal_L)) < kSpread_m) {
    return std::nullopt;
  }
  if (wall.Before(eye_L_m) < 0.0) wall.normal_L = -wall.normal_L;
  std::vector<double> off_m;
  for (const StripeBlock* block : best) off_m.push_back(std::abs(wall.Before(block->p_L_m)));
  constexpr double kMedianOfMagnitude = 0.6745;  // of a normal variable, in sigmas
  wall.sigma_m = Median(std::move(off_m)) / kMedianOfMagnitude;
  return wall;
}

}  // namespace geon::recognition
