#include "recognition/find_bending.h"

#include <algorithm>
#include <cmath>

#include "base/contracts.h"

namespace geon::recognition {
namespace {

// Where a point stands in the image, scaled to metres at distance `z_m`.
Eigen::Vector2d InImage(const Eigen::Vector3d& p_B_m, double z_m) {
  return p_B_m.head<2>() * (z_m / p_B_m.z());
}

// How far p2 lies inside the line from p1 to p3, measured along axis `across` (0: x, 1: y); inwards
// is +1 (left and top ends) or -1 (right and bottom ends).
double ConcaveDepth(const Eigen::Vector3d& p1_B_m, const Eigen::Vector3d& p2_B_m,
                    const Eigen::Vector3d& p3_B_m, int across, double inwards) {
  if (p1_B_m.z() <= 0.0 || p2_B_m.z() <= 0.0 || p3_B_m.z() <= 0.0) return 0.0;
  const Eigen::Vector2d p1_m = InImage(p1_B_m, p2_B_m.z());
  const Eigen::Vector2d p2_m = InImage(p2_B_m, p2_B_m.z());
  const Eigen::Vector2d p3_m = InImage(p3_B_m, p2_B_m.z());
  const int along = 1 - across;
  const double span_m = p3_m[along] - p1_m[along];
  if (span_m <= 0.0) return 0.0;  // crossed stripes tell nothing
  const double t = std::clamp((p2_m[along] - p1_m[along]) / span_m, 0.0, 1.0);
  return inwards * (p2_m[across] - (p1_m[across] + t * (p3_m[across] - p1_m[across])));
}

// (5.3) over all triples of neighbouring stripes and both of their ends.
void AddConcaveEdges(std::span<const ProfileEnds> ends, int across, const BendingOptions& options,
                     sensor::BendingEvidence* bending) {
  for (size_t i = 0; i + 2 < ends.size(); ++i) {
    const ProfileEnds &a = ends[i], &b = ends[i + 1], &c = ends[i + 2];
    const auto add = [&](const Eigen::Vector3d& p1_B_m, const Eigen::Vector3d& p2_B_m,
                         const Eigen::Vector3d& p3_B_m, double inwards) {
      const double depth_m = ConcaveDepth(p1_B_m, p2_B_m, p3_B_m, across, inwards);
      const double span_m = std::abs(p3_B_m[1 - across] - p1_B_m[1 - across]);
      bending->concave_edge_m = std::max(bending->concave_edge_m, depth_m);
      if (depth_m > options.concave_edge_m + options.concave_edge_1 * span_m) {
        bending->concave_edge = true;
      }
    };
    add(a.first_B_m, b.first_B_m, c.first_B_m, 1.0);
    add(a.last_B_m, b.last_B_m, c.last_B_m, -1.0);
  }
}

}  // namespace

void BendingOptions::Validate() const {
  Require(concave_edge_m > 0.0, "concave_edge_m", concave_edge_m, "must be positive");
  Require(concave_edge_1 >= 0.0, "concave_edge_1", concave_edge_1, "must not be negative");
}

sensor::BendingEvidence FindBending(std::span<const sensor::ProfileEvidence> profiles,
                                    std::span<const ProfileEnds> horizontal,
                                    std::span<const ProfileEnds> vertical,
                                    const BendingOptions& options) {
  sensor::BendingEvidence bending;
  for (const sensor::ProfileEvidence& profile : profiles) {
    bending.two_segments = bending.two_segments || profile.segments >= 2;
    bending.concavity = bending.concavity || profile.concavities > 0;
  }
  AddConcaveEdges(horizontal, 0, options, &bending);
  AddConcaveEdges(vertical, 1, options, &bending);
  return bending;
}

}  // namespace geon::recognition
