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

// Normal curvature between two crossings, positive where convex, times scale.
double Curvature(const std::optional<Crossing>& a, const std::optional<Crossing>& b,
                 double scale_m) {
  if (!a || !b) return 0.0;
  const Eigen::Vector3d step = b->p_L_m - a->p_L_m;
  const double curvature = (b->normal_L - a->normal_L).dot(step) / (step.squaredNorm() + 1e-8);
  return std::clamp(curvature * scale_m, -20.0, 20.0);
}

void AddCurvatures(const CrossingGrid& grid, double scale_m, EvidenceList* evidence) {
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
void AddScatter(const CrossingGrid& grid, double scale_m, EvidenceList* evidence) {
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

void AddSurfaceEvidence(const CrossingGrid& grid, double scale_m, EvidenceList* evidence) {
  for (size_t row = 0; row < 3; ++row) {
    for (size_t column = 0; column < 3; ++column) {
      const Eigen::Vector3d n =
          grid[row][column] ? grid[row][column]->normal_L : Eigen::Vector3d::Zero();
      const size_t place = 10 * (row + 1) + column + 1;
      evidence->Add("forward_", place, -n.x());
      evidence->Add("left_", place, n.y());
      evidence->Add("up_", place, n.z());
      evidence->Add("face_up_", place,
                    grid[row][column] ? grid[row][column]->face_normal_L.z() : 0.0);
    }
  }
  AddCurvatures(grid, scale_m, evidence);
  AddScatter(grid, scale_m, evidence);
}

}  // namespace geon::recognition
