#include <gtest/gtest.h>

#include "base/angles.h"
#include "sim/random_world.h"
#include "sim/world_file.h"

namespace geon::sim {
namespace {

TEST(WorldTextTest, WhatIsWrittenReadsBackTheSame) {
  World world = RandomWorld(3, GeonPlace::kBox);
  world.objects.push_back({CylinderShape{0.075, 1.0}, 1.0, 1.0, 0.25, 0.0, {90, 90, 120}, 0.4});
  world.objects.push_back({MeshShape{"some mesh.obj", 0.2, GeonLabel::kBentCylinder},
                           2.5,
                           1.0,
                           {},
                           0.5,
                           {150, 40, 40},
                           {}});
  world.objects.push_back({ChessboardShape{9, 6, 0.0255, 0.02, RadiansFromDegrees(12.5)},
                           0.5,
                           1.5,
                           0.6,
                           0.5,
                           {235, 235, 235},
                           {}});
  world.floor_gloss_1 = 0.035;
  const std::string text = WorldText(world);
  const Result<World> read = ParseWorld(text, "w.yaml", "");
  ASSERT_TRUE(read.ok()) << read.message() << "\n" << text;
  EXPECT_EQ(WorldText(*read), text);
  EXPECT_DOUBLE_EQ(read->floor_gloss_1, 0.035);
  ASSERT_EQ(read->objects.size(), world.objects.size());
  for (size_t k = 0; k < world.objects.size(); ++k) {
    EXPECT_NEAR(read->objects[k].x_m, world.objects[k].x_m, 1e-9);
    EXPECT_NEAR(read->objects[k].yaw_rad, world.objects[k].yaw_rad, RadiansFromDegrees(0.051));
    EXPECT_EQ(read->objects[k].shape.index(), world.objects[k].shape.index());
    EXPECT_EQ(read->objects[k].z_m.has_value(), world.objects[k].z_m.has_value());
    EXPECT_EQ(TrueLabel(read->objects[k]), TrueLabel(world.objects[k]));
  }
}

}  // namespace
}  // namespace geon::sim
