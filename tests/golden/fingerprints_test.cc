// Pins the fingerprint of every message type. A changed type makes recorded logs and other builds
// unreadable: add a new type beside the released one instead, and a line to fingerprints.txt.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include "messaging/codec.h"
#include "messaging/message_schema.h"
#include "messaging/wire.h"

namespace geon::messaging {
namespace {

std::string Hex(uint64_t fingerprint) {
  char text[19];
  std::snprintf(text, sizeof(text), "0x%016llx", static_cast<unsigned long long>(fingerprint));
  return text;
}

// "image_t 0x0123456789abcdef" a line.
std::map<std::string, std::string> Pinned() {
  std::map<std::string, std::string> pinned;
  std::ifstream file(std::string(GEON_SOURCE_DIR) + "/tests/golden/fingerprints.txt");
  std::string name;
  std::string fingerprint;
  while (file >> name >> fingerprint) pinned[name] = fingerprint;
  return pinned;
}

std::set<std::string> DeclaredTypes() {
  std::set<std::string> types;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(GEON_SOURCE_DIR) + "/lcmtypes")) {
    if (entry.path().extension() == ".lcm") {
      types.insert(entry.path().stem().string().substr(std::string("geon_").size()));
    }
  }
  return types;
}

TEST(Fingerprints, AreThoseOfTheReleasedTypes) {
  std::map<std::string, std::string> actual;
  for (const auto& [name, schema] : AllSchemas()) actual[name] = Hex(Fingerprint(schema));
  EXPECT_EQ(actual, Pinned());
}

TEST(Fingerprints, EveryDeclaredTypeIsPinned) {
  std::set<std::string> pinned;
  for (const auto& [name, fingerprint] : Pinned()) pinned.insert(name);
  EXPECT_EQ(pinned, DeclaredTypes());
}

TEST(Fingerprints, NoTwoTypesLookAlike) {
  std::set<uint64_t> fingerprints;
  for (const auto& [name, schema] : AllSchemas()) fingerprints.insert(Fingerprint(schema));
  EXPECT_EQ(fingerprints.size(), AllSchemas().size());
}

// That what is pinned is what lcm-gen compiles in, for every type that travels on its own.
template <typename T>
void ExpectPinned() {
  const std::string name = T::getTypeName();
  EXPECT_EQ(Hex(static_cast<uint64_t>(T::getHash())), Pinned()[name]) << name;
}

TEST(Fingerprints, AreThoseThatLcmGenCompilesIn) {
  ExpectPinned<geon::image_t>();
  ExpectPinned<geon::image_metadata_t>();
  ExpectPinned<geon::stripe_t>();
  ExpectPinned<geon::scan_command_t>();
  ExpectPinned<geon::scan_plan_t>();
  ExpectPinned<geon::planned_stripe_t>();
  ExpectPinned<geon::range_profile_t>();
  ExpectPinned<geon::verdict_t>();
  ExpectPinned<geon::profile_evidence_t>();
  ExpectPinned<geon::ptu_state_t>();
  ExpectPinned<geon::ptu_command_t>();
  ExpectPinned<geon::base_state_t>();
  ExpectPinned<geon::base_command_t>();
  ExpectPinned<geon::sonar_t>();
  ExpectPinned<geon::bumper_t>();
  ExpectPinned<geon::infrared_t>();
  ExpectPinned<geon::laser_state_t>();
  ExpectPinned<geon::planner_state_t>();
  ExpectPinned<geon::point2_t>();
  ExpectPinned<geon::target_view_t>();
  ExpectPinned<geon::health_t>();
  ExpectPinned<geon::session_t>();
}

}  // namespace
}  // namespace geon::messaging
