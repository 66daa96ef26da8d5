#include "sim/random_pen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "base/angles.h"
#include "sim/footprint.h"
#include "sim/random_world.h"
#include "sim/world_file.h"

namespace geon::sim {
namespace {

constexpr std::array kAllKinds = {PenKind::kBoxes, PenKind::kUTrap, PenKind::kDeadEnd,
                                  PenKind::kGap,   PenKind::kEmpty, PenKind::kUnreachable};
constexpr std::array kReachableKinds = {PenKind::kBoxes, PenKind::kUTrap, PenKind::kDeadEnd,
                                        PenKind::kGap};
constexpr uint64_t kSeeds = 20;
constexpr double kGap_m = 0.75;
// From where a geon is looked at.
constexpr double kNearest_m = 0.83, kFarthest_m = 0.95;

Eigen::Vector2d Place(const WorldObject& object) { return {object.x_m, object.y_m}; }
Eigen::Vector2d RobotPlace(const World& world) { return {world.robot_x_m, world.robot_y_m}; }

std::vector<WorldObject> Geons(const World& world) {
  std::vector<WorldObject> geons;
  for (const WorldObject& object : world.objects) {
    if (TrueLabel(object)) geons.push_back(object);
  }
  return geons;
}

// The boxes, without the one that the geon stands on.
std::vector<WorldObject> Boxes(const World& world) {
  const auto geons = Geons(world);
  std::vector<WorldObject> boxes;
  for (const WorldObject& object : world.objects) {
    if (!std::holds_alternative<BoxShape>(object.shape)) continue;
    if (!geons.empty() && Place(object) == Place(geons[0])) continue;
    boxes.push_back(object);
  }
  return boxes;
}

bool Covers(const WorldObject& box, const Eigen::Vector2d& p_m) {
  return NearestPointOfConvex(BoxOutline(box), p_m).distance_m <= 0.0;
}

// The first box on the straight way, as its index; -1 when nothing is in the way.
int FirstOnTheWay(const std::vector<WorldObject>& boxes, const Eigen::Vector2d& from_m,
                  const Eigen::Vector2d& to_m) {
  constexpr double kStep_m = 0.01;
  const double length_m = (to_m - from_m).norm();
  for (double s_m = 0.0; s_m < length_m; s_m += kStep_m) {
    const Eigen::Vector2d p_m = from_m + (to_m - from_m) * (s_m / length_m);
    for (size_t k = 0; k < boxes.size(); ++k) {
      if (Covers(boxes[k], p_m)) return static_cast<int>(k);
    }
  }
  return -1;
}

TEST(RandomPenTest, SameSeedSamePenAndOtherSeedsOthers) {
  for (const PenKind kind : kAllKinds) {
    EXPECT_EQ(WorldText(RandomPen(5, kind)), WorldText(RandomPen(5, kind))) << ToString(kind);
    EXPECT_NE(WorldText(RandomPen(5, kind)), WorldText(RandomPen(6, kind))) << ToString(kind);
  }
}

TEST(RandomPenTest, NamesRoundTrip) {
  std::set<std::string_view> names;
  for (const PenKind kind : kAllKinds) {
    names.insert(ToString(kind));
    EXPECT_EQ(PenKindFromString(ToString(kind)), kind);
  }
  EXPECT_EQ(names.size(), kAllKinds.size());
  EXPECT_EQ(PenKindFromString("maze"), std::nullopt);
  EXPECT_EQ(PenKindFromString(""), std::nullopt);
}

TEST(RandomPenTest, EveryPenCanBeWrittenAndReadAsAWorldFile) {
  for (const PenKind kind : kAllKinds) {
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Result<World> read = ParseWorld(WorldText(RandomPen(seed, kind)), "pen.yaml", "");
      EXPECT_TRUE(read.ok()) << ToString(kind) << " " << seed << ": " << read.message();
    }
  }
}

TEST(RandomPenTest, PensAreAboutAsLargeAsTheThesisAndTheRobotStandsFree) {
  for (const PenKind kind : kAllKinds) {
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      SCOPED_TRACE(std::string(ToString(kind)) + " " + std::to_string(seed));
      const World pen = RandomPen(seed, kind);
      EXPECT_NEAR(pen.pen_size_m.x(), 3.0, 0.5);
      EXPECT_NEAR(pen.pen_size_m.y(), 4.5, 0.5);
      const Eigen::Vector2d robot_m = RobotPlace(pen);
      EXPECT_GT(robot_m.minCoeff(), kRobotRadius_m);
      EXPECT_GT((pen.pen_size_m - robot_m).minCoeff(), kRobotRadius_m);
      for (const WorldObject& box : Boxes(pen)) {
        EXPECT_GT(NearestPointOfConvex(BoxOutline(box), robot_m).distance_m, kRobotRadius_m);
      }
    }
  }
}

TEST(RandomPenTest, OneGeonStandsFarOffOnTheFloorOrOnABox) {
  for (const PenKind kind : kAllKinds) {
    if (kind == PenKind::kEmpty) continue;
    std::set<double> heights_m;
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      SCOPED_TRACE(std::string(ToString(kind)) + " " + std::to_string(seed));
      const World pen = RandomPen(seed, kind);
      const auto geons = Geons(pen);
      ASSERT_EQ(geons.size(), 1U);
      EXPECT_GE((Place(geons[0]) - RobotPlace(pen)).norm(), 1.5);
      heights_m.insert(FootHeight(pen, geons[0]));
    }
    EXPECT_EQ(heights_m, (std::set<double>{0.0, kDeskHeight_m})) << ToString(kind);
  }
}

