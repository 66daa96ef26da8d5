#pragma once

#include <optional>
#include <string>

#include "geometry/sensor_rig.h"
#include "procs/geon/run_record.h"
#include "procs/geon/truth_file.h"

namespace geon::cli {

// The figures of a run's report, each a piece of HTML.

// A picture with the outline of what was taken for the target, and its box.
std::string ViewFigure(const sensor::TargetView& view);

// "Horizontal ¼ from the top".
std::string StripeName(sensor::Laser laser, double fraction_1);

// A card for each stripe: the profile to scale, target and background told apart, and its
// theta-plot.
std::string StripeFigures(const RunRecord& run, const geometry::SensorRig& rig);

// The seven labels and how probable each is.
std::string PosteriorFigure(const sensor::GeonVerdict& verdict);

// From above, frame W: obstacles, safe polygons, target; the true objects where they are known; the
// path by odometry (frame O).
std::string MapFigure(const RunRecord& run, const std::optional<Truth>& truth);

// The phases as a bar to scale and as a list with what the planner said.
std::string TimelineFigure(const RunRecord& run);

}  // namespace geon::cli
