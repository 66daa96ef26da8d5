#include "procs/lockstep/lockstep_settings.h"

#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "procs/planner/planner_config.h"

namespace geon::lockstep {

Result<LockstepSettings> LoadLockstepSettings(const std::filesystem::path& robot_file,
                                              const std::filesystem::path& sim_file) {
  Result<config::YamlDocument> document = config::LoadRobotFile(
      robot_file, {"rig", "color_camera", "ptu", "base", "stripe_camera", "planner", "recognizer"});
  if (!document.ok()) return document.status();
  config::YamlSection root = document->root();
  LockstepSettings settings;
  settings.drawn_rig = config::ReadDrawnRig(root.Child("rig"));
  const config::RobotRig rig = config::ReadRobotRig(root.Child("rig"), robot_file);
  settings.rig = rig.rig;
  ptu::ReadPtuSection(root.Child("ptu"), &settings.ptu);
  base::ReadBaseSection(root.Child("base"), &settings.base);
  color_camera::ReadColorCameraSection(root.Child("color_camera"), color_camera::Role::kHead,
                                       settings.rig, &settings.color_camera);
  stripe_camera::ReadStripeCameraSection(root.Child("stripe_camera"), settings.rig,
                                         &settings.stripe_camera);
  planner::ReadPlannerSection(root.Child("planner"), robot_file, &settings.mission);
  recognizer::ReadRecognizerSection(root.Child("recognizer"), &settings.recognizer);
  if (Status status = document->Finish(); !status.ok()) return status;
  settings.mission.destination_W_m.reset();  // where to go is the experiment's to say
  if (settings.color_camera.exposure) {
    settings.color_camera.exposure->target_color = settings.mission.seeing.target_color;
  }
  settings.recognizer.rig = rig.rig;
  settings.recognizer.rig_source = rig.source;
  settings.recognizer.rig_hash = rig.hash;
  settings.recognizer.calibration_dir =
      robot_file.parent_path() / settings.recognizer.calibration_dir;

  Result<sim::SimOptions> sim = sim::LoadSimOptions(sim_file);
  if (!sim.ok()) return sim.status();
  settings.sim = std::move(*sim);
  return settings;
}

}  // namespace geon::lockstep
