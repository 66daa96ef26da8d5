#include "sim/lamp_shadow.h"

#include <algorithm>

#include "sim/lighting.h"

namespace geon::sim {
namespace {

using Eigen::Vector3f;

constexpr int kShortest_px = 8;          // shorter lines are not halved: their rays cost less
constexpr double kMargin_m = 1e-3;       // for roundings, here and in Embree
constexpr float kGrazingCosine = 0.02F;  // flatter light may meet the facet itself by rounding

}  // namespace

LampShadow::LampShadow(const Scene& scene, const Vector3f& lamp_W_m)
    : scene_(scene), lamp_W_m_(lamp_W_m) {
  constexpr auto kQuarterX_m = static_cast<float>(0.25 * kLampPanel_m[0]);
  constexpr auto kQuarterY_m = static_cast<float>(0.25 * kLampPanel_m[1]);
  for (size_t k = 0; k < 4; ++k) {
    quarters_W_m_[k] = lamp_W_m + Vector3f(k % 2 == 0 ? -kQuarterX_m : kQuarterX_m,
                                           k / 2 == 0 ? -kQuarterY_m : kQuarterY_m, 0);
  }
}

// Follows the light from the line up to the lamp through the heights at which the body is: there
// it stays within a box that shrinks and moves linearly from the line's box to the lamp's.
bool LampShadow::MayBlock(const Eigen::AlignedBox3d& body, const Eigen::AlignedBox3d& line) const {
  const double lamp_m = side_W_m_.min().z();
  if (std::max(body.max().z(), line.max().z()) > lamp_m - 0.1) return true;  // not below the lamp
  if (line.min().z() > body.max().z() + kMargin_m) return false;
  const auto share_of_way = [&](double height_m, double from_m) {
    return std::max(0.0, (height_m - from_m) / (lamp_m - from_m));
  };
  const double enters_1 = share_of_way(body.min().z(), line.max().z());
  const double leaves_1 = share_of_way(body.max().z(), line.min().z());
  for (int axis = 0; axis < 2; ++axis) {
    const auto low = [&](double way_1) {
      return (1.0 - way_1) * line.min()[axis] + way_1 * side_W_m_.min()[axis];
    };
    const auto high = [&](double way_1) {
      return (1.0 - way_1) * line.max()[axis] + way_1 * side_W_m_.max()[axis];
    };
    if (std::min(low(enters_1), low(leaves_1)) > body.max()[axis] + kMargin_m) return false;
    if (std::max(high(enters_1), high(leaves_1)) < body.min()[axis] - kMargin_m) return false;
  }
  return true;
}

bool LampShadow::IsSurelyLit(const Vector3f& normal, const Vector3f& first, const Vector3f& last,
                             int body) const {
  for (const size_t k : {first_quarter_, first_quarter_ + 1}) {
    const Vector3f& quarter = quarters_W_m_[k];
    for (const Vector3f& end : {first, last}) {
      const Vector3f to_light = quarter - end;
      if (normal.dot(to_light) < kGrazingCosine * to_light.norm()) return false;
    }
  }
  Eigen::AlignedBox3d line(first.cast<double>());
  line.extend(last.cast<double>());
  const auto& parts = scene_.facets().parts();
  for (size_t other = 0; other < parts.size(); ++other) {
    if (static_cast<int>(other) == body) continue;
    if (MayBlock(parts[other].bounds_W_m, line)) return false;
  }
  return true;
}

void LampShadow::Enlist(const SurfaceRow& row, int begin, int end) {
  for (int u = begin; u < end; ++u) {
    const Vector3f point = row.Point(u);
    if (row.Normal(u).dot(lamp_W_m_ - point) <= 0.0F) continue;  // turned away: no light to shade
    Rays& rays = rays_[static_cast<size_t>(u % 2)];
    rays.columns.push_back(u);
    rays.points_W_m.push_back(point);
  }
}

void LampShadow::AskLine(const SurfaceRow& row, int body, int begin, int end) {
  if (IsSurelyLit(row.Normal(begin), row.Point(begin), row.Point(end - 1), body)) return;
  if (end - begin <= kShortest_px) {
    Enlist(row, begin, end);
    return;
  }
  const int middle = (begin + end) / 2;
  AskLine(row, body, begin, middle);
  AskLine(row, body, middle, end);
}

void LampShadow::Ask(const SurfaceRow& row, int v, std::span<uint8_t> lit) {
  std::fill(lit.begin(), lit.end(), uint8_t{1});
  first_quarter_ = static_cast<size_t>(v % 2) * 2;
  side_W_m_ = Eigen::AlignedBox3d(quarters_W_m_[first_quarter_].cast<double>());
  side_W_m_.extend(quarters_W_m_[first_quarter_ + 1].cast<double>());
  for (Rays& rays : rays_) {
    rays.columns.clear();
    rays.points_W_m.clear();
  }
  for (const SurfaceRow::Run& run : row.runs) {
    if (run.flat) {
      AskLine(row, run.body, run.begin, run.end);
    } else if (run.body >= 0) {
      Enlist(row, run.begin, run.end);
    }
  }
  for (size_t odd = 0; odd < 2; ++odd) {
    Rays& rays = rays_[odd];
    rays.answers.resize(rays.columns.size());
    scene_.Illuminate(quarters_W_m_[first_quarter_ + odd], rays.points_W_m, rays.answers);
    for (size_t k = 0; k < rays.columns.size(); ++k) {
      lit[static_cast<size_t>(rays.columns[k])] = rays.answers[k];
    }
  }
}

}  // namespace geon::sim
