#pragma once

#include <filesystem>

#include "attention/color_model.h"
#include "config/yaml_section.h"

namespace geon::color_camera {

// Reads `target_color` of the robot file's section `planner:`, the colour that the camera exposes
// for and the planner looks for: a model's name, or a file of `geon teach` beside the robot file.
// Errors go to the section's document.
void ReadTargetColor(config::YamlSection planner, const std::filesystem::path& robot_file,
                     attention::ColorModel* target_color);

}  // namespace geon::color_camera
