#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/geon_label.h"
#include "geons/geon_shape.h"
#include "sim/lighting.h"

namespace geon::sim {

struct MeshShape {
  std::filesystem::path file;  // Wavefront OBJ, z up
  double height_m = 0.2;       // scaled uniformly to this height
  std::optional<GeonLabel> truth;
};
struct BoxShape {
  Eigen::Vector3d size_m = Eigen::Vector3d::Constant(0.5);
};
struct CylinderShape {
  double radius_m = 0.1;
  double height_m = 1.0;
};
// A board that stands on its lower edge and faces along the x axis of the object.
struct ChessboardShape {
  int columns = 9;  // squares
  int rows = 7;
  double square_m = 0.03;
  double margin_m = 0.03;  // white, all round
  double pitch_rad = 0.0;  // how far it leans back
};

struct WorldObject {
  std::variant<geons::GeonShape, MeshShape, BoxShape, CylinderShape, ChessboardShape> shape;
  double x_m = 0.0;
  double y_m = 0.0;
  std::optional<double>
      z_m;  // of its foot; else the floor, or the top of the box below a geon or mesh
  double yaw_rad = 0.0;
  Eigen::Vector3d color_rgb = Eigen::Vector3d(90, 90, 120);  // as seen in full light, 0 to 255
  std::optional<double> reflectance_1;  // at the lasers' 670 nm; else from the colour
};

// What a world file says (docs/worlds.md). The pen's corner is the origin of W; x runs along its
// first side.
struct World {
  Eigen::Vector2d pen_size_m = Eigen::Vector2d(3.0, 4.5);
  double wall_height_m = 0.65;
  Eigen::Vector3d floor_color_rgb = Eigen::Vector3d(150, 150, 140);
  double floor_tile_m = 0.6;
  double floor_gloss_1 = 0.0;    // share of the lamp's light that the floor mirrors; 0: matt
  double groove_tilt_rad = 0.0;  // how far the robot tilts with one wheel in a groove between tiles
  double robot_x_m = 0.5;
  double robot_y_m = 0.5;
  double robot_heading_rad = 0.0;
  Lighting lighting;
  std::vector<WorldObject> objects;
};

inline constexpr double kRobotRadius_m = 0.267;
inline constexpr double kDeskHeight_m = 0.7;  // "desk of known height" (thesis 6.3)

// The height an object stands at.
double FootHeight(const World& world, const WorldObject& object);

// The shape's name if it is a geon, or a mesh that is said to be one.
std::optional<GeonLabel> TrueLabel(const WorldObject& object);

// Whether it is what the robot looks for: a geon, or a mesh.
bool IsTarget(const WorldObject& object);

// The target nearest to a place, from above; nullptr in a world without any.
const WorldObject* NearestTarget(const World& world, const Eigen::Vector2d& place_m);

// Corners of a box from above, counter-clockwise.
std::vector<Eigen::Vector2d> BoxOutline(const WorldObject& box);

}  // namespace geon::sim
