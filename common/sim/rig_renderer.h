#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/sensor_rig.h"
#include "sim/camera_options.h"
#include "sim/image_sensor.h"
#include "sim/mounting.h"
#include "sim/scene.h"

namespace geon::sim {

// Where the head is: the turret in W, and the angles that the pan-tilt unit truly counts.
struct RigPose {
  geometry::RigidTransform X_WR = geometry::RigidTransform::Identity();
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
};

// Where the head was during an exposure, at equal intervals: one pose if it stood still.
struct RigPath {
  RigPath() = default;
  RigPath(const RigPose& pose) : poses{pose} {}  // NOLINT: a pose is a path
  const RigPose& middle() const { return poses[poses.size() / 2]; }
  std::vector<RigPose> poses = {RigPose()};
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
// seed: the same seed, path, exposure and `seq` give the same bytes. `exposure_1` is the exposure
// time in units of the camera's exposure_us.
//
// Light without noise is kept as long as the head stands still, so that its frames are cheap. While
// it moves, a frame is the mean over its path. From four poses on it is smeared, and what each of
// them sees is asked for less finely: by pixels half as many times as large as there are poses, at
// most four; their place differs from pose to pose, so that the mean misses nothing between.
// Deviation: such a picture is softer across the smear, too, and an edge may lie half a pixel off.
class RigRenderer {
 public:
  RigRenderer(std::shared_ptr<const Scene> scene, const geometry::SensorRig& designed,
              const RendererOptions& options, uint64_t seed);
  ~RigRenderer();
  RigRenderer(RigRenderer&&) noexcept;
  RigRenderer& operator=(RigRenderer&&) noexcept;

  void SetScene(std::shared_ptr<const Scene> scene);

  Frame HeadColor(const RigPath& path, int64_t seq, double exposure_1 = 1.0);  // BGR
  Frame HeadBw(const RigPath& path, const LaserFractions& lasers, int64_t seq,
               double exposure_1 = 1.0);                                        // grey
  Frame FloorColor(const RigPath& path, int64_t seq, double exposure_1 = 1.0);  // BGR

  // The rig as it really is. No host-side program may see it.
  const BuiltRig& built_rig() const { return built_rig_; }
  // X_WB of the B/W camera as it really is.
  geometry::RigidTransform StripeCameraPose(const RigPose& pose) const;

 private:
  struct Sight;  // what one camera sees, kept for its next frame
  // The room's light in a colour camera's picture, `seen` along the way of the camera.
  Frame ColorFrame(const BuiltCamera& camera, const CameraOptions& options,
                   const ImageSensor& sensor, std::vector<geometry::RigidTransform> X_WC,
                   double exposure_1, uint64_t noise_seed, Sight* sight) const;
  void AddLaser(size_t laser, const RigPath& path, float share_1, Sight* sight,
                std::vector<float>* signal) const;

  std::shared_ptr<const Scene> scene_;
  BuiltRig built_rig_;
  RendererOptions options_;
  uint64_t seed_;
  ImageSensor color_sensor_, stripe_sensor_, floor_sensor_;
  std::unique_ptr<Sight> color_, bw_, floor_;
};

// The calibration jig of thesis section 3.2: nothing but a flat matt board across the optical axis
// of the B/W camera, `distance_m` in front of its centre.
std::shared_ptr<const Scene> BoardScene(const geometry::RigidTransform& X_WB, double distance_m);

}  // namespace geon::sim
