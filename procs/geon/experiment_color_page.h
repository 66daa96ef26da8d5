#pragma once

#include <string>

#include "procs/geon/experiment_color_record.h"

namespace geon::cli {

// What geon experiment color found, as one self-contained HTML page without scripts. All of it
// follows from the record.
std::string ColorPage(const ColorRecord& record);

}  // namespace geon::cli
