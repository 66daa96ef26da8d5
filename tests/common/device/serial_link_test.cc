#include "device/serial_link.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include "base/contracts.h"

namespace geon::device {
namespace {

// A device that can be plugged in and out under a stable path.
class Plug {
 public:
  Plug() {
    std::string folder = (std::filesystem::temp_directory_path() / "geon-link-XXXXXX").string();
    EXPECT_NE(mkdtemp(folder.data()), nullptr);
    folder_ = folder;
  }
  ~Plug() {
    Out();
    std::filesystem::remove_all(folder_);
  }
  void In() {
    fd_ = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    ASSERT_EQ(grantpt(fd_), 0);
    ASSERT_EQ(unlockpt(fd_), 0);
    std::array<char, 100> name{};
    ASSERT_EQ(ptsname_r(fd_, name.data(), name.size()), 0);
    std::filesystem::remove(path());
    std::filesystem::create_symlink(name.data(), path());
  }
  void Out() {
    if (fd_ >= 0) close(fd_);
    fd_ = -1;
  }
  void Say(const std::string& bytes) const {
    ASSERT_EQ(write(fd_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  std::string Hear() const {
    std::array<char, 1000> bytes{};
    const ssize_t count = read(fd_, bytes.data(), bytes.size());
    return {bytes.data(), static_cast<size_t>(count < 0 ? 0 : count)};
  }
  std::string path() const { return (folder_ / "device").string(); }

 private:
  std::filesystem::path folder_;
  int fd_ = -1;
};

TEST(SerialLinkTest, FollowsADeviceThroughUnplugAndReplug) {
  Plug plug;
  SerialLink link({.path = plug.path(), .baud = 9600});
  EXPECT_FALSE(link.Service(0.0).opened);
  EXPECT_NE(link.trouble().find("cannot open"), std::string::npos);
  plug.In();
  EXPECT_FALSE(link.Service(0.1).opened) << "the first retry waits";
  EXPECT_TRUE(link.Service(0.25).opened);
  EXPECT_EQ(link.reconnects(), 0);
  link.Send("hello");
  EXPECT_EQ(plug.Hear(), "hello");
  plug.Say("there");
  EXPECT_EQ(link.Service(0.3).bytes, "there");
  plug.Out();
  EXPECT_TRUE(link.Service(0.4).lost);
  EXPECT_FALSE(link.is_open());
  EXPECT_FALSE(link.trouble().empty());
  link.Send("into the void");
  plug.In();
  EXPECT_TRUE(link.Service(10.0).opened);
  EXPECT_EQ(link.reconnects(), 1);
  EXPECT_EQ(plug.Hear(), "") << "what was said meanwhile is gone";
}

TEST(SerialLinkTest, ALossSeenWhileSendingIsReportedOnce) {
  Plug plug;
  plug.In();
  SerialLink link({.path = plug.path(), .baud = 9600});
  EXPECT_TRUE(link.Service(0.0).opened);
  plug.Out();
  link.Send("x");
  EXPECT_FALSE(link.is_open());
  EXPECT_TRUE(link.Service(0.1).lost);
  EXPECT_FALSE(link.Service(0.2).lost);
}

TEST(SerialLinkTest, WaitsLongerBetweenAttemptsUpToALimit) {
  Plug plug;
  SerialLink link({.path = plug.path(), .first_retry_s = 0.1, .longest_retry_s = 0.4});
  const auto service_until = [&](int from_ms, int to_ms) {
    for (int t_ms = from_ms; t_ms < to_ms; t_ms += 10) {
      if (link.Service(t_ms * 1e-3).opened) return t_ms;
    }
    return -1;
  };
  EXPECT_EQ(service_until(0, 1530), -1);  // tries at 0, 0.1, 0.3, 0.7, 1.1, 1.5 s
  plug.In();
  EXPECT_NEAR(service_until(1530, 5000), 1900, 40);
  EXPECT_THROW(SerialLink({.path = ""}), ContractViolation);
}

TEST(SerialLinkTest, ADeviceThatTakesNoBytesIsGivenUp) {
  Plug plug;
  plug.In();
  SerialLink link({.path = plug.path(), .baud = 9600});
  EXPECT_TRUE(link.Service(0.0).opened);
  for (int i = 0; i < 2000 && link.is_open(); ++i) link.Send(std::string(100, 'x'));
  EXPECT_FALSE(link.is_open());
  EXPECT_TRUE(link.Service(0.1).lost);
}

}  // namespace
}  // namespace geon::device
