#pragma once

#include <Eigen/Core>

namespace geon::sim {

// The ceiling lamp as a mirror that lies level at `p_W_m` shows it to an eye: how bright, a white
// surface right below the lamp being 1; 0 where the mirror shows something else. `lamp_W_m` is the
// middle of the lamp's panel (kLampPanel_m). The panel's edges are soft: floors are a little wavy.
//
// A panel of area A that gives the floor below it, h away, the irradiance E has the radiance
// E h^2 / A, and a white surface there E / pi: the panel is pi h^2 / A times as bright.
float MirroredLamp_1(const Eigen::Vector3f& p_W_m, const Eigen::Vector3f& eye_W_m,
                     const Eigen::Vector3f& lamp_W_m);

}  // namespace geon::sim
