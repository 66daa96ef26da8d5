#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "recognition/geon_forest.h"

namespace geon::evaluation {

// How the combiner of method `evidence` is trained.
struct TrainingOptions {
  uint64_t seed = 1;
  int scans = 120000;             // the trees grow on these, four of a shape
  int calibration_scans = 12000;  // and the posterior is fitted on these
  int trees = 40;
  int depth = 20;
  bool shuffle_labels = false;  // a control: such a forest must not know anything
};

// A forest that owns its tables.
struct OwnedForest {
  std::vector<recognition::ForestNode> nodes;
  std::vector<int32_t> roots;
  int features = 0;
  double sharpness_1 = 1.0;
  double decided_1 = 0.0;
  recognition::GeonForest view() const { return {nodes, roots, features, sharpness_1, decided_1}; }
};

// What training reports of itself, on scans that no tree has seen.
struct TrainingReport {
  int calibration_scans = 0;
  double right_1 = 0.0;
  double decided_1 = 0.0;        // share of the answers that count as decided
  double decided_right_1 = 0.0;  // of which so many are right
};

// Does task(0) ... task(count - 1), one after the other or side by side, in any order. `share_1` is
// about how much of the whole training that is.
using ForEach =
    std::function<void(double share_1, int count, const std::function<void(int)>& task)>;

// Grows a forest on random scans (training_scan.h), then fits its sharpness by likelihood on others
// of the same kind. An answer counts as decided from the least posterior from which on more than
// 99.9 % of the answers to ordinary scans (random_scan.h, as many as it calibrates on) are right:
// the lower end of Wilson's interval. Depends on the options alone, not on how `for_each` goes
// about it.
//
// Source: Breiman, "Random forests", 2001, as OpenCV grows them (cv::ml::RTrees).
OwnedForest TrainForest(const TrainingOptions& options, const ForEach& for_each,
                        TrainingReport* report);

// The forest as the C++ source that common/recognition/geon_forest.cc includes.
std::string ForestSource(const OwnedForest& forest, const TrainingOptions& options);

}  // namespace geon::evaluation
