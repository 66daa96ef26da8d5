#include "sim/view.h"

#include <algorithm>
#include <array>

namespace geon::sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Nearer corners count as behind the camera: their pixels say nothing about the facet's.
constexpr float kNearest_m = 1e-3F;

struct Rectangle {
  int left, right, top, bottom;  // all included
};

// Least integer not below, greatest not above `x`, which must be representable.
template <typename Real>
int Ceil(Real x) {
  const int k = static_cast<int>(x);
  return k + (static_cast<Real>(k) < x ? 1 : 0);
}
template <typename Real>
int Floor(Real x) {
  const int k = static_cast<int>(x);
  return k - (static_cast<Real>(k) > x ? 1 : 0);
}

// The pixels among which a facet's are. Most facets of a round body are smaller than a pixel and
// have none: this is where they are let go.
Rectangle PixelsAround(const Vector3f& a, const Vector3f& b, const Vector3f& c, int width,
                       int height) {
  constexpr float kMargin_px = 1e-3F;  // more than the corners are rounded
  const auto first = [](float x, float y, float z, int end) {
    const float least = std::min(std::min(x, y), z) - kMargin_px;
    return Ceil(std::max(0.0F, std::min(least, static_cast<float>(end))));
  };
  const auto last = [](float x, float y, float z, int end) {
    const float most = std::max(std::max(x, y), z) + kMargin_px;
    return Floor(std::max(-1.0F, std::min(most, static_cast<float>(end - 1))));
  };
  return {first(a.x(), b.x(), c.x(), width), last(a.x(), b.x(), c.x(), width),
          first(a.y(), b.y(), c.y(), height), last(a.y(), b.y(), c.y(), height)};
}

// A facet takes those pixels of a row at which it is nearer than what was there.
void ClaimSpan(float nearness_1_m, float step_1_m, int number, int count, float* nearest_1_m,
               int* facet) {
  for (int k = 0; k < count; ++k) {
    const float here_1_m = nearness_1_m + step_1_m * static_cast<float>(k);
    // By masks, not by branches: the compiler makes vectors of this.
    const int nearer = here_1_m > nearest_1_m[k] ? -1 : 0;
    nearest_1_m[k] = std::max(here_1_m, nearest_1_m[k]);
    facet[k] = (number & nearer) | (facet[k] & ~nearer);
  }
}

void Claim(int number, const std::array<int, 3>& corners, View* view) {
  const int width = view->camera.width_px, height = view->camera.height_px;
  const auto [i, j, k] =
      std::array{static_cast<size_t>(corners[0]), static_cast<size_t>(corners[1]),
                 static_cast<size_t>(corners[2])};
  const Vector3f &a_px = view->corners_px[i], &b_px = view->corners_px[j],
                 &c_px = view->corners_px[k];
  Rectangle box = {0, width - 1, 0, height - 1};
  double least = 0.0;
  if (std::min(std::min(a_px.z(), b_px.z()), c_px.z()) > kNearest_m) {
    box = PixelsAround(a_px, b_px, c_px, width, height);
    if (box.left > box.right || box.top > box.bottom) return;
    // Seen edge-on, less than a millionth of a pixel: its depth would be all rounding.
    least = 1e-6 * static_cast<double>(a_px.z() * b_px.z() * c_px.z());
  }
  const Vector3d &a = view->corners_px_m[i], &b = view->corners_px_m[j], &c = view->corners_px_m[k];
  std::array<Vector3d, 3> edges = {b.cross(c), c.cross(a), a.cross(b)};
  const double volume = a.dot(edges[0]);
  if (std::abs(volume) <= least) return;
  const Vector3d plane = (edges[0] + edges[1] + edges[2]) / volume;
  if (volume < 0.0) {
    for (Vector3d& edge : edges) edge = -edge;
  }
  for (int v = box.top; v <= box.bottom; ++v) {
    double left_px = box.left, right_px = box.right;
    for (const Vector3d& edge : edges) {
      const double at_zero = edge.y() * v + edge.z();
      if (edge.x() > 0.0) {
        left_px = std::max(left_px, -at_zero / edge.x());
      } else if (edge.x() < 0.0) {
        right_px = std::min(right_px, -at_zero / edge.x());
      } else if (at_zero < 0.0) {
        right_px = -1.0;
      }
    }
    if (left_px > right_px) continue;
    const int first = Ceil(left_px), last = Floor(right_px);
    if (first > last) continue;
    const double nearness_1_m = plane.x() * first + plane.y() * v + plane.z();
    const size_t pixel =
        static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(first);
    ClaimSpan(static_cast<float>(nearness_1_m), static_cast<float>(plane.x()), number,
              last - first + 1, &view->nearness_1_m[pixel], &view->facet[pixel]);
  }
}

// Whether a box, its corners given as (u, v, 1) times the depth, lies wholly beside the picture.
bool IsBeside(const std::array<Vector3d, 8>& corners, int width, int height) {
  const auto all = [&](const auto& outside) {
    return std::all_of(corners.begin(), corners.end(), outside);
  };
  return all([](const Vector3d& p) { return p.z() < 0.0; }) ||
         all([](const Vector3d& p) { return p.x() < 0.0; }) ||
         all([](const Vector3d& p) { return p.y() < 0.0; }) ||
         all([=](const Vector3d& p) { return p.x() > (width - 1) * p.z(); }) ||
         all([=](const Vector3d& p) { return p.y() > (height - 1) * p.z(); });
}

}  // namespace

void LookThrough(const Scene& scene, const geometry::PinholeCamera& camera,
                 const geometry::RigidTransform& X_WC, View* view) {
  view->camera = camera;
  view->X_WC = X_WC;
  const size_t pixels =
      static_cast<size_t>(camera.width_px) * static_cast<size_t>(camera.height_px);
  view->facet.assign(pixels, View::kNothing);
  view->nearness_1_m.assign(pixels, 0.0F);
  const Facets& facets = scene.facets();
  view->corners_px_m.resize(facets.corners_W_m().size());
  view->corners_px.resize(facets.corners_W_m().size());

  Eigen::Matrix3d pixel_of_ray;
  pixel_of_ray << camera.fx_px, 0, camera.cx_px, 0, camera.fy_px, camera.cy_px, 0, 0, 1;
  const Eigen::Matrix3d turn = pixel_of_ray * X_WC.linear().transpose();
  const Vector3d eye_W_m = X_WC.translation();
  for (const Facets::Part& part : facets.parts()) {
    std::array<Vector3d, 8> box;
    for (int k = 0; k < 8; ++k) {
      const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(k);
      box[static_cast<size_t>(k)] = turn * (part.bounds_W_m.corner(corner) - eye_W_m);
    }
    if (IsBeside(box, camera.width_px, camera.height_px)) continue;
    for (auto k = static_cast<size_t>(part.first_corner); k < static_cast<size_t>(part.end_corner);
         ++k) {
      const Vector3d p = turn * (facets.corners_W_m()[k] - eye_W_m);
      view->corners_px_m[k] = p;
      view->corners_px[k] = Vector3d(p.x() / p.z(), p.y() / p.z(), p.z()).cast<float>();
    }
    for (int k = part.first_facet; k < part.end_facet; ++k) {
      Claim(k, facets.facets()[static_cast<size_t>(k)].corners, view);
    }
  }
}

}  // namespace geon::sim
