#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/surface_row.h"

namespace geon::sim {

// Where a light shines freely. It is a level panel of four quarters; the pixels of a 2 x 2 block
// ask one quarter each, so that their mean gives shadows a soft edge. A panel without a size throws
// hard shadows.
//
// Each answer is that of a shadow ray, but most need no ray: along a row, pixels on one flat facet
// lie on a straight line, and if no body's box reaches into the light between line and panel, all
// of them are lit. Otherwise the halves of the line are asked, and single rays at last.
class LightShadow {
 public:
  LightShadow(const Scene& scene, const Eigen::Vector3f& light_W_m, const Eigen::Vector2d& panel_m);

  // Row v of a picture: 1 where the pixel's quarter shines, or would be behind the surface.
  void Ask(const SurfaceRow& row, int v, std::span<uint8_t> lit);

 private:
  void AskLine(const SurfaceRow& row, int body, int begin, int end);
  bool IsSurelyLit(const Eigen::Vector3f& normal, const Eigen::Vector3f& first,
                   const Eigen::Vector3f& last, int body) const;
  bool MayBlock(const Eigen::AlignedBox3d& body, const Eigen::AlignedBox3d& line) const;
  void Enlist(const SurfaceRow& row, int begin, int end);

  const Scene& scene_;
  Eigen::Vector3f light_W_m_;
  std::array<Eigen::Vector3f, 4> quarters_W_m_;
  size_t first_quarter_ = 0;      // of the row in work: even columns ask it, odd ones the next
  Eigen::AlignedBox3d side_W_m_;  // of the panel: the two quarters that the row in work asks
  struct Rays {                   // of one row's even or odd columns
    std::vector<int> columns;
    std::vector<Eigen::Vector3f> points_W_m;
    std::vector<uint8_t> answers;
  };
  std::array<Rays, 2> rays_;
};

}  // namespace geon::sim
