#include "procs/simulator/pty_port.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace geon::simulator {
namespace {

Status Failure(const std::string& what) {
  return Status::Error(what + ": " + std::strerror(errno));
}

// The speed constant of termios for a baud rate the devices use; B0 for none.
speed_t SpeedOf(int baud) {
  switch (baud) {
    case 9600:
      return B9600;
    case 19200:
      return B19200;
    case 38400:
      return B38400;
    case 57600:
      return B57600;
    case 115200:
      return B115200;
    default:
      return B0;
  }
}

// What a receiver at the wrong speed makes of a byte: other bits, the high ones set.
uint8_t Garbled(uint8_t byte) {
  return static_cast<uint8_t>(0x80u | ((byte * 0x1du) ^ (byte >> 3)));
}

std::vector<uint8_t> Garbled(std::span<const uint8_t> bytes) {
  std::vector<uint8_t> garbled;
  garbled.reserve(bytes.size());
  for (const uint8_t byte : bytes) garbled.push_back(Garbled(byte));
  return garbled;
}

}  // namespace

Result<PtyPort> PtyPort::Open(const std::filesystem::path& link, int baud) {
  if (SpeedOf(baud) == B0) return Status::Error("no serial speed " + std::to_string(baud));
  PtyPort port;
  port.baud_ = baud;
  int slave = -1;
  std::array<char, 128> name{};
  termios settings{};
  cfmakeraw(&settings);
  settings.c_cflag |= CS8 | CREAD | CLOCAL;
  cfsetspeed(&settings, SpeedOf(baud));
  if (openpty(&port.master_, &slave, name.data(), &settings, nullptr) != 0) {
    return Failure("cannot open a pseudo-terminal for " + link.string());
  }
  // With the slave closed the kernel tells us, by a hang-up, when nobody has the port open.
  close(slave);
  port.device_ = name.data();
  fcntl(port.master_, F_SETFL, fcntl(port.master_, F_GETFL) | O_NONBLOCK);
  fcntl(port.master_, F_SETFD, FD_CLOEXEC);

  std::error_code error;
  if (std::filesystem::is_symlink(link, error)) std::filesystem::remove(link, error);
  std::filesystem::create_symlink(port.device_, link, error);
  if (error) {
    return Status::Error("cannot put the link " + link.string() + ": " + error.message() +
                         "; make its folder and see that it is writable");
  }
  port.link_ = link;
  return port;
}

PtyPort::PtyPort(PtyPort&& other) noexcept { *this = std::move(other); }

PtyPort& PtyPort::operator=(PtyPort&& other) noexcept {
  if (this == &other) return *this;
  Close();
  master_ = std::exchange(other.master_, -1);
  baud_ = other.baud_;
  driver_present_ = other.driver_present_;
  device_ = std::move(other.device_);
  link_ = std::exchange(other.link_, {});
  return *this;
}

PtyPort::~PtyPort() { Close(); }

void PtyPort::Close() {
  std::error_code error;
  if (!link_.empty() && std::filesystem::read_symlink(link_, error) == device_) {
    std::filesystem::remove(link_, error);
  }
  if (master_ >= 0) close(master_);
  master_ = -1;
}

void PtyPort::UpdatePresence(bool* opened) {
  pollfd state{master_, POLLIN, 0};
  const bool present = poll(&state, 1, 0) >= 0 && (state.revents & POLLHUP) == 0;
  *opened = present && !driver_present_;
  driver_present_ = present;
}

PtyPort::Input PtyPort::Read() {
  Input input;
  UpdatePresence(&input.opened);
  std::array<uint8_t, 512> chunk{};
  while (true) {
    // Fails with EIO while nobody has the port open, with EAGAIN when there is nothing to read.
    const ssize_t count = read(master_, chunk.data(), chunk.size());
    if (count <= 0) break;
    input.bytes.insert(input.bytes.end(), chunk.begin(), chunk.begin() + count);
  }
  if (!speed_matches()) input.bytes = Garbled(input.bytes);
  return input;
}

void PtyPort::Write(std::span<const uint8_t> bytes) {
  pollfd state{master_, POLLOUT, 0};
  if (poll(&state, 1, 0) < 0 || (state.revents & POLLHUP) != 0) return;
  const std::vector<uint8_t> sent =
      speed_matches() ? std::vector<uint8_t>(bytes.begin(), bytes.end()) : Garbled(bytes);
  // A driver that does not read loses what no longer fits.
  [[maybe_unused]] const ssize_t written = write(master_, sent.data(), sent.size());
}

bool PtyPort::speed_matches() const {
  termios settings{};
  return tcgetattr(master_, &settings) == 0 && cfgetospeed(&settings) == SpeedOf(baud_);
}

}  // namespace geon::simulator
