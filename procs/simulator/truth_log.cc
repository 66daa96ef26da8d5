#include "procs/simulator/truth_log.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "base/time.h"

namespace geon::simulator {
namespace {

constexpr double kStateInterval_s = 0.05;

nlohmann::json Line(const char* event, int64_t epoch_utime, double time_s) {
  return {{"event", event},
          {"utime", epoch_utime + MicrosecondsFromSeconds(time_s)},
          {"time_s", std::round(time_s * 1e6) * 1e-6}};
}

const char* KindOf(const sim::WorldObject& object) {
  constexpr std::array kKinds = {"geon", "mesh", "box", "cylinder"};
  return kKinds[object.shape.index()];
}

}  // namespace

Result<std::unique_ptr<TruthLog>> TruthLog::Open(const std::filesystem::path& file,
                                                 const sim::World& world, uint64_t seed,
                                                 int64_t epoch_utime) {
  std::ofstream stream(file);
  if (!stream) return Status::Error(file.string() + ": cannot be written");
  auto log = std::unique_ptr<TruthLog>(new TruthLog(std::move(stream), epoch_utime));
  log->WriteStart(world, seed);
  return log;
}

TruthLog::TruthLog(std::ofstream stream, int64_t epoch_utime)
    : stream_(std::move(stream)), epoch_utime_(epoch_utime) {}

TruthLog::~TruthLog() { stream_ << Line("stop", epoch_utime_, last_.time_s).dump() << '\n'; }

void TruthLog::WriteStart(const sim::World& world, uint64_t seed) {
  nlohmann::json line = Line("start", epoch_utime_, 0.0);
  line["format"] = "geon.truth.v1";
  line["seed"] = seed;
  line["robot"] = {
      {"x_m", world.robot_x_m}, {"y_m", world.robot_y_m}, {"heading_rad", world.robot_heading_rad}};
  line["objects"] = nlohmann::json::array();
  for (const sim::WorldObject& object : world.objects) {
    const std::optional<GeonLabel> label = sim::TrueLabel(object);
    line["objects"].push_back(
        {{"kind", KindOf(object)},
         {"label", label ? nlohmann::json(std::string(ToString(*label))) : nlohmann::json(nullptr)},
         {"x_m", object.x_m},
         {"y_m", object.y_m},
         {"z_m", sim::FootHeight(world, object)},
         {"yaw_rad", object.yaw_rad}});
  }
  stream_ << line.dump() << std::endl;
}

void TruthLog::Observe(const sim::RobotTruth& truth) {
  const auto write_laser = [&](const char* name, bool burns) {
    nlohmann::json line = Line("laser", epoch_utime_, truth.time_s);
    line["laser"] = name;
    line["on"] = burns;
    stream_ << line.dump() << '\n';
  };
  if (truth.horizontal_laser != last_.horizontal_laser)
    write_laser("horizontal", truth.horizontal_laser);
  if (truth.vertical_laser != last_.vertical_laser) write_laser("vertical", truth.vertical_laser);
  if (truth.contacts != last_.contacts || truth.bumper != last_.bumper) {
    nlohmann::json line = Line("contact", epoch_utime_, truth.time_s);
    line["contacts"] = truth.contacts;
    line["bumper"] = truth.bumper;
    line["speed_m_s"] = last_.speed_m_s;  // before the contact took it away
    stream_ << line.dump() << std::endl;
  }
  if (truth.time_s >= next_state_s_) {
    WriteState(truth);
    next_state_s_ = truth.time_s + kStateInterval_s;
  }
  last_ = truth;
}

void TruthLog::WriteState(const sim::RobotTruth& truth) {
  nlohmann::json line = Line("state", epoch_utime_, truth.time_s);
  line["x_m"] = truth.x_m;
  line["y_m"] = truth.y_m;
  line["heading_rad"] = truth.heading_rad;
  line["turret_rad"] = truth.turret_rad;
  line["speed_m_s"] = truth.speed_m_s;
  line["turn_rate_rad_s"] = truth.turn_rate_rad_s;
  line["pan_rad"] = truth.pan_rad;
  line["tilt_rad"] = truth.tilt_rad;
  line["horizontal_laser"] = truth.horizontal_laser;
  line["vertical_laser"] = truth.vertical_laser;
  line["contacts"] = truth.contacts;
  stream_ << line.dump() << std::endl;  // whole lines only, also after a crash
}

}  // namespace geon::simulator
