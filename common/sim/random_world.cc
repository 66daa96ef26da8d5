#include "sim/random_world.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

#include "base/angles.h"
#include "base/contracts.h"
#include "sim/footprint.h"
#include "sim/noise_source.h"

namespace geon::sim {
namespace {

constexpr double kClearance_m = 0.15;       // a path keeps so far from everything
constexpr double kViewingNearest_m = 0.85;  // from the geon to where the robot stands to look at it
constexpr double kViewingFarthest_m = 1.05;
constexpr double kRingFree_m = 1.35;  // no other box so near to the geon

constexpr double kSomeRingFree_m = 0.8;  // the same where there are several geons
constexpr double kGeonsApart_m = 1.1;

bool IsOnBox(GeonPlace place, NoiseSource* noise) {
  return place == GeonPlace::kBox || (place == GeonPlace::kAny && noise->Chance(0.5));
}

double RoundTo(double value, double step) { return std::round(value / step) * step; }

geons::GeonShape RandomGeon(NoiseSource* noise) {
  geons::GeonShape shape;
  shape.label = static_cast<GeonLabel>(noise->Bits() % kGeonLabelCount);
  const auto length = [&](double low_m, double high_m) {
    return RoundTo(noise->Uniform(low_m, high_m), 0.005);
  };
  shape.size_m = {length(0.12, 0.20), length(0.12, 0.20), length(0.18, 0.28)};
  if (shape.label == GeonLabel::kCylinder || shape.label == GeonLabel::kTaperedCylinder) {
    shape.size_m.y() = shape.size_m.x();
  }
  if (geons::IsTapered(shape.label)) shape.taper_1 = RoundTo(noise->Uniform(0.25, 0.6), 0.01);
  if (geons::IsBent(shape.label)) {
    const double thickness_m = length(0.07, 0.10);
    shape.size_m = {thickness_m, thickness_m, length(0.24, 0.34)};
    shape.bend_rad = RadiansFromDegrees(RoundTo(noise->Uniform(70.0, 150.0), 1.0));
  }
  const auto positions = static_cast<uint64_t>(geons::StablePositionCount(shape.label));
  shape.position = 1 + static_cast<int>(noise->Bits() % positions);
  return shape;
}

WorldObject RandomBox(const Eigen::Vector3d& size_m, const World& world, NoiseSource* noise) {
  WorldObject box;
  box.shape = BoxShape{size_m};
  box.x_m = RoundTo(noise->Uniform(0.3, world.pen_size_m.x() - 0.3), 0.01);
  box.y_m = RoundTo(noise->Uniform(0.3, world.pen_size_m.y() - 0.3), 0.01);
  box.yaw_rad = RadiansFromDegrees(RoundTo(noise->Uniform(-45.0, 45.0), 1.0));
  // Greys and blues: nothing that could be taken for the geon.
  const double grey = noise->Uniform(70.0, 120.0);
  box.color_rgb = {RoundTo(grey, 1.0), RoundTo(grey, 1.0),
                   RoundTo(grey + noise->Uniform(0.0, 40.0), 1.0)};
  return box;
}

bool InsidePen(const World& world, const std::vector<Eigen::Vector2d>& outline_m) {
  return std::all_of(outline_m.begin(), outline_m.end(), [&](const Eigen::Vector2d& p) {
    return p.minCoeff() >= 0.0 && p.x() <= world.pen_size_m.x() && p.y() <= world.pen_size_m.y();
  });
}

// Distance from a point to the nearest wall or box.
double Clearance(const World& world, const std::vector<std::vector<Eigen::Vector2d>>& outlines_m,
                 const Eigen::Vector2d& p_m) {
  double clearance_m = std::min(p_m.minCoeff(), (world.pen_size_m - p_m).minCoeff());
  for (const auto& outline_m : outlines_m) {
    clearance_m = std::min(clearance_m, NearestPointOfConvex(outline_m, p_m).distance_m);
  }
  return clearance_m;
}

// Where a geon is put, and on what: a desk of its own, or the floor.
struct PlacedGeon {
  WorldObject geon;
  std::optional<WorldObject> desk;
  Eigen::Vector2d place_m() const { return {geon.x_m, geon.y_m}; }
};

PlacedGeon PlaceGeon(const World& world, bool on_box, NoiseSource* noise) {
  PlacedGeon placed;
  WorldObject& geon = placed.geon;
  geon.shape = RandomGeon(noise);
  geon.x_m = RoundTo(noise->Uniform(0.6, world.pen_size_m.x() - 0.6), 0.01);
  geon.y_m = RoundTo(noise->Uniform(0.6, world.pen_size_m.y() - 0.6), 0.01);
  geon.yaw_rad = RadiansFromDegrees(RoundTo(noise->Uniform(0.0, 360.0), 1.0));
  geon.color_rgb = {150, 40, 40};
  if (on_box) {
    const double side_m = RoundTo(noise->Uniform(0.42, 0.52), 0.01);
    placed.desk = RandomBox({side_m, side_m, kDeskHeight_m}, world, noise);
    placed.desk->x_m = geon.x_m;
    placed.desk->y_m = geon.y_m;
  }
  return placed;
}

// One attempt; nothing when the draw makes no good trial.
std::optional<World> TryWorld(NoiseSource* noise, GeonPlace place, bool on_box, int geons) {
  World world;
  world.pen_size_m = {RoundTo(noise->Uniform(2.8, 3.4), 0.05),
                      RoundTo(noise->Uniform(4.2, 4.8), 0.05)};
  std::vector<PlacedGeon> placed;
  for (int k = 0; k < geons; ++k) {
    const bool on_its_box = k == 0 ? on_box : IsOnBox(place, noise);
    PlacedGeon next = PlaceGeon(world, on_its_box, noise);
    for (const PlacedGeon& other : placed) {
      if ((next.place_m() - other.place_m()).norm() < kGeonsApart_m) return std::nullopt;
    }
    if (next.desk) world.objects.push_back(*next.desk);
    placed.push_back(std::move(next));
  }
  const int boxes = static_cast<int>(noise->Bits() % 3);
  for (int k = 0; k < boxes; ++k) {
    const auto side = [&] { return RoundTo(noise->Uniform(0.25, 0.55), 0.01); };
    const WorldObject box =
        RandomBox({side(), side(), RoundTo(noise->Uniform(0.45, 0.7), 0.01)}, world, noise);
    const std::vector<Eigen::Vector2d> outline_m = BoxOutline(box);
    if (!InsidePen(world, outline_m)) return std::nullopt;
    for (const PlacedGeon& each : placed) {
      const double free_m = geons == 1 ? kRingFree_m : kSomeRingFree_m;
      if (NearestPointOfConvex(outline_m, each.place_m()).distance_m < free_m) return std::nullopt;
    }
    world.objects.push_back(box);
  }
  for (const PlacedGeon& each : placed) world.objects.push_back(each.geon);
  world.robot_x_m = RoundTo(noise->Uniform(0.45, world.pen_size_m.x() - 0.45), 0.01);
  world.robot_y_m = RoundTo(noise->Uniform(0.45, world.pen_size_m.y() - 0.45), 0.01);
  world.robot_heading_rad = RadiansFromDegrees(RoundTo(noise->Uniform(0.0, 360.0), 1.0));
  world.lighting.lamp_W_m.head<2>() = 0.5 * world.pen_size_m;
  const Eigen::Vector2d robot_m(world.robot_x_m, world.robot_y_m);
  for (const PlacedGeon& each : placed) {
    if ((robot_m - each.place_m()).norm() < (geons == 1 ? 1.5 : 1.0)) return std::nullopt;
    if (!CanReach(world, each.place_m(), kViewingNearest_m, kViewingFarthest_m, kClearance_m))
      return std::nullopt;
  }
  return world;
}

}  // namespace

bool CanReach(const World& world, const Eigen::Vector2d& goal_m, double nearest_m,
              double farthest_m, double clearance_m) {
  constexpr double kCell_m = 0.05;
  std::vector<std::vector<Eigen::Vector2d>> outlines_m;
  for (const WorldObject& object : world.objects) {
    if (std::holds_alternative<BoxShape>(object.shape)) {
      outlines_m.push_back(BoxOutline(object));
      continue;
    }
    // Anything else by a circle that holds every geon of the trials, or by its own radius.
    const auto* cylinder = std::get_if<CylinderShape>(&object.shape);
    const double radius_m = cylinder != nullptr ? cylinder->radius_m : 0.2;
    std::vector<Eigen::Vector2d> circle_m;
    for (int k = 0; k < 16; ++k) {
      const double angle_rad = 2.0 * kPi * k / 16;
      circle_m.emplace_back(object.x_m + radius_m * std::cos(angle_rad),
                            object.y_m + radius_m * std::sin(angle_rad));
    }
    outlines_m.push_back(circle_m);
  }
  const int columns = static_cast<int>(world.pen_size_m.x() / kCell_m) + 1;
  const int rows = static_cast<int>(world.pen_size_m.y() / kCell_m) + 1;
  const auto place = [&](int column, int row) {
    return Eigen::Vector2d(column * kCell_m, row * kCell_m);
  };
  const auto index = [&](int column, int row) {
    return static_cast<size_t>(row * columns + column);
  };
  const double needed_m = kRobotRadius_m + clearance_m;
  std::vector<bool> seen(static_cast<size_t>(columns * rows), false);
  std::deque<std::pair<int, int>> open;
  const auto visit = [&](int column, int row) {
    if (column < 0 || row < 0 || column >= columns || row >= rows || seen[index(column, row)])
      return;
    seen[index(column, row)] = true;
    if (Clearance(world, outlines_m, place(column, row)) >= needed_m)
      open.emplace_back(column, row);
  };
  visit(static_cast<int>(std::round(world.robot_x_m / kCell_m)),
        static_cast<int>(std::round(world.robot_y_m / kCell_m)));
  while (!open.empty()) {
    const auto [column, row] = open.front();
    open.pop_front();
    const double distance_m = (place(column, row) - goal_m).norm();
    if (distance_m >= nearest_m && distance_m <= farthest_m) return true;
    visit(column + 1, row);
    visit(column - 1, row);
    visit(column, row + 1);
    visit(column, row - 1);
  }
  return false;
}

World RandomWorld(uint64_t seed, GeonPlace place) { return RandomWorldOfSeveral(seed, place, 1); }

World RandomWorldOfSeveral(uint64_t seed, GeonPlace place, int geons) {
  Require(geons >= 1 && geons <= 4, "RandomWorldOfSeveral: 1 to 4 geons");
  NoiseSource noise(seed ^ 0x776f726c64ULL);
  const bool on_box = IsOnBox(place, &noise);
  // About every third draw of one geon is a good trial, some in a hundred of several.
  while (true) {
    if (std::optional<World> world = TryWorld(&noise, place, on_box, geons)) {
      return *std::move(world);
    }
  }
}

}  // namespace geon::sim
