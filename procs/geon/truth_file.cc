#include "procs/geon/truth_file.h"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "config/text_file.h"

namespace geon::cli {
namespace {

using nlohmann::json;

Truth ReadTruth(const json& start) {
  const double x_m = start.at("robot").at("x_m").get<double>();
  const double y_m = start.at("robot").at("y_m").get<double>();
  const double heading_rad = start.at("robot").at("heading_rad").get<double>();
  const double c = std::cos(heading_rad);
  const double s = std::sin(heading_rad);
  Truth truth;
  for (const json& item : start.at("objects")) {
    const double dx_m = item.at("x_m").get<double>() - x_m;
    const double dy_m = item.at("y_m").get<double>() - y_m;
    Truth::Object object;
    object.kind = item.at("kind").get<std::string>();
    if (item.at("label").is_string()) {
      object.label = GeonLabelFromString(item.at("label").get<std::string>());
    }
    object.x_m = c * dx_m + s * dy_m;
    object.y_m = -s * dx_m + c * dy_m;
    truth.objects.push_back(object);
  }
  return truth;
}

}  // namespace

std::optional<GeonLabel> Truth::LabelNear(double x_m, double y_m) const {
  std::optional<GeonLabel> label;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (const Object& object : objects) {
    const double distance_m = std::hypot(object.x_m - x_m, object.y_m - y_m);
    if (!object.label || distance_m >= nearest_m) continue;
    nearest_m = distance_m;
    label = object.label;
  }
  return label;
}

Result<Truth> LoadTruth(const std::filesystem::path& file) {
  const Result<std::string> text = config::ReadFile(file);
  if (!text.ok()) return text.status();
  const std::string first_line = text->substr(0, text->find('\n'));
  try {
    return ReadTruth(json::parse(first_line));
  } catch (const json::exception& error) {
    return Status::Error(file.string() + ": no truth file of geon-sim: " + error.what());
  }
}

}  // namespace geon::cli
