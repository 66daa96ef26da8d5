#include "procs/simulator/frame_publisher.h"

#include <gtest/gtest.h>

#include "sim/world_scene.h"

namespace geon::simulator {
namespace {

sim::RigRenderer PlainRenderer() {
  return sim::RigRenderer(*sim::BuildScene(sim::World()), geometry::SensorRig(),
                          sim::RendererOptions(), 1);
}

TEST(FramePublisherTest, SaysWhereItCannotPublish) {
  const auto publisher = FramePublisher::Open("/nowhere/run", PlainRenderer(), 0);
  ASSERT_FALSE(publisher.ok());
  EXPECT_NE(publisher.message().find("/nowhere/run/head_color.frames"), std::string::npos);
}

TEST(FramePublisherTest, EndsAtOnceWithoutSubscribers) {
  const auto publisher = FramePublisher::Open(::testing::TempDir(), PlainRenderer(), 0);
  ASSERT_TRUE(publisher.ok()) << publisher.message();
  (*publisher)->Offer(sim::Exposure());
}

}  // namespace
}  // namespace geon::simulator
