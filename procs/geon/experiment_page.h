#pragma once

#include <string>

#include "procs/geon/experiment_record.h"

namespace geon::cli {

// What an experiment over the viewing sphere found, as one self-contained HTML page without
// scripts: for people who do not read the code, on a screen or printed.
//
// All of it follows from the record, so that the same trials give the same bytes however they were
// spread; how long they took is not in it.
std::string ExperimentPage(const ShapeRecord& record);

}  // namespace geon::cli
