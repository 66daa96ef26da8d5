#include "attention/resolve_color.h"

#include <gtest/gtest.h>

#include "attention/color_model.h"

namespace geon::attention {
namespace {

// One letter a pixel: '.' other, 't' target, 'r' rim, '?' cannot tell; the answer has '#' on the
// target.
std::string Resolved(const std::vector<std::string>& rows) {
  cv::Mat1b classes(static_cast<int>(rows.size()), static_cast<int>(rows[0].size()));
  for (int v = 0; v < classes.rows; ++v) {
    for (int u = 0; u < classes.cols; ++u) {
      const char letter = rows[static_cast<size_t>(v)][static_cast<size_t>(u)];
      classes(v, u) = static_cast<uint8_t>(std::string(".tr?").find(letter));
    }
  }
  const cv::Mat1b target = ResolveColor(classes);
  std::string text;
  for (int v = 0; v < target.rows; ++v) {
    for (int u = 0; u < target.cols; ++u) text += target(v, u) != 0 ? '#' : '.';
    text += '\n';
  }
  return text;
}

TEST(ResolveColorTest, RimIsTargetWhereAChainJoinsItToTheTarget) {
  EXPECT_EQ(Resolved({"tr...r.",  //
                      "..r..r.",  //
                      "...r..r"}),
            "##.....\n"
            "..#....\n"
            "...#...\n");
}

TEST(ResolveColorTest, HolesThatCannotTellAreFilled) {
  EXPECT_EQ(Resolved({"ttttt",  //
                      "tt??t",  //
                      "t??tt",  //
                      "ttttt"}),
            "#####\n#####\n#####\n#####\n");
}

TEST(ResolveColorTest, GroupIsTakenWhenMoreOfItsContourIsTarget) {
  EXPECT_EQ(Resolved({"tttt",  //
                      "tt?.",  //
                      "tttt"}),
            "####\n###.\n####\n");
  EXPECT_EQ(Resolved({"t??....",  //
                      "t??....",  //
                      "t??...."}),
            "#......\n#......\n#......\n")
      << "as much target as other: the border of the image is neither";
}

TEST(ResolveColorTest, WindowBesideTheTargetDoesNotSwallowThePicture) {
  EXPECT_EQ(Resolved({"tt????",  //
                      "tt????",  //
                      "......"}),
            "##....\n##....\n......\n");
  EXPECT_EQ(Resolved({"???", "???"}), "...\n...\n") << "nothing around it to go by";
}

TEST(ResolveColorTest, TakenRimCountsAsContourAndLooseRimDoesNot) {
  EXPECT_EQ(Resolved({"trr", "r?r", "rrr"}), "###\n###\n###\n");
  EXPECT_EQ(Resolved({"rrr", "r?r", "rrr"}), "...\n...\n...\n");
  EXPECT_EQ(Resolved({"ttt..", "t???r", "ttt.."}), "###..\n####.\n###..\n")
      << "a filled group makes no rim target";
}

}  // namespace
}  // namespace geon::attention
