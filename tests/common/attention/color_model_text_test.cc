#include "attention/color_model_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::attention {
namespace {

using testing::HasSubstr;

ColorModel LearnedRed() {
  return {"red_paint",
          {{{{3, -5, 0, 0}, {2.25, 0, -3, 1e-3}}}, {{{1, -1, -1, 20}}}},
          {{{{1, -1, 0, 5}}}},
          20,
          250};
}

std::string Without(std::string text, const std::string& line_start) {
  const size_t begin = text.find(line_start);
  return text.erase(begin, text.find('\n', begin) + 1 - begin);
}

TEST(ColorModelTextTest, LearnedModelSurvivesTheRoundTrip) {
  const std::string text = SerializeColorModel(LearnedRed(), {"from two pictures"});
  EXPECT_THAT(text, HasSubstr("# from two pictures\n"));
  const Result<ColorModel> model = ParseColorModel(text, "red.yaml");
  ASSERT_TRUE(model.ok()) << model.message();
  EXPECT_EQ(*model, LearnedRed());
}

TEST(ColorModelTextTest, NamedModelsCanBeWrittenAndReadBack) {
  for (const std::string& name : NamedColorModels()) {
    const std::string text = SerializeColorModel(*NamedColorModel(name), {});
    const Result<ColorModel> model = ParseColorModel(text, "file");
    ASSERT_TRUE(model.ok()) << model.message();
    EXPECT_EQ(*model, *NamedColorModel(name));
  }
}

TEST(ColorModelTextTest, HalfSpacesCanBeWrittenByHand) {
  const Result<ColorModel> model = ParseColorModel(
      "format: geon.color_model.v1\nname: green  # by eye\nregion: target\n"
      "half_space: [ -1, 1,-1, 2e1 ]\n",
      "g");
  ASSERT_TRUE(model.ok()) << model.message();
  EXPECT_TRUE(model->target[0].Contains({10, 90, 20}));
  EXPECT_FALSE(model->target[0].Contains({90, 10, 20}));
}

TEST(ColorModelTextTest, DamageIsReportedWithFileAndLine) {
  const std::string good = SerializeColorModel(LearnedRed(), {});
  const auto error = [](const std::string& text) {
    return ParseColorModel(text, "red.yaml").message();
  };
  EXPECT_THAT(error(good + "hue: 3\n"), HasSubstr("red.yaml:12: unknown key hue"));
  EXPECT_THAT(error(good + "name: blue\n"), HasSubstr("red.yaml:12: duplicate key name"));
  EXPECT_THAT(error(good + "dark_level_1: 2\n"), HasSubstr("duplicate key dark_level_1"));
  EXPECT_THAT(error(good + "nonsense\n"), HasSubstr("red.yaml:12: expected"));
  EXPECT_THAT(error(Without(good, "format")), HasSubstr("format is missing"));
  EXPECT_THAT(error(Without(good, "name")), HasSubstr("name is missing"));
  EXPECT_THAT(error(Without(good, "dark") + "dark_level_1: much\n"), HasSubstr("whole number"));
  EXPECT_THAT(error(Without(good, "dark") + "dark_level_1: 300\n"), HasSubstr("0 ... 255"));
  EXPECT_THAT(error(good + "region: sky\n"), HasSubstr("must be target or rim"));
  EXPECT_THAT(error(good + "region: rim\n"), HasSubstr("no half-space"));
  EXPECT_THAT(error("half_space: [1, 2, 3, 4]\n"), HasSubstr("red.yaml:1: half_space must stand"));
  EXPECT_THAT(error(good + "half_space: [1, 2, 3]\n"), HasSubstr("must be [red"));
  EXPECT_THAT(error(good + "half_space: [1, 2, 3, 4, 5]\n"), HasSubstr("must be [red"));
  EXPECT_THAT(error(good + "half_space: [1, 2, 3, nan]\n"), HasSubstr("must be [red"));
  EXPECT_THAT(error("format: geon.color_model.v1\nname: red\n"), HasSubstr("at least one region"));
  EXPECT_THAT(error("format: geon.color_model.v2\n"), HasSubstr("format must be"));
}

}  // namespace
}  // namespace geon::attention
