#pragma once

#include <cstdint>
#include <vector>

namespace geon::evaluation {

// How many points were labelled rightly: of the target or of its background.
//
// Source: van Rijsbergen, "Information Retrieval", 1979, for the F measure.
struct PointCounts {
  int64_t kept = 0;    // the target's, labelled so
  int64_t lost = 0;    // the target's, taken for background
  int64_t strays = 0;  // of the background, taken for the target's

  void Count(const std::vector<bool>& truth, const std::vector<bool>& label) {
    for (size_t i = 0; i < truth.size(); ++i) {
      if (truth[i] && label[i]) ++kept;
      if (truth[i] && !label[i]) ++lost;
      if (!truth[i] && label[i]) ++strays;
    }
  }
  PointCounts& operator+=(const PointCounts& other) {
    kept += other.kept;
    lost += other.lost;
    strays += other.strays;
    return *this;
  }
  // Harmonic mean of precision and recall; 1 where there was nothing to find.
  double f1_1() const {
    const int64_t all = 2 * kept + lost + strays;
    return all > 0 ? 2.0 * static_cast<double>(kept) / static_cast<double>(all) : 1.0;
  }
  // Part of the target's points that were lost.
  double lost_1() const {
    return kept + lost > 0 ? static_cast<double>(lost) / static_cast<double>(kept + lost) : 0.0;
  }
};

}  // namespace geon::evaluation
