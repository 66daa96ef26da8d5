#pragma once

#include "geometry/sensor_rig.h"
#include "sim/camera_options.h"

namespace geon::sim {

// The individual built from a drawing: focal lengths, and the directions of cameras and lasers, are
// off by a little. These errors are why the rangefinder must be calibrated (thesis section 3.2).
geometry::SensorRig AsMounted(const geometry::SensorRig& designed,
                              const MountingErrorOptions& options);

}  // namespace geon::sim
