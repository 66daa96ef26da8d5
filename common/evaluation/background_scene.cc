#include "evaluation/background_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angles.h"
#include "evaluation/random_scan.h"
#include "evaluation/trial_random.h"
#include "geometry/rigid_transform.h"

namespace geon::evaluation {
namespace {

using geons::TriangleMesh;

constexpr double kTile_m = 0.6;
constexpr double kGroove_m = 0.004;
constexpr double kGrooveDepth_m = 0.006;
constexpr double kTileStep_m = 0.002;
constexpr int kTilesAround = 6;
constexpr double kWallHalf_m = 3.0;
constexpr double kWallThickness_m = 0.02;

// A cuboid from `low` to `high`.
void AddBlock(const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m, TriangleMesh* mesh) {
  const int first = static_cast<int>(mesh->vertices_m.size());
  for (int k = 0; k < 8; ++k) {
    mesh->vertices_m.emplace_back((k & 1) != 0 ? high_m.x() : low_m.x(),
                                  (k & 2) != 0 ? high_m.y() : low_m.y(),
                                  (k & 4) != 0 ? high_m.z() : low_m.z());
  }
  constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    mesh->triangles.push_back({first + face[0], first + face[1], first + face[2]});
    mesh->triangles.push_back({first + face[0], first + face[2], first + face[3]});
  }
}

// How far the mesh reaches from the origin in a horizontal direction.
double Reach(const TriangleMesh& mesh, double direction_rad) {
  const Eigen::Vector3d direction(std::cos(direction_rad), std::sin(direction_rad), 0.0);
  double reach_m = -std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p_m : mesh.vertices_m) {
    reach_m = std::max(reach_m, direction.dot(p_m));
  }
  return reach_m;
}

void Turn(double angle_rad, TriangleMesh* mesh) {
  geons::Transform(
      geometry::MakeTransform(geometry::RotationAboutZ(angle_rad), Eigen::Vector3d::Zero()), mesh);
}

// The object stands on the tile at the origin, which is the highest.
Surroundings Tiles(std::mt19937_64& random) {
  Surroundings tiles{{}, -kGrooveDepth_m};
  const double shift_x_m = Uniform(random, -0.5, 0.5) * kTile_m;
  const double shift_y_m = Uniform(random, -0.5, 0.5) * kTile_m;
  const double half_m = 0.5 * (kTile_m - kGroove_m);
  for (int i = -kTilesAround; i <= kTilesAround; ++i) {
    for (int j = -kTilesAround; j <= kTilesAround; ++j) {
      const double drawn_m = -Uniform(random, 0.0, kTileStep_m);
      const double top_m = i == 0 && j == 0 ? 0.0 : drawn_m;
      const Eigen::Vector3d middle_m(i * kTile_m + shift_x_m, j * kTile_m + shift_y_m, 0.0);
      AddBlock(middle_m - Eigen::Vector3d(half_m, half_m, 0.05),
               middle_m + Eigen::Vector3d(half_m, half_m, top_m), &tiles.mesh);
    }
  }
  Turn(Uniform(random, 0.0, kPi), &tiles.mesh);
  return tiles;
}

// Behind the object, or beside it at an angle of 40 to 85 degrees to the view.
Surroundings Wall(const TriangleMesh& object, double azimuth_rad, std::mt19937_64& random) {
  const bool behind = random() % 2 == 0;
  const double side = random() % 2 == 0 ? 1.0 : -1.0;
  const double aside_rad =
      RadiansFromDegrees(behind ? Uniform(random, 0.0, 40.0) : Uniform(random, 40.0, 85.0));
  const double away_rad = azimuth_rad + kPi + side * aside_rad;
  const double apart_m = Reach(object, away_rad) + Uniform(random, 0.01, 0.15);
  Surroundings wall;
  AddBlock({apart_m, -kWallHalf_m, 0.0},
           {apart_m + kWallThickness_m, kWallHalf_m, Uniform(random, 0.65, 2.0)}, &wall.mesh);
  Turn(away_rad, &wall.mesh);
  return wall;
}

