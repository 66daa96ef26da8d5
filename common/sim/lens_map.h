#pragma once

#include <vector>

#include "sim/lens.h"

namespace geon::sim {

// Carries a picture that an ideal camera took through a camera's lens. The ideal camera sees a
// little more than the picture, so that there is light at its rim; its pixels may be `shrink` times
// as large where fine detail is not worth its time.
//
// Two passes of cubic convolution (Catmull and Smith, "3-D transformations of images in scanline
// order", 1980; Keys, 1981): along rows, then along columns.
class LensMap {
 public:
  LensMap(const BuiltCamera& camera, int shrink);

  const geometry::PinholeCamera& wide() const { return wide_; }
  // From `channels` (1 or 3) interleaved values a pixel of the ideal camera to those of the
  // picture. The memory of `seen` and `between` is used again.
  void Apply(int channels, const std::vector<float>& wide_light, std::vector<float>* between,
             std::vector<float>* seen) const;

 private:
  template <int kDepth>
  void AlongRows(const std::vector<float>& wide_light, std::vector<float>* between) const;
  template <int kDepth>
  void AlongColumns(const std::vector<float>& between, std::vector<float>* seen) const;

  int width_px_, height_px_;  // of the picture
  bool plain_;                // no lens: nothing to be done
  geometry::PinholeCamera wide_;
  std::vector<float> x_px_;  // wide column that column u of the picture sees, at each wide row
  std::vector<float> y_px_;  // wide row that pixel (u, v) of the picture sees
};

}  // namespace geon::sim
