#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "evaluation/success_rate.h"
#include "recognition/recognition_options.h"
#include "sensor/scan_set.h"

namespace geon::evaluation {

struct ThresholdSearchOptions {
  uint64_t seed = 1;
  int draws = 150;  // of all thresholds at random
  int steps = 500;  // changes of a few thresholds of the best so far, ever smaller
};

// What was best, and how often it was right on the scans it was searched with (which flatters it).
struct ThresholdSearchResult {
  recognition::RecognitionOptions options;
  SuccessRate training;
};

// Thresholds with which most scans are recognised, by random search from `start`.
//
// Source: none in the thesis, which gives no values; Bergstra and Bengio 2012, "Random search for
// hyper-parameter optimization". Values are rounded to two digits, as people would set them. Scans
// carry their truth. Same scans and options, same result. `progress` hears of every improvement.
ThresholdSearchResult SearchThresholds(
    std::span<const sensor::ScanSet> scans, const recognition::RecognitionOptions& start,
    const ThresholdSearchOptions& options,
    const std::function<void(int step, const SuccessRate& best)>& progress);

// How often the recogniser is right on scans that carry their truth.
SuccessRate RecognitionRate(std::span<const sensor::ScanSet> scans,
                            const recognition::RecognitionOptions& options);

}  // namespace geon::evaluation
