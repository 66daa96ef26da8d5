#include "sim/line_faults.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

namespace geon::sim {
namespace {

using ::testing::HasSubstr;

std::vector<uint8_t> Numbers(size_t count) {
  std::vector<uint8_t> bytes(count);
  std::iota(bytes.begin(), bytes.end(), uint8_t{0});
  return bytes;
}

LineFaultOptions Parsed(const char* text) { return ParseLineFaults(text).value(); }

TEST(LineFaults, NoFaultsChangeNothing) {
  LineFaults line(Parsed(""));
  EXPECT_EQ(line.ToDevice(Numbers(50)), Numbers(50));
  EXPECT_EQ(line.ToHost(Numbers(50), 1.0), Numbers(50));
  EXPECT_FALSE(line.TakeReboot(1e9));
}

TEST(LineFaults, DelayHoldsBack) {
  LineFaults line(Parsed("delay_s=0.2"));
  EXPECT_TRUE(line.ToHost(Numbers(3), 1.0).empty());
  EXPECT_TRUE(line.ToHost({}, 1.19).empty());
  EXPECT_EQ(line.ToHost({}, 1.21), Numbers(3));
}

TEST(LineFaults, DropsBytesBothWays) {
  LineFaults line(Parsed("drop_1=0.5,seed=3"));
  const size_t down = line.ToDevice(Numbers(200)).size();
  const size_t up = line.ToHost(Numbers(200), 0.0).size();
  EXPECT_GT(down, 60u);
  EXPECT_LT(down, 140u);
  EXPECT_GT(up, 60u);
  EXPECT_LT(up, 140u);
}

TEST(LineFaults, CorruptsOneBit) {
  LineFaults line(Parsed("corrupt_1=1"));
  const auto heard = line.ToHost(Numbers(100), 0.0);
  ASSERT_EQ(heard.size(), 100u);
  for (size_t i = 0; i < heard.size(); ++i) {
    EXPECT_EQ(__builtin_popcount(heard[i] ^ static_cast<unsigned>(i)), 1);
  }
}

TEST(LineFaults, SplitsWritesWithoutLosingOrder) {
  LineFaults line(Parsed("split_1=0.3,split_pause_s=0.1"));
  std::vector<uint8_t> heard = line.ToHost(Numbers(20), 0.0);
  EXPECT_LT(heard.size(), 20u);
  for (double t_s = 0.0; t_s < 3.0; t_s += 0.01) {
    for (const uint8_t byte : line.ToHost({}, t_s)) heard.push_back(byte);
  }
  EXPECT_EQ(heard, Numbers(20));
}

TEST(LineFaults, PutsGarbageInFront) {
  LineFaults line(Parsed("garbage_1=1,garbage_bytes=4"));
  const auto heard = line.ToHost(Numbers(3), 0.0);
  ASSERT_EQ(heard.size(), 7u);
  EXPECT_EQ((std::vector<uint8_t>{heard.begin() + 4, heard.end()}), Numbers(3));
}

TEST(LineFaults, FallsSilentAndComesBack) {
  LineFaults line(Parsed("silent_from_s=10,silent_until_s=12"));
  EXPECT_EQ(line.ToHost(Numbers(2), 9.9).size(), 2u);
  EXPECT_TRUE(line.ToHost(Numbers(2), 11.0).empty());
  EXPECT_EQ(line.ToHost(Numbers(2), 12.0), Numbers(2)) << "what was said meanwhile is lost";
}

TEST(LineFaults, RebootsOnce) {
  LineFaults line(Parsed("reboot_at_s=5"));
  EXPECT_FALSE(line.TakeReboot(4.9));
  EXPECT_TRUE(line.TakeReboot(5.1));
  EXPECT_FALSE(line.TakeReboot(5.2));
}

TEST(LineFaults, TheSameSeedSpoilsTheSameBytes) {
  LineFaults a(Parsed("corrupt_1=0.2,drop_1=0.1,garbage_1=0.5,seed=8"));
  LineFaults b(Parsed("corrupt_1=0.2,drop_1=0.1,garbage_1=0.5,seed=8"));
  LineFaults c(Parsed("corrupt_1=0.2,drop_1=0.1,garbage_1=0.5,seed=9"));
  const auto spoiled = a.ToHost(Numbers(100), 0.0);
  EXPECT_EQ(spoiled, b.ToHost(Numbers(100), 0.0));
  EXPECT_NE(spoiled, c.ToHost(Numbers(100), 0.0));
}

TEST(LineFaults, AWrongWordIsNamed) {
  EXPECT_THAT(ParseLineFaults("delay=1").message(), HasSubstr("'delay' is unknown"));
  EXPECT_THAT(ParseLineFaults("delay_s").message(), HasSubstr("'delay_s' is not name=number"));
  EXPECT_THAT(ParseLineFaults("drop_1=1.5").message(), HasSubstr("probability"));
  EXPECT_THAT(ParseLineFaults("delay_s=-1").message(), HasSubstr("negative"));
  EXPECT_THAT(ParseLineFaults("garbage_bytes=2.5").message(), HasSubstr("whole number"));
  EXPECT_THAT(ParseLineFaults("silent_from_s=9,silent_until_s=3").message(), HasSubstr("before"));
}

}  // namespace
}  // namespace geon::sim
