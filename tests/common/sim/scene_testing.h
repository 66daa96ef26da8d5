#pragma once

#include <memory>
#include <string>

#include "base/angles.h"
#include "geometry/sensor_rig.h"
#include "gtest/gtest.h"
#include "sim/camera_options.h"
#include "sim/view.h"
#include "sim/world_file.h"
#include "sim/world_scene.h"

namespace geon::sim {

inline World WorldFrom(const std::string& objects,
                       const std::string& light = "{kelvin: 4000, level: 1.0}") {
  const Result<World> world = ParseWorld(
      "pen: {size_m: [3.0, 4.5], wall_height_m: 0.65}\n"
      "floor: {color_rgb: [150, 150, 140], tile_m: 0.6, groove_tilt_deg: 0.0}\n"
      "robot: {x_m: 1.5, y_m: 0.6, heading_deg: 90}\n"
      "light: " +
          light + "\n" + (objects.empty() ? "" : "objects:\n" + objects),
      "test.yaml", ".");
  EXPECT_TRUE(world.ok()) << world.message();
  return world.ok() ? *world : World();
}

inline std::shared_ptr<const Scene> SceneFrom(const std::string& objects) {
  return *BuildScene(WorldFrom(objects));
}

// Looks straight down from 2 m above a point of the floor.
inline View LookDown(const Scene& scene, double x_m, double y_m) {
  const geometry::PinholeCamera camera{64, 48, 80.0, 80.0, 31.5, 23.5};
  Eigen::Matrix3d R_WC;
  R_WC << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  View view;
  LookThrough(scene, camera, geometry::MakeTransform(R_WC, {x_m, y_m, 2.0}), &view);
  return view;
}

// A head like that of the robot file, written down again: cameras ahead, lasers above and beside.
inline geometry::SensorRig TestRig() {
  geometry::SensorRig rig;
  rig.X_RP = geometry::MakeTransform(geometry::RotationAboutY(RadiansFromDegrees(15)), {0, 0, 1.2});
  rig.X_TC = geometry::MakeTransform(geometry::CameraAxesInBody(), {0.05, 0, 0.110});
  rig.X_TB = geometry::MakeTransform(geometry::CameraAxesInBody(), {0.05, 0, 0.045});
  rig.X_RF = geometry::MakeTransform(
      geometry::RotationAboutY(RadiansFromDegrees(40)) * geometry::CameraAxesInBody(),
      {0.15, 0, 0.85});
  const double angle_rad = std::atan2(0.125, 1.037);
  rig.horizontal_laser = {{0.05, 0, 0.170}, {std::sin(angle_rad), 0, std::cos(angle_rad)}};
  rig.vertical_laser = {{0.05, 0.125, 0.045}, {std::sin(angle_rad), std::cos(angle_rad), 0}};
  return rig;
}

inline RendererOptions WithoutMountingErrors() {
  RendererOptions options;
  options.mounting = NoMountingErrors();
  return options;
}

}  // namespace geon::sim
