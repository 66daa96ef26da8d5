#include "messaging/bus.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <stdexcept>

#include "messaging/bus_url.h"
#include "messaging/channels.h"
#include "messaging/clock.h"
#include "tests/common/messaging/sample_messages.h"

namespace geon::messaging {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// A bus of this process only, and what it warned of.
struct MemoryBus {
  std::vector<std::string> warnings;
  std::unique_ptr<Bus> bus;
  MemoryBus() {
    BusOptions options;
    options.url = "memq://";
    options.process = "test";
    options.warn = [this](const std::string& text) { warnings.push_back(text); };
    bus = std::move(*Bus::Open(options));
  }
};

sensor::PtuState State(int32_t seq) {
  sensor::PtuState state;
  state.seq = seq;
  return state;
}

TEST(Bus, DeliversEveryMessageInOrder) {
  MemoryBus memory;
  std::vector<int32_t> seen;
  memory.bus->Subscribe<sensor::PtuState>(
      kPtuState, [&](const sensor::PtuState& state) { seen.push_back(state.seq); });
  for (int32_t seq = 1; seq <= 50; ++seq) memory.bus->Publish(kPtuState, State(seq));
  memory.bus->HandlePending();
  ASSERT_EQ(seen.size(), 50u);
  EXPECT_EQ(seen.front(), 1);
  EXPECT_EQ(seen.back(), 50);
  EXPECT_EQ(memory.bus->statistics().lost(), 0);
  EXPECT_TRUE(memory.warnings.empty());
}

TEST(Bus, LatestDeliversTheNewestOnlyAndCountsAll) {
  MemoryBus memory;
  std::vector<int32_t> seen;
  memory.bus->SubscribeLatest<sensor::PtuState>(
      kPtuState, [&](const sensor::PtuState& state) { seen.push_back(state.seq); });
  for (const int32_t seq : {1, 2, 3, 5}) memory.bus->Publish(kPtuState, State(seq));
  memory.bus->HandlePending();
  EXPECT_THAT(seen, ElementsAre(5));
  EXPECT_EQ(memory.bus->statistics().received(), 4);
  EXPECT_EQ(memory.bus->statistics().lost(), 1);
  memory.bus->HandlePending();
  EXPECT_THAT(seen, ElementsAre(5));
}

TEST(Bus, APatternKeepsChannelsApart) {
  MemoryBus memory;
  std::vector<std::string> seen;
  memory.bus->SubscribeLatest<sensor::Health>(
      kAnyHealth, [&](const sensor::Health& health) { seen.push_back(health.process); });
  sensor::Health health;
  health.seq = 1;
  for (const char* process : {"base", "ptu"}) {
    health.process = process;
    memory.bus->Publish(std::string("HEALTH_") + process, health);
  }
  memory.bus->HandlePending();
  EXPECT_THAT(seen, ElementsAre("base", "ptu"));
}

TEST(Bus, AForeignTypeIsRefusedAndNamedOnce) {
  MemoryBus memory;
  int handled = 0;
  memory.bus->Subscribe<sensor::PtuState>(kPtuState, [&](const sensor::PtuState&) { ++handled; });
  for (int i = 0; i < 20; ++i) memory.bus->Publish(kPtuState, samples::SonarScan());
  memory.bus->Publish(kPtuState, State(1));
  memory.bus->HandlePending();
  EXPECT_EQ(handled, 1);
  EXPECT_EQ(memory.bus->statistics().refused(), 20);
  EXPECT_THAT(memory.warnings,
              ElementsAre("refused 1 message(s) on PTU_STATE: expected geon.ptu_state_t, found "
                          "geon.sonar_t"));
}

TEST(Bus, WhatAHandlerThrowsComesOutOfHandlePending) {
  MemoryBus memory;
  int handled = 0;
  memory.bus->Subscribe<sensor::PtuState>(kPtuState, [&](const sensor::PtuState&) {
    if (++handled == 1) throw std::runtime_error("broken");
  });
  memory.bus->Publish(kPtuState, State(1));
  memory.bus->Publish(kPtuState, State(2));
  EXPECT_THROW(memory.bus->HandlePending(), std::runtime_error);
  memory.bus->HandlePending();
  EXPECT_EQ(handled, 2);
}

TEST(Bus, AHandlerMayPublish) {
  MemoryBus memory;
  std::vector<int32_t> seen;
  memory.bus->Subscribe<sensor::PtuCommand>(
      kPtuCommand, [&](const sensor::PtuCommand&) { memory.bus->Publish(kPtuState, State(9)); });
  memory.bus->Subscribe<sensor::PtuState>(
      kPtuState, [&](const sensor::PtuState& state) { seen.push_back(state.seq); });
  memory.bus->Publish(kPtuCommand, sensor::PtuCommand{});
  memory.bus->HandlePending();
  EXPECT_THAT(seen, ElementsAre(9));
}

TEST(Bus, ABadUrlIsAnErrorThatNamesIt) {
  BusOptions options;
  options.url = "nonsense://";
  options.route_timeout_s = 0.0;
  const auto bus = Bus::Open(options);
  ASSERT_FALSE(bus.ok());
  EXPECT_THAT(bus.message(), HasSubstr("nonsense://"));
}

// ---- over UDP, on a port of this test's own
// -------------------------------------------------------

constexpr const char* kTestUrl = "udpm://239.255.76.67:17671?ttl=0";

std::unique_ptr<Bus> OpenUdp(const std::string& url, std::vector<std::string>* warnings) {
  BusOptions options;
  options.url = url;
  options.process = "test";
  options.route_timeout_s = 0.0;
  options.warn = [warnings](const std::string& text) { warnings->push_back(text); };
  Result<std::unique_ptr<Bus>> bus = Bus::Open(options);
  if (!bus.ok()) return nullptr;
  return std::move(*bus);
}

// Handles what comes until nothing has come for a while.
void HandleUntilSilent(Bus* bus, int silence_ms) {
  pollfd fd{bus->file_descriptor(), POLLIN, 0};
  while (poll(&fd, 1, silence_ms) > 0) bus->HandlePending();
}

TEST(Bus, NoImageIsLostWithTheConfiguredBuffer) {
  const auto limits = ReadKernelBufferLimits();
  if (!limits || limits->max_bytes < kNeededReceiveBuffer) {
    GTEST_SKIP() << "net.core.rmem_max is too small here (scripts/config/60-geon.conf raises it)";
  }
  std::vector<std::string> warnings;
  const auto receiver = OpenUdp(kTestUrl, &warnings);
  const auto sender = OpenUdp(kTestUrl, &warnings);
  if (!receiver || !sender) GTEST_SKIP() << "no multicast route here";
  int handled = 0;
  receiver->Subscribe<sensor::Image>(kColorImage, [&](const sensor::Image&) { ++handled; });
  sensor::Image image = samples::GreyImage(640 * 3, 480);
  image.width_px = 640;
  image.format = sensor::PixelFormat::kBgr8;
  constexpr int kImages = 40;
  for (int32_t seq = 1; seq <= kImages; ++seq) {
    image.seq = seq;
    sender->Publish(kColorImage, image);
    HandleUntilSilent(receiver.get(), 30);  // the pace of a camera
  }
  HandleUntilSilent(receiver.get(), 300);
  EXPECT_EQ(handled, kImages);
  EXPECT_EQ(receiver->statistics().lost(), 0);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
}

TEST(Bus, TheDefaultBufferIsWarnedOfAtTheStart) {
  std::vector<std::string> warnings;
  const auto bus = OpenUdp(std::string(kTestUrl) + "&recv_buf_size=0", &warnings);
  if (!bus) GTEST_SKIP() << "no multicast route here";
  const auto limits = ReadKernelBufferLimits();
  if (!limits || limits->default_bytes >= kNeededReceiveBuffer) {
    GTEST_SKIP() << "this kernel's default buffer is large enough";
  }
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], HasSubstr("IMAGES WILL BE LOST"));
}

}  // namespace
}  // namespace geon::messaging
