#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/geon_label.h"
#include "evaluation/object_tracer.h"
#include "evaluation/scan_conditions.h"
#include "evaluation/viewing_sphere.h"
#include "sensor/scan_set.h"

namespace geon::evaluation {

// One object in one stable position, whose views are tried.
struct Subject {
  GeonLabel truth = GeonLabel::kCuboid;
  std::string object;
  int position = 1;
};

// What is the same for all trials of an experiment over the viewing sphere.
struct SphereConditions {
  uint64_t seed = 1;
  double range_m = 1.0;
  bool floor = false;
  bool orthographic = false;
  FaultOptions faults;
  RangefinderOptions rangefinder;
};

// One view and what a recogniser said.
struct ShapeTrial {
  int t = 0;
  int subject = 0;
  ViewingCell cell;
  GeonLabel answer = GeonLabel::kCuboid;
  double confidence = 0.0;
  bool decided = false;
};

// The view of trial t = subject * cells + cell, as a scan set. Depends on the conditions' seed and
// on t alone.
sensor::ScanSet MakeTrialScan(const ObjectTracer& object, const ViewingCell& cell, int t,
                              const SphereConditions& conditions);

}  // namespace geon::evaluation
