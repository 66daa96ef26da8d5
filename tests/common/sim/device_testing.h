#pragma once

// What the tests of the simulated devices share: surroundings simple enough to know the answer, and
// a host's end of a line in virtual time.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/serial_device.h"
#include "sim/surroundings.h"

namespace geon::sim {

// Nothing anywhere.
class FreeSpace : public Surroundings {
 public:
  std::optional<RayHit> CastRay(const Eigen::Vector3d&, const Eigen::Vector3d&,
                                double) const override {
    return std::nullopt;
  }
  std::vector<DiscContact> ContactsOfDisc(const Eigen::Vector2d&, double) const override {
    return {};
  }
};

// Endless upright walls: all points p with normal . p = offset_m, open on the normal's side.
class Walls : public Surroundings {
 public:
  struct Wall {
    Eigen::Vector2d normal;
    double offset_m;
  };
  explicit Walls(std::vector<Wall> walls, double reflectance_1 = 0.8)
      : walls_(std::move(walls)), reflectance_1_(reflectance_1) {}

  std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                const Eigen::Vector3d& direction_W, double) const override {
    std::optional<RayHit> nearest;
    for (const Wall& wall : walls_) {
      const double closing = -wall.normal.dot(direction_W.head<2>());
      const double away_m = wall.normal.dot(origin_W_m.head<2>()) - wall.offset_m;
      if (closing <= 1e-9 || away_m < 0.0) continue;
      const double distance_m = away_m / closing;
      if (nearest && nearest->distance_m <= distance_m) continue;
      nearest = RayHit{distance_m, {wall.normal.x(), wall.normal.y(), 0.0}, reflectance_1_};
    }
    return nearest;
  }
  std::vector<DiscContact> ContactsOfDisc(const Eigen::Vector2d& center_W_m,
                                          double radius_m) const override {
    std::vector<DiscContact> contacts;
    for (const Wall& wall : walls_) {
      const double clearance_m = wall.normal.dot(center_W_m) - wall.offset_m - radius_m;
      if (clearance_m > kContactReach_m) continue;
      contacts.push_back({std::atan2(-wall.normal.y(), -wall.normal.x()), clearance_m});
    }
    return contacts;
  }

 private:
  std::vector<Wall> walls_;
  double reflectance_1_;
};

// The driver's end of a device's line: sends at once, listens in steps of a millisecond.
class TestHost {
 public:
  explicit TestHost(SerialDevice* device) : device_(device) {}

  double now_s() const { return now_s_; }
  void Send(std::string_view text) {
    device_->Receive({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, now_s_);
  }
  void Send(const std::vector<uint8_t>& bytes) { device_->Receive(bytes, now_s_); }
  // Everything that arrives in the next `duration_s`.
  std::vector<uint8_t> Listen(double duration_s) {
    std::vector<uint8_t> heard;
    const double end_s = now_s_ + duration_s;
    while (now_s_ < end_s) {
      now_s_ += 0.001;
      device_->Advance(now_s_);
      const auto bytes = device_->Transmit(now_s_);
      heard.insert(heard.end(), bytes.begin(), bytes.end());
    }
    return heard;
  }
  std::string ListenText(double duration_s) {
    const auto bytes = Listen(duration_s);
    return {bytes.begin(), bytes.end()};
  }
  std::string Ask(std::string_view text, double duration_s = 0.2) {
    Send(text);
    return ListenText(duration_s);
  }

 private:
  SerialDevice* device_;
  double now_s_ = 0.0;
};

}  // namespace geon::sim
