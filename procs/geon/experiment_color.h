#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "attention/color_model.h"
#include "base/status.h"
#include "procs/geon/experiment_color_record.h"
#include "procs/geon/experiment_shapes.h"

namespace geon::cli {

struct ColorConditions {
  uint64_t seed = 1;
  int images = 700;
  int lessons = 56;  // pictures of other scenes that the colour is taught on
};

// Teaches the colour on scenes of the simulator that no trial has: rendered pictures with the
// target's true mask, exposed for the target, the light's colour taken out by what the floor camera
// sees of the floor. `say` hears how far it is, 0 to 1.
Result<attention::ColorModel> TeachOnScenes(const ColorConditions& conditions,
                                            const std::function<void(double)>& say);

// Looks for the target in this shard's trials. `model` is what exposes: the exposure law runs on
// earlier frames of the scene, from the camera's usual exposure, and finds its target by it. In the
// frame that comes of it, and in one of the usual exposure, every model is asked: `model`, adapted
// to the light on the floor, and the thesis's three as they are.
ColorRecord RunColorTrials(const attention::ColorModel& model, const ColorConditions& conditions,
                           const Shard& shard, int jobs, const std::function<void(double)>& say);

}  // namespace geon::cli
