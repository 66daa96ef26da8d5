#include "attention/color_model_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace geon::attention {
namespace {

constexpr std::string_view kFormat = "geon.color_model.v1";

std::string Text(double number) {
  std::array<char, 40> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), end};
}

std::string_view Trim(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r";
  const size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::optional<double> Number(std::string_view text) {
  text = Trim(text);
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number)) {
    return std::nullopt;
  }
  return number;
}

std::optional<int> WholeNumber(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// "[red, green, blue, threshold]".
std::optional<ColorHalfSpace> HalfSpace(std::string_view text) {
  if (text.size() < 2 || text.front() != '[' || text.back() != ']') return std::nullopt;
  text = text.substr(1, text.size() - 2);
  std::array<double, 4> numbers{};
  for (size_t i = 0; i < numbers.size(); ++i) {
    const size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == numbers.size())) return std::nullopt;
    const auto number = Number(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers[i] = *number;
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return ColorHalfSpace{numbers[0], numbers[1], numbers[2], numbers[3]};
}

class Parser {
 public:
  explicit Parser(std::string name) : name_(std::move(name)) {}

  Status Read(const std::string& text) {
    std::string_view rest = text;
    while (!rest.empty()) {
      ++line_;
      const size_t end = rest.find('\n');
      std::string_view line = rest.substr(0, end);
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
      line = Trim(line.substr(0, line.find('#')));
      if (line.empty()) continue;
      const size_t colon = line.find(':');
      if (colon == std::string_view::npos) return Error("expected \"key: value\"");
      const Status status = Use(Trim(line.substr(0, colon)), Trim(line.substr(colon + 1)));
      if (!status.ok()) return status;
    }
    return Status::Ok();
  }

  Result<ColorModel> Finish() const {
    if (!format_seen_) return Whole("the key format is missing");
    if (model_.name.empty()) return Whole("the key name is missing");
    if (const auto error = model_.Validate()) return Whole(*error);
    return model_;
  }

 private:
  Status Use(std::string_view key, std::string_view value) {
    if (key == "format") {
      if (format_seen_) return Error("duplicate key format");
      format_seen_ = true;
      return value == kFormat ? Status::Ok() : Error("format must be " + std::string(kFormat));
    }
    if (key == "name") {
      if (!model_.name.empty()) return Error("duplicate key name");
      model_.name = value;
      return value.empty() ? Error("name must not be empty") : Status::Ok();
    }
    if (key == "region") return UseRegion(value);
    if (key == "half_space") {
      const auto half_space = HalfSpace(value);
      if (!half_space) return Error("half_space must be [red, green, blue, threshold], numbers");
      if (region_ == nullptr) return Error("half_space must stand below a region");
      region_->half_spaces.push_back(*half_space);
      return Status::Ok();
    }
    if (key == "dark_level_1") return UseLevel(key, value, &dark_seen_, &model_.dark_level_1);
    if (key == "clipped_level_1") {
      return UseLevel(key, value, &clipped_seen_, &model_.clipped_level_1);
    }
    return Error("unknown key " + std::string(key));
  }
  Status UseRegion(std::string_view value) {
    if (value != "target" && value != "rim") return Error("region must be target or rim");
    region_ = &(value == "target" ? model_.target : model_.rim).emplace_back();
    return Status::Ok();
  }
  Status UseLevel(std::string_view key, std::string_view value, bool* seen, int* level) const {
    if (*seen) return Error("duplicate key " + std::string(key));
    *seen = true;
    const auto number = WholeNumber(value);
    if (!number) return Error(std::string(key) + " must be a whole number");
    *level = *number;
    return Status::Ok();
  }
  Status Error(const std::string& why) const {
    return Status::Error(name_ + ":" + std::to_string(line_) + ": " + why);
  }
  Status Whole(const std::string& why) const { return Status::Error(name_ + ": " + why); }

  std::string name_;
  int line_ = 0;
  bool format_seen_ = false;
  bool dark_seen_ = false;
  bool clipped_seen_ = false;
  ColorModel model_;
  HalfSpaceColor* region_ = nullptr;  // the one that half_space lines add to
};

std::string RegionText(std::string_view kind, const HalfSpaceColor& region) {
  std::string text = "region: " + std::string(kind) + "\n";
  for (const ColorHalfSpace& half_space : region.half_spaces) {
    text += "half_space: [" + Text(half_space.red_1) + ", " + Text(half_space.green_1) + ", " +
            Text(half_space.blue_1) + ", " + Text(half_space.threshold_1) + "]\n";
  }
  return text;
}

}  // namespace

std::string SerializeColorModel(const ColorModel& model, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + "\n";
  text += "format: " + std::string(kFormat) + "\nname: " + model.name + "\n";
  const ColorModel defaults;
  if (model.dark_level_1 != defaults.dark_level_1) {
    text += "dark_level_1: " + std::to_string(model.dark_level_1) + "\n";
  }
  if (model.clipped_level_1 != defaults.clipped_level_1) {
    text += "clipped_level_1: " + std::to_string(model.clipped_level_1) + "\n";
  }
  for (const HalfSpaceColor& region : model.target) text += RegionText("target", region);
  for (const HalfSpaceColor& region : model.rim) text += RegionText("rim", region);
  return text;
}

Result<ColorModel> ParseColorModel(const std::string& text, const std::string& name) {
  Parser parser(name);
  const Status status = parser.Read(text);
  if (!status.ok()) return status;
  return parser.Finish();
}

}  // namespace geon::attention
