#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "base/status.h"
#include "geometry/sensor_rig.h"
#include "rangefinder/laser_light.h"
#include "sensor/stripe.h"
#include "sim/camera_options.h"

namespace geon::cli {

// The calibration board at one distance from the B/W camera, across its optical axis (thesis 3.2).
struct BoardFrames {
  double distance_m = 0.0;
  // Laser light only, grey; one image a frame.
  std::vector<sensor::Image> light;
};

// The board at all distances, nearest first, for one laser.
struct BoardSeries {
  int distances = 0;
  int frames = 0;  // at each distance, the fewest
  std::function<Result<BoardFrames>(int k)> at;
};

struct BoardSteps {
  double from_m = 0.65;
  double to_m = 2.05;
  double step_m = 0.005;
  int frames = 10;
};

// Before the simulated robot's cameras, in the simulator's own jig.
BoardSeries SimulatedBoard(const geometry::SensorRig& designed, const sim::RendererOptions& options,
                           uint64_t seed, sensor::Laser laser, const BoardSteps& steps);

// From a folder of frames recorded with a real robot. Its frames.csv lists them under the header
// "laser,distance_m,lit,unlit": horizontal or vertical, metres, file names in the folder; `unlit`
// may be empty. Lines of one laser and distance are averaged.
Result<BoardSeries> RecordedBoard(const std::filesystem::path& directory, sensor::Laser laser,
                                  rangefinder::LaserColor color);

}  // namespace geon::cli
