#include "attention/resolve_color.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace geon::attention {
namespace {

// One letter a pixel: '.' other, 't' target, 'r' rim, '?' cannot tell; the answer has '#' on the
// target.
std::string Resolved(const std::vector<std::string>& rows) {
  const BitMask empty(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  PixelClasses classes = {empty, empty, empty, empty};
  for (int v = 0; v < empty.height_px(); ++v) {
    for (int u = 0; u < empty.width_px(); ++u) {
      const char letter = rows[static_cast<size_t>(v)][static_cast<size_t>(u)];
      if (letter == 't') classes.target.Set(v, u, u + 1);
      if (letter == 'r') classes.rim.Set(v, u, u + 1);
      if (letter == '?') classes.cannot_tell.Set(v, u, u + 1);
    }
  }
  const BitMask target = ResolveColor(classes);
  std::string text;
  for (int v = 0; v < target.height_px(); ++v) {
    for (int u = 0; u < target.width_px(); ++u) text += target.At(u, v) ? '#' : '.';
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

TEST(ResolveColorTest, SidesOfRunsOfAnyLengthAreCounted) {
  // A run with target above all of it, and below some of it.
  for (const int width : {1, 2, 7, 8, 9, 63, 64, 65, 200}) {
    for (const int first : {0, 1, 57, 60, 63}) {
      const auto row = [&](char letter, int target_pixels) {
        return std::string(static_cast<size_t>(first), '.') +
               std::string(static_cast<size_t>(target_pixels), 't') +
               std::string(static_cast<size_t>(width - target_pixels), letter);
      };
      const std::string hole = std::string(static_cast<size_t>(first), 't') +
                               row('?', 0).substr(static_cast<size_t>(first));
      const int left = first > 0 ? 1 : 0;  // a side on target
      for (int below = 0; below <= width; below += std::max(1, width / 3)) {
        const std::string resolved = Resolved({row('.', width), hole, row('.', below)});
        const int balance = width + 2 * below - width + left;
        EXPECT_EQ(std::count(resolved.begin(), resolved.end(), '#'),
                  first + width + below + (balance > 0 ? width : 0))
            << width << " from " << first << ", below " << below;
      }
      const std::string resolved = Resolved({row('.', 0), hole, row('.', width / 2)});
      EXPECT_EQ(std::count(resolved.begin(), resolved.end(), '#'), first + width / 2)
          << width << " from " << first;
    }
  }
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
