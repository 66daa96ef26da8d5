#include "navigation/safe_polygon.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::navigation {

namespace {

using Eigen::Vector2d;
using geometry::ConvexPolygon;
using geometry::HalfPlane;

// With the box's four sides as many as the polygon can hold.
constexpr int kMostObstacles = ConvexPolygon::kMaxVertices - 4;
constexpr int kSectors = 64;
constexpr int kSectorsOfOctant = kSectors / 8;

// Farthest point that can still cut the box.
double Vicinity(const SafePolygonOptions& options) {
  return std::numbers::sqrt2 * options.default_box_m + options.clearance_m;
}

// Cosine of the angle between two obstacles' directions, at most.
double SameDirection(const SafePolygonOptions& options) {
  return 1.0 - options.slack_m / Vicinity(options);
}

bool Nearer(const Vector2d& a_m, const Vector2d& b_m) {
  return a_m.squaredNorm() < b_m.squaredNorm();
}

// In which of 64 sectors a point lies, counter-clockwise from the box's corner on the right behind
// the robot. They are nearly equal, at most 0.101 rad wide: the arctangent is that of Rajan, Wang,
// Inkol and Joyal (2006), "Efficient approximations for the arctangent function", and there is no
// branch to guess.
unsigned SectorOf(const Vector2d& p_m) {
  const double x_m = std::abs(p_m.x());
  const double y_m = std::abs(p_m.y());
  const double slope_1 = std::min(x_m, y_m) / std::max(x_m, y_m);
  const double from_axis =
      kSectorsOfOctant * slope_1 * (1.0 + 0.273 / (kPi / 4.0) * (1.0 - slope_1));
  // By octant: the sectors before the nearest axis, and whether bearings grow away from it.
  constexpr std::array<double, 8> kAxis = {24, 56, 24, 56, 40, 40, 8, 8};
  constexpr std::array<double, 8> kGrows = {1, -1, -1, 1, -1, 1, 1, -1};
  const size_t octant =
      (p_m.x() < 0.0 ? 1u : 0u) | (p_m.y() < 0.0 ? 2u : 0u) | (y_m > x_m ? 4u : 0u);
  return static_cast<unsigned>(kAxis[octant] + kGrows[octant] * from_axis) % kSectors;
}

// The obstacles found so far, nearest first, by the sector that their nearest point lies in. No
// sector has two, since what lies in an obstacle's sector belongs to it (IsValid).
class Obstacles {
 public:
  explicit Obstacles(const SafePolygonOptions& options)
      : options_(options), same_direction_1_(SameDirection(options)) {}

  // One whose nearest point is `nearest_m`.
  unsigned Add(const Vector2d& nearest_m) {
    const unsigned sector = SectorOf(nearest_m);
    const double distance_m = nearest_m.norm();
    // Of an obstacle that is too near the line goes through the robot, nearly: the polygon keeps an
    // inside. What it keeps away is less.
    constexpr double kAlmostThrough_m = 1e-6;
    const double line_m = std::max(kAlmostThrough_m, distance_m - options_.clearance_m);
    obstacles_[sector] = {{nearest_m / distance_m, line_m},
                          std::max(distance_m, options_.clearance_m) - options_.slack_m};
    taken_ |= uint64_t{1} << sector;
    return sector;
  }

  // Whether a point that is farther than the obstacle's nearest belongs to it: behind its line, or,
  // too near for that, in the same direction.
  bool Has(unsigned sector, const Vector2d& p_m) const {
    const Obstacle& obstacle = obstacles_[sector];
    const double ahead_m = obstacle.line.normal.dot(p_m);
    return ahead_m >= obstacle.behind_m || ahead_m >= same_direction_1_ * p_m.norm();
  }

  // Whether a point that is farther than all of them belongs to any. It is enough to ask the two
  // on either side: the foot of the robot's perpendicular on each line is not behind any other
  // line, so in order of bearing every line has its part of the border of what is behind none.
  bool Have(const Vector2d& p_m) const {
    if (taken_ == 0) return false;
    const unsigned sector = SectorOf(p_m);
    const uint64_t from_here = std::rotr(taken_, static_cast<int>(sector));
    if ((from_here & 1) != 0) return true;
    const auto next = static_cast<unsigned>(std::countr_zero(from_here));
    const auto previous = kSectors - 1 - static_cast<unsigned>(std::countl_zero(from_here));
    return Has((sector + next) % kSectors, p_m) || Has((sector + previous) % kSectors, p_m);
  }

