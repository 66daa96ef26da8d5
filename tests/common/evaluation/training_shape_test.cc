#include "evaluation/training_shape.h"

#include <gtest/gtest.h>

#include <array>

#include "geons/triangle_mesh.h"

namespace geon::evaluation {
namespace {

TEST(TrainingShape, IsOfEveryClassAndStandsOnTheGround) {
  std::mt19937_64 random(1);
  std::array<int, kGeonLabelCount> counts{};
  for (int k = 0; k < 210; ++k) {
    const TrainingShape shape = MakeTrainingShape(random);
    ++counts[static_cast<size_t>(shape.label)];
    const Eigen::AlignedBox3d bounds = geons::Bounds(shape.mesh);
    EXPECT_NEAR(bounds.min().z(), 0.0, 1e-12);
    EXPECT_GT(bounds.sizes().minCoeff(), 0.01);
    EXPECT_LT(bounds.sizes().maxCoeff(), 0.75);
  }
  for (int count : counts) EXPECT_NEAR(count, 30, 22);
}

TEST(TrainingShape, IsTheSameFromTheSameState) {
  std::mt19937_64 a(7), b(7);
  EXPECT_EQ(MakeTrainingShape(a).mesh.vertices_m, MakeTrainingShape(b).mesh.vertices_m);
}

// A deformation that turned a surface inside out would enclose a negative volume.
TEST(TrainingShape, FacesOutward) {
  std::mt19937_64 random(2);
  for (int k = 0; k < 60; ++k) EXPECT_GT(geons::Volume(MakeTrainingShape(random).mesh), 0.0);
}

}  // namespace
}  // namespace geon::evaluation
