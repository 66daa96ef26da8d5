#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
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
  bool bright = false;     // what begins there: much brighter than the floor, without a colour
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
  // A place of level ground, as far from below the floor camera, in its frame.
  struct GroundPlace {
    double distance_m = 0.0;
    Eigen::Vector3d p_F_m = Eigen::Vector3d::Zero();
  };
  // A direction from below the camera, and the places in the picture at equal steps of the angle,
  // the nearest first.
  struct GroundDirection {
    Eigen::Vector2d azimuth_R;
    int first_step = 0;
    std::vector<GroundPlace> places;
    Eigen::Vector2d begin_px, end_px;  // of the first and the last
  };
  // How far there is floor for sure in one of the directions: rays need not ask.
  struct OpenWay {
    Eigen::Vector2d from_W_m, bearing_W;
    double open_m;
  };
  struct GroundQuestion {
    size_t direction;
    GroundPlace place;
    bool floor = false, bright = false;  // the answer
  };
  // `share_1` of the way, by angle, from straight below the camera to the range's end.
  GroundPlace PlaceAt(const Eigen::Vector2d& azimuth_R, double share_1) const;
  // Nothing where it is not in the picture.
  std::optional<Eigen::Vector2d> PixelOf(const GroundPlace& place) const;
  std::vector<OpenWay> OpenWays(const geometry::RigidTransform& X_WR) const;
  void LookForFloor(const geometry::RigidTransform& X_WR, std::span<const OpenWay> ways,
                    std::span<GroundQuestion> questions);
  std::optional<GeonGlance> Geon(const BuiltCamera& camera, const geometry::RigidTransform& X_WC,
                                 uint64_t noise_seed);
  std::optional<GeonGlance> OneGeon(int body, const BuiltCamera& camera,
                                    const geometry::RigidTransform& X_WC, NoiseSource* noise);
  // Of a thing's paint: twice as bright as the floor's, and nearly white.
  bool IsBright(int body) const;
  bool InGlare(const Eigen::Vector2d& p_W_m, const Eigen::Vector3d& p_WC_m) const;

  std::shared_ptr<const Scene> scene_;
  BuiltRig rig_;
  GlanceOptions options_;
  uint64_t seed_;
  int floor_body_ = -1;
  std::vector<int> geon_bodies_;
  std::vector<GroundDirection> ground_;
  std::vector<Eigen::Vector3f> directions_;
  std::vector<Sighting> sightings_;
};

}  // namespace geon::sim
