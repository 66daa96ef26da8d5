#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "sim/mounting.h"
#include "sim/noise_source.h"
#include "sim/rig_renderer.h"
#include "sim/scene.h"

namespace geon::sim {

// What spoils a glance.
struct GlanceOptions {
  double edge_sigma_px = 0.7;  // of every edge that is told
  double floor_range_m = 3.0;
};

// What a picture of the floor camera tells of the ground in one direction, straight away from below
// the camera: floor from the picture's edge to `end_px`, where something else begins or the picture
// (or the range that is asked for) ends.
struct GroundGlance {
  Eigen::Vector2d begin_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d end_px = Eigen::Vector2d::Zero();
  bool obstacle = false;
  bool any_floor = false;  // else begin and end are the same
};

// The geon in a picture: the part that is visible, in pixels.
struct GeonGlance {
  double left_px = 0.0, right_px = 0.0, top_px = 0.0, bottom_px = 0.0;
  Eigen::Vector2d lowest_px = Eigen::Vector2d::Zero();
  int pixels = 0;  // roughly
};

// What the cameras of one individual robot would show, told by some hundred rays instead of a
// rendered picture: for experiments that are about driving. Of colours, light and exposure only the
// lamp's image in a polished floor has a part in it, which is not of the floor's colour. The same
// seed and `seq` give the same noise.
class Glancer {
 public:
  Glancer(std::shared_ptr<const Scene> scene, const BuiltRig& rig, const GlanceOptions& options,
          uint64_t seed);

  // From left to right.
  std::vector<GroundGlance> Floor(const RigPose& pose, int64_t seq);
  // Of several geons the one that fills most of the picture; nothing when none is in it.
  std::optional<GeonGlance> GeonByHead(const RigPose& pose, int64_t seq);
  std::optional<GeonGlance> GeonByFloorCamera(const RigPose& pose, int64_t seq);

  // Without any camera: how far it is to what stands at `height_m`, all round (`count` directions
  // of W, from 0 on), at most `farthest_m`.
  std::vector<double> AllRound(const Eigen::Vector2d& from_W_m, double height_m, int count,
                               double farthest_m);

 private:
  // A place of level ground as the floor camera sees it.
  struct GroundPlace {
    Eigen::Vector3f ray_F = Eigen::Vector3f::Zero();
    Eigen::Vector2d pixel_px = Eigen::Vector2d::Zero();
    bool in_picture = false;
  };
  // `share_1` of the way, by angle, from straight below the camera to the range's end.
  GroundPlace PlaceAt(int direction, double share_1) const;
  std::optional<GeonGlance> Geon(const BuiltCamera& camera, const geometry::RigidTransform& X_WC,
                                 uint64_t noise_seed);
  std::optional<GeonGlance> OneGeon(int body, const BuiltCamera& camera,
                                    const geometry::RigidTransform& X_WC, NoiseSource* noise);
  bool InGlare(const Sighting& sighting, const Eigen::Vector3f& eye_W_m) const;

  std::shared_ptr<const Scene> scene_;
  BuiltRig rig_;
  GlanceOptions options_;
  uint64_t seed_;
  int floor_body_ = -1;
  std::vector<int> geon_bodies_;
  // Of each direction, the places in the picture at equal steps, the nearest first.
  struct GroundSteps {
    int direction = 0;
    int first = 0;  // number of the first step
    std::vector<GroundPlace> places;
  };
  std::vector<GroundSteps> ground_;
  std::vector<Eigen::Vector3f> directions_;
  std::vector<Sighting> sightings_;
};

}  // namespace geon::sim
