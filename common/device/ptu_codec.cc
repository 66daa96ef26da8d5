#include "device/ptu_codec.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace geon::device {
namespace {

constexpr size_t kLongestPtuLine = 200;

std::string_view Trim(std::string_view text) {
  const size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

bool SaysPanTilt(std::string_view text) {
  std::string upper(text);
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return upper.find("PAN-TILT") != std::string::npos;
}

PtuLine SortPtuLine(std::string_view text) {
  using Kind = PtuLine::Kind;
  const size_t sign = text.find_first_of("*!");
  if (sign == std::string_view::npos) {
    return {SaysPanTilt(text) ? Kind::kBanner : Kind::kUnknown, "", std::string(Trim(text))};
  }
  const std::string_view echo = Trim(text.substr(0, sign));
  // A banner may be framed in stars; an echo never holds those words.
  if (SaysPanTilt(echo)) return {Kind::kBanner, "", std::string(Trim(text))};
  return {text[sign] == '*' ? Kind::kDone : Kind::kRefused, std::string(echo),
          std::string(Trim(text.substr(sign + 1)))};
}

template <typename T>
std::optional<T> ParseWhole(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::string EncodePtuCommand(std::string_view letters) { return std::string(letters) + " "; }

std::string EncodePtuCommand(std::string_view letters, int value) {
  return std::string(letters) + std::to_string(value) + " ";
}

void PtuReader::Push(std::string_view bytes) {
  for (const char byte : bytes) PushByte(byte);
}

void PtuReader::PushByte(char byte) {
  if (std::exchange(mark_begun_, false)) {
    if (byte == 'P' || byte == 'T') {
      (byte == 'P' ? pan_limit_ : tilt_limit_) = true;
      return;
    }
    buffer_ += '!';
  }
  if (byte == '!') {
    mark_begun_ = true;
  } else {
    buffer_ += byte;
  }
}

std::optional<PtuLine> PtuReader::Next() {
  const size_t begin = buffer_.find_first_not_of("\r\n");
  if (begin == std::string::npos) {
    buffer_.clear();
    return std::nullopt;
  }
  const size_t end = buffer_.find_first_of("\r\n", begin);
  if (end == std::string::npos && buffer_.size() - begin <= kLongestPtuLine) return std::nullopt;
  const std::string text = buffer_.substr(begin, std::min(end - begin, kLongestPtuLine));
  buffer_.erase(0, begin + text.size());
  return SortPtuLine(text);
}

std::optional<PtuLine> PtuReader::TakeUnfinished() {
  const size_t begin = buffer_.find_first_not_of("\r\n");
  if (begin == std::string::npos) return std::nullopt;
  const std::string text = std::exchange(buffer_, {}).substr(begin);
  return SortPtuLine(text);
}

bool PtuReader::TakePanLimit() { return std::exchange(pan_limit_, false); }
bool PtuReader::TakeTiltLimit() { return std::exchange(tilt_limit_, false); }

void PtuReader::Clear() {
  buffer_.clear();
  mark_begun_ = pan_limit_ = tilt_limit_ = false;
}

std::optional<double> ParsePtuNumber(std::string_view text) {
  const std::optional<double> value = ParseWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> ParsePtuCount(std::string_view text) { return ParseWhole<int>(text); }

}  // namespace geon::device
