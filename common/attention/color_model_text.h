#pragma once

#include <string>
#include <vector>

#include "attention/color_model.h"
#include "base/status.h"

namespace geon::attention {

// Source: thesis section 4.1.2 for the half-spaces; the file format is ours.
//
// The file format geon.color_model.v1: a small YAML, one "key: value" a line, # for comments.
// Either a learned colour
//
//   format: geon.color_model.v1
//   name: red_paint
//   mean_i_1: 0.61        # and the other fields of ChromaticityColor, all of them
//   ...
//
// or half-spaces, one a line: coefficients of red, green and blue, and the threshold they must
// exceed
//
//   half_space: [1, -1, -1, 20]
//
// `comments` go to the top of the file.
std::string SerializeColorModel(const ColorModel& model, const std::vector<std::string>& comments);

// Strict: unknown, duplicate, missing or ill-typed keys are errors "name:line: ...".
Result<ColorModel> ParseColorModel(const std::string& text, const std::string& name);

}  // namespace geon::attention
