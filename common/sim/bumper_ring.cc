#include "sim/bumper_ring.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::sim {
namespace {

constexpr double kHalfWidth_rad = kPi / BumperRing::kCount;
constexpr double kBounceMin_s = 0.001;
constexpr double kBounceMax_s = 0.005;

}  // namespace

BumperRing::BumperRing(const BumperRingOptions& options, uint64_t seed)
    : options_(options), noise_(seed) {
  Require(!options.stuck || (*options.stuck >= 0 && *options.stuck < kCount),
          "stuck bumper outside 0..19");
  Require(options.chatter_min_s <= options.chatter_max_s, "chatter_min_s above chatter_max_s");
}

void BumperRing::Advance(double time_s, const std::vector<DiscContact>& contacts,
                         double base_W_rad) {
  if (contacts.empty() && quiet_) return;
  mask_ = 0;
  quiet_ = contacts.empty();
  for (int i = 0; i < kCount; ++i) {
    Switch& state = switches_[static_cast<size_t>(i)];
    const double middle_rad = base_W_rad + options_.offset_rad + 2.0 * i * kHalfWidth_rad;
    const bool touched =
        std::any_of(contacts.begin(), contacts.end(), [&](const DiscContact& contact) {
          return contact.clearance_m <= options_.travel_m &&
                 std::abs(WrapAngle(contact.bearing_rad - middle_rad)) <=
                     kHalfWidth_rad + options_.overlap_rad;
        });
    if (touched != state.touched) {
      state.touched = touched;
      state.bounces_until_s =
          time_s + noise_.Uniform(options_.chatter_min_s, options_.chatter_max_s);
      state.next_bounce_s = time_s;
    }
    if (time_s >= state.bounces_until_s) {
      state.reads = touched;
    } else if (time_s >= state.next_bounce_s) {
      state.reads = !state.reads;
      state.next_bounce_s = time_s + noise_.Uniform(kBounceMin_s, kBounceMax_s);
    }
    if (state.reads || options_.stuck == i) mask_ |= 1u << i;
    if (touched || time_s < state.bounces_until_s) quiet_ = false;
  }
}

bool BumperRing::any_pressed() const {
  return std::any_of(switches_.begin(), switches_.end(),
                     [](const Switch& state) { return state.touched; });
}

}  // namespace geon::sim
