#include "procs/lockstep/bench_trial.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "active_vision/laid_fraction.h"
#include "base/angles.h"
#include "evaluation/trial_random.h"
#include "procs/lockstep/lockstep_robot.h"
#include "sim/world_scene.h"

namespace geon::lockstep {
namespace {

constexpr double kDesk_m = 0.7;
constexpr double kDeskSide_m = 0.6;
constexpr double kLongest_s = 120.0;
const Eigen::Vector3d kRedPaint_rgb(150, 40, 40);
const Eigen::Vector3d kDeskPaint_rgb(90, 90, 120);

struct Bench {
  sim::World world;
  double distance_m = 0.0;  // from the robot's axis to the object's middle, along the ground
};

// The head tilts until the camera looks at the object's middle; its centre then moves a little.
double GroundDistance(const geometry::SensorRig& rig, double range_m, double middle_m) {
  double distance_m = range_m;
  for (int round = 0; round < 10; ++round) {
    const double look_rad = std::atan2(rig.X_RP.translation().z() - middle_m, distance_m);
    const Eigen::Vector3d axis_R = rig.X_RP.linear().col(0);
    const double pitch_rad = std::atan2(-axis_R.z(), axis_R.x());
    const Eigen::Vector3d p_RB_m = rig.StripeCameraPose(0.0, pitch_rad - look_rad).translation();
    const double drop_m = p_RB_m.z() - middle_m;
    distance_m = p_RB_m.x() + std::sqrt(std::max(0.01, range_m * range_m - drop_m * drop_m));
  }
  return distance_m;
}

Result<Bench> SetUp(const geometry::SensorRig& rig, const BenchTrial& trial) {
  std::mt19937_64 random = evaluation::TrialRandom(trial.seed, 0);
  const double heading_rad = RadiansFromDegrees(90.0 + evaluation::Uniform(random, -3.0, 3.0));
  const double aside_m = evaluation::Uniform(random, -0.03, 0.03);
  Bench bench;
  sim::World& world = bench.world;
  world.robot_x_m = 1.5;
  world.robot_y_m = 0.8;
  world.robot_heading_rad = heading_rad;
  sim::WorldObject object;
  std::visit([&](const auto& shape) { object.shape = shape; }, trial.shape);
  object.z_m = 0.0;
  object.yaw_rad = trial.yaw_rad;
  object.color_rgb = kRedPaint_rgb;
  const auto mesh = sim::ObjectMesh(world, object);
  if (!mesh.ok()) return mesh.status();
  double top_m = 0.0;
  for (const Eigen::Vector3d& vertex : mesh->vertices_m) top_m = std::max(top_m, vertex.z());
  object.z_m = kDesk_m;
  bench.distance_m = GroundDistance(rig, trial.range_m, kDesk_m + 0.5 * top_m);
  object.x_m = world.robot_x_m + aside_m;
  object.y_m = world.robot_y_m + bench.distance_m;
  sim::WorldObject desk;
  desk.shape = sim::BoxShape{{kDeskSide_m, kDeskSide_m, kDesk_m}};
  desk.x_m = object.x_m;
  desk.y_m = object.y_m + 0.05;  // the object stands a little before the middle
  desk.color_rgb = kDeskPaint_rgb;
  world.objects = {desk, object};
  return bench;
}

std::vector<double> Misplaced(const geometry::SensorRig& rig, const sensor::ScanSet& scan) {
  std::vector<double> misplaced_1;
  if (!scan.target_box) return misplaced_1;
  const auto X_LB = geometry::MakeTransform(scan.rotation_LB, scan.camera_position_L_m);
  const geometry::RigidTransform X_CL = rig.X_TC.inverse() * rig.X_TB * X_LB.inverse();
  for (const sensor::RangeProfile& profile : scan.profiles) {
    const auto laid_1 =
        active_vision::LaidFraction(profile, X_CL, rig.color_camera, *scan.target_box);
    // A swept stripe was meant for the quarter that it lies nearest to.
    const double quarter_1 = std::clamp(std::round(4.0 * profile.fraction), 1.0, 3.0) / 4.0;
    if (laid_1) misplaced_1.push_back(*laid_1 - quarter_1);
  }
  return misplaced_1;
}

}  // namespace

Result<BenchOutcome> RunBenchTrial(const LockstepSettings& settings,
                                   const std::optional<recognizer::StripeCalibration>& calibration,
                                   const BenchTrial& trial) {
  Result<Bench> bench = SetUp(settings.rig, trial);
  if (!bench.ok()) return bench.status();
  LockstepSettings own = settings;
  own.mission.looking.stop_distance_m = std::clamp(bench->distance_m, 0.7, 2.0);  // there already
  auto created = LockstepRobot::Create(own, calibration, bench->world, trial.seed);
  if (!created.ok()) return created.status();
  LockstepRobot& robot = **created;

  BenchOutcome outcome;
  while (robot.mission().outcome() == sensor::MissionOutcome::kRunning &&
         robot.time_s() < kLongest_s) {
    robot.Turn();
    const mission::Phase phase = robot.mission().phase();
    if (phase != mission::Phase::kWait && phase != mission::Phase::kSearch && !outcome.seen_s) {
      outcome.seen_s = robot.time_s();
    }
    if (phase == mission::Phase::kScan && !outcome.whole_s) outcome.whole_s = robot.time_s();
  }
  outcome.end = robot.mission().State().text;
  outcome.end_s = robot.time_s();
  outcome.verdict = robot.mission().verdict();
  outcome.scan = robot.scan();
  outcome.misplaced_1 = Misplaced(settings.rig, outcome.scan);
  if (robot.decision()) {
    outcome.view = robot.decision()->sighting.image;
    outcome.mask = robot.decision()->sighting.seen.mask;
  }
  return outcome;
}

}  // namespace geon::lockstep
