#include "procs/planner/planner_config.h"

#include <array>
#include <filesystem>
#include <sstream>

#include "base/angles.h"
#include "config/bus_config.h"
#include "config/rig_config.h"
#include "procs/color_camera/target_color.h"

namespace geon::planner {

namespace {

void ReadColor(config::YamlSection section, const std::filesystem::path& robot_file,
               mission::SeeingOptions* seeing) {
  color_camera::ReadTargetColor(section, robot_file, &seeing->target_color);
  section.ReadOptional("min_target_pixels", &seeing->head.min_target_pixels);
  section.ReadOptional("min_target_pixels_floor_camera", &seeing->floor.min_target_pixels);
}

void ReadFloor(config::YamlSection section, mission::SeeingOptions* seeing) {
  std::array<double, 3> color_rgb = {150.0, 150.0, 140.0};
  section.ReadNumbers("color_rgb", 3, color_rgb.data());
  const bool in_range = color_rgb[0] > 0 && color_rgb[1] > 0 && color_rgb[2] > 0 &&
                        color_rgb[0] <= 255 && color_rgb[1] <= 255 && color_rgb[2] <= 255;
  section.Check(in_range, "color_rgb", "must be within 1..255");
  navigation::FloorModel& model = seeing->floor_model;
  if (in_range) model = navigation::FloorModel::OfColor(color_rgb);
  section.Read("learn", &seeing->learn_floor);
  section.ReadOptional("share_tolerance_1", &model.share_tolerance_1);
  section.ReadOptional("darkest_1", &model.darkest_1);
  section.ReadOptional("brightest_1", &model.brightest_1);
  section.ReadOptional("max_range_m", &seeing->floor_obstacles.max_range_m);
}

void ReadDriving(config::YamlSection section, mission::DrivingOptions* driving) {
  std::string planner = "map";
  section.ReadOptional("planner", &planner);
  const auto kind = mission::PlannerKindFromString(planner);
  section.Check(kind.has_value(), "planner", "must be thesis or map");
  driving->planner = kind.value_or(driving->planner);
  section.Read("max_speed_m_s", &driving->velocity.max_speed_m_s);
  section.ReadAngle("max_turn_rate_deg_s", &driving->velocity.max_turn_rate_rad_s);
  section.Read("acceleration_m_s2", &driving->velocity.acceleration_m_s2);
  section.Read("clearance_m", &driving->safe_polygon.clearance_m);
  section.Read("default_box_m", &driving->safe_polygon.default_box_m);
  section.Read("wander_s", &driving->wander_s);
  section.Read("back_off_m", &driving->back_off_m);
}

void ReadArea(config::YamlSection section, active_vision::SearchOptions* area) {
  std::array<double, 2> pan_deg{};
  std::array<double, 2> tilt_deg{};
  section.ReadNumbers("pan_deg", 2, pan_deg.data());
  section.ReadNumbers("tilt_deg", 2, tilt_deg.data());
  section.Check(pan_deg[0] < pan_deg[1], "pan_deg", "must be [right, left], right below left");
  section.Check(tilt_deg[0] < tilt_deg[1], "tilt_deg", "must be [down, up], down below up");
  area->pan_min_rad = RadiansFromDegrees(pan_deg[0]);
  area->pan_max_rad = RadiansFromDegrees(pan_deg[1]);
  area->tilt_min_rad = RadiansFromDegrees(tilt_deg[0]);
  area->tilt_max_rad = RadiansFromDegrees(tilt_deg[1]);
}

void ReadLooking(config::YamlSection section, mission::LookingOptions* looking) {
  section.Read("support_heights_m", &looking->support_heights_m);
  section.Read("stop_distance_m", &looking->stop_distance_m);
  std::array<double, 2> range_m = {looking->min_range_m, looking->max_range_m};
  section.ReadNumbers("range_m", 2, range_m.data());
  looking->min_range_m = range_m[0];
  looking->max_range_m = range_m[1];
  ReadArea(section.Child("sweep"), &looking->sweep);
  ReadArea(section.Child("near_sweep"), &looking->near);
  std::string scan = "stop";
  section.ReadOptional("scan", &scan);
  const auto mode = mission::ScanModeFromString(scan);
  section.Check(mode.has_value(), "scan", "must be stop or sweep");
  looking->scan = mode.value_or(looking->scan);
  section.ReadOptional("sweep_s", &looking->sweep_s);
}

void ReadPatience(config::YamlSection section, mission::PatienceOptions* patience) {
  section.Read("mission_s", &patience->mission_s);
  section.Read("device_s", &patience->device_s);
  section.Read("stripe_s", &patience->stripe_s);
  section.Read("verdict_s", &patience->verdict_s);
  section.Read("stripe_attempts", &patience->stripe_attempts);
  section.Read("min_stripes", &patience->min_stripes);
  section.Read("scans", &patience->scans);
  section.ReadOptional("views", &patience->views);
  section.Read("back_offs", &patience->back_offs);
  section.Read("traps", &patience->traps);
  section.Read("bumps", &patience->bumps);
}

}  // namespace

void ReadPlannerSection(config::YamlSection section, const std::filesystem::path& robot_file,
                        mission::MissionOptions* options) {
  ReadColor(section, robot_file, &options->seeing);
  ReadFloor(section.Child("floor"), &options->seeing);
  ReadDriving(section.Child("driving"), &options->driving);
  ReadLooking(section.Child("looking"), &options->looking);
  ReadPatience(section.Child("patience"), &options->patience);
  if (section.Has("destination_m")) {
    Eigen::Vector2d destination_m = Eigen::Vector2d::Zero();
    section.ReadNumbers("destination_m", 2, destination_m.data());
    options->destination_W_m = destination_m;
  }
  section.ReadOptional("inventory", &options->inventory);
  int seed = 1;
  section.Read("seed", &seed);
  section.Check(seed >= 0, "seed", "must not be negative");
  options->seed = static_cast<uint32_t>(seed);
  std::string rule;
  if (!options->IsValid(&rule)) section.Fail(rule);
}

namespace {

Status SendTo(const std::string& place, mission::MissionOptions* options) {
  const auto wrong = [&](const std::string& rule) {
    return Status::Error("--to " + place + ": " + rule);
  };
  std::istringstream text(place);
  Eigen::Vector2d place_m;
  char comma = 0;
  if (!(text >> place_m.x() >> comma >> place_m.y()) || comma != ',' || text.peek() != EOF) {
    return wrong("must be two numbers with a comma between them, X,Y in metres");
  }
  options->destination_W_m = place_m;
  std::string rule;
  return options->IsValid(&rule) ? Status::Ok() : wrong(rule);
}

}  // namespace

Result<PlannerConfig> LoadPlannerConfig(const config::DaemonArguments& arguments,
                                        const std::string& to) {
  Result<config::YamlDocument> document =
      config::LoadRobotFile(arguments.config_file, {"planner", "rig", "bus"});
  if (!document.ok()) return document.status();
  PlannerConfig config;
  config.bus_url = config::ReadBusUrl(arguments, document->root().Child("bus"));
  const config::RobotRig rig =
      config::ReadRobotRig(document->root().Child("rig"), arguments.config_file);
  config.rig = rig.rig;
  config.rig_source = rig.source;
  ReadPlannerSection(document->root().Child("planner"), arguments.config_file, &config.mission);
  if (Status status = document->Finish(); !status.ok()) return status;
  if (to.empty()) return config;
  if (Status status = SendTo(to, &config.mission); !status.ok()) return status;
  return config;
}

}  // namespace geon::planner
