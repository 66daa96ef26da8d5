#pragma once

#include <cstdint>
#include <random>

#include "geons/geon_shape.h"
#include "geons/triangle_mesh.h"
#include "sensor/scan_set.h"

namespace geon::evaluation {

enum class Family { kSuperquadric, kPolygon };

// A shape of random size, deformation and stable position; each class as likely as the others.
//
// Source: the thesis has no such experiment. Ranges: sections of 8 to 20 cm, lengths up to 24 cm
// (36 cm along a bent axis), tapers 0.12 to 0.8, bends 45 to 180 degrees: what the robot's image
// can hold at its distances, and wider than the 28 objects, none of which is drawn on purpose.
geons::GeonShape RandomShape(std::mt19937_64& random);

// The surface of a shape by one of the two generators, standing on z = 0 above the origin.
geons::TriangleMesh ShapeMesh(const geons::GeonShape& shape, Family family, int sides = 48);

// What a recogniser is trained and tuned on, and tested on with other seeds.
struct RandomScan {
  geons::GeonShape shape;
  Family family = Family::kSuperquadric;
  double range_m = 1.0;
  double elevation_rad = 0.0;
  sensor::ScanSet scan;  // with its truth
};

// The scan `t` of a seed: a random shape of either family seen from anywhere (0.9-1.7 m, 15-70
// degrees of elevation) with 0.1 px of noise by a baseline of 62.5 or 125 mm; half of them on a
// floor, half of them with stripes misplaced by 3 %. Depends on (seed, t) alone.
RandomScan MakeRandomScan(uint64_t seed, uint64_t t);

}  // namespace geon::evaluation
