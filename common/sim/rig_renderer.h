#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/sensor_rig.h"
#include "sim/camera_options.h"
#include "sim/image_sensor.h"
#include "sim/scene.h"

namespace geon::sim {

// Where the head is during an exposure: the turret in W, and the pan-tilt unit's true angles.
struct RigPose {
  geometry::RigidTransform X_WR = geometry::RigidTransform::Identity();
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
};

// Share of the exposure during which each laser burned.
struct LaserFractions {
  double horizontal_1 = 0.0;
  double vertical_1 = 0.0;
};

// Tightly packed rows, 1 (grey) or 3 (blue, green, red) bytes a pixel.
struct Frame {
  int width_px = 0;
  int height_px = 0;
  int channels = 0;
  std::vector<uint8_t> pixels;
};

// What the three cameras of one individual robot (options.mounting) see. All noise follows from the
// seed: the same seed, pose and `seq` give the same bytes.
//
// Light without noise is kept as long as the pose stays the same, so a head that stands still is
// cheap.
class RigRenderer {
 public:
  RigRenderer(std::shared_ptr<const Scene> scene, const geometry::SensorRig& designed,
              const RendererOptions& options, uint64_t seed);
  ~RigRenderer();
  RigRenderer(RigRenderer&&) noexcept;
  RigRenderer& operator=(RigRenderer&&) noexcept;

  void SetScene(std::shared_ptr<const Scene> scene);

  Frame HeadColor(const RigPose& pose, int64_t seq);                             // BGR
  Frame HeadBw(const RigPose& pose, const LaserFractions& lasers, int64_t seq);  // grey
  Frame FloorColor(const RigPose& pose, int64_t seq);                            // BGR

  // The rig as it really is, mounting errors included. No host-side program may see it.
  const geometry::SensorRig& mounted_rig() const { return mounted_rig_; }
  // X_WB of the B/W camera as it really is.
  geometry::RigidTransform StripeCameraPose(const RigPose& pose) const;

 private:
  struct Sight;  // one camera's view from one pose, and the light it sees there
  Sight& SightFrom(std::unique_ptr<Sight>* kept, const geometry::PinholeCamera& camera,
                   const geometry::RigidTransform& X_WC);

  std::shared_ptr<const Scene> scene_;
  geometry::SensorRig mounted_rig_;
  RendererOptions options_;
  uint64_t seed_;
  ImageSensor color_sensor_, stripe_sensor_, floor_sensor_;
  std::unique_ptr<Sight> color_, bw_, floor_;
};

// The calibration jig of thesis section 3.2: nothing but a flat matt board across the optical axis
// of the B/W camera, `distance_m` in front of its centre.
std::shared_ptr<const Scene> BoardScene(const geometry::RigidTransform& X_WB, double distance_m);

}  // namespace geon::sim
