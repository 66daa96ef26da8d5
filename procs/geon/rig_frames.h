#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "calibration/rig_observations.h"
#include "geometry/sensor_rig.h"
#include "sensor/image.h"

namespace geon::cli {

// One picture of a calibration of the rig.
struct RigFrame {
  enum class Camera { kColor, kStripe };
  enum class Light { kNone, kHorizontal, kVertical };
  Camera camera = Camera::kStripe;
  Light light = Light::kNone;  // which laser burned
  double exposure_s = 0.0;
  sensor::Image image;
  std::string file;  // where it came from, for errors; empty: from the simulated robot
};

// All pictures taken at one head pose. `stop` counts where the robot stood before the board; of
// pictures of the bare floor it is kFloor.
struct RigShot {
  static constexpr int kFloor = -1;
  int stop = 0;
  double pan_rad = 0.0, tilt_rad = 0.0;  // by the unit's encoders
  std::vector<RigFrame> frames;
};

// A calibration's shots, one after the other.
struct RigSeries {
  int shots = 0;
  std::function<Result<RigShot>(int k)> at;
};

// From a folder of frames recorded with a real robot (or by RigRecorder). Its frames.csv lists them
// under the header "stop,pan_deg,tilt_deg,camera,laser,exposure_s,file": a number or "floor",
// degrees by the encoders, color or stripe, none, horizontal or vertical, seconds, a file name in
// the folder. Lines with the same stop and angles are one shot.
Result<RigSeries> RecordedRig(const std::filesystem::path& directory);

// Writes shots as such a folder.
class RigRecorder {
 public:
  static Result<RigRecorder> Create(const std::filesystem::path& directory);
  Status Add(const RigShot& shot);
  Status Finish() const;  // writes the listing

 private:
  std::filesystem::path directory_;
  std::string listing_;
  int shots_ = 0;
};

// Adds what a shot shows to the observations: the board's corners in both cameras (the B/W frame of
// the longest exposure without a laser), and each laser's stripe, its light less that of the unlit
// frame of the same exposure. Errors name the frame: a picture of another size than the drawing's,
// the light of the other laser.
Status ObserveShot(const RigShot& shot, const geometry::SensorRig& drawn,
                   calibration::RigObservations* observations);

}  // namespace geon::cli
