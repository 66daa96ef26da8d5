#include "geons/polygon_geon.h"

#include <gtest/gtest.h>

#include "base/angles.h"
#include "base/contracts.h"
#include "geons/geon_mesh.h"

namespace geon::geons {
namespace {

GeonShape Example(GeonLabel label, int position) {
  GeonShape shape{label, {0.16, 0.12, 0.24}, 0.0, 0.0, position};
  if (IsTapered(label)) shape.taper_1 = 0.4;
  if (IsBent(label)) {
    shape.size_m = {0.08, 0.08, 0.30};
    shape.bend_rad = RadiansFromDegrees(120);
  }
  return shape;
}

// The two generators know nothing of each other: where they agree, both are right.
TEST(PolygonGeon, HasTheVolumeAndBoundsOfTheSuperquadricOfTheSameNumbers) {
  for (int l = 0; l < kGeonLabelCount; ++l) {
    const auto label = static_cast<GeonLabel>(l);
    for (int position = 1; position <= StablePositionCount(label); ++position) {
      const GeonShape shape = Example(label, position);
      SCOPED_TRACE(std::string(ToString(label)) + " " + std::to_string(position));
      const TriangleMesh polygon = PolygonGeon(shape, 48);
      const TriangleMesh smooth = GeonMesh(shape, {128, 96});
      EXPECT_NEAR(Volume(polygon) / Volume(smooth), 1.0, 0.02);
      const Eigen::Vector3d difference_m = Bounds(polygon).sizes() - Bounds(smooth).sizes();
      EXPECT_LT(difference_m.cwiseAbs().maxCoeff(), 2.5e-3);
      EXPECT_NEAR(Bounds(polygon).min().z(), 0.0, 1e-12);
    }
  }
}

TEST(PolygonGeon, ACuboidIsABoxOfTwelveTrianglesWithFlatNormals) {
  const TriangleMesh box = PolygonGeon(Example(GeonLabel::kCuboid, 1), 48);
  EXPECT_EQ(box.triangles.size(), 12U);
  EXPECT_NEAR(Volume(box), 0.16 * 0.12 * 0.24, 1e-12);
  for (const Eigen::Vector3d& normal : box.normals) {
    EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1.0, 1e-12);
  }
}

TEST(PolygonGeon, APrismHasTheAreaOfItsCircleWhateverItsSides) {
  const GeonShape shape{GeonLabel::kCylinder, {0.1, 0.1, 0.2}, 0.0, 0.0, 1};
  for (int sides : {6, 17, 64}) {
    EXPECT_NEAR(Volume(PolygonGeon(shape, sides)), kPi * 0.05 * 0.05 * 0.2, 1e-9);
  }
}

TEST(PolygonGeon, ImpossibleShapesAreContractViolations) {
  EXPECT_THROW(PolygonGeon(Example(GeonLabel::kCuboid, 4), 48), ContractViolation);
  EXPECT_THROW(PolygonGeon(Example(GeonLabel::kCylinder, 1), 5), ContractViolation);
}

TEST(PolygonVessel, IsHollow) {
  GeonShape cup{GeonLabel::kTaperedCylinder, {0.1, 0.1, 0.12}, 0.2};
  for (int position : {1, 3}) {
    cup.position = position;
    const TriangleMesh vessel = PolygonVessel(cup, 0.1, 48);
    EXPECT_GT(Volume(vessel), 0.0);
    EXPECT_LT(Volume(vessel), 0.4 * Volume(PolygonGeon(cup, 48)));
    EXPECT_NEAR(Bounds(vessel).sizes().z(), 0.12, 1e-12);
  }
}

TEST(PolygonVessel, RefusesWhatCannotBeOpen) {
  const GeonShape ball{GeonLabel::kEllipsoid, {0.1, 0.1, 0.1}};
  EXPECT_THROW(PolygonVessel(ball, 0.1, 48), ContractViolation);
  const GeonShape box{GeonLabel::kCuboid, {0.1, 0.1, 0.1}};
  EXPECT_THROW(PolygonVessel(box, 1.0, 48), ContractViolation);
}

}  // namespace
}  // namespace geon::geons
