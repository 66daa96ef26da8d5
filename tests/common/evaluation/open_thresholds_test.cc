#include "evaluation/open_thresholds.h"

#include <gtest/gtest.h>

#include <set>

namespace geon::evaluation {
namespace {

using recognition::CurvatureMethod;

TEST(OpenThresholds, EachSetsWhatItGetsAndNothingElse) {
  for (const CurvatureMethod method :
       {CurvatureMethod::kOGorman, CurvatureMethod::kRamer, CurvatureMethod::kWall}) {
    const std::vector<Threshold> all = OpenThresholds(method);
    for (const Threshold& set : all) {
      recognition::RecognitionOptions options;
      const double value = set.integer ? set.low : 0.5 * (set.low + set.high);
      set.set(&options, value);
      for (const Threshold& other : all) {
        EXPECT_EQ(other.get(options),
                  other.name == set.name ? value : other.get(recognition::RecognitionOptions()))
            << set.name << " " << other.name;
      }
    }
  }
}

TEST(OpenThresholds, HaveNamesOfTheirOwnAndHoldTheDefaults) {
  std::set<std::string> names;
  const std::vector<Threshold> all = OpenThresholds(CurvatureMethod::kOGorman);
  for (const Threshold& threshold : all) {
    names.insert(threshold.name);
    EXPECT_GE(threshold.get({}), threshold.low) << threshold.name;
    EXPECT_LE(threshold.get({}), threshold.high) << threshold.name;
  }
  EXPECT_EQ(names.size(), all.size());
}

}  // namespace
}  // namespace geon::evaluation
