#pragma once

#include <string_view>
#include <vector>

#include "recognition/evidence_list.h"

namespace geon::recognition {

// Adds the least, the 10th, 25th, 50th, 75th and 90th percentile and the largest of the values,
// interpolated between neighbours; zeros when there are none. Source: Hyndman and Fan, "Sample
// quantiles in statistical packages", 1996, type 7.
void AddQuantiles(std::string_view name, std::vector<double> values, EvidenceList* evidence);

}  // namespace geon::recognition
