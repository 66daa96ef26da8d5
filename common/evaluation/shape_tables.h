#pragma once

#include <span>
#include <string>

#include "evaluation/confusion.h"
#include "evaluation/reliability.h"

namespace geon::evaluation {

// Tables 6.1-6.7 and the course of figure 6.11 as text, as they came out, with the thesis's own
// figures in brackets where it has any. Rates carry their count and Wilson's 95 % interval. Below
// them the worst class, row and viewing cell, and how far the confidence is to be believed.
//
// Source: thesis section 6.1.
std::string ShapeTables(std::span<const ConfusionRow> rows, std::span<const CellRate> cells,
                        const Reliability& reliability);

}  // namespace geon::evaluation
