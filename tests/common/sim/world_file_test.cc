#include "sim/world_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/angles.h"
#include "config/text_file.h"

namespace geon::sim {
namespace {

using ::testing::HasSubstr;

// The example of the contract, whole.
constexpr const char* kContractWorld = R"(pen: {size_m: [3.0, 4.5], wall_height_m: 0.65}
floor: {color_rgb: [150, 150, 140], tile_m: 0.6, gloss: 0.05, groove_tilt_deg: 0.0}
robot: {x_m: 0.5, y_m: 0.5, heading_deg: 90}
light: {kelvin: 4000, level: 1.0, sun: {level: 0.0, azimuth_deg: 0, elevation_deg: 45}}
objects:
  - {geon: tapered_cuboid, size_m: [0.20, 0.20, 0.28], taper: 0.4, position: 1, x_m: 1.5, y_m: 3.0, yaw_deg: 30, color_rgb: [150, 40, 40]}
  - {mesh: banana.obj, height_m: 0.2, x_m: 1.0, y_m: 2.0, yaw_deg: 0, color_rgb: [150, 40, 40], truth: bent_cylinder}
  - {box: [0.5, 0.5, 0.7], x_m: 2.0, y_m: 2.0, color_rgb: [90, 90, 120]}
  - {cylinder: {radius_m: 0.075, height_m: 1.0}, x_m: 1.0, y_m: 1.0, color_rgb: [90, 90, 120]}
)";

std::string WithObject(const std::string& object) {
  return "pen: {size_m: [3.0, 4.5]}\nrobot: {x_m: 0.5, y_m: 0.5, heading_deg: 90}\nobjects:\n  - "
         "{" +
         object + "}\n";
}

std::string Refusal(const std::string& text) { return ParseWorld(text, "w.yaml", ".").message(); }

TEST(WorldFileTest, ReadsTheContractsExample) {
  const Result<World> world = ParseWorld(kContractWorld, "w.yaml", "/pens");
  ASSERT_TRUE(world.ok()) << world.message();
  ASSERT_EQ(world->objects.size(), 4u);
  const auto& geon = std::get<geons::GeonShape>(world->objects[0].shape);
  EXPECT_EQ(geon.label, GeonLabel::kTaperedCuboid);
  EXPECT_DOUBLE_EQ(geon.taper_1, 0.4);
  EXPECT_NEAR(world->objects[0].yaw_rad, RadiansFromDegrees(30), 1e-12);
  const auto& mesh = std::get<MeshShape>(world->objects[1].shape);
  EXPECT_EQ(mesh.file, "/pens/banana.obj");
  EXPECT_EQ(TrueLabel(world->objects[1]), GeonLabel::kBentCylinder);
  EXPECT_EQ(TrueLabel(world->objects[2]), std::nullopt);
  EXPECT_DOUBLE_EQ(std::get<CylinderShape>(world->objects[3].shape).radius_m, 0.075);
  EXPECT_NEAR(world->robot_heading_rad, kPi / 2, 1e-12);
  EXPECT_DOUBLE_EQ(world->floor_gloss_1, 0.05);
}

TEST(WorldFileTest, WhatIsLeftOutKeepsItsDefault) {
  const Result<World> world =
      ParseWorld(WithObject("geon: bent_cylinder, size_m: [0.08, 0.08, 0.3], x_m: 1.5, y_m: 3.0"),
                 "w.yaml", ".");
  ASSERT_TRUE(world.ok()) << world.message();
  const auto& geon = std::get<geons::GeonShape>(world->objects[0].shape);
  EXPECT_NEAR(geon.bend_rad, kPi / 2, 1e-12);
  EXPECT_EQ(geon.position, 1);
  EXPECT_EQ(world->objects[0].color_rgb, Eigen::Vector3d(150, 40, 40));
  EXPECT_DOUBLE_EQ(world->lighting.kelvin, 4000.0);
  EXPECT_DOUBLE_EQ(world->floor_gloss_1, 0.0);
}

TEST(WorldFileTest, WhatStandsOnABoxStandsOnItsTop) {
  const std::string on_box = "  - {geon: cuboid, size_m: [0.2, 0.2, 0.2], x_m: 2.1, y_m: 1.9}\n";
  World world = *ParseWorld(std::string(kContractWorld) + on_box, "w.yaml", ".");
  EXPECT_DOUBLE_EQ(FootHeight(world, world.objects[4]), 0.7);
  EXPECT_DOUBLE_EQ(FootHeight(world, world.objects[0]), 0.0);
  EXPECT_DOUBLE_EQ(FootHeight(world, world.objects[2]), 0.0);
  world.objects[4].z_m = 0.1;
  EXPECT_DOUBLE_EQ(FootHeight(world, world.objects[4]), 0.1);
}

TEST(WorldFileTest, RefusesWithFileLineAndReason) {
  EXPECT_THAT(Refusal(WithObject("geon: cube, size_m: [0.2, 0.2, 0.2], x_m: 1, y_m: 2")),
              AllOf(HasSubstr("w.yaml:4"), HasSubstr("tapered_cuboid")));
  EXPECT_THAT(Refusal(WithObject("geon: cuboid, size_m: [0.2, 0.2], x_m: 1, y_m: 2")),
              HasSubstr("size_m"));
  EXPECT_THAT(
      Refusal(WithObject("geon: cuboid, size_m: [0.2, 0.2, 0.2], taper: 0.3, x_m: 1, y_m: 2")),
      HasSubstr("no taper"));
  EXPECT_THAT(
      Refusal(WithObject("chessboard: {squares: [9, 6.5], square_m: 0.03}, x_m: 1, y_m: 2")),
      HasSubstr("two whole numbers"));
  EXPECT_THAT(Refusal(WithObject("box: [0.5, 0.5, 0.7], pitch_deg: 5, x_m: 1, y_m: 2")),
              HasSubstr("pitch_deg"));
  EXPECT_THAT(Refusal(WithObject("box: [0.5, 0.5, 0.7], x_m: 1, y_m: 5")),
              HasSubstr("inside the pen"));
  EXPECT_THAT(Refusal(WithObject("box: [0.5, 0.5, 0.7], x_m: 0.6, y_m: 0.6")),
              HasSubstr("inside this object"));
  EXPECT_THAT(Refusal(WithObject("box: [0.5, 0.5, 0.7], geon: cuboid, x_m: 1, y_m: 2")),
              HasSubstr("exactly one"));
  EXPECT_THAT(Refusal(WithObject("box: [0.5, 0.5, 0.7], x_m: 1, y_m: 2, colour_rgb: [1, 2, 3]")),
              HasSubstr("colour_rgb"));
  EXPECT_THAT(Refusal("pen: {size_m: [3.0, 4.5]}\nrobot: {x_m: 0.1, y_m: 0.5}\n"),
              AllOf(HasSubstr("w.yaml:2"), HasSubstr("0.267")));
  EXPECT_THAT(Refusal("robot: {x_m: 0.5, y_m: 0.5}\n"), HasSubstr("pen"));
  EXPECT_THAT(Refusal("pen: {size_m: [3, 4.5]}\nfloor: {gloss: 5}\nrobot: {x_m: 0.5, y_m: 0.5}\n"),
              AllOf(HasSubstr("w.yaml:2"), HasSubstr("gloss"), HasSubstr("from 0 to 1")));
}

TEST(WorldFileTest, ReportsEveryMistakeAtOnce) {
  const std::string message = Refusal(
      WithObject("cylinder: {radius_m: -1, height_m: 1}, x_m: 1, y_m: 9, color_rgb: [300, 0, 0]"));
  EXPECT_THAT(message, AllOf(HasSubstr("radius_m"), HasSubstr("y_m"), HasSubstr("color_rgb")));
}

TEST(WorldFileTest, TheProductsWorldsAreGood) {
  for (const char* name : {"demo.yaml", "box.yaml"}) {
    const Result<World> world =
        LoadWorld(std::string(GEON_SOURCE_DIR "/scripts/config/worlds/") + name);
    ASSERT_TRUE(world.ok()) << world.message();
    EXPECT_FALSE(world->objects.empty());
  }
}

}  // namespace
}  // namespace geon::sim
