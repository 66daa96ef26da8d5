#include "sim/light_shadow.h"

#include <algorithm>

namespace geon::sim {
namespace {

using Eigen::Vector3f;

constexpr int kShortest_px = 8;          // shorter lines are not halved: their rays cost less
constexpr double kMargin_m = 1e-3;       // for roundings, here and in Embree
constexpr float kGrazingCosine = 0.02F;  // flatter light may meet the facet itself by rounding

}  // namespace

LightShadow::LightShadow(const Scene& scene, const Vector3f& light_W_m,
                         const Eigen::Vector2d& panel_m)
    : scene_(scene), light_W_m_(light_W_m) {
  const Eigen::Vector2f quarter_m = (0.25 * panel_m).cast<float>();
  for (size_t k = 0; k < 4; ++k) {
    quarters_W_m_[k] = light_W_m + Vector3f(k % 2 == 0 ? -quarter_m.x() : quarter_m.x(),
                                            k / 2 == 0 ? -quarter_m.y() : quarter_m.y(), 0);
  }
}

// Follows the light from the line up to the panel through the heights at which the body is: there
// it stays within a box that shrinks and moves linearly from the line's box to the panel's.
bool LightShadow::MayBlock(const Eigen::AlignedBox3d& body, const Eigen::AlignedBox3d& line) const {
  const double light_m = side_W_m_.min().z();
  if (std::max(body.max().z(), line.max().z()) > light_m - 0.1) return true;  // not below it
  if (line.min().z() > body.max().z() + kMargin_m) return false;
  const auto share_of_way = [&](double height_m, double from_m) {
    return std::max(0.0, (height_m - from_m) / (light_m - from_m));
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

bool LightShadow::IsSurelyLit(const Vector3f& normal, const Vector3f& first, const Vector3f& last,
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

void LightShadow::Enlist(const SurfaceRow& row, int begin, int end) {
  for (int u = begin; u < end; ++u) {
    const Vector3f point = row.Point(u);
    if (row.Normal(u).dot(light_W_m_ - point) <= 0.0F) continue;  // turned away: no light to shade
    Rays& rays = rays_[static_cast<size_t>(u % 2)];
    rays.columns.push_back(u);
    rays.points_W_m.push_back(point);
  }
}

void LightShadow::AskLine(const SurfaceRow& row, int body, int begin, int end) {
  if (IsSurelyLit(row.Normal(begin), row.Point(begin), row.Point(end - 1), body)) return;
  if (end - begin <= kShortest_px) {
    Enlist(row, begin, end);
    return;
  }
  const int middle = (begin + end) / 2;
  AskLine(row, body, begin, middle);
  AskLine(row, body, middle, end);
}

void LightShadow::Ask(const SurfaceRow& row, int v, std::span<uint8_t> lit) {
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
