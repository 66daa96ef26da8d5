#include "sim/world.h"

#include <algorithm>
#include <limits>

#include "base/contracts.h"
#include "geometry/rigid_transform.h"
#include "sim/footprint.h"

namespace geon::sim {

std::vector<Eigen::Vector2d> BoxOutline(const WorldObject& box) {
  const auto* shape = std::get_if<BoxShape>(&box.shape);
  Require(shape != nullptr, "BoxOutline: not a box");
  const geometry::RigidTransform X_WO = geometry::PlanarPose(box.x_m, box.y_m, box.yaw_rad);
  const Eigen::Vector3d half_m = 0.5 * shape->size_m;
  std::vector<Eigen::Vector2d> outline;
  for (const Eigen::Vector2d& sign : {Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, -1),
                                      Eigen::Vector2d(1, 1), Eigen::Vector2d(-1, 1)}) {
    const Eigen::Vector3d corner =
        X_WO * Eigen::Vector3d(sign.x() * half_m.x(), sign.y() * half_m.y(), 0.0);
    outline.emplace_back(corner.head<2>());
  }
  return outline;
}

double FootHeight(const World& world, const WorldObject& object) {
  if (object.z_m) return *object.z_m;
  if (!IsTarget(object)) return 0.0;
  double height_m = 0.0;
  for (const WorldObject& other : world.objects) {
    const auto* box = std::get_if<BoxShape>(&other.shape);
    if (box == nullptr) continue;
    if (NearestPointOfConvex(BoxOutline(other), {object.x_m, object.y_m}).distance_m < 0.0) {
      height_m = std::max(height_m, other.z_m.value_or(0.0) + box->size_m.z());
    }
  }
  return height_m;
}

bool IsTarget(const WorldObject& object) {
  return std::holds_alternative<geons::GeonShape>(object.shape) ||
         std::holds_alternative<MeshShape>(object.shape);
}

std::optional<GeonLabel> TrueLabel(const WorldObject& object) {
  if (const auto* shape = std::get_if<geons::GeonShape>(&object.shape)) return shape->label;
  if (const auto* mesh = std::get_if<MeshShape>(&object.shape)) return mesh->truth;
  return std::nullopt;
}

const WorldObject* NearestTarget(const World& world, const Eigen::Vector2d& place_m) {
  const auto distance_m = [&](const WorldObject& object) {
    return IsTarget(object) ? (Eigen::Vector2d(object.x_m, object.y_m) - place_m).norm()
                            : std::numeric_limits<double>::infinity();
  };
  const auto nearest =
      std::min_element(world.objects.begin(), world.objects.end(),
                       [&](const auto& a, const auto& b) { return distance_m(a) < distance_m(b); });
  return nearest != world.objects.end() && IsTarget(*nearest) ? &*nearest : nullptr;
}

}  // namespace geon::sim
