#include "attention/color_tests.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace geon::attention {
namespace {

constexpr int kLevels = 256;
constexpr int kMaxSum = 128;  // of coefficients: 128 * 255 is within 16 bits
constexpr int kMin = INT16_MIN;
constexpr int kMax = INT16_MAX;

using Coefficients = std::array<double, 3>;

Coefficients CoefficientsOf(const ColorHalfSpace& half_space) {
  return {half_space.red_1, half_space.green_1, half_space.blue_1};
}

int16_t Limit(double value) {
  return static_cast<int16_t>(std::clamp(value, static_cast<double>(kMin), double{kMax}));
}

Rgb Colored(int channel, int level, int other_channel, int other_level) {
  std::array<uint8_t, 3> levels = {0, 0, 0};
  levels[static_cast<size_t>(channel)] = static_cast<uint8_t>(level);
  levels[static_cast<size_t>(other_channel)] = static_cast<uint8_t>(other_level);
  return {levels[0], levels[1], levels[2]};
}

// A half-space of one channel is an interval of it.
void Narrow(const ColorHalfSpace& half_space, int channel, RegionTest* region) {
  int low = kLevels;
  int high = -1;
  for (int level = 0; level < kLevels; ++level) {
    if (!half_space.Contains(Colored(channel, level, channel, level))) continue;
    low = std::min(low, level);
    high = level;
  }
  if (high < 0) {  // empty: no level is at least 255 and at most 0
    low = 255;
    high = 0;
  }
  region->low[channel] = std::max(region->low[channel], static_cast<uint8_t>(low));
  region->high[channel] = std::min(region->high[channel], static_cast<uint8_t>(high));
  region->bounded = region->bounded || low > 0 || high < 255;
}

// The edge of a half-space of two channels: for every level of the one, the levels of the other
// next to the edge on either side.
struct Edge {
  int channel = 0;
  int other_channel = 0;
  std::vector<std::pair<int, int>> inside;  // levels of the channels
  std::vector<std::pair<int, int>> outside;
};

Edge EdgeOf(const ColorHalfSpace& half_space, int channel, int other_channel) {
  Edge edge{channel, other_channel, {}, {}};
  for (int level = 0; level < kLevels; ++level) {
    bool last_is_inside = false;
    for (int other = 0; other < kLevels; ++other) {
      const bool is_inside = half_space.Contains(Colored(channel, level, other_channel, other));
      if (other > 0 && is_inside != last_is_inside) {
        (last_is_inside ? edge.inside : edge.outside).emplace_back(level, other - 1);
        (is_inside ? edge.inside : edge.outside).emplace_back(level, other);
      } else if (other == 0 || other == kLevels - 1) {
        (is_inside ? edge.inside : edge.outside).emplace_back(level, other);
      }
      last_is_inside = is_inside;
    }
  }
  return edge;
}

PlaneTest TestOfPair(const Edge& edge, int coefficient, int other_coefficient) {
  const auto value = [&](const std::pair<int, int>& levels) {
    return coefficient * levels.first + other_coefficient * levels.second;
  };
  int least_inside = kMax + 1;
  int most_outside = kMin;
  for (const auto& levels : edge.inside) least_inside = std::min(least_inside, value(levels));
  for (const auto& levels : edge.outside) most_outside = std::max(most_outside, value(levels));
  PlaneTest test;
  test.coefficients[edge.channel] = static_cast<int16_t>(coefficient);
  test.coefficients[edge.other_channel] = static_cast<int16_t>(other_coefficient);
  test.sure = Limit(most_outside);
  test.maybe = std::min(test.sure, Limit(least_inside - 1));
  return test;
}

// Of all small pairs of coefficients, the first without doubt, or the one with the least.
PlaneTest FitPair(const ColorHalfSpace& half_space, int channel, int other_channel) {
  const Coefficients exact = CoefficientsOf(half_space);
  const double one = exact[static_cast<size_t>(channel)];
  const double other = exact[static_cast<size_t>(other_channel)];
  const double larger = std::max(std::abs(one), std::abs(other));
  const Edge edge = EdgeOf(half_space, channel, other_channel);
  PlaneTest best;
  for (int size = 1; size <= kMaxSum / 2; ++size) {
    const PlaneTest test = TestOfPair(edge, static_cast<int>(std::lround(one / larger * size)),
                                      static_cast<int>(std::lround(other / larger * size)));
    if (size == 1 || test.sure - test.maybe < best.sure - best.maybe) best = test;
    if (best.sure == best.maybe) break;
  }
  return best;
}

// Three channels (or none): the rounded plane, and by how much rounding can have moved it.
PlaneTest FitRounded(const ColorHalfSpace& half_space) {
  const Coefficients exact = CoefficientsOf(half_space);
  const auto is_whole = [](double number) { return number == std::round(number); };
  const double sum = std::abs(exact[0]) + std::abs(exact[1]) + std::abs(exact[2]);
  const bool as_it_is = sum <= kMaxSum && std::all_of(exact.begin(), exact.end(), is_whole);
  const double scale = as_it_is ? 1.0 : (kMaxSum - 3 * 0.5) / sum;  // rounding may add a half each
  PlaneTest test;
  if (scale < 1e-100 || scale > 1e100) {  // beyond sense: always in doubt
    test.sure = kMax;
    test.maybe = kMin;
    return test;
  }
  // The rule's own sums are off by much less than this, and not at all with whole numbers.
  double least_error = as_it_is ? 0.0 : -1e-6;
  double most_error = -least_error;
  for (size_t channel = 0; channel < 3; ++channel) {
    const double coefficient = std::round(exact[channel] * scale);
    const double error = 255.0 * (exact[channel] * scale - coefficient);
    (error < 0.0 ? least_error : most_error) += error;
    test.coefficients[channel] = static_cast<int16_t>(coefficient);
  }
  const double threshold = half_space.threshold_1 * scale;
  test.sure = Limit(std::floor(threshold - least_error));
  test.maybe = Limit(std::floor(threshold - most_error));
  return test;
}

// How many colours of a coarse grid a half-space leaves out.
int LeftOut(const ColorHalfSpace& half_space) {
  constexpr int kStep = 36;
  int count = 0;
  for (int red = 0; red < kLevels; red += kStep) {
    for (int green = 0; green < kLevels; green += kStep) {
      for (int blue = 0; blue < kLevels; blue += kStep) {
        const Rgb color{static_cast<uint8_t>(red), static_cast<uint8_t>(green),
                        static_cast<uint8_t>(blue)};
        count += half_space.Contains(color) ? 0 : 1;
      }
    }
  }
  return count;
}

}  // namespace

RegionTest TestOf(const HalfSpaceColor& region) {
  std::vector<ColorHalfSpace> half_spaces = region.half_spaces;
  std::stable_sort(half_spaces.begin(), half_spaces.end(), [](const auto& one, const auto& other) {
    return LeftOut(one) > LeftOut(other);
  });
  RegionTest test;
  for (const ColorHalfSpace& half_space : half_spaces) {
    const Coefficients exact = CoefficientsOf(half_space);
    std::vector<int> channels;
    for (int channel = 0; channel < 3; ++channel) {
      if (exact[static_cast<size_t>(channel)] != 0.0) channels.push_back(channel);
    }
    if (channels.size() == 1) {
      Narrow(half_space, channels[0], &test);
      continue;
    }
    test.planes.push_back(channels.size() == 2 ? FitPair(half_space, channels[0], channels[1])
                                               : FitRounded(half_space));
    test.doubtful = test.doubtful || test.planes.back().sure != test.planes.back().maybe;
  }
  return test;
}

}  // namespace geon::attention
