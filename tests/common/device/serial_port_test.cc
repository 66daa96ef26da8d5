#include "device/serial_port.h"

#include <gtest/gtest.h>
#include <termios.h>

#include <string>

#include "tests/common/device/plug.h"

namespace geon::device {
namespace {

TEST(SerialPortTest, CarriesAnyBytesBothWays) {
  Plug far_end;
  far_end.In();
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
  Plug far_end;
  far_end.In();
  const Result<SerialPort> port = SerialPort::Open(far_end.path(), 9600);
  ASSERT_TRUE(port.ok());
  const termios settings = far_end.Settings();
  EXPECT_EQ(cfgetospeed(&settings), static_cast<speed_t>(B9600));
  EXPECT_EQ(settings.c_lflag & (ECHO | ICANON | ISIG), 0u);
  EXPECT_EQ(settings.c_cflag & CSIZE, static_cast<tcflag_t>(CS8));
}

TEST(SerialPortTest, ADeadFarEndIsAnErrorOfReadAndOfWrite) {
  Plug far_end;
  far_end.In();
  Result<SerialPort> port = SerialPort::Open(far_end.path(), 9600);
  ASSERT_TRUE(port.ok());
  far_end.Out();
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
  Plug far_end;
  far_end.In();
  const auto odd = SerialPort::Open(far_end.path(), 12345);
  ASSERT_FALSE(odd.ok());
  EXPECT_NE(odd.message().find("12345 baud"), std::string::npos);
}

}  // namespace
}  // namespace geon::device
