#pragma once

#include <span>
#include <vector>

namespace geon::recognition {

// The middle one of `values` (of an even number: the upper of the two); 0 when there are none.
//
// Source: quickselect (Hoare 1961). Each pass copies what is below the pivot and what is not
// instead of asking which it is, so that noise does not cost a mispredicted branch a value.
double Median(std::vector<double> values);

// For each of `values` the middle one of those at most `half_width` to each side of it, into
// `medians`, which is as long. At an end the window shrinks on both sides, so that a slope is not
// bent there.
//
// Source: thesis section 5.1 for the use. Two neighbouring windows differ by one value: what they
// share is sorted once for both, by merges (Batcher 1968) whose comparisons do not depend on the
// values. Windows of more than 15 values are looked at one by one. Throws ContractViolation when
// `half_width` is negative.
void RunningMedian(std::span<const double> values, int half_width, std::span<double> medians);

}  // namespace geon::recognition
