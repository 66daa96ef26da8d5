#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "procs/lockstep/lockstep_settings.h"
#include "procs/lockstep/run_watch.h"
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
  kReached,  // the robot stands where it is to look at the geon, or named it from elsewhere; with
             // a destination: it is there
  kUnreachable,  // the mission says that no way leads there
  kNoneFound,    // the mission says that there is none where it can look
  kTrapped,      // anything else: out of time, or another reason to give up
};
std::string_view ToString(NavigationEnd end);
std::optional<NavigationEnd> NavigationEndFromString(std::string_view name);

struct NavigationOutcome {
  NavigationEnd end = NavigationEnd::kTrapped;
  std::string why;  // in the mission's words
  double end_s = 0.0;
  std::optional<double> left_m;  // with a destination: how far from it the robot ended
  RunTrack track;
};

// One mission up to the place from which the geon would be scanned, up to its destination where
// MissionOptions has one (within 25 cm of the true place), or to its end: the mission and the
// base's bytes as everywhere, pictures by glances. Errors: a mesh that cannot be used.
Result<NavigationOutcome> RunNavigationTrial(const LockstepSettings& settings,
                                             const sim::World& world, uint64_t seed,
                                             double longest_s);

}  // namespace geon::lockstep
