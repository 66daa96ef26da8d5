#include "geons/triangle_mesh.h"

#include <cmath>
#include <map>
#include <utility>

namespace geon::geons {

Eigen::AlignedBox3d Bounds(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d bounds;
  for (const Eigen::Vector3d& p : mesh.vertices_m) bounds.extend(p);
  return bounds;
}

double Volume(const TriangleMesh& mesh) {
  double six_volumes_m3 = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto& v = mesh.vertices_m;
    six_volumes_m3 +=
        v[static_cast<size_t>(a)].dot(v[static_cast<size_t>(b)].cross(v[static_cast<size_t>(c)]));
  }
  return six_volumes_m3 / 6.0;
}

bool IsClosed(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& corners : mesh.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      if (++uses[{corners[k], corners[(k + 1) % 3]}] > 1) return false;
    }
  }
  for (const auto& [edge, count] : uses) {
    if (!uses.contains({edge.second, edge.first})) return false;
  }
  return !mesh.triangles.empty();
}

void Transform(const geometry::RigidTransform& X_AB, TriangleMesh* mesh) {
  for (Eigen::Vector3d& p : mesh->vertices_m) p = X_AB * p;
  for (Eigen::Vector3d& n : mesh->normals) n = X_AB.linear() * n;
}

void StandOnGround(TriangleMesh* mesh) {
  const Eigen::AlignedBox3d bounds = Bounds(*mesh);
  const Eigen::Vector3d middle = bounds.center();
  const Eigen::Vector3d foot(middle.x(), middle.y(), bounds.min().z());
  for (Eigen::Vector3d& p : mesh->vertices_m) p -= foot;
}

TriangleMesh WithFaceNormals(const TriangleMesh& mesh, double crease_rad) {
  std::vector<Eigen::Vector3d> face(mesh.triangles.size());  // length: twice the area
  std::vector<std::vector<size_t>> faces_at(mesh.vertices_m.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Eigen::Vector3d& p = mesh.vertices_m[static_cast<size_t>(a)];
    face[t] = (mesh.vertices_m[static_cast<size_t>(b)] - p)
                  .cross(mesh.vertices_m[static_cast<size_t>(c)] - p);
    for (int corner : mesh.triangles[t]) faces_at[static_cast<size_t>(corner)].push_back(t);
  }
  TriangleMesh result;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!(face[t].norm() > 0.0)) continue;
    std::array<int, 3> corners{};
    for (size_t k = 0; k < 3; ++k) {
      const auto vertex = static_cast<size_t>(mesh.triangles[t][k]);
      Eigen::Vector3d normal = Eigen::Vector3d::Zero();
      for (size_t other : faces_at[vertex]) {
        const double cosine =
            face[t].dot(face[other]) / std::max(1e-300, face[t].norm() * face[other].norm());
        if (cosine >= std::cos(crease_rad)) normal += face[other];
      }
      corners[k] = static_cast<int>(result.vertices_m.size());
      result.vertices_m.push_back(mesh.vertices_m[vertex]);
      result.normals.push_back(normal.normalized());
    }
    result.triangles.push_back(corners);
  }
  return result;
}

}  // namespace geon::geons