  ConvexPolygon Polygon() const {
    std::array<HalfPlane, ConvexPolygon::kMaxVertices> by_bearing;
    size_t count = 0;
    uint64_t rest = taken_;
    const auto add_sectors_before = [&](int end) {
      for (; std::countr_zero(rest) < end; rest &= rest - 1) {
        by_bearing[count++] = obstacles_[static_cast<size_t>(std::countr_zero(rest))].line;
      }
    };
    const std::array<Vector2d, 4> sides = {-Vector2d::UnitY(), Vector2d::UnitX(), Vector2d::UnitY(),
                                           -Vector2d::UnitX()};
    for (int k = 0; k < 4; ++k) {
      add_sectors_before((2 * k + 1) * kSectorsOfOctant);
      by_bearing[count++] = {sides[static_cast<size_t>(k)], options_.default_box_m};
    }
    add_sectors_before(kSectors);
    return ConvexPolygon::Intersection({by_bearing.data(), count});
  }

 private:
  struct Obstacle {
    HalfPlane line;
    double behind_m;
  };

  const SafePolygonOptions& options_;
  double same_direction_1_;
  uint64_t taken_ = 0;
  std::array<Obstacle, kSectors> obstacles_;
};

// Sorts so few points as fit a key's last six bits. Counting how many are nearer has no branch to
// guess, which is quicker here than sorting by comparing.
constexpr size_t kFew = 64;
void SortNearestFirst(std::span<Vector2d> points_m) {
  std::array<int32_t, kFew> keys;
  keys.fill(std::numeric_limits<int32_t>::max());
  for (size_t i = 0; i < points_m.size(); ++i) {
    // Positive floats are in the order of their bits.
    const auto squared_m2 = static_cast<float>(points_m[i].squaredNorm());
    keys[i] = (std::bit_cast<int32_t>(squared_m2) & ~63) | static_cast<int32_t>(i);
  }
  std::array<Vector2d, kFew> sorted_m;
  for (size_t i = 0; i < points_m.size(); ++i) {
    int nearer = 0;
    for (const int32_t key : keys) nearer += key < keys[i] ? 1 : 0;
    sorted_m[static_cast<size_t>(nearer)] = points_m[i];
  }
  // What the keys leave off matters between equals only: they are exchanged here.
  for (size_t i = 0; i < points_m.size(); ++i) {
    size_t k = i;
    for (; k > 0 && Nearer(sorted_m[i], points_m[k - 1]); --k) points_m[k] = points_m[k - 1];
    points_m[k] = sorted_m[i];
  }
}

}  // namespace

bool SafePolygonOptions::IsValid(std::string* error) const {
  const auto fail = [&](const std::string& rule) {
    if (error != nullptr) *error = rule;
    return false;
  };
  if (!(clearance_m > 0.0)) return fail("clearance_m must be positive");
  if (!(default_box_m > 0.0)) return fail("default_box_m must be positive");
  if (!(slack_m > 0.0 && slack_m < clearance_m)) {
    return fail("slack_m must lie between 0 and clearance_m");
  }
  // So far obstacles are apart in direction, which bounds their number.
  static const double apart_1 = std::cos(2.0 * kPi / kMostObstacles);
  if (SameDirection(*this) > apart_1) {
    return fail("slack_m is too small for default_box_m: more lines than the polygon can hold");
  }
  return true;
}

geometry::ConvexPolygon SafePolygon(std::span<Eigen::Vector2d> obstacles_R_m,
                                    const SafePolygonOptions& options) {
  std::string error;
  Require(options.IsValid(&error), error);

  // A point on the robot's axis has no direction; such a point is a sensor's error.
  constexpr double kOnAxis_m = 1e-3;
  const double vicinity_m = Vicinity(options);
  const auto begin = obstacles_R_m.begin();
  auto rest = std::partition(begin, obstacles_R_m.end(), [&](const Vector2d& p_m) {
    const double squared_m2 = p_m.squaredNorm();
    return squared_m2 > kOnAxis_m * kOnAxis_m && squared_m2 < vicinity_m * vicinity_m;
  });
  Obstacles obstacles(options);
  // Of many points most belong to the nearest few obstacles: take those out first.
  while (rest - begin > static_cast<ptrdiff_t>(kFew)) {
    const unsigned nearest = obstacles.Add(*std::min_element(begin, rest, Nearer));
    rest = std::partition(begin, rest,
                          [&](const Vector2d& p_m) { return !obstacles.Has(nearest, p_m); });
  }
  const std::span few_R_m(begin, rest);
  SortNearestFirst(few_R_m);
  for (const Vector2d& p_m : few_R_m) {
    if (!obstacles.Have(p_m)) obstacles.Add(p_m);
  }
  return obstacles.Polygon();
}

}  // namespace geon::navigation
