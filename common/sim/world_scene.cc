#include "sim/world_scene.h"

#include <tiny_obj_loader.h>

#include <array>
#include <string>
#include <utility>

#include "base/angles.h"
#include "geons/geon_mesh.h"

namespace geon::sim {
namespace {

using geometry::MakeTransform;
using geons::TriangleMesh;

constexpr double kWallThickness_m = 0.02;
constexpr double kFloorBeyondPen_m = 8.0;
const Eigen::Vector3d kWallColor_rgb(198, 200, 205);  // white plastic boards

TriangleMesh BoxMesh(const Eigen::Vector3d& size_m) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.vertices_m.emplace_back(size_m.x() * ((corner & 1) != 0 ? 0.5 : -0.5),
                                 size_m.y() * ((corner & 2) != 0 ? 0.5 : -0.5),
                                 size_m.z() * ((corner & 4) != 0 ? 1.0 : 0.0));
  }
  for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1},
                                   {4, 5, 7, 6},
                                   {0, 1, 5, 4},
                                   {2, 6, 7, 3},
                                   {0, 4, 6, 2},
                                   {1, 3, 7, 5}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  }
  return geons::WithFaceNormals(mesh, RadiansFromDegrees(30.0));
}

Body FloorBody(const World& world) {
  Body floor;
  floor.name = "floor";
  floor.obstacle = false;
  const Eigen::Vector2d far_m = world.pen_size_m.array() + kFloorBeyondPen_m;
  for (const Eigen::Vector2d& p : {Eigen::Vector2d(-kFloorBeyondPen_m, -kFloorBeyondPen_m),
                                   Eigen::Vector2d(far_m.x(), -kFloorBeyondPen_m), far_m,
                                   Eigen::Vector2d(-kFloorBeyondPen_m, far_m.y())}) {
    floor.surface_W.vertices_m.emplace_back(p.x(), p.y(), 0.0);
    floor.surface_W.normals.emplace_back(Eigen::Vector3d::UnitZ());
  }
  floor.surface_W.triangles = {{0, 1, 2}, {0, 2, 3}};
  floor.material = Paint(world.floor_color_rgb);
  floor.material.tile_m = static_cast<float>(world.floor_tile_m);
  floor.material.mirror_1 = static_cast<float>(world.floor_gloss_1);
  return floor;
}

// The boards stand round the pen; their inner faces are its sides.
void AddWalls(const World& world, std::vector<Body>* bodies) {
  const double x_m = world.pen_size_m.x(), y_m = world.pen_size_m.y();
  const double half_m = 0.5 * kWallThickness_m;
  const Eigen::Vector3d along_x(x_m + 2 * kWallThickness_m, kWallThickness_m, world.wall_height_m);
  const Eigen::Vector3d along_y(kWallThickness_m, y_m, world.wall_height_m);
  const std::array<std::pair<Eigen::Vector3d, Eigen::Vector2d>, 4> walls = {
      std::pair{along_x, Eigen::Vector2d(0.5 * x_m, -half_m)},
      {along_x, Eigen::Vector2d(0.5 * x_m, y_m + half_m)},
      {along_y, Eigen::Vector2d(-half_m, 0.5 * y_m)},
      {along_y, Eigen::Vector2d(x_m + half_m, 0.5 * y_m)}};
  for (const auto& [size_m, middle_m] : walls) {
    Body wall;
    wall.name = "wall";
    wall.surface_W = BoxMesh(size_m);
    geons::Transform(geometry::PlanarPose(middle_m.x(), middle_m.y(), 0.0), &wall.surface_W);
    wall.material = Paint(kWallColor_rgb);
    bodies->push_back(std::move(wall));
  }
}

Eigen::Vector2d SizeOf(const ChessboardShape& board) {
  const Eigen::Vector2d squares(board.columns, board.rows);
  return (squares * board.square_m).array() + 2.0 * board.margin_m;
}

// X_WO of a chessboard's front: x towards the viewer, y to his right, z up along the board, origin
// in the middle of the lower edge.
geometry::RigidTransform FrontOf(const World& world, const WorldObject& object) {
  geometry::RigidTransform X_WO = geometry::PlanarPose(object.x_m, object.y_m, object.yaw_rad);
  X_WO.translation().z() = FootHeight(world, object);
  return X_WO * geometry::MakeTransform(
                    geometry::RotationAboutY(-std::get<ChessboardShape>(object.shape).pitch_rad),
                    {0, 0, 0});
}

// The printed sheet; its plate, which is an object like others, lies behind it.
Body ChessboardSheet(const World& world, const WorldObject& object) {
  const auto& board = std::get<ChessboardShape>(object.shape);
  const geometry::RigidTransform X_WO = FrontOf(world, object);
  const Eigen::Vector2d size_m = SizeOf(board);
  Body sheet;
  sheet.name = "chessboard";
  sheet.obstacle = false;
  for (const auto& [y_1, z_1] : {std::pair{-0.5, 0.0}, {0.5, 0.0}, {0.5, 1.0}, {-0.5, 1.0}}) {
    sheet.surface_W.vertices_m.push_back(X_WO *
                                         Eigen::Vector3d(0, y_1 * size_m.x(), z_1 * size_m.y()));
    sheet.surface_W.normals.push_back(X_WO.linear().col(0));
  }
  sheet.surface_W.triangles = {{0, 1, 2}, {0, 2, 3}};
  sheet.material = Paint(object.color_rgb, object.reflectance_1);
  sheet.material.gloss_1 = 0.0F;  // printed matt, as for any calibration
  Checks checks;
  checks.corner_W_m = X_WO * Eigen::Vector3d(0, board.margin_m - 0.5 * size_m.x(), board.margin_m);
  checks.along_W = X_WO.linear().col(1);
  checks.up_W = X_WO.linear().col(2);
  checks.columns = board.columns;
  checks.rows = board.rows;
  checks.square_m = board.square_m;
  sheet.material.checks = checks;
  return sheet;
}

