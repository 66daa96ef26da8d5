#include "sim/lens_map.h"

#include <algorithm>
#include <cstddef>

#include "base/contracts.h"

namespace geon::sim {
namespace {

using Eigen::Vector2d;

// Weights of four neighbours for a place t after the second of them.
struct CubicWeights {
  explicit CubicWeights(float t)
      : a(t * (-0.5F + t * (1.0F - 0.5F * t))),
        b(1.0F + t * t * (-2.5F + 1.5F * t)),
        c(t * (0.5F + t * (2.0F - 1.5F * t))),
        d(t * t * (-0.5F + 0.5F * t)) {}
  float a, b, c, d;
};

}  // namespace

LensMap::LensMap(const BuiltCamera& camera, int shrink)
    : width_px_(camera.ideal.width_px),
      height_px_(camera.ideal.height_px),
      plain_(camera.lens.bend_1_px2 == 0.0 && shrink == 1),
      wide_(camera.ideal) {
  Require(shrink >= 1, "LensMap: shrink must be at least 1");
  if (plain_) return;
  Eigen::AlignedBox2d seen_px;
  for (int u = 0; u < width_px_; ++u) {
    for (const int v : {0, height_px_ - 1}) seen_px.extend(camera.lens.Ideal(Vector2d(u, v)));
  }
  for (int v = 0; v < height_px_; ++v) {
    for (const int u : {0, width_px_ - 1}) seen_px.extend(camera.lens.Ideal(Vector2d(u, v)));
  }
  // Two pixels beyond on each side, for the four neighbours and for rounding.
  const double margin_px = 2.0 * shrink + 1.0;
  const Vector2d corner_px = (seen_px.min().array() - margin_px).floor();
  const Vector2d size_px = ((seen_px.max() - corner_px).array() + margin_px) / shrink;
  const auto to_wide = [&](double ideal_px, int axis) {
    return (ideal_px - corner_px[axis] + 0.5) / shrink - 0.5;
  };
  wide_.width_px = static_cast<int>(std::ceil(size_px.x())) + 1;
  wide_.height_px = static_cast<int>(std::ceil(size_px.y())) + 1;
  wide_.fx_px /= shrink;
  wide_.fy_px /= shrink;
  wide_.cx_px = to_wide(wide_.cx_px, 0);
  wide_.cy_px = to_wide(wide_.cy_px, 1);

  y_px_.reserve(static_cast<size_t>(width_px_) * static_cast<size_t>(height_px_));
  for (int v = 0; v < height_px_; ++v) {
    for (int u = 0; u < width_px_; ++u) {
      y_px_.push_back(static_cast<float>(to_wide(camera.lens.Ideal(Vector2d(u, v)).y(), 1)));
    }
  }
  x_px_.reserve(static_cast<size_t>(width_px_) * static_cast<size_t>(wide_.height_px));
  for (int row = 0; row < wide_.height_px; ++row) {
    const double ideal_y_px = (row + 0.5) * shrink - 0.5 + corner_px.y();
    for (int u = 0; u < width_px_; ++u) {
      // Where column u of the picture crosses this row; each round leaves a hundredth of the error.
      double v = ideal_y_px;
      for (int round = 0; round < 3; ++round) v += ideal_y_px - camera.lens.Ideal({u, v}).y();
      x_px_.push_back(static_cast<float>(to_wide(camera.lens.Ideal({u, v}).x(), 0)));
    }
  }
}

template <int kDepth>
void LensMap::AlongRows(const std::vector<float>& wide_light, std::vector<float>* between) const {
  const auto values = static_cast<size_t>(kDepth * width_px_);
  between->resize(values * static_cast<size_t>(wide_.height_px));
  const float* from = wide_light.data();
  const float* x_px = x_px_.data();
  float* to = between->data();
  for (int row = 0; row < wide_.height_px; ++row) {
    for (int u = 0; u < width_px_; ++u) {
      const int left = static_cast<int>(x_px[u]);
      const CubicWeights weight(x_px[u] - static_cast<float>(left));
      const float* here = from + kDepth * (left - 1);
      for (int c = 0; c < kDepth; ++c) {
        *to++ = weight.a * here[c] + weight.b * here[kDepth + c] + weight.c * here[2 * kDepth + c] +
                weight.d * here[3 * kDepth + c];
      }
    }
    from += kDepth * wide_.width_px;
    x_px += width_px_;
  }
}

template <int kDepth>
void LensMap::AlongColumns(const std::vector<float>& between, std::vector<float>* seen) const {
  const int stride = kDepth * width_px_;
  seen->resize(static_cast<size_t>(stride) * static_cast<size_t>(height_px_));
  std::vector<float> after_1(static_cast<size_t>(stride));  // how far each value lies after the row
  float* after = after_1.data();                            // above it
  const float* y_px = y_px_.data();
  float* to = seen->data();
  for (int v = 0; v < height_px_; ++v) {
    // Neighbours take from the same rows, for long stretches: loops that the compiler can pack.
    for (int u = 0; u < width_px_;) {
      const int begin = u, above = static_cast<int>(y_px[u]);
      for (; u < width_px_ && static_cast<int>(y_px[u]) == above; ++u) {
        for (int c = 0; c < kDepth; ++c) {
          after[kDepth * u + c] = y_px[u] - static_cast<float>(above);
        }
      }
      const float* first = between.data() + static_cast<ptrdiff_t>(above - 1) * stride;
#pragma GCC ivdep
      for (int k = kDepth * begin; k < kDepth * u; ++k) {
        const CubicWeights weight(after[k]);
        to[k] = weight.a * first[k] + weight.b * first[stride + k] +
                weight.c * first[2 * stride + k] + weight.d * first[3 * stride + k];
      }
    }
    y_px += width_px_;
    to += stride;
  }
}

void LensMap::Apply(int channels, const std::vector<float>& wide_light, std::vector<float>* between,
                    std::vector<float>* seen) const {
  const auto values = static_cast<size_t>(channels) * static_cast<size_t>(wide_.width_px) *
                      static_cast<size_t>(wide_.height_px);
  Require(wide_light.size() == values, "LensMap::Apply: the picture has another size");
  if (plain_) {
    *seen = wide_light;
    return;
  }
  Require(channels == 1 || channels == 3, "LensMap::Apply: a pixel has 1 or 3 values");
  if (channels == 1) {
    AlongRows<1>(wide_light, between);
    AlongColumns<1>(*between, seen);
  } else {
    AlongRows<3>(wide_light, between);
    AlongColumns<3>(*between, seen);
  }
}

}  // namespace geon::sim
