// Any bytes at any pace into the simulated base: afterwards, and after a quiet moment, one
// GET_STATE is answered by one state packet, and the speeds are within the robot's limits.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "sim/nomad_emulator.h"

namespace {

class FreeSpace : public geon::sim::Surroundings {
 public:
  std::optional<geon::sim::RayHit> CastRay(const Eigen::Vector3d&, const Eigen::Vector3d&,
                                           double) const override {
    return std::nullopt;
  }
  std::vector<geon::sim::DiscContact> ContactsOfDisc(const Eigen::Vector2d&,
                                                     double) const override {
    return {};
  }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const FreeSpace world;
  geon::sim::NomadEmulator base({}, &world);
  double now_s = 0.0;
  for (size_t at = 0; at < size && at < 2048;) {
    const size_t count = std::min<size_t>(1 + data[at] % 32, size - at);
    base.Receive({data + at, count}, now_s);
    now_s += 0.0002 * data[at];
    base.Advance(now_s);
    if (std::abs(base.drive().true_speed_m_s()) > 0.509) std::abort();
    at += count;
  }
  // A stop ends a wait that is still open (its reply comes first), then all is in step again.
  const auto ask = [&](uint8_t type) {
    now_s += 2.0;
    base.Advance(now_s);
    base.Transmit(now_s);
    base.Receive(geon::sim::EncodeNomadFrame({type, {}}), now_s);
    now_s += 0.1;
    base.Advance(now_s);
    geon::sim::NomadFrameReader reader;
    std::vector<geon::sim::NomadFrame> frames;
    for (const uint8_t byte : base.Transmit(now_s)) {
      for (auto& frame : reader.Push(byte)) frames.push_back(std::move(frame));
    }
    return frames;
  };
  const auto stopped = ask(9);
  const auto state = ask(7);
  if (stopped.empty() || stopped.back().type != 9) std::abort();
  if (state.size() != 1 || state[0].type != 7) std::abort();
  return 0;
}
