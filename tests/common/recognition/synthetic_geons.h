#pragma once

#include <random>
#include <vector>

#include "geons/geon_mesh.h"
#include "tests/common/recognition/synthetic_scan.h"

namespace geon::recognition {

// Distance along a ray to a mesh of few triangles, by trying them all (Moeller and Trumbore 1997).
class MeshCaster {
 public:
  explicit MeshCaster(const geons::TriangleMesh& mesh) {
    for (const auto& t : mesh.triangles) {
      const Eigen::Vector3d& a = mesh.vertices_m[static_cast<size_t>(t[0])];
      corners_.push_back({a, mesh.vertices_m[static_cast<size_t>(t[1])] - a,
                          mesh.vertices_m[static_cast<size_t>(t[2])] - a});
      for (const int i : t) {
        radius_m_ = std::max(radius_m_, mesh.vertices_m[static_cast<size_t>(i)].norm());
      }
    }
  }

  std::optional<double> operator()(const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& direction) const {
    if (from.cross(direction).norm() > radius_m_) return std::nullopt;  // passes the object
    std::optional<double> nearest_m;
    for (const Corner& c : corners_) {
      const Eigen::Vector3d p = direction.cross(c.ac);
      const double det = c.ab.dot(p);
      if (std::abs(det) < 1e-15) continue;
      const Eigen::Vector3d t = from - c.a;
      const double u = t.dot(p) / det;
      if (u < 0.0 || u > 1.0) continue;
      const Eigen::Vector3d q = t.cross(c.ab);
      const double v = direction.dot(q) / det;
      if (v < 0.0 || u + v > 1.0) continue;
      const double distance_m = c.ac.dot(q) / det;
      if (distance_m > 1e-6 && (!nearest_m || distance_m < *nearest_m)) nearest_m = distance_m;
    }
    return nearest_m;
  }

 private:
  struct Corner {
    Eigen::Vector3d a, ab, ac;
  };
  std::vector<Corner> corners_;
  double radius_m_ = 0.0;
};

// The scan of a geon turned by `yaw_rad`.
inline std::optional<sensor::ScanSet> ScanOfGeon(const geons::GeonShape& shape, double yaw_rad,
                                                 const SyntheticView& view, uint64_t seed) {
  geons::TriangleMesh mesh = geons::GeonMesh(shape, {24, 16});
  geons::Transform(
      geometry::MakeTransform(geometry::RotationAboutZ(yaw_rad), Eigen::Vector3d::Zero()), &mesh);
  std::mt19937_64 random(seed);
  return MakeSyntheticScan(MeshCaster(mesh), mesh.vertices_m, view, random);
}

// One of each, in shapes that show their nature; by label.
inline std::vector<geons::GeonShape> PlainGeons() {
  const double bend_rad = RadiansFromDegrees(110.0);
  return {{GeonLabel::kCuboid, {0.18, 0.14, 0.15}, 0.0, 0.0, 1},
          {GeonLabel::kCylinder, {0.16, 0.16, 0.18}, 0.0, 0.0, 1},
          {GeonLabel::kEllipsoid, {0.18, 0.18, 0.18}, 0.0, 0.0, 1},
          {GeonLabel::kTaperedCuboid, {0.18, 0.18, 0.18}, 0.5, 0.0, 1},
          {GeonLabel::kTaperedCylinder, {0.18, 0.18, 0.18}, 0.5, 0.0, 1},
          {GeonLabel::kBentCuboid, {0.08, 0.09, 0.36}, 0.0, bend_rad, 2},
          {GeonLabel::kBentCylinder, {0.08, 0.08, 0.36}, 0.0, bend_rad, 1}};
}

struct RandomScan {
  sensor::ScanSet scan;
  GeonLabel label = GeonLabel::kCuboid;
};

// `count` scans of each geon: random size, deformation, stable position and yaw, seen as the robot
// sees them: at 25 degrees from 1.05 m or at 50 degrees from 1.5 m, and some in between.
inline std::vector<RandomScan> RandomScans(int count, uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<RandomScan> scans;
  for (int l = 0; l < kGeonLabelCount; ++l) {
    for (int found = 0; found < count;) {
      geons::GeonShape shape;
      shape.label = static_cast<GeonLabel>(l);
      shape.position = 1 + static_cast<int>(uniform(0, geons::StablePositionCount(shape.label)));
      if (geons::IsBent(shape.label)) {
        shape.size_m = {uniform(.05, .11), uniform(.05, .12), uniform(.25, .45)};
        shape.bend_rad = RadiansFromDegrees(uniform(60, 170));
      } else {
        shape.size_m = {uniform(.11, .22), uniform(.11, .22), uniform(.11, .20)};
      }
      if (geons::IsTapered(shape.label)) shape.taper_1 = uniform(.2, .75);
      const bool round_section =
          geons::IsRound(shape.label) && shape.label != GeonLabel::kEllipsoid;
      if (round_section) shape.size_m.y() = shape.size_m.x();
      if (!geons::Validate(shape).ok()) continue;
      SyntheticView view;
      if (found % 2 == 0) {
        view.range_m = 1.05;
        view.elevation_rad = RadiansFromDegrees(uniform(22, 29));
      } else {
        view.range_m = 1.5;
        view.elevation_rad = RadiansFromDegrees(uniform(46, 53));
      }
      const auto scan = ScanOfGeon(shape, uniform(0, 2 * kPi), view, random());
      if (!scan) continue;
      scans.push_back({*scan, shape.label});
      ++found;
    }
  }
  return scans;
}

}  // namespace geon::recognition
