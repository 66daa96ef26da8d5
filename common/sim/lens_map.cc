#include "sim/lens_map.h"

#include <algorithm>

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

void LensMap::Apply(int channels, const std::vector<float>& wide_light, std::vector<float>* between,
                    std::vector<float>* seen) const {
  const auto values = static_cast<size_t>(channels) * static_cast<size_t>(wide_.width_px) *
                      static_cast<size_t>(wide_.height_px);
  Require(wide_light.size() == values, "LensMap::Apply: the picture has another size");
  if (plain_) {
    *seen = wide_light;
    return;
  }
  AlongRows(channels, wide_light, between);
  AlongColumns(channels, *between, seen);
}

void LensMap::AlongRows(int channels, const std::vector<float>& wide_light,
                        std::vector<float>* between) const {
  const auto depth = static_cast<size_t>(channels), width = static_cast<size_t>(width_px_);
  const auto rows = static_cast<size_t>(wide_.height_px);
  between->resize(depth * width * rows);
  for (size_t row = 0; row < rows; ++row) {
    const float* from = wide_light.data() + row * depth * static_cast<size_t>(wide_.width_px);
    const float* x_px = x_px_.data() + row * width;
    float* to = between->data() + row * depth * width;
    for (size_t u = 0; u < width; ++u) {
      const auto left = static_cast<size_t>(x_px[u]);
      const CubicWeights weight(x_px[u] - static_cast<float>(left));
      const float* here = from + depth * (left - 1);
      for (size_t c = 0; c < depth; ++c) {
        *to++ = weight.a * here[c] + weight.b * here[depth + c] + weight.c * here[2 * depth + c] +
                weight.d * here[3 * depth + c];
      }
    }
  }
}

void LensMap::AlongColumns(int channels, const std::vector<float>& between,
                           std::vector<float>* seen) const {
  const auto depth = static_cast<size_t>(channels), width = static_cast<size_t>(width_px_);
  const size_t stride = depth * width;
  seen->resize(stride * static_cast<size_t>(height_px_));
  std::vector<float> after_1(stride);  // how far after the row above each value lies
  for (size_t v = 0; v < static_cast<size_t>(height_px_); ++v) {
    const float* y_px = y_px_.data() + v * width;
    float* to = seen->data() + v * stride;
    // Neighbours take from the same rows, for long stretches: loops that the compiler can pack.
    for (size_t u = 0; u < width;) {
      const size_t begin = u;
      const auto above = static_cast<size_t>(y_px[u]);
      for (; u < width && static_cast<size_t>(y_px[u]) == above; ++u) {
        const float after = y_px[u] - static_cast<float>(above);
        for (size_t c = 0; c < depth; ++c) after_1[depth * u + c] = after;
      }
      const float* first = between.data() + (above - 1) * stride;
#pragma GCC ivdep
      for (size_t k = depth * begin; k < depth * u; ++k) {
        const CubicWeights weight(after_1[k]);
        to[k] = weight.a * first[k] + weight.b * first[stride + k] +
                weight.c * first[2 * stride + k] + weight.d * first[3 * stride + k];
      }
    }
  }
}

}  // namespace geon::sim
