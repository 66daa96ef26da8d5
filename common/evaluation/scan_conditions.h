#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geon::evaluation {

// The range finder that makes the scans: the B/W camera of scripts/config/robot.yaml with lasers at
// the distance that gives the thesis's 1 mm at 1 m (section 3.2).
struct RangefinderOptions {
  int width_px = 640;
  // The head turns for every stripe, so that the object is never cut at the top or bottom of the
  // 480 rows; here the head stands still and the image is as high as it is wide.
  int height_px = 640;
  double focal_px = 1600.0;
  double baseline_m = 0.0625;    // horizontal laser above the camera, vertical one beside it
  double color_above_m = 0.065;  // the colour camera, which measures the target box
  // Points are told the colour that the colour camera sees where they lie (`on_color_1`).
  bool color_tags = false;
  // A depth camera instead: its rows and columns are the stripes, nothing is hidden from it, and it
  // errs as a triangulation over baseline_m does.
  bool depth_camera = false;
};

// From where the object is seen, and on what.
struct ViewOptions {
  double range_m = 1.0;        // from the camera to the middle of the object
  double elevation_rad = 0.0;  // of the camera above the horizon of that middle
  double azimuth_rad = 0.0;    // round the object, from its x axis
  // On a floor, whose points belong to the scan; else in the air, as in thesis section 6.1.
  bool floor = false;
  // Height of that floor, from what the object stands on: below 0 where that is a tile or a box,
  // which then belongs to what stands beside the object.
  double floor_m = 0.0;
  // Parallel rays instead of triangulation: nothing is hidden from the laser (section 6.1).
  bool orthographic = false;
};

// What goes wrong while measuring.
struct FaultOptions {
  double noise_px = 0.1;        // on the stripe in the image, standard deviation
  double speckle_px = 0.0;      // as much again, correlated over about four pixels
  double outliers_1 = 0.0;      // fraction of pixels with a peak anywhere within 20 px
  double dropout_1 = 0.0;       // fraction of pixels without a peak
  double floor_cut_m = 0.0;     // points lower than this are missing
  double misplacement_1 = 0.0;  // of a stripe, in target boxes, standard deviation
  double attitude_rad = 0.0;    // by which the camera's believed attitude is wrong
  // The robot leans by so much in any direction, on the floor below its camera, and does not know.
  double lean_rad = 0.0;
  // Of sensors that match patches instead of finding peaks (structured light, stereo):
  double step_px = 0.0;     // offsets come in such steps
  double patch_px = 0.0;    // each line shows the mean over so many lines to both sides
  double steepest_m = 0.0;  // lines missing where the depth changes faster from line to line
  double edge_px = 0.0;     // each end of a surface stands so far beside its place
  double shadow_px = 0.0;   // up to so many lines missing on each side of it
  // What calibration leaves of errors in the offset, standard deviations: the same all over the
  // image, and waves as long as the image or half of it.
  double offset_px = 0.0;
  double ripple_px = 0.0;
};

// A named set of faults. `noise_px` is kept by all.
struct Stress {
  std::string name;
  FaultOptions faults;
  bool floor = false;
  double scale_1 = 1.0;  // of the object
};

// none outliers dropout speckle floor_cut attitude misplacement small, and realish: a floor that
// the recogniser has to cut away and stripes misplaced by 3 %.
const std::vector<Stress>& Stresses();
std::optional<Stress> FindStress(std::string_view name);

}  // namespace geon::evaluation