TEST(RandomPenTest, APenOfBoxesHasUpToFiveBesideTheGeonsOwn) {
  std::set<size_t> counts;
  for (uint64_t seed = 1; seed <= 2 * kSeeds; ++seed) {
    const World pen = RandomPen(seed, PenKind::kBoxes);
    counts.insert(Boxes(pen).size());
    EXPECT_EQ(Geons(pen).size(), 1U) << seed;
  }
  EXPECT_LE(*counts.rbegin(), 5U);
  EXPECT_GE(counts.size(), 4U);
}

TEST(RandomPenTest, AUStandsBetweenRobotAndGeonOpenTowardsTheRobot) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const World pen = RandomPen(seed, PenKind::kUTrap);
    const Eigen::Vector2d robot_m = RobotPlace(pen), geon_m = Place(Geons(pen)[0]);
    const auto boards = Boxes(pen);
    ASSERT_EQ(boards.size(), 3U);
    // The straight way leads in and ends at the back; both sides reach from there to the robot's.
    const int back = FirstOnTheWay(boards, robot_m, geon_m);
    ASSERT_GE(back, 0);
    const Eigen::Vector2d along = (geon_m - robot_m).normalized();
    const double back_m = along.dot(Place(boards[static_cast<size_t>(back)]) - robot_m);
    double across_m = 1.0;
    for (size_t k = 0; k < boards.size(); ++k) {
      if (static_cast<int>(k) == back) continue;
      const Eigen::Vector2d side_m = Place(boards[k]) - robot_m;
      EXPECT_LT(along.dot(side_m), back_m);
      across_m *= along.x() * side_m.y() - along.y() * side_m.x();
    }
    EXPECT_LT(across_m, 0.0) << "one side to the left, one to the right";
  }
}

TEST(RandomPenTest, InADeadEndThereIsOneWayOut) {
  constexpr int kDirections = 180;
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const World pen = RandomPen(seed, PenKind::kDeadEnd);
    const auto boards = Boxes(pen);
    std::vector<bool> open;
    for (int k = 0; k < kDirections; ++k) {
      const double angle_rad = 2.0 * kPi * k / kDirections;
      const Eigen::Vector2d far_m =
          RobotPlace(pen) + 1.2 * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
      open.push_back(FirstOnTheWay(boards, RobotPlace(pen), far_m) < 0);
    }
    int openings = 0;
    for (size_t k = 0; k < open.size(); ++k) openings += open[k] && !open[(k + 1) % open.size()];
    EXPECT_EQ(openings, 1) << seed;
    EXPECT_LT(std::count(open.begin(), open.end(), true), 0.3 * kDirections) << seed;
  }
}

TEST(RandomPenTest, OneGapOfThreeQuartersOfAMetreIsInTheWall) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const World pen = RandomPen(seed, PenKind::kGap);
    const auto boards = Boxes(pen);
    ASSERT_EQ(boards.size(), 2U);
    const double wall_m = boards[0].y_m;
    EXPECT_DOUBLE_EQ(boards[1].y_m, wall_m);
    EXPECT_LT(pen.robot_y_m, wall_m);
    EXPECT_GT(Geons(pen)[0].y_m, wall_m);
    int free = 0;
    constexpr double kStep_m = 0.001;
    const int steps = static_cast<int>(pen.pen_size_m.x() / kStep_m);
    for (int k = 0; k < steps; ++k) {
      const Eigen::Vector2d p_m((k + 0.5) * kStep_m, wall_m);
      free += !Covers(boards[0], p_m) && !Covers(boards[1], p_m);
    }
    EXPECT_NEAR(free * kStep_m, kGap_m, 0.003);
  }
}

TEST(RandomPenTest, AReachableGeonCanBeReached) {
  for (const PenKind kind : kReachableKinds) {
    for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const World pen = RandomPen(seed, kind);
      EXPECT_TRUE(CanReach(pen, Place(Geons(pen)[0]), kNearest_m, kFarthest_m, 0.08))
          << ToString(kind) << " " << seed;
    }
  }
}

TEST(RandomPenTest, AnUnreachableGeonCannot) {
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const World pen = RandomPen(seed, PenKind::kUnreachable);
    EXPECT_FALSE(CanReach(pen, Place(Geons(pen)[0]), kNearest_m, kFarthest_m, 0.0)) << seed;
  }
}

TEST(RandomPenTest, AnEmptyPenHasBoxesAndNothingElse) {
  std::set<size_t> counts;
  for (uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const World pen = RandomPen(seed, PenKind::kEmpty);
    EXPECT_TRUE(Geons(pen).empty()) << seed;
    EXPECT_TRUE(std::none_of(pen.objects.begin(), pen.objects.end(), IsTarget)) << seed;
    EXPECT_EQ(Boxes(pen).size(), pen.objects.size()) << seed;
    counts.insert(pen.objects.size());
  }
  EXPECT_LE(*counts.rbegin(), 5U);
  EXPECT_GE(counts.size(), 4U);
}

TEST(RandomPenTest, TheMixtureIsHalfBoxesAndASixthOfEachTrap) {
  std::map<PenKind, int> counts;
  for (uint64_t seed = 0; seed < 3000; ++seed) ++counts[MixedPenKind(seed)];
  EXPECT_NEAR(counts[PenKind::kBoxes], 1500, 110);
  for (const PenKind trap : {PenKind::kUTrap, PenKind::kDeadEnd, PenKind::kGap}) {
    EXPECT_NEAR(counts[trap], 500, 80) << ToString(trap);
  }
  EXPECT_EQ(counts[PenKind::kEmpty], 0);
  EXPECT_EQ(counts[PenKind::kUnreachable], 0);
}

}  // namespace
}  // namespace geon::sim
