#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "sim/world.h"

namespace geon::sim {

// What makes a pen hard.
enum class PenKind {
  kBoxes,        // up to five boxes anywhere
  kUTrap,        // a U of boards between robot and geon, open towards the robot
  kDeadEnd,      // the robot starts in a blind alley
  kGap,          // a wall with one gap of 0.75 m across the pen
  kEmpty,        // boxes, and no geon
  kUnreachable,  // a wall across the pen closes every way to the geon
};
std::string_view ToString(PenKind kind);
std::optional<PenKind> PenKindFromString(std::string_view name);

// A pen about as large as the thesis's (section 6.3, 3.0 x 4.5 m) for experiments with driving: one
// geon (but for kEmpty), on the floor or on a box of 70 cm, at least 1.5 m from the robot. Where
// the kind does not say otherwise a robot that knew everything could drive to it through gaps of at
// least 0.72 m. The same seed gives the same pen.
World RandomPen(uint64_t seed, PenKind kind);

// The kind of a pen of the mixture that navigation is measured on: half boxes, a sixth each of the
// three traps.
PenKind MixedPenKind(uint64_t seed);

}  // namespace geon::sim
