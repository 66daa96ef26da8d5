#include "sim/facets.h"

#include <gtest/gtest.h>

#include "tests/common/sim/scene_testing.h"

namespace geon::sim {
namespace {

TEST(FacetsTest, OnlyBodiesOfFlatFacesWithoutHollowsAreConvexPolyhedra) {
  const auto scene = SceneFrom(
      "  - {box: [0.4, 0.4, 0.3], x_m: 1.5, y_m: 2.0, yaw_deg: 20}\n"
      "  - {geon: bent_cuboid, size_m: [0.08, 0.1, 0.3], x_m: 1.5, y_m: 2.0}\n"
      "  - {cylinder: {radius_m: 0.1, height_m: 0.3}, x_m: 1.5, y_m: 3.0}\n");
  const auto& parts = scene->facets().parts();
  ASSERT_EQ(parts.size(), 8u);  // floor, four walls, and these
  for (size_t k = 0; k < 6; ++k) EXPECT_TRUE(parts[k].convex_polyhedron) << k;
  EXPECT_FALSE(parts[6].convex_polyhedron);
  EXPECT_FALSE(parts[7].convex_polyhedron);
}

TEST(FacetsTest, TwoBoxesInOneBodyAreNotConvex) {
  const geons::TriangleMesh box =
      SceneFrom("  - {box: [0.4, 0.4, 0.3], x_m: 1.5, y_m: 2.0}\n")->bodies().back().surface_W;
  geons::TriangleMesh two = box;
  const int corners = static_cast<int>(box.vertices_m.size());
  for (const Eigen::Vector3d& p : box.vertices_m)
    two.vertices_m.emplace_back(p.x() + 1.0, p.y(), p.z());
  two.normals.insert(two.normals.end(), box.normals.begin(), box.normals.end());
  for (const auto& [a, b, c] : box.triangles) {
    two.triangles.push_back({a + corners, b + corners, c + corners});
  }
  Facets facets;
  facets.Append(box);
  facets.Append(two);
  EXPECT_TRUE(facets.parts()[0].convex_polyhedron);
  EXPECT_FALSE(facets.parts()[1].convex_polyhedron);
  // Numbers go on from body to body.
  const Facets::Part& part = facets.parts()[1];
  EXPECT_EQ(part.first_facet, 12);
  EXPECT_EQ(part.end_facet, 36);
  EXPECT_EQ(part.first_corner, corners);
  const Facets::Facet& last = facets.facets()[35];
  EXPECT_EQ(last.body, 1);
  const Eigen::Vector3d p = facets.corners_W_m()[static_cast<size_t>(last.corners[2])];
  const Eigen::Vector3d expected = two.vertices_m[static_cast<size_t>(two.triangles[23][2])];
  EXPECT_LT((p - expected).norm(), 1e-6);
  EXPECT_NEAR(part.bounds_W_m.sizes().x(), 1.4, 1e-6);
}

}  // namespace
}  // namespace geon::sim
