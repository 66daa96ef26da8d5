#include "device/horus_codec.h"

#include <algorithm>

#include "base/contracts.h"

namespace geon::device {
namespace {

constexpr size_t kLongestHorusLine = 200;

std::string EncodeLaser(std::string_view code, int number) {
  Require(number == 1 || number == 2, "laser number must be 1 or 2, is " + std::to_string(number));
  return std::string(code) + "T" + std::to_string(number) + "\r\n";
}

HorusLine SortHorusLine(std::string text) {
  HorusLine line{HorusLine::Kind::kUnknown, std::move(text)};
  const std::string_view view = line.text;
  if (view == "ok") {
    line.kind = HorusLine::Kind::kOk;
  } else if (view.starts_with("error:") || view.starts_with("ALARM:")) {
    line.kind = HorusLine::Kind::kError;
  } else if (view.starts_with("Horus 0.2")) {
    line.kind = HorusLine::Kind::kBanner;
  } else if (view.starts_with("Horus ") || view.starts_with("Grbl ")) {
    line.kind = HorusLine::Kind::kForeignBanner;
  } else if ((view.front() == '[' && view.back() == ']') ||
             (view.front() == '<' && view.back() == '>')) {
    line.kind = HorusLine::Kind::kNote;
  }
  return line;
}

}  // namespace

std::string EncodeLaserOff(int number) { return EncodeLaser("M70", number); }
std::string EncodeLaserOn(int number) { return EncodeLaser("M71", number); }
std::string EncodeHorusReset() { return "\x18\r\n"; }

std::optional<HorusLine> HorusReader::Next() {
  const size_t begin = buffer_.find_first_not_of("\r\n");
  if (begin == std::string::npos) {
    buffer_.clear();
    return std::nullopt;
  }
  const size_t end = buffer_.find_first_of("\r\n", begin);
  if (end == std::string::npos && buffer_.size() - begin <= kLongestHorusLine) {
    buffer_.erase(0, begin);
    return std::nullopt;
  }
  std::string text = buffer_.substr(begin, std::min(end - begin, kLongestHorusLine));
  buffer_.erase(0, begin + text.size());
  return SortHorusLine(std::move(text));
}

}  // namespace geon::device
