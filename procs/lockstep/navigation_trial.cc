#include "procs/lockstep/navigation_trial.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <utility>

#include "procs/lockstep/lockstep_robot.h"

namespace geon::lockstep {
namespace {

constexpr double kInPosition_m = 0.25;  // the robot may stand so much beside where it believes to

constexpr std::array<std::pair<SensorQuality, std::string_view>, 3> kQualities = {
    {{SensorQuality::kPerfect, "perfect"},
     {SensorQuality::kReal, "real"},
     {SensorQuality::kDegraded, "degraded"}}};
constexpr std::array<std::pair<NavigationEnd, std::string_view>, 4> kEnds = {
    {{NavigationEnd::kReached, "reached"},
     {NavigationEnd::kUnreachable, "unreachable"},
     {NavigationEnd::kNoneFound, "none_found"},
     {NavigationEnd::kTrapped, "trapped"}}};

template <typename Names, typename Value>
std::string_view NameOf(const Names& names, Value value) {
  return std::find_if(names.begin(), names.end(),
                      [&](const auto& each) { return each.first == value; })
      ->second;
}
template <typename Value, size_t kCount>
std::optional<Value> ValueOf(const std::array<std::pair<Value, std::string_view>, kCount>& names,
                             std::string_view name) {
  for (const auto& [value, known] : names) {
    if (known == name) return value;
  }
  return std::nullopt;
}

// To the nearest geon, from above; without any, beyond everything.
double DistanceToGeon(const sim::World& world, const sim::RobotTruth& truth) {
  const Eigen::Vector2d place_m(truth.x_m, truth.y_m);
  const sim::WorldObject* geon = sim::NearestTarget(world, place_m);
  return geon == nullptr ? std::numeric_limits<double>::infinity()
                         : (Eigen::Vector2d(geon->x_m, geon->y_m) - place_m).norm();
}

NavigationEnd EndOf(const mission::Mission& mission, bool in_position) {
  if (in_position) return NavigationEnd::kReached;
  switch (mission.outcome()) {
    case sensor::MissionOutcome::kNamed:  // from farther off than it was to stop
      return NavigationEnd::kReached;
    case sensor::MissionOutcome::kUnreachable:
      return NavigationEnd::kUnreachable;
    case sensor::MissionOutcome::kNoneFound:
      return NavigationEnd::kNoneFound;
    default:
      return NavigationEnd::kTrapped;
  }
}

}  // namespace

std::string_view ToString(SensorQuality quality) { return NameOf(kQualities, quality); }
std::optional<SensorQuality> SensorQualityFromString(std::string_view name) {
  return ValueOf(kQualities, name);
}
std::string_view ToString(NavigationEnd end) { return NameOf(kEnds, end); }
std::optional<NavigationEnd> NavigationEndFromString(std::string_view name) {
  return ValueOf(kEnds, name);
}

LockstepSettings ForNavigation(LockstepSettings settings, SensorQuality quality) {
  settings.sensing = quality == SensorQuality::kPerfect ? Sensing::kPerfect : Sensing::kGlances;
  settings.color_camera.exposure.reset();
  settings.sim.geon_mesh = {128, 32};  // nobody looks closely
  sim::NomadEmulatorOptions& base = settings.sim.base;
  if (quality == SensorQuality::kPerfect) {
    base.drive.odometry_distance_scale_1 = base.drive.odometry_turn_scale_1 = 1.0;
  }
  if (quality == SensorQuality::kDegraded) {
    constexpr double kOften_1 = 0.1;
    base.sonar.deaf_probability_1 = kOften_1;
    base.sonar.specular_probability_1 = kOften_1;
    base.sonar.crosstalk_probability_1 = 0.02;
    base.drive.odometry_distance_scale_1 = base.drive.odometry_turn_scale_1 = 1.02;
    settings.least_floor_gloss_1 = 0.05;  // a varnish met squarely
  }
  return settings;
}

Result<NavigationOutcome> RunNavigationTrial(const LockstepSettings& settings,
                                             const sim::World& world, uint64_t seed,
                                             double longest_s) {
  auto created = LockstepRobot::Create(settings, std::nullopt, world, seed);
  if (!created.ok()) return created.status();
  LockstepRobot& robot = **created;
  // A scan begun at a wrong place, by a wrong belief of where the geon stands, shows the mission
  // its error: it goes on.
  const double near_m = settings.mission.looking.stop_distance_m + kInPosition_m;
  const geometry::RigidTransform X_PenW =
      geometry::PlanarPose(world.robot_x_m, world.robot_y_m, world.robot_heading_rad);
  const auto destination_W_m = settings.mission.destination_W_m;
  const auto left_m = [&] {
    const sim::RobotTruth truth = robot.truth();
    return (geometry::OnGround(X_PenW, *destination_W_m) - Eigen::Vector2d(truth.x_m, truth.y_m))
        .norm();
  };
  const auto in_position = [&] {
    if (destination_W_m) return left_m() < kInPosition_m;
    return robot.mission().phase() == mission::Phase::kScan &&
           DistanceToGeon(world, robot.truth()) < near_m;
  };
  RunWatch watch;
  // It looks for a geon at a destination that it believes to have reached.
  const auto is_elsewhere = [&] {
    return destination_W_m && robot.mission().phase() == mission::Phase::kSearch;
  };
  while (robot.mission().outcome() == sensor::MissionOutcome::kRunning && !in_position() &&
         !is_elsewhere() && robot.time_s() < longest_s) {
    robot.Turn();
    watch.See(robot);
  }
  NavigationOutcome outcome;
  outcome.track = watch.track();
  outcome.end = EndOf(robot.mission(), in_position());
  outcome.why = robot.mission().State().text;
  outcome.end_s = robot.time_s();
  if (destination_W_m) outcome.left_m = left_m();
  if (is_elsewhere() && !in_position()) outcome.why = "at the destination, as it believes";
  return outcome;
}

}  // namespace geon::lockstep
