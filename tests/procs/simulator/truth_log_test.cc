#include "procs/simulator/truth_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/random_world.h"

namespace geon::simulator {
namespace {

std::vector<nlohmann::json> LinesOf(const std::filesystem::path& file) {
  std::vector<nlohmann::json> lines;
  std::ifstream stream(file);
  for (std::string text; std::getline(stream, text);) lines.push_back(nlohmann::json::parse(text));
  return lines;
}

TEST(TruthLogTest, TellsTheStartStatesEventsAndTheEnd) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "truth.jsonl";
  const sim::World world = sim::RandomWorld(2, sim::GeonPlace::kFloor);
  {
    auto log = TruthLog::Open(file, world, 2, 1000000);
    ASSERT_TRUE(log.ok()) << log.message();
    sim::RobotTruth truth;
    for (int step = 0; step <= 220; ++step) {
      truth.time_s = 0.001 * step;
      truth.speed_m_s = 0.3;
      truth.horizontal_laser = step >= 50 && step < 120;
      truth.contacts = step >= 150 ? 1 : 0;
      (*log)->Observe(truth);
    }
  }
  const auto lines = LinesOf(file);
  EXPECT_EQ(lines.front()["event"], "start");
  EXPECT_EQ(lines.front()["seed"], 2);
  EXPECT_EQ(lines.front()["objects"].back()["label"],
            std::string(ToString(*sim::TrueLabel(world.objects.back()))));
  EXPECT_EQ(lines.back()["event"], "stop");
  int states = 0;
  std::vector<double> laser_s, contact_s;
  for (const auto& line : lines) {
    if (line["event"] == "state") ++states;
    if (line["event"] == "laser") laser_s.push_back(line["time_s"]);
    if (line["event"] == "contact") {
      contact_s.push_back(line["time_s"]);
      EXPECT_DOUBLE_EQ(line["speed_m_s"], 0.3);
    }
    EXPECT_EQ(line["utime"].get<int64_t>(),
              1000000 + static_cast<int64_t>(std::llround(line["time_s"].get<double>() * 1e6)));
  }
  EXPECT_EQ(states, 5);  // 20 a second, the first at once
  ASSERT_EQ(laser_s.size(), 2U);
  EXPECT_NEAR(laser_s[0], 0.05, 1e-9);
  EXPECT_NEAR(laser_s[1], 0.12, 1e-9);
  EXPECT_EQ(contact_s, (std::vector<double>{0.15}));
}

TEST(TruthLogTest, SaysWhereItCannotWrite) {
  const auto log = TruthLog::Open("/nowhere/truth.jsonl", sim::World(), 1, 0);
  ASSERT_FALSE(log.ok());
  EXPECT_NE(log.message().find("/nowhere"), std::string::npos);
}

}  // namespace
}  // namespace geon::simulator
