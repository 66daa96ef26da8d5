#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "base/geon_label.h"
#include "evaluation/scan_conditions.h"
#include "sensor/scan_set.h"

namespace geon::evaluation {

// What goes wrong while the robot scans: noise from none to two and a half times the usual,
// stripes misplaced by up to 6 %, and in every second scan one or two faults more.
FaultOptions RobotFaults(std::mt19937_64& random);

// Scans of one random shape (training_shape.h) for growing the forest of method `evidence`; `truth`
// is set. Depends on (seed, t) and on `views` alone; shares no scan with MakeRandomScan.
//
// Three views in four are the robot's (0.7-1.75 m, elevations of 8-82 degrees, a baseline of 50 to
// 130 mm), half of them with one or two of the faults of FaultOptions. The fourth is a depth
// camera's (0.4-1.2 m, 20-60 degrees): coarser, with patches, steps and lost edges, on a support
// that leans; people show such scans too, and they keep the evidence from leaning on what only the
// robot's lasers can see. One shape in eight has something else beside it.
//
// Source: ours; Khoshelham and Elberink 2012 (stripe_noise.h) for how depth cameras err.
std::vector<sensor::ScanSet> MakeTrainingScans(uint64_t seed, uint64_t t, int views);

}  // namespace geon::evaluation
