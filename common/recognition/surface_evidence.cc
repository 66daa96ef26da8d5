#include "recognition/surface_evidence.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace geon::recognition {
namespace {

// The surface where two stripes cross; frame L, the normal towards the camera.
struct Crossing {
  Eigen::Vector3d p_L_m;
  Eigen::Vector3d normal_L;
};
using Grid = std::array<std::array<std::optional<Crossing>, 3>, 3>;

constexpr size_t kTangentShare = 10;        // a tangent averages this part of a stripe to each side
constexpr double kFarthestCrossing = 0.06;  // in stripe lengths: stripes further apart do not cross

// A stripe as a run of directions from the camera: x/z and y/z of each point.
std::vector<Eigen::Vector2d> Directions(const TargetStripe& stripe, const Eigen::Vector3d& p_LB_m,
                                        const Eigen::Matrix3d& R_LB) {
  std::vector<Eigen::Vector2d> directions;
  directions.reserve(stripe.p_L_m.size());
  for (const Eigen::Vector3d& p_L : stripe.p_L_m) {
    const Eigen::Vector3d p_B = R_LB.transpose() * (p_L - p_LB_m);
    directions.emplace_back(p_B.x() / p_B.z(), p_B.y() / p_B.z());
  }
  return directions;
}

// Index of the point whose coordinate `axis` (nearly monotone along the stripe) is nearest `value`.
size_t Nearest(const std::vector<Eigen::Vector2d>& directions, int axis, double value) {
  const auto above = std::lower_bound(
      directions.begin(), directions.end(), value,
      [axis](const Eigen::Vector2d& direction, double v) { return direction[axis] < v; });
  if (above == directions.begin()) return 0;
  if (above == directions.end()) return directions.size() - 1;
  const auto below = above - 1;
  const bool nearer = value - (*below)[axis] < (*above)[axis] - value;
  return static_cast<size_t>((nearer ? below : above) - directions.begin());
}

// The stripe's direction at a point: from the mean of the points before to that of those after.
Eigen::Vector3d Tangent(const TargetStripe& stripe, size_t at) {
  const size_t reach = std::max<size_t>(stripe.p_L_m.size() / kTangentShare, 2);
  const size_t begin = at > reach ? at - reach : 0;
  const size_t end = std::min(at + reach + 1, stripe.p_L_m.size());
  const size_t middle = std::clamp(at, begin + 1, end - 1);
  Eigen::Vector3d before = Eigen::Vector3d::Zero(), after = before;
  for (size_t i = begin; i < middle; ++i) before += stripe.p_L_m[i];
  for (size_t i = middle; i < end; ++i) after += stripe.p_L_m[i];
  return after / static_cast<double>(end - middle) - before / static_cast<double>(middle - begin);
}

Grid FindCrossings(const std::vector<TargetStripe>& stripes, const Eigen::Vector3d& p_LB_m,
                   const Eigen::Matrix3d& R_LB) {
  std::vector<std::vector<Eigen::Vector2d>> directions;
  for (const TargetStripe& stripe : stripes) directions.push_back(Directions(stripe, p_LB_m, R_LB));
  Grid grid;
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      const TargetStripe& h = stripes[row];
      const TargetStripe& v = stripes[3 + column];
      if (h.p_L_m.size() < 5 || v.p_L_m.size() < 5) continue;
      // From each stripe to the other's level in turn: they are nearly straight and at right
      // angles.
      size_t i = h.p_L_m.size() / 2, j = v.p_L_m.size() / 2;
      for (int pass = 0; pass < 3; ++pass) {
        i = Nearest(directions[row], 0, directions[3 + column][j].x());
        j = Nearest(directions[3 + column], 1, directions[row][i].y());
      }
      const double extent = directions[row].back().x() - directions[row].front().x();
      const double apart = (directions[row][i] - directions[3 + column][j]).norm();
      if (apart > kFarthestCrossing * std::abs(extent)) continue;
      Eigen::Vector3d normal = Tangent(h, i).cross(Tangent(v, j)).normalized();
      const Eigen::Vector3d p = 0.5 * (h.p_L_m[i] + v.p_L_m[j]);
      if (normal.dot(p_LB_m - p) < 0.0) normal = -normal;
      grid[row][column] = Crossing{p, normal};
    }
  }
  return grid;
}

