#include "messaging/message_schema.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "messaging/codec.h"
#include "messaging/wire.h"
#include "tests/common/messaging/sample_messages.h"

namespace geon::messaging {
namespace {

TEST(MessageSchema, ComputesTheFingerprintsOfLcmGen) {
  const auto fingerprint = [](const char* name) {
    return Fingerprint(AllSchemas().find(std::string_view(name))->second);
  };
  EXPECT_EQ(fingerprint("point2_t"), static_cast<uint64_t>(geon::point2_t::getHash()));
  EXPECT_EQ(fingerprint("bumper_t"), static_cast<uint64_t>(geon::bumper_t::getHash()));
  EXPECT_EQ(fingerprint("image_t"), static_cast<uint64_t>(geon::image_t::getHash()));
  EXPECT_EQ(fingerprint("verdict_t"), static_cast<uint64_t>(geon::verdict_t::getHash()));
  EXPECT_EQ(fingerprint("target_view_t"), static_cast<uint64_t>(geon::target_view_t::getHash()));
}

TEST(MessageSchema, ReadsADeclaration) {
  const auto schema = ParseSchema(
      "package p; // comment\n/* more */ struct s_t { int32_t n, m; double a[n][3]; string t;\n"
      "const int32_t A = 1, B = 2; }");
  ASSERT_TRUE(schema.ok()) << schema.message();
  EXPECT_EQ(schema->name, "s_t");
  ASSERT_EQ(schema->fields.size(), 4u);
  EXPECT_EQ(schema->fields[1].name, "m");
  EXPECT_EQ(schema->fields[2].dimensions, (std::vector<std::string>{"n", "3"}));
}

TEST(MessageSchema, RefusesWhatIsNoDeclaration) {
  EXPECT_FALSE(ParseSchema("").ok());
  EXPECT_FALSE(ParseSchema("struct s_t { double a ").ok());
  EXPECT_FALSE(ParseSchema("struct s_t { double a[3; }").ok());
  EXPECT_FALSE(ParseSchema("struct s_t double a; }").ok());
}

TEST(MessageSchema, NamesAndSumsTheFingerprints) {
  EXPECT_EQ(TypeNameOf(WireFingerprint<sensor::Stripe>()), "stripe_t");
  EXPECT_EQ(TypeNameOf(1), "");
  uint64_t sum = 0;
  for (const auto& [name, schema] : AllSchemas()) sum += Fingerprint(schema);
  EXPECT_EQ(TypesHash(), static_cast<int64_t>(sum));
}

TEST(MessageSchema, ChecksAcceptWhatWasEncoded) {
  EXPECT_TRUE(CheckMessage("planner_state_t", Encode(samples::PlannerState())).ok());
  EXPECT_TRUE(CheckMessage("target_view_t", Encode(samples::TargetView())).ok());
  EXPECT_TRUE(CheckMessage("bumper_t", Encode(samples::BumperState())).ok());
}

TEST(MessageSchema, TellsWhichFieldIsWrong) {
  std::vector<uint8_t> bytes = Encode(samples::Health());
  bytes[8 + 8 + 4] = 0xff;  // the length of `process`
  EXPECT_NE(CheckMessage("health_t", bytes).message().find("health_t.process: string of -"),
            std::string::npos);
}

TEST(MessageSchema, PrintsMessagesWithoutTheirImages) {
  const auto stripe = MessageToJson(Encode(samples::Stripe()));
  ASSERT_TRUE(stripe.ok()) << stripe.message();
  EXPECT_EQ((*stripe)["scan_id"], 1234567890123);
  EXPECT_EQ((*stripe)["laser"], 2);
  EXPECT_EQ((*stripe)["pan_rad"], 0.1);
  EXPECT_EQ((*stripe)["difference"]["data"]["bytes"], 4);
  const auto sonar = MessageToJson(Encode(samples::SonarScan()));
  ASSERT_TRUE(sonar.ok()) << sonar.message();
  EXPECT_EQ(sonar->dump().find("nan"), std::string::npos);
  EXPECT_EQ((*sonar)["range_m"].size(), 16u);
  const auto verdict = MessageToJson(Encode(samples::Verdict()));
  ASSERT_TRUE(verdict.ok()) << verdict.message();
  EXPECT_EQ((*verdict)["decided"], true);
  EXPECT_EQ((*verdict)["reasons"][0], "two curves");
  EXPECT_EQ((*verdict)["profiles"][1]["theta_rad"][1], 0.6);
  const auto session = MessageToJson(Encode(samples::Session()));
  EXPECT_EQ((*session)["types_hash"], -5);
}

TEST(MessageSchema, PrintsNothingOfUnknownTypes) {
  EXPECT_FALSE(MessageToJson(std::vector<uint8_t>(40)).ok());
  EXPECT_FALSE(MessageToJson({}).ok());
}

}  // namespace
}  // namespace geon::messaging
