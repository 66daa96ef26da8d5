#pragma once

#include <cstdint>

#include "base/angles.h"
#include "sim/sim_config.h"
#include "sim/world.h"

namespace geon::sim {

// How bad it gets. Worn tyres and a floor that gives: what encoders count is off by so much,
// distance and turning each (the drift that navigation is to bear).
inline constexpr double kOdometryDrift_1 = 0.02;
// One wheel in a groove between raised floor tiles, "a small angle" (thesis section 6.3): a groove
// 5 mm deep tilts a circle of wheels of 0.19 m by 1 degree, one of 10 mm by 2.
inline constexpr double kMostTilt_rad = RadiansFromDegrees(2.0);
// Lamps that offices have, from warm white to daylight tubes; between old and dusty, and new.
inline constexpr double kWarmest_kelvin = 3000.0, kColdest_kelvin = 6500.0;
inline constexpr double kDimmest_1 = 0.7, kBrightest_1 = 1.3;
// Sun through blinds or an open window, in units of the lamp's; 3 is that of the colour experiment.
inline constexpr double kSunnyRuns_1 = 1.0 / 3.0;
inline constexpr double kFaintestSun_1 = 0.5, kStrongestSun_1 = 3.0;
inline constexpr double kLowestSun_rad = RadiansFromDegrees(20.0);
inline constexpr double kHighestSun_rad = RadiansFromDegrees(60.0);
// A worn polish, and a fresh one: varnish (refractive index 1.5) mirrors 4 % of what meets it
// squarely and 5 % at 45 degrees.
inline constexpr double kGlossyRuns_1 = 1.0 / 3.0;
inline constexpr double kLeastGloss_1 = 0.02, kMostGloss_1 = 0.05;
// Frames that a camera loses on a bus that is nearly full: our guess.
inline constexpr double kMostDropped_1 = 0.05;
// Another tin of the same paint: another lot, another maker, a thinner coat. Each of the three
// alone changes the thesis's red (150 40 40) by less than 3 in CIELAB, on average all by 2.5: seen
// side by side (from about 1 on), and by its name the same colour. How far tins are apart is our
// guess.
inline constexpr double kPaintHue_rad = RadiansFromDegrees(3.0);
inline constexpr double kPaintSaturation_1 = 0.05, kPaintValue_1 = 0.05;

// What real rooms and robots do to a run, drawn from the seed, each evenly within its bounds:
// odometry, tilt, light, sun, a polished floor, frames that get lost, and the paint of each target.
// It replaces what `world` and `options` say of these and leaves everything else alone; the
// lasers' reflectance of a target, where the world does not state it, follows its new colour. The
// same seed and world give the same trouble.
void AddTrouble(uint64_t seed, World* world, SimOptions* options);

}  // namespace geon::sim
