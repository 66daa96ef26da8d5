#include "config/scan_set_json.h"

#include <Eigen/LU>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/geon_label.h"
#include "config/text_file.h"

namespace geon::config {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "geon.scan_set.v1";
constexpr double kLargest_m = 1000.0;  // no rangefinder of this kind measures farther
constexpr int kLargestPixel = 1000000;
constexpr double kRotationTolerance = 1e-3;  // rotations are written with a few digits

// What stops the reading, thrown and caught in this file only.
struct Refusal {
  std::string place;
  std::string rule;
};

// A value and where it stands.
struct Node {
  const json& value;
  std::string place;

  [[noreturn]] void Refuse(const std::string& rule) const { throw Refusal{place, rule}; }

  bool Has(const char* key) const { return value.contains(key); }
  Node At(const char* key) const {
    if (!value.is_object()) Refuse("must be an object");
    const auto found = value.find(key);
    if (found == value.end()) Refuse(std::string("has no \"") + key + "\"");
    return {*found, place + "/" + key};
  }
  Node At(size_t index) const { return {value[index], place + "/" + std::to_string(index)}; }
  size_t ArraySize() const {
    if (!value.is_array()) Refuse("must be a list");
    return value.size();
  }
  double Number() const {
    if (!value.is_number()) Refuse("must be a number");
    const double number = value.get<double>();
    if (!std::isfinite(number)) Refuse("must be finite");
    return number;
  }
  int Integer() const {
    if (!value.is_number_integer()) Refuse("must be an integer");
    const auto number = value.get<int64_t>();
    if (number < -kLargestPixel || number > kLargestPixel) Refuse("is out of range");
    return static_cast<int>(number);
  }
  std::string Text() const {
    if (!value.is_string()) Refuse("must be a string");
    return value.get<std::string>();
  }
};

Eigen::Vector3d ReadPoint(const Node& node) {
  if (node.ArraySize() != 3) node.Refuse("must be 3 numbers");
  Eigen::Vector3d p_m;
  for (size_t i = 0; i < 3; ++i) p_m[static_cast<int>(i)] = node.At(i).Number();
  if (p_m.cwiseAbs().maxCoeff() > kLargest_m) node.Refuse("is farther than 1000 m");
  return p_m;
}

Eigen::Matrix3d ReadRotation(const Node& node) {
  if (node.ArraySize() != 9) node.Refuse("must be 9 numbers");
  Eigen::Matrix3d R;
  for (size_t i = 0; i < 9; ++i) {
    R(static_cast<int>(i) / 3, static_cast<int>(i) % 3) = node.At(i).Number();
  }
  const double defect = (R * R.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(defect <= kRotationTolerance) || R.determinant() < 0.0)
    node.Refuse("is no rotation matrix");
  return R;
}

sensor::PixelBox ReadBox(const Node& node) {
  sensor::PixelBox box;
  box.u_px = node.At("u").Integer();
  box.v_px = node.At("v").Integer();
  box.w_px = node.At("w").Integer();
  box.h_px = node.At("h").Integer();
  if (box.w_px <= 0 || box.h_px <= 0) node.Refuse("must have a positive width and height");
  return box;
}

sensor::Laser ReadLaserName(const Node& node) {
  const std::string name = node.Text();
  if (name == "horizontal") return sensor::Laser::kHorizontal;
  if (name == "vertical") return sensor::Laser::kVertical;
  node.Refuse("must be \"horizontal\" or \"vertical\"");
}

std::vector<double> ReadColors(const Node& node, size_t points) {
  if (node.ArraySize() != points) {
    node.Refuse("has " + std::to_string(node.ArraySize()) + " numbers for " +
                std::to_string(points) + " points");
  }
  std::vector<double> on_color_1;
  for (size_t i = 0; i < points; ++i) {
    on_color_1.push_back(node.At(i).Number());
    if (on_color_1[i] < 0.0 || on_color_1[i] > 1.0) node.At(i).Refuse("must be between 0 and 1");
  }
  return on_color_1;
}

sensor::RangeProfile ReadStripe(const Node& node, size_t index) {
  sensor::RangeProfile profile;
  profile.stripe_index = static_cast<int32_t>(index);
  profile.laser = ReadLaserName(node.At("laser"));
  profile.fraction = node.At("fraction").Number();
  if (profile.fraction < 0.0 || profile.fraction > 1.0) {
    node.At("fraction").Refuse("must be between 0 and 1");
  }
  if (node.Has("laser_origin_m")) profile.laser_origin_L_m = ReadPoint(node.At("laser_origin_m"));
  if (node.Has("camera_rotation_LB")) {
    profile.rotation_LB = ReadRotation(node.At("camera_rotation_LB"));
  }
  const Node pixel = node.At("pixel");
  const Node points = node.At("points_m");
  const size_t count = pixel.ArraySize();
  if (points.ArraySize() != count) {
    points.Refuse("has " + std::to_string(points.ArraySize()) + " points for " +
                  std::to_string(count) + " pixels");
  }
  for (size_t i = 0; i < count; ++i) {
    profile.pixel.push_back(pixel.At(i).Integer());
    if (i > 0 && profile.pixel[i] <= profile.pixel[i - 1]) {
      pixel.At(i).Refuse("must be larger than its predecessor");
    }
    profile.p_L_m.push_back(ReadPoint(points.At(i)));
  }
  if (node.Has("color")) profile.on_color_1 = ReadColors(node.At("color"), count);
  return profile;
}

sensor::ScanSet ReadScanSet(const Node& root) {
  const Node format = root.At("format");
  if (format.Text() != kFormat) format.Refuse(std::string("must be \"") + kFormat + "\"");
  sensor::ScanSet scan;
  if (root.Has("truth")) {
    const Node truth = root.At("truth");
    scan.truth = GeonLabelFromString(truth.Text());
    if (!scan.truth) truth.Refuse("is none of the seven labels");
  }
  const Node camera = root.At("camera");
  scan.camera_position_L_m = ReadPoint(camera.At("position_m"));
  scan.rotation_LB = ReadRotation(camera.At("rotation_LB"));
  if (root.Has("target_box_px")) scan.target_box = ReadBox(root.At("target_box_px"));
  const Node stripes = root.At("stripes");
  const size_t count = stripes.ArraySize();
  if (count == 0) stripes.Refuse("holds no stripe");
  for (size_t i = 0; i < count; ++i) scan.profiles.push_back(ReadStripe(stripes.At(i), i));
  return scan;
}

json PointJson(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

json RotationJson(const Eigen::Matrix3d& R) {
  json numbers = json::array();
  for (int i = 0; i < 9; ++i) numbers.push_back(R(i / 3, i % 3));
  return numbers;
}

json StripeJson(const sensor::RangeProfile& profile) {
  json stripe = {{"laser", ToString(profile.laser)},
                 {"fraction", profile.fraction},
                 {"pixel", profile.pixel},
                 {"points_m", json::array()}};
  for (const Eigen::Vector3d& p : profile.p_L_m) stripe["points_m"].push_back(PointJson(p));
  if (profile.laser_origin_L_m) stripe["laser_origin_m"] = PointJson(*profile.laser_origin_L_m);
  if (!profile.on_color_1.empty()) stripe["color"] = profile.on_color_1;
  if (profile.rotation_LB) stripe["camera_rotation_LB"] = RotationJson(*profile.rotation_LB);
  return stripe;
}

}  // namespace

Result<sensor::ScanSet> LoadScanSet(const std::filesystem::path& file) {
  const Result<std::string> text = ReadFile(file);
  if (!text.ok()) return text.status();
  return ParseScanSet(*text, file.string());
}

Result<sensor::ScanSet> ParseScanSet(const std::string& text, const std::string& name) {
  try {
    const json root = json::parse(text);
    return ReadScanSet({root, ""});
  } catch (const Refusal& refusal) {
    const std::string place = refusal.place.empty() ? "the whole" : refusal.place;
    return Status::Error(name + ": " + place + ": " + refusal.rule);
  } catch (const json::exception& error) {
    return Status::Error(name + ": not JSON: " + error.what());
  }
}

std::string SerializeScanSet(const sensor::ScanSet& scan) {
  json root = {{"format", kFormat},
               {"camera",
                {{"position_m", PointJson(scan.camera_position_L_m)},
                 {"rotation_LB", RotationJson(scan.rotation_LB)}}},
               {"stripes", json::array()}};
  if (scan.truth) root["truth"] = std::string(ToString(*scan.truth));
  if (scan.target_box) {
    root["target_box_px"] = {{"u", scan.target_box->u_px},
                             {"v", scan.target_box->v_px},
                             {"w", scan.target_box->w_px},
                             {"h", scan.target_box->h_px}};
  }
  for (const sensor::RangeProfile& profile : scan.profiles) {
    root["stripes"].push_back(StripeJson(profile));
  }
  return root.dump();
}

}  // namespace geon::config
