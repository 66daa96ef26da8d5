#include "messaging/bus_url.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace geon::messaging {
namespace {

constexpr KernelBufferLimits kRaised{4'194'304, 212'992};
constexpr KernelBufferLimits kStockDebian{212'992, 212'992};

TEST(BusUrl, AReceiveBufferIsAppendedWhenMissing) {
  EXPECT_EQ(WithReceiveBuffer("udpm://239.255.76.67:7667"),
            "udpm://239.255.76.67:7667?recv_buf_size=4194304");
  EXPECT_EQ(WithReceiveBuffer("udpm://239.255.76.67:7667?ttl=0"),
            "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304");
}

TEST(BusUrl, WhatTheUrlSaysIsKept) {
  const std::string url = "udpm://239.255.76.67:7667?recv_buf_size=0&ttl=1";
  EXPECT_EQ(WithReceiveBuffer(url), url);
  EXPECT_EQ(WithReceiveBuffer("memq://"), "memq://");
}

TEST(BusUrl, TheKernelCapsTheBuffer) {
  const std::string url = "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304";
  EXPECT_EQ(GrantedReceiveBuffer(url, kRaised), 4'194'304);
  EXPECT_EQ(GrantedReceiveBuffer(url, kStockDebian), 212'992);
  EXPECT_EQ(GrantedReceiveBuffer("udpm://239.255.76.67:7667", kRaised), 212'992);
  EXPECT_EQ(GrantedReceiveBuffer("memq://", kRaised), std::nullopt);
}

TEST(BusUrl, WarnsLoudlyWhenTheKernelCapsTheBuffer) {
  const auto warning =
      ReceiveBufferWarning("udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304", kStockDebian);
  ASSERT_TRUE(warning.has_value());
  EXPECT_EQ(*warning,
            "the LCM receive buffer is 212992 bytes, not the 4194304 asked for, because "
            "net.core.rmem_max caps it: raise the cap with `sudo sysctl -w "
            "net.core.rmem_max=4194304` (for good: scripts/config/60-geon.conf to "
            "/etc/sysctl.d/). IMAGES WILL BE LOST");
}

TEST(BusUrl, WarnsLoudlyOfTheDefaultBuffer) {
  const auto warning =
      ReceiveBufferWarning("udpm://239.255.76.67:7667?ttl=0&recv_buf_size=0", kRaised);
  ASSERT_TRUE(warning.has_value());
  EXPECT_EQ(*warning,
            "the LCM receive buffer is 212992 bytes because the LCM URL says so: use "
            "recv_buf_size=4194304 in it, or leave the option out. IMAGES WILL BE LOST");
}

TEST(BusUrl, IsSilentWhenTheBufferIsGranted) {
  EXPECT_FALSE(ReceiveBufferWarning("udpm://239.255.76.67:7667?recv_buf_size=4194304", kRaised));
  EXPECT_FALSE(ReceiveBufferWarning("udpm://239.255.76.67:7667?recv_buf_size=2097152", kRaised));
  EXPECT_FALSE(ReceiveBufferWarning("memq://", kStockDebian));
}

TEST(BusUrl, ACapAboveTheNeedIsToldWithoutAlarm) {
  const auto warning =
      ReceiveBufferWarning("udpm://239.255.76.67:7667?recv_buf_size=8388608", kRaised);
  ASSERT_TRUE(warning.has_value());
  EXPECT_EQ(warning->find("IMAGES"), std::string::npos);
}

TEST(BusUrl, ReadsTheKernelsLimits) {
  const std::filesystem::path directory =
      std::filesystem::path(testing::TempDir()) / "geon_bus_url_test";
  std::filesystem::create_directories(directory);
  std::ofstream(directory / "rmem_max") << "123456\n";
  EXPECT_FALSE(ReadKernelBufferLimits(directory).has_value());
  std::ofstream(directory / "rmem_default") << "212992\n";
  const auto limits = ReadKernelBufferLimits(directory);
  ASSERT_TRUE(limits.has_value());
  EXPECT_EQ(limits->max_bytes, 123456);
  EXPECT_EQ(limits->default_bytes, 212992);
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace geon::messaging
