#include "geons/triangle_mesh.h"

#include <gtest/gtest.h>

#include "base/angles.h"

namespace geon::geons {
namespace {

TriangleMesh Tetrahedron() {
  TriangleMesh mesh;
  mesh.vertices_m = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

TEST(TriangleMeshTest, TetrahedronIsClosedAndHasASixth) {
  EXPECT_TRUE(IsClosed(Tetrahedron()));
  EXPECT_NEAR(Volume(Tetrahedron()), 1.0 / 6.0, 1e-12);
}

TEST(TriangleMeshTest, MissingOrFlippedFaceIsNotClosed) {
  TriangleMesh open = Tetrahedron();
  open.triangles.pop_back();
  EXPECT_FALSE(IsClosed(open));
  TriangleMesh flipped = Tetrahedron();
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  EXPECT_FALSE(IsClosed(flipped));
  EXPECT_FALSE(IsClosed(TriangleMesh{}));
}

TEST(TriangleMeshTest, StandsOnTheGroundUnderItsMiddle) {
  TriangleMesh mesh = Tetrahedron();
  Transform(geometry::MakeTransform(Eigen::Matrix3d::Identity(), {3, -2, -5}), &mesh);
  StandOnGround(&mesh);
  const Eigen::AlignedBox3d bounds = Bounds(mesh);
  EXPECT_NEAR(bounds.min().z(), 0.0, 1e-12);
  EXPECT_NEAR(bounds.center().head<2>().norm(), 0.0, 1e-12);
}

TEST(TriangleMeshTest, NormalsAreSplitAtCreasesAndSharedBelow) {
  const TriangleMesh split = WithFaceNormals(Tetrahedron(), RadiansFromDegrees(30));
  ASSERT_EQ(split.vertices_m.size(), 12u);
  EXPECT_NEAR((split.normals[0] - Eigen::Vector3d(0, 0, -1)).norm(), 0.0, 1e-12);
  const TriangleMesh shared = WithFaceNormals(Tetrahedron(), kPi);
  EXPECT_GT(shared.normals[0].dot(Eigen::Vector3d(-1, -1, -1)), 0.9);
}

}  // namespace
}  // namespace geon::geons
