#include "sim/random_pen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/angles.h"
#include "sim/footprint.h"
#include "sim/noise_source.h"
#include "sim/random_world.h"

namespace geon::sim {
namespace {

constexpr double kPassing_m = 0.095;  // a way keeps so far from everything: gaps of 0.73 m count
constexpr double kLookNearest_m = 0.83;
constexpr double kLookFarthest_m = 0.95;
constexpr double kApart_m = 1.5;  // robot and geon, at the start
constexpr double kBoard_m = 0.08;
constexpr double kGap_m = 0.75;

constexpr std::array<std::pair<PenKind, std::string_view>, 6> kKinds = {{
    {PenKind::kBoxes, "boxes"},
    {PenKind::kUTrap, "u_trap"},
    {PenKind::kDeadEnd, "dead_end"},
    {PenKind::kGap, "gap"},
    {PenKind::kEmpty, "empty"},
    {PenKind::kUnreachable, "unreachable"},
}};

WorldObject Box(const Eigen::Vector2d& middle_m, const Eigen::Vector3d& size_m, double yaw_rad,
                NoiseSource* noise) {
  WorldObject box;
  box.shape = BoxShape{size_m};
  box.x_m = middle_m.x();
  box.y_m = middle_m.y();
  box.yaw_rad = yaw_rad;
  const double grey = noise->Uniform(70.0, 120.0);
  box.color_rgb = {grey, grey, grey + noise->Uniform(0.0, 40.0)};
  return box;
}

class Pen {
 public:
  explicit Pen(NoiseSource* noise) : noise_(noise) {
    world_.pen_size_m = {noise->Uniform(2.8, 3.4), noise->Uniform(4.2, 4.8)};
    world_.lighting.lamp_W_m.head<2>() = 0.5 * world_.pen_size_m;
  }
  const World& world() const { return world_; }
  Eigen::Vector2d AnyPlace(double from_wall_m) {
    return {noise_->Uniform(from_wall_m, world_.pen_size_m.x() - from_wall_m),
            noise_->Uniform(from_wall_m, world_.pen_size_m.y() - from_wall_m)};
  }
  double AnyHeading() { return noise_->Uniform(-kPi, kPi); }
  void PutRobot(const Eigen::Vector2d& place_m, double heading_rad) {
    world_.robot_x_m = place_m.x();
    world_.robot_y_m = place_m.y();
    world_.robot_heading_rad = heading_rad;
  }
  void PutGeon(const Eigen::Vector2d& place_m) {
    geon_m_ = place_m;
    if (noise_->Chance(0.5)) {
      const double side_m = noise_->Uniform(0.42, 0.52);
      world_.objects.push_back(Box(place_m, {side_m, side_m, kDeskHeight_m}, AnyHeading(), noise_));
    }
    WorldObject geon;
    geons::GeonShape shape;  // driving does not ask which
    shape.label = GeonLabel::kCylinder;
    shape.size_m = {0.16, 0.16, 0.22};
    geon.shape = shape;
    geon.x_m = place_m.x();
    geon.y_m = place_m.y();
    geon.color_rgb = {150, 40, 40};
    world_.objects.push_back(geon);
  }
  void PutBox(double least_m, double most_m) {
    const auto side = [&] { return noise_->Uniform(least_m, most_m); };
    world_.objects.push_back(
        Box(AnyPlace(0.1), {side(), side(), noise_->Uniform(0.35, 0.7)}, AnyHeading(), noise_));
  }
  // A board that stands on its edge, `along_m` long in direction `yaw_rad`.
  void PutBoard(const Eigen::Vector2d& middle_m, double along_m, double yaw_rad) {
    world_.objects.push_back(Box(middle_m, {along_m, kBoard_m, 0.5}, yaw_rad, noise_));
  }
  // Whether the robot stands free, and the geon, if there is one, where it can be put; `reachable`
  // as asked.
  bool IsGood(bool reachable) const {
    const Eigen::Vector2d robot_m(world_.robot_x_m, world_.robot_y_m);
    if (robot_m.minCoeff() < kRobotRadius_m + 0.1 ||
        (world_.pen_size_m - robot_m).minCoeff() < kRobotRadius_m + 0.1) {
      return false;
    }
    for (const WorldObject& object : world_.objects) {
      if (!std::holds_alternative<BoxShape>(object.shape)) continue;
      const auto outline_m = BoxOutline(object);
      if (NearestPointOfConvex(outline_m, robot_m).distance_m < kRobotRadius_m + 0.1) return false;
      if (!geon_m_) continue;
      const bool desk = object.x_m == geon_m_->x() && object.y_m == geon_m_->y();
      if (!desk && NearestPointOfConvex(outline_m, *geon_m_).distance_m < 0.25) {
        return false;
      }
    }
    if (!geon_m_) return true;
    if ((robot_m - *geon_m_).norm() < kApart_m) return false;
    return CanReach(world_, *geon_m_, kLookNearest_m, kLookFarthest_m,
                    reachable ? kPassing_m : -0.05) == reachable;
  }

