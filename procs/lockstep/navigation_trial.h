#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "procs/lockstep/lockstep_settings.h"
#include "sim/world.h"

namespace geon::lockstep {

// How well robot and sensors work in an experiment with driving.
enum class SensorQuality {
  kPerfect,   // obstacles all round known without an error; exact odometry
  kReal,      // as the simulator's file has it
  kDegraded,  // sonars deaf or fooled one time in ten each, crosstalk, 2 % of drift, a glaring
              // floor
};
std::string_view ToString(SensorQuality quality);
std::optional<SensorQuality> SensorQualityFromString(std::string_view name);

// The settings for a run without rendered pictures.
LockstepSettings ForNavigation(LockstepSettings settings, SensorQuality quality);

enum class NavigationEnd {
  kReached,      // the robot stands where it is to look at the geon, or named it from elsewhere
  kUnreachable,  // the mission says that no way leads there
  kNoneFound,    // the mission says that there is none where it can look
  kTrapped,      // anything else: out of time, or another reason to give up
};
std::string_view ToString(NavigationEnd end);
std::optional<NavigationEnd> NavigationEndFromString(std::string_view name);

struct NavigationOutcome {
  NavigationEnd end = NavigationEnd::kTrapped;
  std::string why;                      // in the mission's words
  std::optional<double> first_sight_s;  // of the geon by the head's camera or the floor's
  double end_s = 0.0;
  int contacts = 0;  // times the body came to touch something
  double hardest_contact_m_s = 0.0;
  double path_m = 0.0;                    // driven, first sight or not
  std::vector<Eigen::Vector2d> path_W_m;  // of the pen, a place every 0.2 s
};

// One mission up to the place from which the geon would be scanned, or to its end: the mission and
// the base's bytes as everywhere, pictures by glances. Errors: a mesh that cannot be used.
Result<NavigationOutcome> RunNavigationTrial(const LockstepSettings& settings,
                                             const sim::World& world, uint64_t seed,
                                             double longest_s);

}  // namespace geon::lockstep
