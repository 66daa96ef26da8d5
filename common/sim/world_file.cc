#include "sim/world_file.h"

#include <cmath>
#include <sstream>

#include "base/angles.h"
#include "config/yaml_section.h"
#include "sim/footprint.h"

namespace geon::sim {
namespace {

using config::YamlDocument;
using config::YamlSection;

void ReadColor(YamlSection* section, const std::string& key, Eigen::Vector3d* color_rgb) {
  if (!section->Has(key)) return;
  section->ReadNumbers(key, 3, color_rgb->data());
  section->Check(color_rgb->minCoeff() >= 0.0 && color_rgb->maxCoeff() <= 255.0, key,
                 "must be three numbers from 0 to 255");
}

void ReadPen(YamlSection pen, World* world) {
  pen.ReadNumbers("size_m", 2, world->pen_size_m.data());
  pen.Check(world->pen_size_m.minCoeff() >= 1.0 && world->pen_size_m.maxCoeff() <= 50.0, "size_m",
            "must be two lengths from 1 to 50 m");
  pen.ReadOptional("wall_height_m", &world->wall_height_m);
  pen.Check(world->wall_height_m > 0.0 && world->wall_height_m <= 3.0, "wall_height_m",
            "must be above 0 and at most 3 m");
}

void ReadFloor(YamlSection floor, World* world) {
  ReadColor(&floor, "color_rgb", &world->floor_color_rgb);
  floor.ReadOptional("tile_m", &world->floor_tile_m);
  floor.Check(world->floor_tile_m >= 0.1, "tile_m", "must be at least 0.1 m");
  floor.ReadOptional("gloss", &world->floor_gloss_1);
  floor.Check(world->floor_gloss_1 >= 0.0 && world->floor_gloss_1 <= 1.0, "gloss",
              "must be from 0 to 1");
  floor.ReadOptionalAngle("groove_tilt_deg", &world->groove_tilt_rad);
  floor.Check(world->groove_tilt_rad >= 0.0 && world->groove_tilt_rad <= RadiansFromDegrees(10.0),
              "groove_tilt_deg", "must be from 0 to 10 degrees");
}

void ReadRobot(YamlSection robot, World* world) {
  robot.Read("x_m", &world->robot_x_m);
  robot.Read("y_m", &world->robot_y_m);
  robot.ReadOptionalAngle("heading_deg", &world->robot_heading_rad);
  const Eigen::Vector2d far_m = world->pen_size_m.array() - kRobotRadius_m;
  robot.Check(world->robot_x_m >= kRobotRadius_m && world->robot_x_m <= far_m.x(), "x_m",
              "must leave the robot (radius 0.267 m) inside the pen");
  robot.Check(world->robot_y_m >= kRobotRadius_m && world->robot_y_m <= far_m.y(), "y_m",
              "must leave the robot (radius 0.267 m) inside the pen");
}

void ReadLight(YamlSection light, Lighting* lighting) {
  light.ReadOptional("kelvin", &lighting->kelvin);
  light.Check(lighting->kelvin >= 1500.0 && lighting->kelvin <= 20000.0, "kelvin",
              "must be from 1500 to 20000");
  light.ReadOptional("level", &lighting->level_1);
  light.Check(lighting->level_1 >= 0.0 && lighting->level_1 <= 100.0, "level",
              "must be from 0 to 100");
  if (!light.Has("sun")) return;
  YamlSection sun = light.Child("sun");
  sun.ReadOptional("level", &lighting->sun.level_1);
  sun.Check(lighting->sun.level_1 >= 0.0 && lighting->sun.level_1 <= 100.0, "level",
            "must be from 0 to 100");
  sun.ReadOptionalAngle("azimuth_deg", &lighting->sun.azimuth_rad);
  sun.ReadOptionalAngle("elevation_deg", &lighting->sun.elevation_rad);
  sun.Check(lighting->sun.elevation_rad > 0.0 && lighting->sun.elevation_rad <= kPi / 2,
            "elevation_deg", "must be above 0 and at most 90");
}

std::optional<GeonLabel> ReadLabel(YamlSection* section, const std::string& key) {
  std::string name;
  section->Read(key, &name);
  const std::optional<GeonLabel> label = GeonLabelFromString(name);
  section->Check(
      label.has_value(), key,
      "must be cuboid, cylinder, ellipsoid, tapered_cuboid, tapered_cylinder, bent_cuboid or "
      "bent_cylinder");
  return label;
}

geons::GeonShape ReadGeon(YamlSection* section) {
  geons::GeonShape shape;
  shape.label = ReadLabel(section, "geon").value_or(GeonLabel::kCuboid);
  // What the file does not say about a tapered or bent geon.
  constexpr double kTaper_1 = 0.4, kBend_deg = 90.0;
  if (geons::IsTapered(shape.label)) shape.taper_1 = kTaper_1;
  if (geons::IsBent(shape.label)) shape.bend_rad = RadiansFromDegrees(kBend_deg);
  section->ReadNumbers("size_m", 3, shape.size_m.data());
  section->ReadOptional("taper", &shape.taper_1);
  section->ReadOptionalAngle("bend_deg", &shape.bend_rad);
  section->ReadOptional("position", &shape.position);
  section->Check(shape.size_m.maxCoeff() <= 2.0, "size_m", "must be at most 2 m");
  const Status valid = geons::Validate(shape);
  section->Check(valid.ok(), "geon", "must be possible: " + valid.message());
  return shape;
}

MeshShape ReadMesh(YamlSection* section, const std::filesystem::path& folder) {
  MeshShape mesh;
  std::string file;
  section->Read("mesh", &file);
  mesh.file = folder / file;
  section->Read("height_m", &mesh.height_m);
  section->Check(mesh.height_m > 0.0 && mesh.height_m <= 2.0, "height_m",
                 "must be above 0 and at most 2 m");
  if (section->Has("truth")) mesh.truth = ReadLabel(section, "truth");
  return mesh;
}

BoxShape ReadBox(YamlSection* section) {
  BoxShape box;
  section->ReadNumbers("box", 3, box.size_m.data());
  section->Check(box.size_m.minCoeff() > 0.0 && box.size_m.maxCoeff() <= 10.0, "box",
                 "must be three lengths above 0 and at most 10 m");
  return box;
}

CylinderShape ReadCylinder(YamlSection* section) {
  CylinderShape cylinder;
  YamlSection child = section->Child("cylinder");
  child.Read("radius_m", &cylinder.radius_m);
  child.Check(cylinder.radius_m > 0.0 && cylinder.radius_m <= 5.0, "radius_m",
              "must be above 0 and at most 5 m");
  child.Read("height_m", &cylinder.height_m);
  child.Check(cylinder.height_m > 0.0 && cylinder.height_m <= 5.0, "height_m",
              "must be above 0 and at most 5 m");
  return cylinder;
}

ChessboardShape ReadChessboard(YamlSection* section) {
  ChessboardShape board;
  YamlSection child = section->Child("chessboard");
  double squares[2] = {0.0, 0.0};
  child.ReadNumbers("squares", 2, squares);
  const auto countable = [](double n) { return n >= 2.0 && n <= 100.0 && n == std::floor(n); };
  child.Check(countable(squares[0]) && countable(squares[1]), "squares",
              "must be two whole numbers from 2 to 100");
  if (countable(squares[0])) board.columns = static_cast<int>(squares[0]);
  if (countable(squares[1])) board.rows = static_cast<int>(squares[1]);
  child.Read("square_m", &board.square_m);
  child.Check(board.square_m >= 0.002 && board.square_m <= 0.5, "square_m",
              "must be from 0.002 to 0.5 m");
  board.margin_m = board.square_m;
  child.ReadOptional("margin_m", &board.margin_m);
  child.Check(board.margin_m >= 0.0 && board.margin_m <= 1.0, "margin_m", "must be from 0 to 1 m");
  section->ReadOptionalAngle("pitch_deg", &board.pitch_rad);
  section->Check(std::abs(board.pitch_rad) <= RadiansFromDegrees(60.0), "pitch_deg",
                 "must be from -60 to 60 degrees");
  return board;
}

// How far the robot's centre must stay from the object's: a geon's or mesh's own size is left out.
bool RobotOverlaps(const World& world, const WorldObject& object) {
  const Eigen::Vector2d robot_m(world.robot_x_m, world.robot_y_m);
  if (std::holds_alternative<BoxShape>(object.shape)) {
    return NearestPointOfConvex(BoxOutline(object), robot_m).distance_m < kRobotRadius_m;
  }
  const auto* cylinder = std::get_if<CylinderShape>(&object.shape);
  const double reach_m = kRobotRadius_m + (cylinder != nullptr ? cylinder->radius_m : 0.0);
  return (Eigen::Vector2d(object.x_m, object.y_m) - robot_m).norm() < reach_m;
}

void ReadObject(YamlSection section, const std::filesystem::path& folder, World* world) {
  WorldObject object;
  const int kinds = (section.Has("geon") ? 1 : 0) + (section.Has("mesh") ? 1 : 0) +
                    (section.Has("box") ? 1 : 0) + (section.Has("cylinder") ? 1 : 0) +
                    (section.Has("chessboard") ? 1 : 0);
  if (kinds != 1) {
    section.Fail("an object has exactly one of the keys geon, mesh, box, cylinder, chessboard");
    for (const std::string& key : section.Keys()) section.Ignore(key);
    return;
  }
  if (section.Has("geon") || section.Has("mesh")) object.color_rgb = {150, 40, 40};
  if (section.Has("chessboard")) object.color_rgb = {235, 235, 235};
  if (section.Has("geon")) object.shape = ReadGeon(&section);
  if (section.Has("mesh")) object.shape = ReadMesh(&section, folder);
  if (section.Has("box")) object.shape = ReadBox(&section);
  if (section.Has("cylinder")) object.shape = ReadCylinder(&section);
  if (section.Has("chessboard")) object.shape = ReadChessboard(&section);
  section.Read("x_m", &object.x_m);
  section.Read("y_m", &object.y_m);
  section.Check(object.x_m >= 0.0 && object.x_m <= world->pen_size_m.x(), "x_m",
                "must lie inside the pen");
  section.Check(object.y_m >= 0.0 && object.y_m <= world->pen_size_m.y(), "y_m",
                "must lie inside the pen");
  if (section.Has("z_m")) {
    double z_m = 0.0;
    section.Read("z_m", &z_m);
    section.Check(z_m >= 0.0 && z_m <= 5.0, "z_m", "must be from 0 to 5 m");
    object.z_m = z_m;
  }
  section.ReadOptionalAngle("yaw_deg", &object.yaw_rad);
  ReadColor(&section, "color_rgb", &object.color_rgb);
  if (section.Has("reflectance")) {
    double reflectance_1 = 0.0;
    section.Read("reflectance", &reflectance_1);
    section.Check(reflectance_1 >= 0.0 && reflectance_1 <= 1.0, "reflectance",
                  "must be from 0 to 1");
    object.reflectance_1 = reflectance_1;
  }
  if (RobotOverlaps(*world, object)) section.Fail("the robot would start inside this object");
  world->objects.push_back(object);
}

Result<World> ReadWorld(const YamlDocument& document, const std::filesystem::path& folder) {
  World world;
  YamlSection root = document.root();
  ReadPen(root.Child("pen"), &world);
  if (root.Has("floor")) ReadFloor(root.Child("floor"), &world);
  ReadRobot(root.Child("robot"), &world);
  if (root.Has("light")) ReadLight(root.Child("light"), &world.lighting);
  world.lighting.lamp_W_m.head<2>() = 0.5 * world.pen_size_m;
  for (const YamlSection& object : root.Children("objects")) ReadObject(object, folder, &world);
  const Status status = document.Finish();
  if (!status.ok()) return status;
  return world;
}

}  // namespace

Result<World> LoadWorld(const std::filesystem::path& file) {
  const Result<YamlDocument> document = YamlDocument::Load(file);
  if (!document.ok()) return document.status();
  return ReadWorld(*document, file.parent_path());
}

Result<World> ParseWorld(const std::string& text, const std::string& name,
                         const std::filesystem::path& folder) {
  const Result<YamlDocument> document = YamlDocument::Parse(text, name);
  if (!document.ok()) return document.status();
  return ReadWorld(*document, folder);
}

}  // namespace geon::sim
