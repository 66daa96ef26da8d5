#include "procs/geon/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace geon::cli {
namespace {

TEST(Svg, DataUrisAreBase64) {
  const std::string text = "Many hands";
  const std::vector<uint8_t> bytes(text.begin(), text.end());
  EXPECT_EQ(DataUri("text/plain", bytes), "data:text/plain;base64,TWFueSBoYW5kcw==");
  EXPECT_EQ(DataUri("x/y", {0xff, 0xff, 0xff}), "data:x/y;base64,////");
  EXPECT_EQ(DataUri("x/y", {}), "data:x/y;base64,");
}

TEST(Svg, TextIsEscaped) { EXPECT_EQ(Escape("a<b>&\""), "a&lt;b&gt;&amp;&quot;"); }

TEST(Plot, MapsTheWorldWithYUpwards) {
  const Plot plot(200, 100, {0, 0}, {4, 2}, true);
  EXPECT_TRUE(plot.At({0, 0}).isApprox(Eigen::Vector2d(0, 100)));
  EXPECT_TRUE(plot.At({4, 2}).isApprox(Eigen::Vector2d(200, 0)));
}

TEST(Plot, EqualScaleCentresTheShorterAxis) {
  const Plot plot(200, 100, {0, 0}, {1, 1}, true);
  EXPECT_TRUE(plot.At({0, 0}).isApprox(Eigen::Vector2d(50, 100)));
  EXPECT_TRUE(plot.At({1, 1}).isApprox(Eigen::Vector2d(150, 0)));
}

TEST(Plot, DrawsWhatItIsGiven) {
  Plot plot(10, 10, {0, 0}, {1, 1}, true);
  plot.Polyline({{0, 0}, {1, 1}}, "path");
  plot.Text({0, 0}, {0, 0}, "start", "small", "<x>");
  EXPECT_THAT(plot.Svg("a <map>"),
              testing::AllOf(testing::HasSubstr("0.0,10.0 10.0,0.0"),
                             testing::HasSubstr("&lt;x&gt;"), testing::HasSubstr("a &lt;map&gt;")));
}

TEST(Plot, RectanglesMayTellWhatTheyAre) {
  Plot plot(10, 20, {0, 0}, {1, 1}, false);
  plot.Rect({1, 1}, {0.5, 0}, "bin", "3 < 4");
  plot.Rect({0, 0}, {1, 1}, "frame");
  EXPECT_THAT(
      plot.Svg(""),
      testing::AllOf(testing::HasSubstr("x=\"5.0\" y=\"0.0\" width=\"5.0\" height=\"20.0\"><title>"
                                        "3 &lt; 4</title></rect>"),
                     testing::HasSubstr("height=\"20.0\"/>")));
}

}  // namespace
}  // namespace geon::cli
