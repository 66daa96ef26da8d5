#include "config/yaml_section.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

namespace geon::config {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

YamlDocument Parse(const std::string& text) {
  Result<YamlDocument> document = YamlDocument::Parse(text, "robot.yaml");
  EXPECT_TRUE(document.ok()) << document.message();
  return *std::move(document);
}

TEST(YamlSectionTest, ReadsEveryTypeAndFinishesCleanly) {
  const YamlDocument document = Parse(
      "port: /dev/ttyS0\nretries: 3\nscale: 2.5e-1\nenabled: true\ntilt_deg: 90\n"
      "list: [1, 2.5]\nnames: [a, b]\nxyz: [1, 2, 3]\n");
  YamlSection root = document.root();
  std::string port;
  int retries = 0;
  double scale = 0.0, tilt_rad = 0.0, xyz[3] = {};
  bool enabled = false;
  std::vector<double> list;
  std::vector<std::string> names;
  root.Read("port", &port);
  root.Read("retries", &retries);
  root.Read("scale", &scale);
  root.Read("enabled", &enabled);
  root.ReadAngle("tilt_deg", &tilt_rad);
  root.Read("list", &list);
  root.Read("names", &names);
  root.ReadNumbers("xyz", 3, xyz);
  EXPECT_TRUE(document.Finish().ok()) << document.Finish().message();
  EXPECT_EQ(port, "/dev/ttyS0");
  EXPECT_EQ(retries, 3);
  EXPECT_EQ(scale, 0.25);
  EXPECT_TRUE(enabled);
  EXPECT_NEAR(tilt_rad, std::numbers::pi / 2, 1e-12);
  EXPECT_THAT(list, ElementsAre(1.0, 2.5));
  EXPECT_THAT(names, ElementsAre("a", "b"));
  EXPECT_EQ(xyz[2], 3.0);
}

TEST(YamlSectionTest, UnknownKeyIsNamedWithItsLine) {
  const YamlDocument document = Parse("known: 1\nunknwon: 2\n");
  int known = 0;
  document.root().Read("known", &known);
  EXPECT_EQ(document.Finish().message(), "robot.yaml:2: 'unknwon' is not a known key");
}

TEST(YamlSectionTest, UnknownKeyInsideAChildIsFound) {
  const YamlDocument document = Parse("ptu:\n  port: x\n  spede: 3\n");
  std::string port;
  document.root().Child("ptu").Read("port", &port);
  EXPECT_EQ(document.Finish().message(), "robot.yaml:3: 'spede' is not a known key");
}

TEST(YamlSectionTest, DuplicateKeyIsRefusedEvenInAnIgnoredSection) {
  const YamlDocument document = Parse("other:\n  a: 1\n  b: 2\n  a: 3\n");
  document.root().Ignore("other");
  EXPECT_EQ(document.Finish().message(), "robot.yaml:4: 'a' is given twice (first in line 2)");
}

TEST(YamlSectionTest, MissingKeyIsReportedOnceAndKeepsTheDefault) {
  const YamlDocument document = Parse("a: 1\n");
  double speed_m_s = 0.5;
  YamlSection root = document.root();
  root.Ignore("a");
  root.Read("speed_m_s", &speed_m_s);
  root.Read("speed_m_s", &speed_m_s);
  EXPECT_EQ(document.Finish().message(), "robot.yaml:1: 'speed_m_s' is missing");
  EXPECT_EQ(speed_m_s, 0.5);
}

TEST(YamlSectionTest, OptionalKeyMayBeAbsentButNotIllTyped) {
  const YamlDocument document = Parse("here: soon\n");
  double here = 1.0, absent = 2.0;
  YamlSection root = document.root();
  root.ReadOptional("here", &here);
  root.ReadOptional("absent", &absent);
  EXPECT_EQ(document.Finish().message(), "robot.yaml:1: 'here' must be a finite number");
  EXPECT_EQ(absent, 2.0);
}

class NotANumberTest : public ::testing::TestWithParam<const char*> {};

TEST_P(NotANumberTest, IsRefused) {
  const YamlDocument document = Parse(std::string("speed: ") + GetParam() + "\n");
  double speed = 0.5;
  document.root().Read("speed", &speed);
  EXPECT_THAT(document.Finish().message(), HasSubstr("'speed' must be a finite number"));
  EXPECT_EQ(speed, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Texts, NotANumberTest,
                         ::testing::Values("nan", ".nan", "inf", "-.inf", "1e999", "\"1\"", "1 m",
                                           "0x10", "", "[1]", "+-1", "true"));

TEST(YamlSectionTest, WholeNumbersAreDecimalAndWhole) {
  const YamlDocument document = Parse("a: 1.5\nb: 99999999999\nc: 010\n");
  YamlSection root = document.root();
  int a = 0, b = 0, c = 0;
  root.Read("a", &a);
  root.Read("b", &b);
  root.Read("c", &c);
  EXPECT_EQ(c, 10);
  EXPECT_EQ(document.Finish().message(),
            "robot.yaml:1: 'a' must be a whole number\nrobot.yaml:2: 'b' must be a whole number");
}

TEST(YamlSectionTest, ListOfWrongLengthOrContentIsRefused) {
  const YamlDocument document = Parse("a: [1, 2]\nb: [1, nan, 3]\nc: 5\n");
  YamlSection root = document.root();
  double xyz[3] = {7, 7, 7};
  std::vector<double> list = {4.0};
  root.ReadNumbers("a", 3, xyz);
  root.ReadNumbers("b", 3, xyz);
  root.Read("c", &list);
  EXPECT_EQ(document.Finish().message(),
            "robot.yaml:1: 'a' must be a list of 3 finite numbers\n"
            "robot.yaml:2: 'b' must be a list of 3 finite numbers\n"
            "robot.yaml:3: 'c' must be a list of finite numbers");
  EXPECT_EQ(xyz[0], 7.0);
  EXPECT_THAT(list, ElementsAre(4.0));
}

TEST(YamlSectionTest, MissingChildIsOneErrorHoweverMuchIsReadFromIt) {
  const YamlDocument document = Parse("bus: {url: x}\n");
  YamlSection root = document.root();
  root.Ignore("bus");
  YamlSection ptu = root.Child("ptu");
  double a = 0.0;
  ptu.Read("a", &a);
  ptu.Check(false, "a", "must be positive");
  ptu.Child("deeper").Read("b", &a);
  EXPECT_EQ(document.Finish().message(), "robot.yaml:1: 'ptu' is missing");
}

TEST(YamlSectionTest, SameChildReadByTwoReadersCountsAsOne) {
  const YamlDocument document = Parse("bus:\n  url: x\n  other: y\n");
  std::string text;
  document.root().Child("bus").Read("url", &text);
  document.root().Child("bus").Read("other", &text);
  EXPECT_TRUE(document.Finish().ok()) << document.Finish().message();
}

TEST(YamlSectionTest, ListOfMapsGivesOneSectionEach) {
  const YamlDocument document =
      Parse("objects:\n  - {x_m: 1}\n  - {x_m: 2, y: 3}\n  - just text\n");
  std::vector<YamlSection> objects = document.root().Children("objects");
  ASSERT_EQ(objects.size(), 2u);
  double x_m = 0.0;
  objects[0].Read("x_m", &x_m);
  objects[1].Read("x_m", &x_m);
  EXPECT_EQ(x_m, 2.0);
  EXPECT_EQ(objects[1].Where(), "robot.yaml:3");
  EXPECT_EQ(document.Finish().message(),
            "robot.yaml:3: 'y' is not a known key\n"
            "robot.yaml:4: every entry of 'objects' must be a map");
  EXPECT_TRUE(document.root().Children("absent").empty());
}

TEST(YamlSectionTest, BrokenRuleNamesKeyAndLineAndIsNotToldTwice) {
  const YamlDocument document = Parse("a: 1\nspeed: -1\n");
  YamlSection root = document.root();
  double speed = 0.0;
  root.Ignore("a");
  root.Read("speed", &speed);
  root.Check(speed > 0, "speed", "must be positive");
  root.Check(speed > 0, "speed", "must be positive");
  EXPECT_EQ(document.Finish().message(), "robot.yaml:2: 'speed' must be positive");
}

TEST(YamlSectionTest, FailNamesTheSection) {
  const YamlDocument document = Parse("a:\n  b: 1\n");
  YamlSection a = document.root().Child("a");
  a.Ignore("b");
  a.Fail("needs a geon, a mesh, a box or a cylinder");
  EXPECT_THAT(document.Finish().message(), HasSubstr("needs a geon"));
}

TEST(YamlDocumentTest, WhatIsNotOneMapIsRefused) {
  EXPECT_FALSE(YamlDocument::Parse("", "f").ok());
  EXPECT_FALSE(YamlDocument::Parse("- 1\n- 2\n", "f").ok());
  EXPECT_FALSE(YamlDocument::Parse("a: 1\n---\nb: 2\n", "f").ok());
  EXPECT_THAT(YamlDocument::Parse("a: 1\nb: [1, 2\n", "f").message(), HasSubstr("f:"));
  EXPECT_THAT(YamlDocument::Load("/nonexistent/robot.yaml").message(),
              HasSubstr("/nonexistent/robot.yaml"));
}

TEST(YamlDocumentTest, AliasesThatUnfoldWithoutEndAreRefused) {
  std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 8; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
    for (int j = 1; j < 10; ++j) text += ", " + before;
    text += "]\n";
  }
  EXPECT_THAT(YamlDocument::Parse(text, "bomb").message(), HasSubstr("too deep or too large"));
}

}  // namespace
}  // namespace geon::config