TriangleMesh ChessboardPlate(const ChessboardShape& board) {
  constexpr double kThickness_m = 0.008, kBehindSheet_m = 0.0005;
  const Eigen::Vector2d size_m = SizeOf(board);
  TriangleMesh plate = BoxMesh({kThickness_m, size_m.x(), size_m.y()});
  geons::Transform(geometry::MakeTransform(Eigen::Matrix3d::Identity(),
                                           {-0.5 * kThickness_m - kBehindSheet_m, 0, 0}),
                   &plate);
  return plate;
}

Result<TriangleMesh> UprightMesh(const WorldObject& object,
                                 const geons::MeshResolution& geon_mesh) {
  if (const auto* shape = std::get_if<geons::GeonShape>(&object.shape)) {
    return geons::GeonMesh(*shape, geon_mesh);
  }
  if (const auto* box = std::get_if<BoxShape>(&object.shape)) return BoxMesh(box->size_m);
  if (const auto* board = std::get_if<ChessboardShape>(&object.shape)) {
    return ChessboardPlate(*board);
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&object.shape)) {
    geons::GeonShape shape;
    shape.label = GeonLabel::kCylinder;
    shape.size_m = {2 * cylinder->radius_m, 2 * cylinder->radius_m, cylinder->height_m};
    return geons::GeonMesh(shape, {128, 32});
  }
  const auto& mesh_shape = std::get<MeshShape>(object.shape);
  Result<TriangleMesh> mesh = LoadObj(mesh_shape.file);
  if (!mesh.ok()) return mesh;
  const double height_m = geons::Bounds(*mesh).sizes().z();
  if (!(height_m > 0.0))
    return Status::Error(mesh_shape.file.string() + ": the mesh has no height");
  for (Eigen::Vector3d& p : mesh->vertices_m) p *= mesh_shape.height_m / height_m;
  geons::StandOnGround(&*mesh);
  return mesh;
}

}  // namespace

Result<TriangleMesh> LoadObj(const std::filesystem::path& file) {
  tinyobj::ObjReader reader;
  tinyobj::ObjReaderConfig options;
  options.triangulate = true;
  if (!reader.ParseFromFile(file.string(), options)) {
    return Status::Error(file.string() + ": cannot read this mesh (Wavefront OBJ is expected)");
  }
  TriangleMesh mesh;
  const std::vector<tinyobj::real_t>& coordinates = reader.GetAttrib().vertices;
  for (size_t k = 0; k + 2 < coordinates.size(); k += 3) {
    mesh.vertices_m.emplace_back(coordinates[k], coordinates[k + 1], coordinates[k + 2]);
  }
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    const auto& indices = shape.mesh.indices;
    for (size_t k = 0; k + 2 < indices.size(); k += 3) {
      mesh.triangles.push_back(
          {indices[k].vertex_index, indices[k + 1].vertex_index, indices[k + 2].vertex_index});
      for (int corner : mesh.triangles.back()) {
        if (corner < 0 || static_cast<size_t>(corner) >= mesh.vertices_m.size()) {
          return Status::Error(file.string() + ": a face uses a vertex that is not there");
        }
      }
    }
  }
  mesh = geons::WithFaceNormals(mesh, RadiansFromDegrees(35.0));
  if (mesh.triangles.empty()) return Status::Error(file.string() + ": the mesh has no faces");
  return mesh;
}

Result<TriangleMesh> ObjectMesh(const World& world, const WorldObject& object,
                                const geons::MeshResolution& geon_mesh) {
  Result<TriangleMesh> mesh = UprightMesh(object, geon_mesh);
  if (!mesh.ok()) return mesh;
  geometry::RigidTransform X_WO = geometry::PlanarPose(object.x_m, object.y_m, object.yaw_rad);
  X_WO.translation().z() = FootHeight(world, object);
  if (std::holds_alternative<ChessboardShape>(object.shape)) X_WO = FrontOf(world, object);
  geons::Transform(X_WO, &*mesh);
  return mesh;
}

Result<std::shared_ptr<const Scene>> BuildScene(const World& world,
                                                const geons::MeshResolution& geon_mesh) {
  std::vector<Body> bodies = {FloorBody(world)};
  AddWalls(world, &bodies);
  for (const WorldObject& object : world.objects) {
    Result<TriangleMesh> mesh = ObjectMesh(world, object, geon_mesh);
    if (!mesh.ok()) return mesh.status();
    Body body;
    const std::optional<GeonLabel> label = TrueLabel(object);
    const bool is_mesh = std::holds_alternative<MeshShape>(object.shape);
    body.name = label ? std::string(ToString(*label)) : is_mesh ? "mesh" : "box";
    body.surface_W = std::move(*mesh);
    body.material = Paint(object.color_rgb, object.reflectance_1);
    bodies.push_back(std::move(body));
    if (std::holds_alternative<ChessboardShape>(object.shape)) {
      bodies.push_back(ChessboardSheet(world, object));
    }
  }
  return std::shared_ptr<const Scene>(std::make_shared<Scene>(std::move(bodies), world.lighting));
}

}  // namespace geon::sim