Surroundings Box(const TriangleMesh& object, std::mt19937_64& random) {
  const double yaw_rad = Uniform(random, 0.0, kPi);
  std::array<double, 4> edges_m{};  // from the origin, every quarter turn
  for (int k = 0; k < 4; ++k) {
    edges_m[static_cast<size_t>(k)] =
        Reach(object, yaw_rad + 0.5 * kPi * k) + Uniform(random, 0.01, 0.20);
  }
  Surroundings box;
  box.floor_m = -Uniform(random, 0.3, 0.8);
  AddBlock({-edges_m[2], -edges_m[3], box.floor_m}, {edges_m[0], edges_m[1], 0.0}, &box.mesh);
  Turn(yaw_rad, &box.mesh);
  return box;
}

Surroundings Neighbour(const TriangleMesh& object, std::mt19937_64& random) {
  Surroundings neighbour{ShapeMesh(RandomShape(random), Family::kPolygon), 0.0};
  Turn(Uniform(random, 0.0, 2.0 * kPi), &neighbour.mesh);
  const double away_rad = Uniform(random, 0.0, 2.0 * kPi);
  const double apart_m =
      Reach(object, away_rad) + Reach(neighbour.mesh, away_rad + kPi) + Uniform(random, 0.02, 0.15);
  geons::Transform(
      geometry::MakeTransform(Eigen::Matrix3d::Identity(),
                              {apart_m * std::cos(away_rad), apart_m * std::sin(away_rad), 0.0}),
      &neighbour.mesh);
  return neighbour;
}

}  // namespace

std::string_view ToString(BackgroundScene scene) {
  constexpr std::array<std::string_view, kBackgroundScenes.size()> kNames = {
      "level", "lean", "tiles", "wall", "box", "neighbour"};
  return kNames[static_cast<size_t>(scene)];
}

Surroundings MakeSurroundings(BackgroundScene scene, const TriangleMesh& object, double azimuth_rad,
                              std::mt19937_64& random) {
  switch (scene) {
    case BackgroundScene::kLevel:
    case BackgroundScene::kLean:
      return {};
    case BackgroundScene::kTiles:
      return Tiles(random);
    case BackgroundScene::kWall:
      return Wall(object, azimuth_rad, random);
    case BackgroundScene::kBox:
      return Box(object, random);
    case BackgroundScene::kNeighbour:
      return Neighbour(object, random);
  }
  return {};
}

BackgroundTrial MakeBackgroundTrial(uint64_t seed, uint64_t t, double baseline_m) {
  std::mt19937_64 random = TrialRandom(seed, t);
  BackgroundTrial trial;
  trial.scene = kBackgroundScenes[t % kBackgroundScenes.size()];
  const Family family = random() % 2 == 0 ? Family::kSuperquadric : Family::kPolygon;
  const geons::GeonShape shape = RandomShape(random);
  const TriangleMesh object = ShapeMesh(shape, family);

  ViewOptions view;
  view.range_m = trial.range_m = Uniform(random, 0.7, 2.0);
  view.elevation_rad = RadiansFromDegrees(Uniform(random, 15.0, 65.0));
  view.azimuth_rad = Uniform(random, 0.0, 2.0 * kPi);
  view.floor = true;
  FaultOptions faults;
  faults.misplacement_1 = 0.03;
  faults.lean_rad = RadiansFromDegrees(Uniform(random, 0.0, 3.0));
  if (trial.scene == BackgroundScene::kLevel) faults.lean_rad = 0.0;
  RangefinderOptions rangefinder;
  rangefinder.baseline_m = baseline_m;
  rangefinder.color_tags = true;

  const Surroundings around = MakeSurroundings(trial.scene, object, view.azimuth_rad, random);
  view.floor_m = around.floor_m;
  const ObjectTracer tracer(object, around.mesh.triangles.empty() ? nullptr : &around.mesh);
  trial.labelled = MakeLabelledScan(tracer, view, faults, rangefinder, random);
  trial.labelled.scan.truth = shape.label;
  return trial;
}

}  // namespace geon::evaluation
