#include "procs/simulator/pty_port.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

namespace geon::simulator {
namespace {

// A folder of its own for the links, and a driver's end of a port.
class PtyPortTest : public ::testing::Test {
 protected:
  PtyPortTest() {
    std::string name = (std::filesystem::temp_directory_path() / "pty_port_XXXXXX").string();
    folder_ = mkdtemp(name.data());
    link_ = folder_ / "ptu.tty";
  }
  ~PtyPortTest() override {
    CloseDriver();
    std::filesystem::remove_all(folder_);
  }
  void OpenDriver() {
    driver_ = open(link_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
    ASSERT_GE(driver_, 0);
  }
  void CloseDriver() {
    if (driver_ >= 0) close(driver_);
    driver_ = -1;
  }
  void SetSpeed(speed_t speed) const {
    termios settings{};
    ASSERT_EQ(tcgetattr(driver_, &settings), 0);
    cfsetspeed(&settings, speed);
    ASSERT_EQ(tcsetattr(driver_, TCSANOW, &settings), 0);
  }
  // What has come to the driver within a second.
  std::string DriverReads() const {
    pollfd state{driver_, POLLIN, 0};
    if (poll(&state, 1, 1000) <= 0) return "";
    char text[256];
    const ssize_t count = read(driver_, text, sizeof text);
    return count > 0 ? std::string(text, static_cast<size_t>(count)) : "";
  }
  static std::string PortReads(PtyPort* port) {
    const auto bytes = port->Read().bytes;
    return {bytes.begin(), bytes.end()};
  }
  static void PortWrites(PtyPort* port, const std::string& text) {
    port->Write({reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  }

  std::filesystem::path folder_;
  std::filesystem::path link_;
  int driver_ = -1;
};

TEST_F(PtyPortTest, CarriesBytesBothWaysUnchanged) {
  PtyPort port = PtyPort::Open(link_, 9600).value();
  OpenDriver();
  ASSERT_EQ(write(driver_, "PP\r\n\x01\xff\x03", 7), 7);
  EXPECT_EQ(PortReads(&port), "PP\r\n\x01\xff\x03");
  PortWrites(&port, "* 0\r\n\x11\x13");
  EXPECT_EQ(DriverReads(), "* 0\r\n\x11\x13");
  EXPECT_EQ(PortReads(&port), "") << "no echo by the line itself";
}

TEST_F(PtyPortTest, SurvivesADriverThatComesAndGoes) {
  PtyPort port = PtyPort::Open(link_, 9600).value();
  EXPECT_FALSE(port.Read().opened);
  EXPECT_FALSE(port.is_open());
  for (int i = 0; i < 3; ++i) {
    OpenDriver();
    EXPECT_TRUE(port.Read().opened);
    EXPECT_FALSE(port.Read().opened) << "told once";
    EXPECT_TRUE(port.is_open());
    ASSERT_EQ(write(driver_, "x", 1), 1);
    EXPECT_EQ(PortReads(&port), "x");
    CloseDriver();
    EXPECT_EQ(PortReads(&port), "");
    EXPECT_FALSE(port.is_open());
  }
}

TEST_F(PtyPortTest, WhatIsSentToNobodyIsLost) {
  PtyPort port = PtyPort::Open(link_, 9600).value();
  PortWrites(&port, "banner");
  OpenDriver();
  port.Read();
  PortWrites(&port, "hello");
  EXPECT_EQ(DriverReads(), "hello");
}

TEST_F(PtyPortTest, TheWrongSpeedGarblesBothWays) {
  PtyPort port = PtyPort::Open(link_, 38400).value();
  OpenDriver();
  EXPECT_TRUE(port.speed_matches());
  SetSpeed(B9600);
  EXPECT_FALSE(port.speed_matches());
  ASSERT_EQ(write(driver_, "abc", 3), 3);
  const std::string heard = PortReads(&port);
  EXPECT_EQ(heard.size(), 3u);
  EXPECT_NE(heard, "abc");
  PortWrites(&port, "abc");
  EXPECT_NE(DriverReads(), "abc");
  SetSpeed(B38400);
  PortWrites(&port, "abc");
  EXPECT_EQ(DriverReads(), "abc");
}

TEST_F(PtyPortTest, TheLinkIsRepointedAndTakenAway) {
  {
    PtyPort first = PtyPort::Open(link_, 9600).value();
    const PtyPort second = PtyPort::Open(link_, 9600).value();
    EXPECT_EQ(std::filesystem::read_symlink(link_), second.device());
    { const PtyPort moved = std::move(first); }
    EXPECT_TRUE(std::filesystem::is_symlink(link_)) << "it is the second port's now";
  }
  EXPECT_FALSE(std::filesystem::is_symlink(link_));
}

TEST_F(PtyPortTest, AFullLineLosesBytesButNeverWaits) {
  PtyPort port = PtyPort::Open(link_, 115200).value();
  OpenDriver();
  port.Read();
  for (int i = 0; i < 200; ++i) PortWrites(&port, std::string(1000, 'x'));
  EXPECT_FALSE(DriverReads().empty());
}

TEST_F(PtyPortTest, RefusesWithAReason) {
  const auto nowhere = PtyPort::Open(folder_ / "missing" / "ptu.tty", 9600);
  EXPECT_NE(nowhere.message().find("ptu.tty"), std::string::npos);
  EXPECT_FALSE(PtyPort::Open(link_, 12345).ok());
  const std::filesystem::path precious = folder_ / "file";
  close(open(precious.c_str(), O_CREAT | O_WRONLY, 0600));
  EXPECT_FALSE(PtyPort::Open(precious, 9600).ok());
  EXPECT_TRUE(std::filesystem::is_regular_file(precious));
}

}  // namespace
}  // namespace geon::simulator
