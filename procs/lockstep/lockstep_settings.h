#pragma once

#include <filesystem>

#include "mission/mission_options.h"
#include "procs/base/base_config.h"
#include "procs/color_camera/color_camera_config.h"
#include "procs/ptu/ptu_config.h"
#include "procs/recognizer/recognizer_config.h"
#include "procs/stripe_camera/stripe_camera_config.h"
#include "sim/glance.h"
#include "sim/sim_config.h"

namespace geon::lockstep {

// Where the mission's knowledge of the world comes from.
enum class Sensing {
  kPictures,  // rendered pictures, looked at by the programs
  kGlances,   // what pictures would show (sim/glance.h): no colours, no light, fast
  kPerfect,   // obstacles all round without an error, no sonar, no infrared
};

// Everything the daemons of one robot are configured with, and what the simulated robot is like.
struct LockstepSettings {
  geometry::SensorRig drawn_rig;  // what the simulated individual was built from
  geometry::SensorRig rig;        // what the programs work with
  ptu::PtuConfig ptu;
  base::BaseConfig base;
  color_camera::ColorCameraConfig color_camera;
  stripe_camera::StripeCameraConfig stripe_camera;
  mission::MissionOptions mission;
  recognizer::RecognizerConfig recognizer;
  sim::SimOptions sim;
  Sensing sensing = Sensing::kPictures;
  sim::GlanceOptions glances;
  double least_floor_gloss_1 = 0.0;  // of a floor that the world has duller
  // From the end of an exposure until the frame is with its daemon: read-out and transport.
  double frame_delay_s = 0.03;
};

// Reads the robot file's sections as the daemons do, and the simulator's file.
Result<LockstepSettings> LoadLockstepSettings(const std::filesystem::path& robot_file,
                                              const std::filesystem::path& sim_file);

}  // namespace geon::lockstep
