#include "attention/color_model_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::attention {
namespace {

using testing::HasSubstr;

ColorModel LearnedRed() {
  return {"red_paint", ChromaticityColor{0.61, 0.1875, 120.5, -3.25, 88.0, 2.4, 17.0}};
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
  EXPECT_EQ(model->name, "red_paint");
  EXPECT_EQ(SerializeColorModel(*model, {"from two pictures"}), text);
}

TEST(ColorModelTextTest, NamedModelsCanBeWrittenAndReadBack) {
  for (const std::string& name : NamedColorModels()) {
    const std::string text = SerializeColorModel(*NamedColorModel(name), {});
    const Result<ColorModel> model = ParseColorModel(text, "file");
    ASSERT_TRUE(model.ok()) << model.message();
    EXPECT_EQ(SerializeColorModel(*model, {}), text);
  }
}

TEST(ColorModelTextTest, HalfSpacesCanBeWrittenByHand) {
  const Result<ColorModel> model = ParseColorModel(
      "format: geon.color_model.v1\nname: green  # by eye\nhalf_space: [ -1, 1,-1, 2e1 ]\n", "g");
  ASSERT_TRUE(model.ok()) << model.message();
  EXPECT_TRUE(model->Contains({10, 90, 20}));
  EXPECT_FALSE(model->Contains({90, 10, 20}));
}

TEST(ColorModelTextTest, DamageIsReportedWithFileAndLine) {
  const std::string good = SerializeColorModel(LearnedRed(), {});
  const auto error = [](const std::string& text) {
    return ParseColorModel(text, "red.yaml").message();
  };
  EXPECT_THAT(error(good + "hue: 3\n"), HasSubstr("red.yaml:10: unknown key hue"));
  EXPECT_THAT(error(good + "mean_i_1: 3\n"), HasSubstr("red.yaml:10: duplicate key mean_i_1"));
  EXPECT_THAT(error(good + "nonsense\n"), HasSubstr("red.yaml:10: expected"));
  EXPECT_THAT(error(Without(good, "mean_q_1")), HasSubstr("mean_q_1 is missing"));
  EXPECT_THAT(error(Without(good, "mean_q_1") + "mean_q_1: much\n"), HasSubstr("must be a number"));
  EXPECT_THAT(error(Without(good, "mean_q_1") + "mean_q_1: nan\n"), HasSubstr("must be a number"));
  EXPECT_THAT(error(Without(good, "format")), HasSubstr("format is missing"));
  EXPECT_THAT(error(Without(good, "inverse_qq_1") + "inverse_qq_1: -1\n"),
              HasSubstr("positive definite"));
  EXPECT_THAT(error(good + "half_space: [1, 2, 3]\n"), HasSubstr("must be [red"));
  EXPECT_THAT(error(good + "half_space: [1, 2, 3, 4, 5]\n"), HasSubstr("must be [red"));
  EXPECT_THAT(error(good + "half_space: [1, 2, 3, 4]\n"), HasSubstr("not both"));
  EXPECT_THAT(error("format: geon.color_model.v2\n"), HasSubstr("format must be"));
}

}  // namespace
}  // namespace geon::attention
