#include "sim/line_faults.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace geon::sim {
namespace {

// A bit of `byte` flipped, or the byte as it was.
uint8_t Corrupted(uint8_t byte, double probability_1, NoiseSource* noise) {
  if (probability_1 <= 0.0 || !noise->Chance(probability_1)) return byte;
  return static_cast<uint8_t>(byte ^ (1u << (noise->Bits() & 7)));
}

bool Happens(double probability_1, NoiseSource* noise) {
  return probability_1 > 0.0 && noise->Chance(probability_1);
}

Status SetFault(std::string_view name, double value, LineFaultOptions* options) {
  const std::array<std::pair<std::string_view, double*>, 4> probabilities = {
      {{"drop_1", &options->drop_1},
       {"corrupt_1", &options->corrupt_1},
       {"split_1", &options->split_1},
       {"garbage_1", &options->garbage_1}}};
  const std::array<std::pair<std::string_view, double*>, 5> times = {
      {{"delay_s", &options->delay_s},
       {"split_pause_s", &options->split_pause_s},
       {"silent_from_s", &options->silent_from_s},
       {"silent_until_s", &options->silent_until_s},
       {"reboot_at_s", &options->reboot_at_s}}};
  const auto error = [&](const std::string& rule) {
    return Status::Error("line fault '" + std::string(name) + "' " + rule);
  };
  for (const auto& [known, field] : probabilities) {
    if (known != name) continue;
    if (value < 0.0 || value > 1.0) return error("is a probability, 0 to 1");
    *field = value;
    return Status::Ok();
  }
  if (value < 0.0) return error("cannot be negative");
  for (const auto& [known, field] : times) {
    if (known != name) continue;
    *field = value;
    return Status::Ok();
  }
  if (name == "seed" || name == "garbage_bytes") {
    if (value != std::floor(value) || value > 1e6) return error("is a whole number up to 1000000");
    if (name == "seed") {
      options->seed = static_cast<uint64_t>(value);
    } else {
      options->garbage_bytes = static_cast<int>(value);
    }
    return Status::Ok();
  }
  return error(
      "is unknown; known are seed, delay_s, drop_1, corrupt_1, split_1, split_pause_s, garbage_1, "
      "garbage_bytes, silent_from_s, silent_until_s, reboot_at_s");
}

}  // namespace

Result<LineFaultOptions> ParseLineFaults(std::string_view text) {
  LineFaultOptions options;
  while (!text.empty()) {
    const size_t comma = std::min(text.find(','), text.size());
    const std::string_view word = text.substr(0, comma);
    text.remove_prefix(std::min(comma + 1, text.size()));
    const size_t equals = word.find('=');
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const bool has_value = equals != std::string_view::npos;
    const auto read = std::from_chars(word.data() + (has_value ? equals + 1 : word.size()), end,
                                      value, std::chars_format::fixed);
    if (!has_value || read.ec != std::errc() || read.ptr != end) {
      return Status::Error("line fault '" + std::string(word) + "' is not name=number");
    }
    const Status status = SetFault(word.substr(0, equals), value, &options);
    if (!status.ok()) return status;
  }
  if (options.silent_until_s < options.silent_from_s) {
    return Status::Error("line fault 'silent_until_s' lies before 'silent_from_s'");
  }
  return options;
}

LineFaults::LineFaults(const LineFaultOptions& options) : options_(options), noise_(options.seed) {}

std::vector<uint8_t> LineFaults::ToDevice(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> heard;
  for (const uint8_t byte : bytes) {
    if (Happens(options_.drop_1, &noise_)) continue;
    heard.push_back(Corrupted(byte, options_.corrupt_1, &noise_));
  }
  return heard;
}

std::vector<uint8_t> LineFaults::ToHost(std::span<const uint8_t> bytes, double time_s) {
  const bool silent = time_s >= options_.silent_from_s && time_s < options_.silent_until_s;
  if (!bytes.empty() && !silent) {
    double arrival_s = std::max(time_s + options_.delay_s, last_arrival_s_);
    if (Happens(options_.garbage_1, &noise_)) {
      for (int i = 0; i < options_.garbage_bytes; ++i) {
        Queue(static_cast<uint8_t>(noise_.Bits() & 0xff), arrival_s);
      }
    }
    for (const uint8_t byte : bytes) {
      if (Happens(options_.drop_1, &noise_)) continue;
      Queue(Corrupted(byte, options_.corrupt_1, &noise_), arrival_s);
      if (Happens(options_.split_1, &noise_)) arrival_s += options_.split_pause_s;
    }
    last_arrival_s_ = arrival_s;
  }
  std::vector<uint8_t> arrived;
  while (!queue_.empty() && queue_.front().time_s <= time_s) {
    arrived.push_back(queue_.front().byte);
    queue_.pop_front();
  }
  return arrived;
}

void LineFaults::Queue(uint8_t byte, double time_s) { queue_.push_back({byte, time_s}); }

bool LineFaults::TakeReboot(double time_s) {
  if (rebooted_ || time_s < options_.reboot_at_s) return false;
  rebooted_ = true;
  return true;
}

}  // namespace geon::sim
