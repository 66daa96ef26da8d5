#include "evaluation/object_tracer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/contracts.h"
#include "geons/geon_mesh.h"
#include "geons/polygon_geon.h"

namespace geon::evaluation {
namespace {

ObjectTracer Box() {
  return ObjectTracer(geons::PolygonGeon({GeonLabel::kCuboid, {0.2, 0.1, 0.3}}, 48));
}

TEST(ObjectTracer, FindsTheNearSideOfABox) {
  const ObjectTracer box = Box();
  const std::vector<ObjectRay> rays = {{{1, 0, 0.1}, {-1, 0, 0}},    // x = 0.1
                                       {{0, 0.5, 0.2}, {0, -2, 0}},  // y = 0.05, long direction
                                       {{1, 0, 0.4}, {-1, 0, 0}}};   // over the top
  const std::vector<double> hits = box.FirstHits(rays);
  EXPECT_NEAR(hits[0], 0.9, 1e-6);
  EXPECT_NEAR(hits[1], 0.225, 1e-6);
  EXPECT_TRUE(std::isinf(hits[2]));
  EXPECT_EQ(box.Hits(rays), (std::vector<bool>{true, true, false}));
}

TEST(ObjectTracer, TellsTheObjectFromWhatStandsBesideIt) {
  const auto object = geons::PolygonGeon({GeonLabel::kCuboid, {0.2, 0.1, 0.3}}, 48);
  geons::TriangleMesh beside = object;
  for (Eigen::Vector3d& p_m : beside.vertices_m) p_m.y() += 0.5;
  const ObjectTracer both(object, &beside);
  std::vector<bool> on_object;
  const auto hits = both.FirstHits(
      std::vector<ObjectRay>{
          {{1, 0, 0.1}, {-1, 0, 0}}, {{1, 0.5, 0.1}, {-1, 0, 0}}, {{1, 1.0, 0.1}, {-1, 0, 0}}},
      &on_object);
  EXPECT_NEAR(hits[1], 0.9, 1e-6);
  EXPECT_TRUE(std::isinf(hits[2]));
  EXPECT_EQ(on_object, (std::vector<bool>{true, false, false}));
}

TEST(ObjectTracer, ARayEndsAtItsReach) {
  const ObjectTracer box = Box();
  EXPECT_FALSE(box.Hits(std::vector<ObjectRay>{{{1, 0, 0.1}, {-1, 0, 0}, 0.89}})[0]);
  EXPECT_TRUE(box.Hits(std::vector<ObjectRay>{{{1, 0, 0.1}, {-1, 0, 0}, 0.91}})[0]);
}

TEST(ObjectTracer, SeesASphereWhereItIs) {
  const ObjectTracer sphere(geons::GeonMesh({GeonLabel::kEllipsoid, {0.2, 0.2, 0.2}}));
  std::vector<ObjectRay> rays;
  for (int k = 0; k < 40; ++k) {  // more than one packet
    const double y_m = 0.0024 * k;
    rays.push_back({{1.0, y_m, 0.1}, {-1, 0, 0}});
  }
  const std::vector<double> hits = sphere.FirstHits(rays);
  for (size_t k = 0; k < rays.size(); ++k) {
    const double y_m = rays[k].origin_m.y();
    EXPECT_NEAR(hits[k], 1.0 - std::sqrt(0.01 - y_m * y_m), 2e-4);
  }
}

TEST(ObjectTracer, KnowsItsHeightAndOutline) {
  EXPECT_NEAR(Box().height_m(), 0.3, 1e-12);
  EXPECT_GE(Box().outline_m().size(), 8U);
}

TEST(ObjectTracer, RefusesAnEmptyMesh) {
  EXPECT_THROW(ObjectTracer(geons::TriangleMesh()), ContractViolation);
}

}  // namespace
}  // namespace geon::evaluation
