#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

namespace geon::device {

// The far end of a serial line, which can be plugged in and out under a stable path.
class Plug {
 public:
  // No copies: it owns a folder and a device.
  Plug(const Plug&) = delete;
  Plug& operator=(const Plug&) = delete;
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
  termios Settings() const {
    termios settings{};
    EXPECT_EQ(tcgetattr(fd_, &settings), 0);
    return settings;
  }
  std::string path() const { return (folder_ / "device").string(); }

 private:
  std::filesystem::path folder_;
  int fd_ = -1;
};

}  // namespace geon::device
