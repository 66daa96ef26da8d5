#include "messaging/health_reporter.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "messaging/channels.h"
#include "messaging/message_schema.h"

namespace geon::messaging {
namespace {

TEST(HealthReporter, NamesTheChannelAfterTheProcess) {
  EXPECT_EQ(HealthChannel("geon-ptu"), "HEALTH_PTU");
  EXPECT_EQ(HealthChannel("geon-color-camera-head"), "HEALTH_COLOR_CAMERA_HEAD");
}

TEST(HealthReporter, PublishesHealthAndSessionAtOnce) {
  BusOptions options;
  options.url = "memq://";
  auto bus = std::move(*Bus::Open(options));
  PollLoop loop;
  HealthReporter reporter(bus.get(), &loop, {"geon-test", "1.2.3", "cafe"});
  reporter.SetLevel(sensor::HealthLevel::kWarn, "because");
  reporter.CountReconnect();
  reporter.ReportAge(0.25);
  reporter.ReportAge(0.125);
  reporter.SetCalibration("beef", "lut.yaml");
  std::optional<sensor::Health> health;
  std::optional<sensor::Session> session;
  bus->Subscribe<sensor::Health>("HEALTH_TEST", [&](const sensor::Health& h) { health = h; });
  bus->Subscribe<sensor::Session>(kGeonSession, [&](const sensor::Session& s) { session = s; });
  loop.Watch(bus->file_descriptor(), [&] {
    bus->HandlePending();
    if (health && session) loop.Stop();
  });
  loop.Run();
  EXPECT_EQ(health->process, "geon-test");
  EXPECT_EQ(health->pid, getpid());
  EXPECT_EQ(health->version, "1.2.3");
  EXPECT_EQ(health->config_hash, "cafe");
  EXPECT_EQ(health->level, sensor::HealthLevel::kWarn);
  EXPECT_EQ(health->text, "because");
  EXPECT_EQ(health->reconnects, 1);
  EXPECT_EQ(health->max_age_s, 0.25);
  EXPECT_EQ(health->seq, 1);
  EXPECT_GT(health->utime, 0);
  EXPECT_GT(health->rss_bytes, 1'000'000);
  EXPECT_EQ(session->process, "geon-test");
  EXPECT_EQ(session->calibration_hash, "beef");
  EXPECT_EQ(session->types_hash, TypesHash());
  EXPECT_FALSE(session->host.empty());
}

}  // namespace
}  // namespace geon::messaging
