#include "config/verdict_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace geon::config {
namespace {

TEST(VerdictJson, IsOneLineWithTheContractsKeys) {
  sensor::GeonVerdict verdict;
  verdict.label = GeonLabel::kTaperedCylinder;
  verdict.confidence = 0.5;
  verdict.posterior = {0.1, 0.1, 0.1, 0.1, 0.5, 0.05, 0.05};
  verdict.decided = true;
  verdict.method = "thesis";
  verdict.tapering.monotone_horizontal = true;
  sensor::ProfileEvidence profile;
  profile.segments = 1;
  profile.curves = 2;
  profile.corners = 3;
  profile.length_m = 0.2;
  verdict.profiles.push_back(profile);
  verdict.reasons = {"Not bent.", "Tapered."};
  const std::string text = SerializeVerdict(verdict, "a/b.json", 123);
  EXPECT_EQ(text.find('\n'), std::string::npos);
  const nlohmann::json root = nlohmann::json::parse(text);
  EXPECT_EQ(root["format"], "geon.verdict.v1");
  EXPECT_EQ(root["file"], "a/b.json");
  EXPECT_EQ(root["label"], "tapered_cylinder");
  EXPECT_EQ(root["confidence"], 0.5);
  EXPECT_EQ(root["posterior"].size(), 7U);
  EXPECT_EQ(root["posterior"]["tapered_cylinder"], 0.5);
  EXPECT_EQ(root["decided"], true);
  EXPECT_EQ(root["evidence"]["tapering"]["found"], true);
  EXPECT_EQ(root["evidence"]["bending"]["found"], false);
  EXPECT_EQ(root["evidence"]["profiles"][0]["curves"], 2);
  EXPECT_EQ(root["evidence"]["profiles"][0]["corners"], 3);
  EXPECT_EQ(root["evidence"]["profiles"][0]["segments"], 1);
  EXPECT_EQ(root["evidence"]["profiles"][0]["length_m"], 0.2);
  EXPECT_EQ(root["microseconds"], 123);
}

TEST(VerdictJson, SurvivesAFileNameThatIsNoText) {
  const std::string text = SerializeVerdict({}, "bad\xff.json", 0);
  EXPECT_TRUE(nlohmann::json::accept(text));
}

}  // namespace
}  // namespace geon::config
