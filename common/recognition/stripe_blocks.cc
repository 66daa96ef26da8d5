#include "recognition/stripe_blocks.h"

#include <algorithm>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

constexpr int kFewestInBlock = 6;
constexpr int kMostInBlock = 16;
constexpr double kBlockPerNoise_1_m = 8000.0;  // points of a block per metre of noise
constexpr double kHangTogether_m = 0.02;       // ... and six sigmas: from a point to the next
constexpr double kFoot_1 = 0.12;               // of the rows are the lowest
constexpr double kRowMargin_1 = 0.08;          // of the rows: stripes are laid so exactly

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

StripeBlock MakeBlock(std::span<const Eigen::Vector3d> p_L_m, size_t begin, size_t end) {
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
  return block;
}

}  // namespace

std::vector<StripeBlock> FindStripeBlocks(const sensor::ScanSet& scan,
                                          const std::optional<VerticalRegion>& region,
                                          std::span<const RegionProfile> parts,
                                          const std::optional<Extent>& rows) {
  Require(parts.size() == scan.profiles.size(), "FindStripeBlocks: the number of parts",
          parts.size(), "must be that of the scan's profiles");
  const BwCamera at_target = CameraAtTarget(scan);
  std::vector<StripeBlock> blocks;
  for (size_t k = 0; k < parts.size(); ++k) {
    const sensor::RangeProfile& profile = scan.profiles[k];
    const double noise_m = parts[k].noise_m;
    const auto wanted = static_cast<size_t>(
        std::clamp(static_cast<int>(kBlockPerNoise_1_m * noise_m), kFewestInBlock, kMostInBlock));
    const double apart_m = kHangTogether_m + 6.0 * noise_m;
    const auto apart = [&](size_t i) {
      return (profile.p_L_m[i] - profile.p_L_m[i - 1]).squaredNorm() > apart_m * apart_m;
    };
    size_t begin = 0;
    for (size_t i = 1; i <= profile.p_L_m.size(); ++i) {
      const bool ends = i == profile.p_L_m.size() || apart(i);
      if (!ends && i - begin < wanted) continue;
      if (i - begin >= static_cast<size_t>(kFewestInBlock)) {
        StripeBlock& block = blocks.emplace_back(MakeBlock(profile.p_L_m, begin, i));
        block.noise_m = noise_m;
        block.stripe = k;
        block.place = PlaceOf(at_target.InCamera(block.p_L_m), profile.laser, region, rows);
      }
      begin = i;
    }
  }
  return blocks;
}

}  // namespace geon::recognition
