#include "recognition/stripe_blocks.h"

#include <algorithm>
#include <cmath>

#include "recognition/profile_noise.h"

namespace geon::recognition {
namespace {

constexpr int kFewestInBlock = 6;
constexpr int kMostInBlock = 16;
constexpr double kBlockPerNoise_1_m = 8000.0;  // points of a block per metre of noise
constexpr double kHangTogether_m = 0.02;       // ... and six sigmas: from a point to the next
constexpr double kFoot_1 = 0.12;               // of the rows are the lowest
constexpr double kRowMargin_1 = 0.08;          // of the rows: stripes are laid so exactly

// What all points of one profile share.
struct ProfileView {
  const sensor::RangeProfile& profile;
  BwCamera camera;  // as it stood at the stripe
  double noise_m = 0.0;
};

double NoiseOf(const sensor::RangeProfile& profile, const BwCamera& camera) {
  std::vector<double> depth_m;
  depth_m.reserve(profile.p_L_m.size());
  for (const Eigen::Vector3d& p_L : profile.p_L_m) depth_m.push_back(camera.InCamera(p_L).z());
  return DepthNoise(profile.pixel, depth_m);
}

BlockPlace PlaceOf(const Eigen::Vector3d& p_B_m, sensor::Laser laser,
                   const std::optional<VerticalRegion>& region, const std::optional<Extent>& rows) {
  if (region && !region->Holds(p_B_m)) return BlockPlace::kBeside;
  if (laser != sensor::Laser::kVertical) return BlockPlace::kOnTarget;
  if (!rows) return BlockPlace::kAtFoot;
  const double row_1 = Tangents(p_B_m).y();
  if (!rows->Holds(row_1, kRowMargin_1)) return BlockPlace::kBeside;
  const double foot_1 = rows->last_1 - kFoot_1 * (rows->last_1 - rows->first_1);
  return row_1 > foot_1 ? BlockPlace::kAtFoot : BlockPlace::kOnTarget;
}

StripeBlock MakeBlock(const ProfileView& view, size_t begin, size_t end) {
  const std::vector<Eigen::Vector3d>& p_L_m = view.profile.p_L_m;
  const size_t middle = (begin + end) / 2;
  Eigen::Vector3d first_m = Eigen::Vector3d::Zero(), second_m = Eigen::Vector3d::Zero();
  for (size_t i = begin; i < middle; ++i) first_m += p_L_m[i];
  for (size_t i = middle; i < end; ++i) second_m += p_L_m[i];
  StripeBlock block;
  block.points = static_cast<int>(end - begin);
  block.p_L_m = (first_m + second_m) / static_cast<double>(end - begin);
  block.along_L =
      (second_m / static_cast<double>(end - middle) - first_m / static_cast<double>(middle - begin))
          .normalized();
  block.noise_m = view.noise_m;
  return block;
}

}  // namespace

std::vector<StripeBlock> FindStripeBlocks(const sensor::ScanSet& scan,
                                          const std::optional<VerticalRegion>& region,
                                          const std::optional<Extent>& rows) {
  const BwCamera at_target = CameraAtTarget(scan);
  std::vector<StripeBlock> blocks;
  for (const sensor::RangeProfile& profile : scan.profiles) {
    ProfileView view{profile, CameraAtStripe(scan, profile), 0.0};
    view.noise_m = NoiseOf(profile, view.camera);
    const auto wanted = static_cast<size_t>(std::clamp(
        static_cast<int>(kBlockPerNoise_1_m * view.noise_m), kFewestInBlock, kMostInBlock));
    const double apart_m = kHangTogether_m + 6.0 * view.noise_m;
    const auto apart = [&](size_t i) {
      return (profile.p_L_m[i] - profile.p_L_m[i - 1]).squaredNorm() > apart_m * apart_m;
    };
    size_t begin = 0;
    for (size_t i = 1; i <= profile.p_L_m.size(); ++i) {
      const bool ends = i == profile.p_L_m.size() || apart(i);
      if (!ends && i - begin < wanted) continue;
      if (i - begin >= static_cast<size_t>(kFewestInBlock)) {
        StripeBlock& block = blocks.emplace_back(MakeBlock(view, begin, i));
        block.place = PlaceOf(at_target.InCamera(block.p_L_m), profile.laser, region, rows);
      }
      begin = i;
    }
  }
  return blocks;
}

}  // namespace geon::recognition
