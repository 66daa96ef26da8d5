#pragma once

#include <functional>
#include <vector>

#include "evaluation/shape_experiment.h"
#include "procs/geon/experiment_objects.h"
#include "procs/geon/worst_views.h"
#include "sensor/geon_verdict.h"

namespace geon::cli {

// Shard `index` (1 to `count`) of an experiment: the trials t with t mod count = index - 1.
struct Shard {
  int index = 1;
  int count = 1;
};

using Recognizer = std::function<sensor::GeonVerdict(const sensor::ScanSet&)>;

struct ShapeRun {
  std::vector<evaluation::ShapeTrial> trials;  // by rising t
  std::vector<WorstView> worst;
};

// Recognises every view of every object, `jobs` objects at a time.
ShapeRun RunShapeTrials(const std::vector<ShownObject>& objects,
                        const std::vector<evaluation::ViewingCell>& sphere,
                        const evaluation::SphereConditions& conditions, const Recognizer& recognize,
                        Shard shard, int jobs);

}  // namespace geon::cli
