#include "attention/color_model_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace geon::attention {
namespace {

constexpr std::string_view kFormat = "geon.color_model.v1";

struct Field {
  std::string_view key;
  double ChromaticityColor::*value;
};
constexpr std::array<Field, 7> kFields = {{
    {"mean_i_1", &ChromaticityColor::mean_i_1},
    {"mean_q_1", &ChromaticityColor::mean_q_1},
    {"inverse_ii_1", &ChromaticityColor::inverse_ii_1},
    {"inverse_iq_1", &ChromaticityColor::inverse_iq_1},
    {"inverse_qq_1", &ChromaticityColor::inverse_qq_1},
    {"max_distance_1", &ChromaticityColor::max_distance_1},
    {"min_luminance_1", &ChromaticityColor::min_luminance_1},
}};

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
    if (color_name_.empty()) return Whole("the key name is missing");
    size_t given = 0;
    for (const bool seen : seen_) given += seen ? 1 : 0;
    if (given > 0 && !half_spaces_.empty()) {
      return Whole("a colour is either half_space lines or a learned one, not both");
    }
    if (!half_spaces_.empty()) return ColorModel{color_name_, HalfSpaceColor{half_spaces_}};
    for (size_t i = 0; i < kFields.size(); ++i) {
      if (!seen_[i]) return Whole("the key " + std::string(kFields[i].key) + " is missing");
    }
    const bool is_ellipse = learned_.inverse_ii_1 > 0.0 &&
                            learned_.inverse_ii_1 * learned_.inverse_qq_1 >
                                learned_.inverse_iq_1 * learned_.inverse_iq_1 &&
                            learned_.max_distance_1 > 0.0;
    if (!is_ellipse) {
      return Whole("inverse_*_1 must be positive definite and max_distance_1 positive");
    }
    return ColorModel{color_name_, learned_};
  }

 private:
  Status Use(std::string_view key, std::string_view value) {
    if (key == "format") {
      if (format_seen_) return Error("duplicate key format");
      format_seen_ = true;
      return value == kFormat ? Status::Ok() : Error("format must be " + std::string(kFormat));
    }
    if (key == "name") {
      if (!color_name_.empty()) return Error("duplicate key name");
      color_name_ = value;
      return value.empty() ? Error("name must not be empty") : Status::Ok();
    }
    if (key == "half_space") {
      const auto half_space = HalfSpace(value);
      if (!half_space) return Error("half_space must be [red, green, blue, threshold], numbers");
      half_spaces_.push_back(*half_space);
      return Status::Ok();
    }
    for (size_t i = 0; i < kFields.size(); ++i) {
      if (key != kFields[i].key) continue;
      if (seen_[i]) return Error("duplicate key " + std::string(key));
      const auto number = Number(value);
      if (!number) return Error(std::string(key) + " must be a number");
      seen_[i] = true;
      learned_.*kFields[i].value = *number;
      return Status::Ok();
    }
    return Error("unknown key " + std::string(key));
  }
  Status Error(const std::string& why) const {
    return Status::Error(name_ + ":" + std::to_string(line_) + ": " + why);
  }
  Status Whole(const std::string& why) const { return Status::Error(name_ + ": " + why); }

  std::string name_;
  int line_ = 0;
  bool format_seen_ = false;
  std::string color_name_;
  std::vector<ColorHalfSpace> half_spaces_;
  ChromaticityColor learned_;
  std::array<bool, kFields.size()> seen_{};
};

}  // namespace

std::string SerializeColorModel(const ColorModel& model, const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += "# " + comment + "\n";
  text += "format: " + std::string(kFormat) + "\nname: " + model.name + "\n";
  if (const auto* learned = std::get_if<ChromaticityColor>(&model.color)) {
    for (const Field& field : kFields) {
      text += std::string(field.key) + ": " + Text(learned->*field.value) + "\n";
    }
    return text;
  }
  for (const ColorHalfSpace& half_space : std::get<HalfSpaceColor>(model.color).half_spaces) {
    text += "half_space: [" + Text(half_space.red_1) + ", " + Text(half_space.green_1) + ", " +
            Text(half_space.blue_1) + ", " + Text(half_space.threshold_1) + "]\n";
  }
  return text;
}

Result<ColorModel> ParseColorModel(const std::string& text, const std::string& name) {
  Parser parser(name);
  const Status status = parser.Read(text);
  if (!status.ok()) return status;
  return parser.Finish();
}

}  // namespace geon::attention
