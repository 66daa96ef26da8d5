#pragma once

#include <optional>
#include <string>

#include "geometry/sensor_rig.h"
#include "procs/geon/run_record.h"
#include "procs/geon/truth_file.h"

namespace geon::cli {

// One self-contained HTML page by which a person understands the run.
std::string ReportPage(const RunRecord& run, const geometry::SensorRig& rig,
                       const std::optional<Truth>& truth);

// The true label of what the run was about: that of the shape nearest to the supposed target.
std::optional<GeonLabel> TrueLabel(const RunRecord& run, const Truth& truth);

}  // namespace geon::cli
