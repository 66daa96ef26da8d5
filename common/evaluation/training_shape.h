#pragma once

#include <random>

#include "base/geon_label.h"
#include "geons/triangle_mesh.h"

namespace geon::evaluation {

// A shape to train on, standing on z = 0 above the origin.
struct TrainingShape {
  GeonLabel label = GeonLabel::kCuboid;
  geons::TriangleMesh mesh;
};

// A random shape, each class as likely as the others. Far more kinds than the 28 objects, none of
// which is drawn on purpose: half of them superquadrics with edges from sharp to well rounded, half
// polygon meshes; sides of 3 to 26 cm, from discs and plates to rods; tapers that differ between
// the two sides, down to wedges that taper on one side only; boxes and cylinders with a draft of up
// to 2 %, as castings have; round sections that are slightly oval; bent bodies that also taper;
// bends of 40 to 180 degrees; one upright box or cylinder in eight an open vessel. It stands or
// lies on any of its flat sides; bent ones also stand on an end, as a handle is mounted.
//
// Source: the thesis has no such shapes. Solina and Bajcsy 1990 for the deformations
// (superquadric.h). What counts as tapered is ours: the narrow end at most 0.82 of the wide one
// (taper 0.1), the least for which recognition was found to be possible at every range.
TrainingShape MakeTrainingShape(std::mt19937_64& random);

}  // namespace geon::evaluation
