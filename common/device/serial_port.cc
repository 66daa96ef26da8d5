#include "device/serial_port.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <utility>

namespace geon::device {
namespace {

struct Rate {
  int baud;
  speed_t speed;
};

constexpr std::array<Rate, 8> kRates = {{{4800, B4800},
                                         {9600, B9600},
                                         {19200, B19200},
                                         {38400, B38400},
                                         {57600, B57600},
                                         {115200, B115200},
                                         {230400, B230400},
                                         {0, B0}}};

speed_t SpeedFromBaud(int baud) {
  for (const Rate& rate : kRates) {
    if (rate.baud == baud) return rate.speed;
  }
  return B0;
}

Status Failure(const std::string& path, const std::string& what, int error,
               const std::string& advice) {
  return Status::Error(path + ": " + what + ": " + std::strerror(error) +
                       (advice.empty() ? "" : "; " + advice));
}

std::string AdviceForOpening(int error) {
  switch (error) {
    case ENOENT:
      return "is the device plugged in (or the simulator running) and the path right?";
    case EACCES:
      return "add the user to group dialout";
    case EBUSY:
      return "another program holds the device: end it first";
    default:
      return "check cable and path";
  }
}

// Raw 8N1 without handshake. HUPCL: the last close drops DTR, so that a board behind it restarts.
Status Configure(int fd, const std::string& path, int baud) {
  const speed_t speed = SpeedFromBaud(baud);
  if (speed == B0) {
    return Status::Error(path + ": " + std::to_string(baud) +
                         " baud is not a rate of this port; use 4800 ... 230400");
  }
  termios settings{};
  if (tcgetattr(fd, &settings) != 0) {
    return Failure(path, "not a serial device", errno, "check the path");
  }
  cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS | PARENB);
  settings.c_cflag |= CLOCAL | CREAD | HUPCL | CS8;
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  if (cfsetspeed(&settings, speed) != 0 || tcsetattr(fd, TCSANOW, &settings) != 0) {
    return Failure(path, "cannot set " + std::to_string(baud) + " baud 8N1", errno, "");
  }
  // tcsetattr succeeds when any one of its changes did.
  termios actual{};
  if (tcgetattr(fd, &actual) != 0 || cfgetospeed(&actual) != speed ||
      (actual.c_lflag & (ICANON | ECHO)) != 0) {
    return Status::Error(path + ": the driver of this port does not take " + std::to_string(baud) +
                         " baud raw; use another adapter or rate");
  }
  return Status::Ok();
}

}  // namespace

Result<SerialPort> SerialPort::Open(const std::string& path, int baud) {
  const int fd = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) return Failure(path, "cannot open", errno, AdviceForOpening(errno));
  SerialPort port(fd, path);
  const Status configured = Configure(fd, path, baud);
  if (!configured.ok()) return configured;
  if (ioctl(fd, TIOCEXCL) != 0) return Failure(path, "cannot claim it alone", errno, "");
  tcflush(fd, TCIOFLUSH);
  return port;
}

SerialPort::SerialPort(int file_descriptor, std::string path)
    : file_descriptor_(file_descriptor), path_(std::move(path)) {}

SerialPort::SerialPort(SerialPort&& other) noexcept
    : file_descriptor_(std::exchange(other.file_descriptor_, -1)), path_(std::move(other.path_)) {}

SerialPort& SerialPort::operator=(SerialPort&& other) noexcept {
  std::swap(file_descriptor_, other.file_descriptor_);
  std::swap(path_, other.path_);
  return *this;
}

SerialPort::~SerialPort() {
  if (file_descriptor_ < 0) return;
  ioctl(file_descriptor_, TIOCNXCL);
  close(file_descriptor_);
}

Result<std::string> SerialPort::Read() {
  std::string bytes;
  std::array<char, 512> chunk{};
  while (bytes.size() < 16 * chunk.size()) {
    const ssize_t count = read(file_descriptor_, chunk.data(), chunk.size());
    if (count > 0) {
      bytes.append(chunk.data(), static_cast<size_t>(count));
      continue;
    }
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno != EAGAIN) {
      return Failure(path_, "cannot read", errno, "check cable and power");
    }
    break;
  }
  // With VMIN 0 "no bytes" and "hung up" both read as 0: poll tells them apart.
  pollfd line{file_descriptor_, POLLIN, 0};
  if (bytes.empty() && poll(&line, 1, 0) > 0 && (line.revents & (POLLHUP | POLLERR | POLLNVAL))) {
    return Status::Error(path_ + ": hung up; the device was unplugged or its far end ended");
  }
  return bytes;
}

Result<size_t> SerialPort::Write(std::string_view bytes) {
  size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t count = write(file_descriptor_, bytes.data() + written, bytes.size() - written);
    if (count > 0) {
      written += static_cast<size_t>(count);
    } else if (count == 0 || errno == EAGAIN) {
      break;
    } else if (errno != EINTR) {
      return Failure(path_, "cannot write", errno, "check cable and power");
    }
  }
  return written;
}

void SerialPort::WaitReadable(double timeout_s) const {
  pollfd line{file_descriptor_, POLLIN, 0};
  poll(&line, 1, static_cast<int>(std::lround(timeout_s * 1e3)));
}

}  // namespace geon::device
