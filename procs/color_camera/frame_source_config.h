#pragma once

#include "config/yaml_section.h"
#include "device/frame_source.h"
#include "geometry/pinhole_camera.h"

namespace geon::color_camera {

// Reads the keys that every camera section of the robot file has: source, timeout_s, controls. The
// size is the rig's. Errors go to the section's document.
device::FrameSourceOptions ReadFrameSource(config::YamlSection section,
                                           const geometry::PinholeCamera& camera);

}  // namespace geon::color_camera
