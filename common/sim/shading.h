#pragma once

#include <vector>

#include "sim/scene.h"
#include "sim/view.h"

namespace geon::sim {

enum class LampShadows { kSoft, kNone };

// Light that comes to each pixel, linear, without noise: diffuse and mirrored light of the lamp and
// the sun (hard shadows), and what the room reflects. Fills `light`, whose memory is used again.
// 3 values (blue, green, red) a pixel:
void ShadeColor(const Scene& scene, const View& view, LampShadows shadows,
                std::vector<float>* light);
// Red alone, the lamp shining through everything:
void ShadeRed(const Scene& scene, const View& view, std::vector<float>* light);

}  // namespace geon::sim