 private:
  NoiseSource* noise_;
  World world_;
  std::optional<Eigen::Vector2d> geon_m_;
};

// Boards at three sides of a rectangle whose open side looks along `open_rad`.
void PutU(const Eigen::Vector2d& middle_m, double wide_m, double deep_m, double open_rad,
          Pen* pen) {
  const Eigen::Vector2d open(std::cos(open_rad), std::sin(open_rad));
  const Eigen::Vector2d across(-open.y(), open.x());
  pen->PutBoard(middle_m - 0.5 * deep_m * open, wide_m, open_rad + kPi / 2.0);
  for (const double side : {-0.5, 0.5}) {
    pen->PutBoard(middle_m + side * wide_m * across, deep_m, open_rad);
  }
}

void Fill(PenKind kind, NoiseSource* noise, Pen* pen) {
  const Eigen::Vector2d size_m = pen->world().pen_size_m;
  switch (kind) {
    case PenKind::kBoxes:
    case PenKind::kEmpty: {
      const auto boxes = static_cast<int>(noise->Bits() % 6);
      pen->PutRobot(pen->AnyPlace(0.4), pen->AnyHeading());
      if (kind == PenKind::kBoxes) pen->PutGeon(pen->AnyPlace(0.45));
      for (int k = 0; k < boxes; ++k) pen->PutBox(0.2, 0.7);
      return;
    }
    case PenKind::kUTrap: {
      const Eigen::Vector2d robot_m(noise->Uniform(0.6, size_m.x() - 0.6),
                                    noise->Uniform(0.4, 0.8));
      const Eigen::Vector2d geon_m(noise->Uniform(0.7, size_m.x() - 0.7),
                                   size_m.y() - noise->Uniform(0.5, 0.8));
      const Eigen::Vector2d back_m = robot_m - geon_m;
      pen->PutRobot(robot_m, pen->AnyHeading());
      pen->PutGeon(geon_m);
      PutU(0.5 * (robot_m + geon_m), noise->Uniform(0.9, 1.3), noise->Uniform(0.5, 0.8),
           std::atan2(back_m.y(), back_m.x()) + noise->Uniform(-0.3, 0.3), pen);
      return;
    }
    case PenKind::kDeadEnd: {
      const Eigen::Vector2d robot_m = pen->AnyPlace(0.7);
      const double open_rad = pen->AnyHeading();
      pen->PutRobot(robot_m, open_rad + kPi);
      pen->PutGeon(pen->AnyPlace(0.5));
      PutU(robot_m + 0.15 * Eigen::Vector2d(std::cos(open_rad), std::sin(open_rad)),
           noise->Uniform(0.9, 1.1), noise->Uniform(0.9, 1.3), open_rad, pen);
      return;
    }
    case PenKind::kGap: {
      pen->PutRobot({noise->Uniform(0.5, size_m.x() - 0.5), noise->Uniform(0.45, 1.2)},
                    pen->AnyHeading());
      pen->PutGeon({noise->Uniform(0.6, size_m.x() - 0.6), size_m.y() - noise->Uniform(0.5, 1.0)});
      const double wall_m = noise->Uniform(0.45, 0.55) * size_m.y();
      const double gap_m = noise->Uniform(0.2, size_m.x() - kGap_m - 0.2);
      pen->PutBoard({0.5 * gap_m, wall_m}, gap_m, 0.0);
      const double rest_m = size_m.x() - gap_m - kGap_m;
      pen->PutBoard({size_m.x() - 0.5 * rest_m, wall_m}, rest_m, 0.0);
      return;
    }
    case PenKind::kUnreachable: {
      pen->PutRobot({noise->Uniform(0.5, size_m.x() - 0.5), noise->Uniform(0.45, 1.2)},
                    pen->AnyHeading());
      pen->PutGeon({noise->Uniform(0.6, size_m.x() - 0.6), size_m.y() - noise->Uniform(0.45, 0.6)});
      const double wall_m = noise->Uniform(0.42, 0.55) * size_m.y();
      pen->PutBoard({0.5 * size_m.x(), wall_m}, size_m.x(), 0.0);
      return;
    }
  }
}

}  // namespace

std::string_view ToString(PenKind kind) {
  for (const auto& [known, name] : kKinds) {
    if (known == kind) return name;
  }
  return "";
}

std::optional<PenKind> PenKindFromString(std::string_view name) {
  for (const auto& [kind, known] : kKinds) {
    if (known == name) return kind;
  }
  return std::nullopt;
}

PenKind MixedPenKind(uint64_t seed) {
  constexpr std::array kMixture = {PenKind::kBoxes, PenKind::kBoxes,   PenKind::kBoxes,
                                   PenKind::kUTrap, PenKind::kDeadEnd, PenKind::kGap};
  return kMixture[NoiseSource(seed ^ 0x6b696e64ULL).Bits() % kMixture.size()];
}

World RandomPen(uint64_t seed, PenKind kind) {
  NoiseSource noise(seed ^ 0x70656e73ULL);
  // Most draws put something into something else; one in some dozens is good.
  while (true) {
    Pen pen(&noise);
    Fill(kind, &noise, &pen);
    if (pen.IsGood(kind != PenKind::kUnreachable)) return pen.world();
  }
}

}  // namespace geon::sim
