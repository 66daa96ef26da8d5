#include "procs/geon/barn_courses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace geon::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kHeading =
    "world,n_cylinders,straight_len_m,opt_path_len_m,len_nomad_r0267,split\n";
constexpr const char* kWorlds = "7,3,10.0,12.0,10.5,dev\n";
// A field of 4.5 m from its lower corners on, and something on the way.
constexpr const char* kObstacles =
    "world,cyl,x_m,y_m,r_m\n7,0,-4.425,0.075,0.075\n7,1,-0.075,0.075,0.075\n7,2,-2.0,6.0,0.1\n";

class BarnCoursesTest : public testing::Test {
 protected:
  BarnCoursesTest() { std::filesystem::create_directories(folder_); }
  ~BarnCoursesTest() override { std::filesystem::remove_all(folder_); }
  Result<std::vector<BarnCourse>> Load(const std::string& worlds, const std::string& obstacles) {
    std::ofstream(folder_ / "worlds.csv") << worlds;
    std::ofstream(folder_ / "obstacles.csv") << obstacles;
    return LoadBarnCourses(folder_);
  }
  std::string Refusal(const std::string& worlds, const std::string& obstacles = kObstacles) {
    const auto courses = Load(worlds, obstacles);
    EXPECT_FALSE(courses.ok());
    return courses.ok() ? "" : courses.status().message();
  }
  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / "geon_barn_courses";
};

TEST_F(BarnCoursesTest, TheRobotStartsOnTheFieldsMiddleLineAndLooksAtTheGoal) {
  const auto courses = Load(std::string(kHeading) + kWorlds, kObstacles);
  ASSERT_TRUE(courses.ok()) << courses.status().message();
  ASSERT_EQ(courses->size(), 1U);
  const BarnCourse& course = courses->front();
  EXPECT_EQ(course.id, "7");
  EXPECT_EQ(course.split, "dev");
  EXPECT_EQ(course.destination_W_m, Eigen::Vector2d(10.0, 0.0));
  EXPECT_EQ(course.shortest_m, 10.5);
  EXPECT_EQ(course.optimal_s, 6.0);
  const sim::World& world = course.world;
  EXPECT_NEAR(world.robot_x_m, 2.25, 1e-9);
  EXPECT_NEAR(world.robot_y_m, 3.0, 1e-9);
  EXPECT_NEAR(world.robot_heading_rad, M_PI / 2.0, 1e-9);
  EXPECT_NEAR(world.pen_size_m.x(), 4.5, 1e-9);
  EXPECT_NEAR(world.pen_size_m.y(), 14.5, 1e-9) << "with room beyond the goal";
  ASSERT_EQ(world.objects.size(), 3U);
  EXPECT_NEAR(world.objects[2].x_m, 2.5, 1e-9);
  EXPECT_NEAR(world.objects[2].y_m, 6.0, 1e-9);
  EXPECT_EQ(std::get<sim::CylinderShape>(world.objects[2].shape).radius_m, 0.1);
  EXPECT_FALSE(sim::IsTarget(world.objects[2]));
}

TEST_F(BarnCoursesTest, WhatIsWrongIsNamedWithFileAndLine) {
  const std::string worlds = std::string(kHeading) + kWorlds;
  EXPECT_THAT(Refusal("world,split\n7,dev\n"),
              AllOf(HasSubstr("worlds.csv:1"), HasSubstr("n_cylinders is missing")));
  EXPECT_THAT(Refusal(std::string(kHeading) + "7,3,10.0,12.0,far,dev\n"),
              AllOf(HasSubstr("worlds.csv:2"), HasSubstr("len_nomad_r0267"), HasSubstr("far")));
  EXPECT_THAT(Refusal(std::string(kHeading) + "7,3,0,12.0,10.5,dev\n"),
              AllOf(HasSubstr("straight_len_m"), HasSubstr("above 0")));
  EXPECT_THAT(Refusal(worlds, std::string(kObstacles) + "7,3,1.0,,0.1\n"),
              AllOf(HasSubstr("obstacles.csv:5"), HasSubstr("y_m is missing")));
  EXPECT_THAT(Refusal(worlds, std::string(kObstacles) + "7,3,1.0,2.0,-0.1\n"),
              AllOf(HasSubstr("obstacles.csv:5"), HasSubstr("r_m must be above 0")));
  EXPECT_THAT(Refusal(kHeading), HasSubstr("no worlds"));
}

TEST_F(BarnCoursesTest, WhatDoesNotFitTogetherIsRefused) {
  const std::string worlds = std::string(kHeading) + kWorlds;
  EXPECT_THAT(Refusal(std::string(kHeading) + kWorlds + "8,1,10.0,12.0,10.5,dev\n"),
              AllOf(HasSubstr("worlds.csv:3"), HasSubstr("0 of world 8")));
  EXPECT_THAT(Refusal(std::string(kHeading) + "7,4,10.0,12.0,10.5,dev\n"), HasSubstr("has 3"));
  std::string blocked = kObstacles;
  blocked.replace(blocked.find("-2.0,6.0"), 8, "-2.3,3.2");
  EXPECT_THAT(Refusal(worlds, blocked), AllOf(HasSubstr("worlds.csv:2"), HasSubstr("starts")));
}

TEST_F(BarnCoursesTest, AFolderWithoutTheFilesIsRefused) {
  EXPECT_THAT(LoadBarnCourses(folder_).status().message(), HasSubstr("worlds.csv"));
}

}  // namespace
}  // namespace geon::cli
