#pragma once

#include <cstdint>

#include "base/angles.h"
#include "base/status.h"

namespace geon::sim {

// One camera's electronics and lens. Light of 1 is a white surface under the lamp.
struct CameraOptions {
  double rate_hz = 5.0;
  double exposure_us = 20000.0;
  double white_1 = 1.0;          // signal of light 1 at this exposure, in units of full scale
  double gamma_1 = 2.2;          // signal to pixel value; 1 for a measuring camera
  double full_well_e = 12000.0;  // electrons at full scale: shot noise
  double read_noise_e = 15.0;
  double black_level_1 = 0.0;  // pedestal, in units of full scale
  double blur_1 =
      0.12;  // share of a pixel's light that the lens spreads to each neighbour, per axis
  double dropped_1 = 0.0;  // share of the frames that never arrive
};

// The two line lasers (thesis section 3.1: 20 mW, 670 nm) as the filtered B/W camera sees them.
struct LaserOptions {
  // Signal of the stripe's crest on a white surface at 1 m, in units of full scale. 1.7 puts the
  // crest at 0.8 of full scale on the red paint of the geons.
  double crest_1 = 2.2;
  double waist_sigma_m = 0.0007;  // half thickness (standard deviation) of the fan at its origin
  double divergence_m =
      1.4;  // distance at which it is thicker by sqrt(2): 2 mm full width half maximum at 1 m
  double fan_half_angle_rad = RadiansFromDegrees(30.0);
  // Contrast of the speckle between pixels. 0.17 moves the centroid by about 0.07 px rms.
  double speckle_1 = 0.17;
};

// How far the simulated robot is from its drawing: standard deviations, drawn once an individual.
struct MountingErrorOptions {
  double focal_1 = 0.003;     // of focal lengths, against the drawing's
  double aspect_1 = 0.001;    // of how far a pixel is from square
  double principal_px = 4.0;  // of the principal point, and of the lens's middle against that
  double lens_px = 2.0;       // barrel distortion at the picture's corner: a mean, not a deviation
  double camera_m = 0.0015;
  double camera_rad = RadiansFromDegrees(0.1);
  double laser_m = 0.0015;
  double laser_rad = RadiansFromDegrees(0.3);
  double laser_bow_1 = 0.0002;  // of a line at the edge of its fan, as a share of the distance
  double axes_m = 0.0015;       // how far the tilt axis passes by the pan axis
  double axes_rad = RadiansFromDegrees(0.1);  // how far it is from square to it
  double zero_rad = RadiansFromDegrees(0.2);  // the pan-tilt unit's true angles where it counts 0
  // Which robot of the series: its errors stay its own, so that one calibration serves every run.
  int individual = 1;
};

// A robot that is just as its drawing.
inline MountingErrorOptions NoMountingErrors() {
  return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1};
}

struct RendererOptions {
  CameraOptions color;
  // 30 Hz. The band-pass filter leaves 2.5 % of the room's light.
  CameraOptions stripe{30.0, 10000.0, 0.025, 1.0, 20000.0, 60.0, 0.016, 0.15};
  CameraOptions floor;
  LaserOptions lasers;
  MountingErrorOptions mounting;
};

// Which option is out of range, if any.
Status Validate(const RendererOptions& options);

}  // namespace geon::sim
