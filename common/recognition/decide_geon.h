#pragma once

#include "sensor/geon_verdict.h"

namespace geon::recognition {

// Fills label, confidence, posterior and reasons of a verdict from its evidence.
//
// Source: thesis section 5.6, figure 5.17. Bent? More than half of the profiles curved: bent
// cylinder, else bent cuboid. Tapered? More than one curved: tapered cylinder, else tapered cuboid.
// No curve: cuboid. A corner: cylinder. All curved: ellipsoid, else cylinder. ("More than half" is
// "more than three" of the six.)
//
// The posterior is not in the thesis and is not calibrated. Each question of the tree is given to
// its answer with (m + 1) / (m + 2), where m counts the observations that speak for it: clues that
// fired, or silent ones where none did; profiles beyond the limit where profiles are counted. A
// label's posterior is the product along its way through the tree; they sum to 1, and confidence is
// the label's own.
void DecideGeon(sensor::GeonVerdict* verdict);

}  // namespace geon::recognition
