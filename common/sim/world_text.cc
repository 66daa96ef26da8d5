#include <cmath>
#include <sstream>

#include "base/angles.h"
#include "sim/world_file.h"

namespace geon::sim {
namespace {

// Numbers people can read: millimetres and tenths of a degree are as fine as a world is laid out.
std::string Number(double value, double step) {
  std::ostringstream text;
  text << std::round(value / step) * step;
  return text.str() == "-0" ? "0" : text.str();
}
std::string Metres(double value_m) { return Number(value_m, 0.001); }
std::string Degrees(double value_rad) { return Number(DegreesFromRadians(value_rad), 0.1); }
std::string Plain(double value) { return Number(value, 0.001); }

template <typename Vector, typename Format>
std::string List(const Vector& values, Format format) {
  std::string text = "[";
  for (Eigen::Index k = 0; k < values.size(); ++k) text += (k > 0 ? ", " : "") + format(values[k]);
  return text + "]";
}

struct ShapeText {
  std::string operator()(const geons::GeonShape& shape) const {
    std::string text =
        "geon: " + std::string(ToString(shape.label)) + ", size_m: " + List(shape.size_m, Metres);
    if (geons::IsTapered(shape.label)) text += ", taper: " + Plain(shape.taper_1);
    if (geons::IsBent(shape.label)) text += ", bend_deg: " + Degrees(shape.bend_rad);
    return text + ", position: " + std::to_string(shape.position);
  }
  std::string operator()(const MeshShape& mesh) const {
    std::string text = "mesh: \"" + mesh.file.string() + "\", height_m: " + Metres(mesh.height_m);
    if (mesh.truth) text += ", truth: " + std::string(ToString(*mesh.truth));
    return text;
  }
  std::string operator()(const BoxShape& box) const { return "box: " + List(box.size_m, Metres); }
  std::string operator()(const CylinderShape& cylinder) const {
    return "cylinder: {radius_m: " + Metres(cylinder.radius_m) +
           ", height_m: " + Metres(cylinder.height_m) + "}";
  }
  std::string operator()(const ChessboardShape& board) const {
    constexpr double kSquareStep_m = 1e-5;
    return "chessboard: {squares: [" + std::to_string(board.columns) + ", " +
           std::to_string(board.rows) + "], square_m: " + Number(board.square_m, kSquareStep_m) +
           ", margin_m: " + Metres(board.margin_m) + "}, pitch_deg: " + Degrees(board.pitch_rad);
  }
};

}  // namespace

std::string WorldText(const World& world) {
  const Lighting& light = world.lighting;
  std::ostringstream text;
  text << "pen: {size_m: " << List(world.pen_size_m, Metres)
       << ", wall_height_m: " << Metres(world.wall_height_m) << "}\n"
       << "floor: {color_rgb: " << List(world.floor_color_rgb, Plain)
       << ", tile_m: " << Metres(world.floor_tile_m) << ", gloss: " << Plain(world.floor_gloss_1)
       << ", groove_tilt_deg: " << Degrees(world.groove_tilt_rad) << "}\n"
       << "robot: {x_m: " << Metres(world.robot_x_m) << ", y_m: " << Metres(world.robot_y_m)
       << ", heading_deg: " << Degrees(world.robot_heading_rad) << "}\n"
       << "light: {kelvin: " << Plain(light.kelvin) << ", level: " << Plain(light.level_1)
       << ", sun: {level: " << Plain(light.sun.level_1)
       << ", azimuth_deg: " << Degrees(light.sun.azimuth_rad)
       << ", elevation_deg: " << Degrees(light.sun.elevation_rad) << "}}\n";
  if (world.objects.empty()) return text.str();
  text << "objects:\n";
  for (const WorldObject& object : world.objects) {
    text << "  - {" << std::visit(ShapeText(), object.shape) << ", x_m: " << Metres(object.x_m)
         << ", y_m: " << Metres(object.y_m);
    if (object.z_m) text << ", z_m: " << Metres(*object.z_m);
    text << ", yaw_deg: " << Degrees(object.yaw_rad)
         << ", color_rgb: " << List(object.color_rgb, Plain);
    if (object.reflectance_1) text << ", reflectance: " << Plain(*object.reflectance_1);
    text << "}\n";
  }
  return text.str();
}

}  // namespace geon::sim