// Normal curvature between two crossings, positive where convex, times scale.
double Curvature(const std::optional<Crossing>& a, const std::optional<Crossing>& b,
                 double scale_m) {
  if (!a || !b) return 0.0;
  const Eigen::Vector3d step = b->p_L_m - a->p_L_m;
  const double curvature = (b->normal_L - a->normal_L).dot(step) / (step.squaredNorm() + 1e-8);
  return std::clamp(curvature * scale_m, -20.0, 20.0);
}

void AddCurvatures(const Grid& grid, double scale_m, EvidenceList* evidence) {
  for (int direction = 0; direction < 2; ++direction) {
    std::array<double, 6> curvatures{};
    size_t k = 0;
    for (size_t line = 0; line < 3; ++line) {
      for (size_t step = 0; step < 2; ++step) {
        const auto& a = direction == 0 ? grid[line][step] : grid[step][line];
        const auto& b = direction == 0 ? grid[line][step + 1] : grid[step + 1][line];
        curvatures[k++] = Curvature(a, b, scale_m);
      }
    }
    const std::string_view name = direction == 0 ? "along_rows_" : "along_columns_";
    const std::string_view rank = direction == 0 ? "along_rows_rank_" : "along_columns_rank_";
    for (size_t c = 0; c < 6; ++c) evidence->Add(name, c, curvatures[c]);
    std::sort(curvatures.begin(), curvatures.end());
    for (size_t c : {size_t{0}, size_t{2}, size_t{3}, size_t{5}})
      evidence->Add(rank, c, curvatures[c]);
  }
}

// Root of the smallest eigenvalues of the crossings' and of their normals' scatter: 0 for a plane,
// and for a surface that curves one way only.
void AddScatter(const Grid& grid, double scale_m, EvidenceList* evidence) {
  Eigen::Matrix3d places = Eigen::Matrix3d::Zero(), normals = places;
  Eigen::Vector3d mean_p = Eigen::Vector3d::Zero(), mean_n = mean_p;
  double count = 0.0;
  for (const auto& row : grid) {
    for (const auto& crossing : row) {
      if (!crossing) continue;
      count += 1.0;
      mean_p += crossing->p_L_m;
      mean_n += crossing->normal_L;
    }
  }
  mean_p /= std::max(count, 1.0);
  mean_n /= std::max(count, 1.0);
  for (const auto& row : grid) {
    for (const auto& crossing : row) {
      if (!crossing) continue;
      const Eigen::Vector3d p = (crossing->p_L_m - mean_p) / scale_m;
      places += p * p.transpose();
      const Eigen::Vector3d n = crossing->normal_L - mean_n;
      normals += n * n.transpose();
    }
  }
  const auto roots = [&](const Eigen::Matrix3d& scatter) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(scatter / std::max(count, 1.0), Eigen::EigenvaluesOnly);
    return Eigen::Vector3d(solver.eigenvalues().cwiseMax(0.0).cwiseSqrt());
  };
  const Eigen::Vector3d p = roots(places), n = roots(normals);
  evidence->Add("crossings", count);
  evidence->Add("off_plane", p[0]);
  for (int k = 0; k < 3; ++k) evidence->Add("normals_", static_cast<size_t>(k), n[k]);
  evidence->Add("mean_normal_up", mean_n.z());
  evidence->Add("mean_normal_length", mean_n.norm());
}

}  // namespace

void AddSurfaceEvidence(const std::vector<TargetStripe>& stripes, const Eigen::Vector3d& p_LB_m,
                        const Eigen::Matrix3d& R_LB, double scale_m, EvidenceList* evidence) {
  const Grid grid = FindCrossings(stripes, p_LB_m, R_LB);
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      const Eigen::Vector3d n =
          grid[row][column] ? grid[row][column]->normal_L : Eigen::Vector3d::Zero();
      const size_t place = 10 * (row + 1) + column + 1;
      evidence->Add("forward_", place, -n.x());
      evidence->Add("left_", place, n.y());
      evidence->Add("up_", place, n.z());
    }
  }
  AddCurvatures(grid, scale_m, evidence);
  AddScatter(grid, scale_m, evidence);
}

}  // namespace geon::recognition
