#include "evaluation/thesis_objects.h"

#include <gtest/gtest.h>

#include "evaluation/thesis_results.h"

namespace geon::evaluation {
namespace {

TEST(ThesisObjects, AreFourOfEachGeonInTheSixtyPositionsOfTheTables) {
  std::array<int, kGeonLabelCount> objects{};
  size_t positions = 0;
  for (const ExperimentObject& object : ThesisObjects()) {
    ++objects[static_cast<size_t>(object.shape.label)];
    for (int position : object.positions) {
      ++positions;
      EXPECT_TRUE(ThesisRow({object.shape.label, object.name, position}).has_value())
          << ToString(object.shape.label) << " " << object.name << " " << position;
    }
  }
  EXPECT_EQ(objects, (std::array{4, 4, 4, 4, 4, 4, 4}));
  EXPECT_EQ(positions, 60U);
}

TEST(ThesisObjects, ArePossibleInEveryPosition) {
  for (const ExperimentObject& object : ThesisObjects()) {
    for (int position : object.positions) {
      geons::GeonShape shape = object.shape;
      shape.position = position;
      EXPECT_TRUE(geons::Validate(shape).ok()) << ToString(shape.label) << " " << object.name;
    }
  }
}

TEST(ThesisObjects, RunFromStrongToSlight) {
  const std::vector<ExperimentObject> objects = ThesisObjects();
  for (size_t k = 1; k < objects.size(); ++k) {
    const geons::GeonShape &before = objects[k - 1].shape, &after = objects[k].shape;
    if (before.label != after.label) continue;
    EXPECT_LE(after.taper_1, before.taper_1);
    EXPECT_LE(after.bend_rad, before.bend_rad);
  }
}

}  // namespace
}  // namespace geon::evaluation
