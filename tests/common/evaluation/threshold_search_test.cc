#include "evaluation/threshold_search.h"

#include <gtest/gtest.h>

#include "evaluation/random_scan.h"

namespace geon::evaluation {
namespace {

std::vector<sensor::ScanSet> Scans(uint64_t seed, uint64_t count) {
  std::vector<sensor::ScanSet> scans;
  for (uint64_t t = 0; t < count; ++t) scans.push_back(MakeRandomScan(seed, t).scan);
  return scans;
}

// Thresholds with which everything is bent.
recognition::RecognitionOptions BadOptions() {
  recognition::RecognitionOptions options;
  options.method = recognition::Method::kThesis;
  options.bending.concave_edge_m = 1e-6;
  options.difference_of_slope.curve_width = 60;
  return options;
}

TEST(SearchThresholds, ImprovesBadThresholdsAndTellsTheRateItFound) {
  const std::vector<sensor::ScanSet> scans = Scans(1, 40);
  ThresholdSearchOptions options;
  options.draws = 10;
  options.steps = 40;
  int heard = 0;
  const ThresholdSearchResult found = SearchThresholds(
      scans, BadOptions(), options, [&heard](int, const SuccessRate&) { ++heard; });
  EXPECT_GT(found.training.right, RecognitionRate(scans, BadOptions()).right);
  EXPECT_EQ(found.training.right, RecognitionRate(scans, found.options).right);
  EXPECT_GE(heard, 2);
}

TEST(SearchThresholds, SameSeedSameThresholds) {
  const std::vector<sensor::ScanSet> scans = Scans(2, 12);
  ThresholdSearchOptions options;
  options.draws = 5;
  options.steps = 10;
  const auto search = [&] {
    return SearchThresholds(scans, BadOptions(), options, [](int, const SuccessRate&) {});
  };
  const auto a = search(), b = search();
  EXPECT_EQ(a.training.right, b.training.right);
  EXPECT_EQ(a.options.samples, b.options.samples);
  EXPECT_EQ(a.options.bending.concave_edge_m, b.options.bending.concave_edge_m);
}

}  // namespace
}  // namespace geon::evaluation
