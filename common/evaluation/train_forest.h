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
  int scans = 60000;              // the trees grow on these, four of a shape
  int calibration_scans = 12000;  // and the posterior is fitted on these
  int trees = 50;
  int depth = 16;
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

// Grows a forest on random scans of both families (random_scan.h) under random stress, then fits
// its sharpness by likelihood and sets the posterior from which an answer counts as decided.
// Depends on the options alone. `progress` hears how much is done, 0 to 1.
//
// Source: Breiman, "Random forests", 2001, as OpenCV grows them (cv::ml::RTrees).
OwnedForest TrainForest(const TrainingOptions& options, const std::function<void(double)>& progress,
                        TrainingReport* report);

// The forest as the C++ source that common/recognition/geon_forest.cc includes.
std::string ForestSource(const OwnedForest& forest, const TrainingOptions& options);

}  // namespace geon::evaluation
