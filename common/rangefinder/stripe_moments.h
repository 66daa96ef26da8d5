#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rangefinder/stripe_fit.h"

namespace geon::rangefinder {

// Writes the profiles round `runs` to `fits`, which has room for each; nothing where the light is
// no Gaussian's. Returns which runs have a clipped crest: those are left alone.
//
// Source: ours. Moments under a Gaussian window of about the stripe's own width: the product of two
// Gaussians is one, so the profile's position, width and height follow in closed form, and with
// equal widths the position is as good as that of a least-squares fit (it solves the same
// equation). Windows are moved and widened until they suit. Many profiles are measured side by
// side, in single precision, so that four go into one instruction.
std::vector<size_t> FitByMoments(const LineView& image, std::span<const Run> runs, double level_1,
                                 const Background& background,
                                 std::span<std::optional<ProfileFit>> fits);

}  // namespace geon::rangefinder
