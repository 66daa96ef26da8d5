#include "device/serial_port.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <string>

namespace geon::device {
namespace {

// The far end of a serial line.
class FarEnd {
 public:
  FarEnd() : fd_(posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_GE(fd_, 0);
    EXPECT_EQ(grantpt(fd_), 0);
    EXPECT_EQ(unlockpt(fd_), 0);
    std::array<char, 100> name{};
    EXPECT_EQ(ptsname_r(fd_, name.data(), name.size()), 0);
    path_ = name.data();
  }
  ~FarEnd() { Die(); }
  void Die() {
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
  termios Settings() const {
    termios settings{};
    EXPECT_EQ(tcgetattr(fd_, &settings), 0);
    return settings;
  }
  const std::string& path() const { return path_; }

 private:
  int fd_;
  std::string path_;
};

TEST(SerialPortTest, CarriesAnyBytesBothWays) {
  const FarEnd far_end;
  Result<SerialPort> port = SerialPort::Open(far_end.path(), 38400);
  ASSERT_TRUE(port.ok()) << port.message();
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  EXPECT_EQ(*port->Write(all), all.size());
  EXPECT_EQ(far_end.Hear(), all);
  far_end.Say(all);
  EXPECT_EQ(*port->Read(), all);
  EXPECT_EQ(*port->Read(), "");  // nothing there is not an error
}

TEST(SerialPortTest, SetsRawModeAndRate) {
  const FarEnd far_end;
  const Result<SerialPort> port = SerialPort::Open(far_end.path(), 9600);
  ASSERT_TRUE(port.ok());
  const termios settings = far_end.Settings();
  EXPECT_EQ(cfgetospeed(&settings), static_cast<speed_t>(B9600));
  EXPECT_EQ(settings.c_lflag & (ECHO | ICANON | ISIG), 0u);
  EXPECT_EQ(settings.c_cflag & CSIZE, static_cast<tcflag_t>(CS8));
}

TEST(SerialPortTest, ADeadFarEndIsAnErrorOfReadAndOfWrite) {
  FarEnd far_end;
  Result<SerialPort> port = SerialPort::Open(far_end.path(), 9600);
  ASSERT_TRUE(port.ok());
  far_end.Die();
  const auto read = port->Read();
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.message().find(port->path()), std::string::npos);
  EXPECT_FALSE(port->Write("x").ok());
}

TEST(SerialPortTest, ErrorsSayPathReasonAndWhatNext) {
  const auto missing = SerialPort::Open("/dev/geon-no-such-tty", 9600);
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.message().find("/dev/geon-no-such-tty: cannot open: No such file"),
            std::string::npos);
  EXPECT_NE(missing.message().find("plugged in"), std::string::npos);
  EXPECT_FALSE(SerialPort::Open("/dev/null", 9600).ok());
  const FarEnd far_end;
  const auto odd = SerialPort::Open(far_end.path(), 12345);
  ASSERT_FALSE(odd.ok());
  EXPECT_NE(odd.message().find("12345 baud"), std::string::npos);
}

}  // namespace
}  // namespace geon::device
