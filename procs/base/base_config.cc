#include "procs/base/base_config.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angles.h"
#include "config/bus_config.h"

namespace geon::base {
namespace {

constexpr double kTopSpeed_m_s = 0.5;
constexpr double kTopTurnRate_rad_s = RadiansFromDegrees(60.0);
constexpr double kSonarTick_s = 0.004;

void ReadLimits(config::YamlSection* section, BaseConfig* config) {
  device::NomadDriverOptions& driver = config->driver;
  section->Read("speed_limit_m_s", &driver.speed_limit_m_s);
  section->Check(driver.speed_limit_m_s > 0.0 && driver.speed_limit_m_s <= kTopSpeed_m_s,
                 "speed_limit_m_s", "must be above 0 and at most 0.5");
  section->ReadAngle("turn_rate_limit_deg_s", &driver.turn_rate_limit_rad_s);
  section->Check(driver.turn_rate_limit_rad_s > 0.0 &&
                     driver.turn_rate_limit_rad_s <= kTopTurnRate_rad_s + 1e-9,
                 "turn_rate_limit_deg_s", "must be above 0 and at most 60");
  section->Read("acceleration_m_s2", &driver.acceleration_m_s2);
  section->Check(driver.acceleration_m_s2 >= 0.05 && driver.acceleration_m_s2 <= 5.0,
                 "acceleration_m_s2", "must be 0.05 ... 5");
  section->ReadAngle("turn_acceleration_deg_s2", &driver.turn_acceleration_rad_s2);
  section->Check(driver.turn_acceleration_rad_s2 >= 0.05 && driver.turn_acceleration_rad_s2 <= 20.0,
                 "turn_acceleration_deg_s2", "must be 3 ... 1100");
  config->guard.speed_limit_m_s = driver.speed_limit_m_s;
  config->guard.turn_rate_limit_rad_s = driver.turn_rate_limit_rad_s;
}

void ReadSonar(config::YamlSection* section, device::NomadDriverOptions* driver) {
  double interval_s = kSonarTick_s * driver->sonar_rate;
  section->Read("sonar_interval_s", &interval_s);
  section->Check(interval_s >= kSonarTick_s && interval_s <= 255 * kSonarTick_s, "sonar_interval_s",
                 "must be 0.004 ... 1.02");
  driver->sonar_rate =
      static_cast<int>(std::lround(std::clamp(interval_s / kSonarTick_s, 1.0, 255.0)));
  std::array<double, sensor::kSonarCount> numbers{};
  std::copy(driver->sonar_order.begin(), driver->sonar_order.end(), numbers.begin());
  section->ReadNumbers("sonar_order", sensor::kSonarCount, numbers.data());
  std::array<bool, sensor::kSonarCount> seen{};
  for (size_t i = 0; i < numbers.size(); ++i) {
    const double number = numbers[i];
    if (number < 0.0 || number >= sensor::kSonarCount || number != std::floor(number)) continue;
    driver->sonar_order[i] = static_cast<int>(number);
    seen[static_cast<size_t>(number)] = true;
  }
  section->Check(std::all_of(seen.begin(), seen.end(), [](bool fires) { return fires; }),
                 "sonar_order", "must name each of the sonars 0 ... 15 once");
}

}  // namespace

void ReadBaseSection(config::YamlSection section, BaseConfig* config) {
  section.Read("port", &config->link.path);
  section.Check(!config->link.path.empty(), "port", "must name a serial device");
  section.Read("baud", &config->link.baud);
  section.Check(config->link.baud >= 9600 && config->link.baud <= 230400, "baud",
                "must be 9600 ... 230400; the robot's own is 38400");
  ReadLimits(&section, config);
  section.Read("dead_man_s", &config->driver.dead_man_s);
  section.Check(config->driver.dead_man_s >= 1 && config->driver.dead_man_s <= 5, "dead_man_s",
                "must be 1 ... 5 whole seconds");
  ReadSonar(&section, &config->driver);
  section.ReadAngle("bumper_zero_deg", &config->bumper_zero_rad);
}

Result<BaseConfig> LoadBaseConfig(const config::DaemonArguments& arguments,
                                  const std::string& port) {
  Result<config::YamlDocument> document =
      config::LoadRobotFile(arguments.config_file, {"base", "bus"});
  if (!document.ok()) return document.status();
  BaseConfig config;
  ReadBaseSection(document->root().Child("base"), &config);
  config.bus_url = config::ReadBusUrl(arguments, document->root().Child("bus"));
  const Status status = document->Finish();
  if (!status.ok()) return status;
  if (!port.empty()) config.link.path = port;
  return config;
}

}  // namespace geon::base
