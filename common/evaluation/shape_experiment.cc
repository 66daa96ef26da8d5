#include "evaluation/shape_experiment.h"

#include "evaluation/scan_maker.h"
#include "evaluation/trial_random.h"

namespace geon::evaluation {

sensor::ScanSet MakeTrialScan(const ObjectTracer& object, const ViewingCell& cell, int t,
                              const SphereConditions& conditions) {
  std::mt19937_64 random = TrialRandom(conditions.seed, static_cast<uint64_t>(t));
  ViewOptions view;
  view.range_m = conditions.range_m;
  view.elevation_rad = cell.elevation_rad;
  view.azimuth_rad = cell.azimuth_rad;
  view.floor = conditions.floor;
  view.orthographic = conditions.orthographic;
  return MakeScan(object, view, conditions.faults, conditions.rangefinder, random);
}

}  // namespace geon::evaluation
