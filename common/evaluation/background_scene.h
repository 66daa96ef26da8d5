#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "evaluation/scan_maker.h"
#include "geons/triangle_mesh.h"

namespace geon::evaluation {

// What a geon stands on and beside while its background is to be removed.
//
// Source: thesis sections 5.1 and 6.3 and chapter 7: raised floor tiles, the robot tilted by the
// grooves between them, a box as a desk, a pen of boards. The figures are ours.
enum class BackgroundScene {
  kLevel,      // a smooth floor, the robot upright
  kLean,       // the same, the robot leaning by 0 to 3 degrees in any direction, as in all below
  kTiles,      // tiles of 60 cm, up to 2 mm higher or lower than each other, grooves between them
  kWall,       // a wall 1 to 15 cm behind the geon or beside it
  kBox,        // on a box whose edges are 1 to 20 cm from the geon, the floor 30 to 80 cm below
  kNeighbour,  // another geon 2 to 15 cm beside it
};
inline constexpr std::array kBackgroundScenes = {
    BackgroundScene::kLevel, BackgroundScene::kLean, BackgroundScene::kTiles,
    BackgroundScene::kWall,  BackgroundScene::kBox,  BackgroundScene::kNeighbour};
// level, lean, tiles, wall, box, neighbour.
std::string_view ToString(BackgroundScene scene);

// What stands round an object: all of it but a plain floor at `floor_m`.
struct Surroundings {
  geons::TriangleMesh mesh;  // empty in the open
  double floor_m = 0.0;
};

// Of an object that is seen from `azimuth_rad` (ViewOptions).
Surroundings MakeSurroundings(BackgroundScene scene, const geons::TriangleMesh& object,
                              double azimuth_rad, std::mt19937_64& random);

// A random shape (random_scan.h) in such a scene, 0.7 to 2.0 m away, seen from 15 to 65 degrees of
// elevation with 0.1 px of noise and stripes misplaced by 3 %. Depends on (seed, t) alone; the
// scene is that of t mod 6.
struct BackgroundTrial {
  BackgroundScene scene = BackgroundScene::kLevel;
  double range_m = 0.0;
  LabelledScan labelled;  // with colour tags and the shape's name
};
BackgroundTrial MakeBackgroundTrial(uint64_t seed, uint64_t t, double baseline_m);

}  // namespace geon::evaluation
