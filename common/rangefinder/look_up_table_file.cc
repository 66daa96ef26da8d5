// The file format geon.lut.v1. Header lines "key value", in this order, each ended by \n:
//
//   geon.lut.v1
//   laser horizontal|vertical
//   date YYYY-MM-DD
//   width_px, height_px, frames, distances       whole numbers
//   first_distance_m, step_m                     metres
//   position_offset_px, position_step_px         pixels
//   fnv1a <16 hex digits>                        of the data
//   data
//
// then, for every line of the image and every distance, an unsigned 16-bit little-endian number n:
// the stripe's position is offset + n * step; 65535 means none.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "rangefinder/look_up_table.h"

namespace geon::rangefinder {
namespace {

constexpr std::string_view kFormat = "geon.lut.v1";
constexpr uint16_t kNoPosition = 65535;
constexpr int kMaxSide_px = 8192;
constexpr int kMaxDistances = 8192;

std::string Fnv1a(std::string_view bytes) {
  uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : bytes) {
    hash ^= static_cast<uint8_t>(c);
    hash *= 0x100000001b3U;
  }
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (size_t i = 0; i < 16; ++i) text[15 - i] = kDigits[(hash >> (4 * i)) & 15U];
  return text;
}

template <typename Number>
std::string Text(Number number) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), end};
}

// Reads the header's lines one after the other; the first that is not as expected is the error.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : rest_(bytes) {}

  std::string_view Line() {
    const size_t end = rest_.find('\n');
    if (end == std::string_view::npos || end > 200) {
      Fail("the header ends too early");
      return {};
    }
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }
  std::string_view Value(std::string_view key) {
    const std::string_view line = Line();
    if (line.size() <= key.size() + 1 || line.substr(0, key.size()) != key ||
        line[key.size()] != ' ') {
      Fail("expected \"" + std::string(key) + " VALUE\"");
      return {};
    }
    return line.substr(key.size() + 1);
  }
  template <typename Number>
  Number In(std::string_view key, Number min, Number max) {
    const std::string_view text = Value(key);
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || !(number >= min) ||
        !(number <= max)) {
      Fail(std::string(key) + " must be a number from " + Text(min) + " to " + Text(max));
      return min;
    }
    return number;
  }
  void Fail(const std::string& why) {
    if (status_.ok()) status_ = Status::Error("not a " + std::string(kFormat) + " file: " + why);
  }
  const Status& status() const { return status_; }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  Status status_;
};

Status CheckPositions(const LookUpTable& table) {
  bool any = false;
  for (int line = 0; line < table.lines(); ++line) {
    double previous_px = std::numeric_limits<double>::quiet_NaN();
    double direction = 0.0;
    for (int k = 0; k < table.distances; ++k) {
      const double position_px = table.PositionAt(line, k);
      if (std::isnan(position_px)) continue;
      any = true;
      const double change = position_px - previous_px;
      if (change * direction < 0.0 || change == 0.0) {
        return Status::Error("not a sound " + std::string(kFormat) + " file: line " +
                             std::to_string(line) + " is not monotone at distance " +
                             std::to_string(k));
      }
      if (!std::isnan(change)) direction = change;
      previous_px = position_px;
    }
  }
  return any ? Status::Ok() : Status::Error("an empty " + std::string(kFormat) + " file");
}

}  // namespace

std::string SerializeLookUpTable(const LookUpTable& table) {
  double low_px = std::numeric_limits<double>::infinity();
  double high_px = -low_px;
  for (const double position_px : table.position_px) {
    if (std::isnan(position_px)) continue;
    low_px = std::min(low_px, position_px);
    high_px = std::max(high_px, position_px);
  }
  Require(low_px <= high_px, "SerializeLookUpTable: the table is empty");
  // A step that is a power of two keeps offset + n * step free of rounding.
  const double step_px = std::exp2(std::ceil(std::log2((high_px - low_px + 1.0) / 65534.0)));
  const double offset_px = std::floor(low_px);

  std::string data;
  data.reserve(2 * table.position_px.size());
  for (const double position_px : table.position_px) {
    const auto number =
        std::isnan(position_px)
            ? kNoPosition
            : static_cast<uint16_t>(std::lround((position_px - offset_px) / step_px));
    data.push_back(static_cast<char>(number & 255U));
    data.push_back(static_cast<char>(number >> 8U));
  }

  std::string bytes(kFormat);
  const auto add = [&bytes](std::string_view key, const std::string& value) {
    bytes.append("\n").append(key).append(" ").append(value);
  };
  add("laser", std::string(ToString(table.laser)));
  add("date", table.date);
  add("width_px", Text(table.width_px));
  add("height_px", Text(table.height_px));
  add("frames", Text(table.frames));
  add("distances", Text(table.distances));
  add("first_distance_m", Text(table.first_distance_m));
  add("step_m", Text(table.step_m));
  add("position_offset_px", Text(offset_px));
  add("position_step_px", Text(step_px));
  add("fnv1a", Fnv1a(data));
  return bytes + "\ndata\n" + data;
}

Result<LookUpTable> ParseLookUpTable(const std::string& bytes) {
  HeaderReader reader(bytes);
  LookUpTable table;
  if (reader.Line() != kFormat) reader.Fail("the first line must be " + std::string(kFormat));
  const std::string_view laser = reader.Value("laser");
  if (laser != "horizontal" && laser != "vertical")
    reader.Fail("laser must be horizontal or vertical");
  table.laser = laser == "vertical" ? sensor::Laser::kVertical : sensor::Laser::kHorizontal;
  table.date = reader.Value("date");
  table.width_px = reader.In("width_px", 1, kMaxSide_px);
  table.height_px = reader.In("height_px", 1, kMaxSide_px);
  table.frames = reader.In("frames", 1, 1000000);
  table.distances = reader.In("distances", 2, kMaxDistances);
  table.first_distance_m = reader.In("first_distance_m", 1e-3, 100.0);
  table.step_m = reader.In("step_m", 1e-5, 1.0);
  const double offset_px = reader.In("position_offset_px", -1e5, 1e5);
  const double step_px = reader.In("position_step_px", 1e-6, 1.0);
  const std::string_view hash = reader.Value("fnv1a");
  if (reader.Line() != "data") reader.Fail("expected \"data\"");
  if (!reader.status().ok()) return reader.status();

  const std::string_view data = reader.rest();
  const size_t entries = static_cast<size_t>(table.lines()) * static_cast<size_t>(table.distances);
  if (data.size() != 2 * entries) {
    return Status::Error("not a whole " + std::string(kFormat) +
                         " file: " + std::to_string(data.size()) + " bytes of data, expected " +
                         std::to_string(2 * entries));
  }
  if (Fnv1a(data) != hash) {
    return Status::Error("damaged " + std::string(kFormat) + " file: its hash is " + Fnv1a(data) +
                         ", expected " + std::string(hash) + "; calibrate again");
  }
  table.position_px.resize(entries);
  for (size_t i = 0; i < entries; ++i) {
    const auto number = static_cast<uint16_t>(static_cast<uint8_t>(data[2 * i]) |
                                              (static_cast<uint8_t>(data[2 * i + 1]) << 8U));
    table.position_px[i] = number == kNoPosition ? std::numeric_limits<double>::quiet_NaN()
                                                 : offset_px + number * step_px;
  }
  const Status monotone = CheckPositions(table);
  if (!monotone.ok()) return monotone;
  return table;
}

}  // namespace geon::rangefinder
