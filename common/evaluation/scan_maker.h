#pragma once

#include <random>
#include <vector>

#include "evaluation/object_tracer.h"
#include "evaluation/scan_conditions.h"
#include "sensor/scan_set.h"

namespace geon::evaluation {

// The scan set that six stripes make of an object which stands on z = 0 above the origin.
//
// Source: thesis sections 3.1 (triangulation), 4.2.4 (stripes at 1/4, 1/2 and 3/4 of the target
// box) and 6.1 (viewing sphere). Steps for each stripe: lay it through the wanted place of the box
// at the distance of the object's middle; one ray of the laser's fan for each image column (row);
// what it meets first, if the camera sees that too; the stripe's place in the image, with noise;
// triangulation.
//
// The lasers sit straight above and straight beside the camera, so that each column (row) belongs
// to one ray of the fan, whatever its depth. Deviations: the camera stands still and the fan is
// swung, where the robot turns its head; an orthographic view is one from 100 m through a longer
// lens, with no laser beside it. Frame L as in sensor::ScanSet; in the air z = 0 lies half a metre
// below the object. Same object, options and random state: same scan, bit for bit.
//
// Colour tags: how much of what lies within three pixels of the point in the colour camera's
// picture is the target; the camera's calibration is a pixel off.
sensor::ScanSet MakeScan(const ObjectTracer& object, const ViewOptions& view,
                         const FaultOptions& faults, const RangefinderOptions& rangefinder,
                         std::mt19937_64& random);

// The same scan with the truth: for each point of each profile whether it lies on the object, not
// on the floor or on what stands beside it.
struct LabelledScan {
  sensor::ScanSet scan;
  std::vector<std::vector<bool>> on_object;
};
LabelledScan MakeLabelledScan(const ObjectTracer& object, const ViewOptions& view,
                              const FaultOptions& faults, const RangefinderOptions& rangefinder,
                              std::mt19937_64& random);

}  // namespace geon::evaluation
