#include "geons/geon_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "base/contracts.h"

namespace geon::geons {
namespace {

GeonShape ExampleMesh(GeonLabel label, int position) {
  GeonShape shape{label, {0.16, 0.12, 0.24}, 0.0, 0.0, position};
  if (IsTapered(label)) shape.taper_1 = 0.4;
  if (IsBent(label)) {
    shape.size_m = {0.08, 0.08, 0.30};
    shape.bend_rad = RadiansFromDegrees(120);
  }
  return shape;
}

TEST(GeonMeshTest, EveryGeonInEveryPositionIsClosedAndStandsOnTheGround) {
  for (int label = 0; label < kGeonLabelCount; ++label) {
    for (int position = 1; position <= StablePositionCount(static_cast<GeonLabel>(label));
         ++position) {
      const GeonShape shape = ExampleMesh(static_cast<GeonLabel>(label), position);
      SCOPED_TRACE(std::string(ToString(shape.label)) + " " + std::to_string(position));
      const TriangleMesh mesh = GeonMesh(shape);
      EXPECT_TRUE(IsClosed(mesh));
      EXPECT_GT(Volume(mesh), 0.0);
      const Eigen::AlignedBox3d bounds = Bounds(mesh);
      EXPECT_NEAR(bounds.min().z(), 0.0, 1e-12);
      EXPECT_NEAR(bounds.center().head<2>().norm(), 0.0, 1e-12);
    }
  }
}

TEST(GeonMeshTest, VolumesAreThoseOfTheIdealBodies) {
  const double box_m3 = 0.16 * 0.12 * 0.24;
  EXPECT_NEAR(Volume(GeonMesh(ExampleMesh(GeonLabel::kCuboid, 1))), box_m3, 0.01 * box_m3);
  EXPECT_NEAR(Volume(GeonMesh(ExampleMesh(GeonLabel::kCylinder, 1))), kPi / 4 * box_m3,
              0.01 * box_m3);
  EXPECT_NEAR(Volume(GeonMesh(ExampleMesh(GeonLabel::kEllipsoid, 1))), kPi / 6 * box_m3,
              0.005 * box_m3);
  // Frustum: the mean of 1, q and q^2, with q the ratio of the ends.
  const double q = 0.6 / 1.4;
  const double frustum = (1 + q + q * q) / 3;
  EXPECT_NEAR(Volume(GeonMesh(ExampleMesh(GeonLabel::kTaperedCuboid, 2))), frustum * box_m3,
              0.01 * box_m3);
  EXPECT_NEAR(Volume(GeonMesh(ExampleMesh(GeonLabel::kTaperedCylinder, 3))),
              kPi / 4 * frustum * box_m3, 0.01 * box_m3);
  const double bar_m3 = 0.08 * 0.08 * 0.30;
  EXPECT_NEAR(Volume(GeonMesh(ExampleMesh(GeonLabel::kBentCuboid, 1))), bar_m3, 0.01 * bar_m3);
  EXPECT_NEAR(Volume(GeonMesh(ExampleMesh(GeonLabel::kBentCylinder, 2))), kPi / 4 * bar_m3,
              0.01 * bar_m3);
}

TEST(GeonMeshTest, SizesAreKeptInTheUprightPosition) {
  for (GeonLabel label : {GeonLabel::kCuboid, GeonLabel::kCylinder, GeonLabel::kEllipsoid,
                          GeonLabel::kTaperedCuboid, GeonLabel::kTaperedCylinder}) {
    const Eigen::Vector3d sizes_m = Bounds(GeonMesh(ExampleMesh(label, 1))).sizes();
    EXPECT_NEAR((sizes_m - Eigen::Vector3d(0.16, 0.12, 0.24)).cwiseAbs().maxCoeff(), 0.0, 1.5e-3);
  }
}

// Width along x of the slice within 5 mm of the given height.
double WidthAt(const TriangleMesh& mesh, double z_m) {
  double low_m = 1e9, high_m = -1e9;
  for (const Eigen::Vector3d& p : mesh.vertices_m) {
    if (std::abs(p.z() - z_m) > 5e-3) continue;
    low_m = std::min(low_m, p.x());
    high_m = std::max(high_m, p.x());
  }
  return high_m - low_m;
}

TEST(GeonMeshTest, TaperedGeonStandsOnItsLargeEndAndInvertedOnItsSmallOne) {
  const TriangleMesh upright = GeonMesh(ExampleMesh(GeonLabel::kTaperedCylinder, 1));
  EXPECT_NEAR(WidthAt(upright, 0.004) / WidthAt(upright, 0.236), 1.4 / 0.6, 0.1);
  const TriangleMesh inverted = GeonMesh(ExampleMesh(GeonLabel::kTaperedCylinder, 3));
  EXPECT_NEAR(WidthAt(inverted, 0.004) / WidthAt(inverted, 0.236), 0.6 / 1.4, 0.05);
}

TEST(GeonMeshTest, LyingTaperedCuboidRestsOnAWholeFlank) {
  const TriangleMesh mesh = GeonMesh(ExampleMesh(GeonLabel::kTaperedCuboid, 2));
  Eigen::AlignedBox3d foot;
  for (const Eigen::Vector3d& p : mesh.vertices_m) {
    if (p.z() < 1e-3) foot.extend(p);
  }
  const double flank_m = std::hypot(0.24, 0.08 * (1 - 0.6 / 1.4));
  EXPECT_NEAR(foot.sizes().x(), flank_m, 0.01);
  EXPECT_NEAR(foot.sizes().y(), 0.12, 0.01);
}

TEST(GeonMeshTest, BentCuboidLiesArchesOrCups) {
  const double radius_m = 0.30 / RadiansFromDegrees(120);
  EXPECT_NEAR(Bounds(GeonMesh(ExampleMesh(GeonLabel::kBentCuboid, 1))).sizes().z(), 0.08, 1e-3);
  // "n": the middle of the arch is above, its feet below; "u" is the same upside down.
  const TriangleMesh arch = GeonMesh(ExampleMesh(GeonLabel::kBentCuboid, 2));
  const TriangleMesh cup = GeonMesh(ExampleMesh(GeonLabel::kBentCuboid, 3));
  const double height_m = Bounds(arch).sizes().z();
  EXPECT_NEAR(height_m, (radius_m + 0.04) - (radius_m - 0.04) * 0.5, 2e-3);
  EXPECT_NEAR(Bounds(cup).sizes().z(), height_m, 1e-9);
  EXPECT_GT(WidthAt(arch, 0.03), WidthAt(arch, height_m - 0.004));
  EXPECT_LT(WidthAt(cup, 0.004), WidthAt(cup, height_m - 0.03));
}

TEST(GeonMeshTest, ImpossibleShapeIsAContractViolation) {
  GeonShape shape = ExampleMesh(GeonLabel::kCuboid, 1);
  shape.position = 4;
  EXPECT_THROW(GeonMesh(shape), ContractViolation);
}

}  // namespace
}  // namespace geon::geons
