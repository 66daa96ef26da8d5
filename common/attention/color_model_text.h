#pragma once

#include <string>
#include <vector>

#include "attention/color_model.h"
#include "base/status.h"

namespace geon::attention {

// Source: thesis section 4.1.2 for the half-spaces; the file format is ours.
//
// The file format geon.color_model.v1: a small YAML, one "key: value" a line, # for comments.
//
//   format: geon.color_model.v1
//   name: red_paint
//   dark_level_1: 20       # both levels may be left out: none
//   clipped_level_1: 250
//   region: target         # or rim; as many as there are
//   half_space: [1, -1, -1, 20]
//   half_space: [0, 0, -1, -75]
//
// A half-space belongs to the region above it: coefficients of red, green and blue, and the
// threshold that their sum must exceed.
//
// `comments` go to the top of the file.
std::string SerializeColorModel(const ColorModel& model, const std::vector<std::string>& comments);

// Strict: unknown, duplicate, missing or ill-typed keys are errors "name:line: ...".
Result<ColorModel> ParseColorModel(const std::string& text, const std::string& name);

}  // namespace geon::attention
