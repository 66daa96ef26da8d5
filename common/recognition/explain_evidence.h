#pragma once

#include <string>
#include <vector>

#include "sensor/geon_verdict.h"

namespace geon::recognition {

// The evidence behind a verdict in words: bending, tapering, how many profiles are curved or have
// corners, and how the posterior is shared among the labels.
//
// Source: the thesis's own evidence, sections 5.3 to 5.5, as DecideGeon finds it.
std::vector<std::string> ExplainEvidence(const sensor::GeonVerdict& verdict);

}  // namespace geon::recognition
