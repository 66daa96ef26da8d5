#pragma once

#include <Eigen/Core>

namespace geon::sim {

// Sides of the ceiling lamp, along x and y of W.
inline constexpr double kLampPanel_m[2] = {0.6, 1.6};
// Of the light on a floor right below the lamp; 0.4 comes from the walls.
inline constexpr float kLampShare_1 = 0.6F;

// The light of the room: a ceiling lamp with its diffuse reflection from the walls, and the sun.
struct Lighting {
  struct Sun {
    double level_1 = 0.0;  // irradiance across its rays, in units of the lamp's below it
    double azimuth_rad = 0.0;
    double elevation_rad = 0.785398163397448;
  };
  double kelvin = 4000.0;  // colour temperature of the lamp
  double level_1 = 1.0;    // at 1 the floor below the lamp is shown in the colour it is painted
  Sun sun;
  Eigen::Vector3d lamp_W_m = Eigen::Vector3d(1.5, 2.25, 2.8);  // middle of the lamp
};

// Red, green and blue of a black body as the cameras see it: their white balance is locked to 4000
// K.
Eigen::Vector3f BlackBodyColor(double kelvin);

}  // namespace geon::sim
