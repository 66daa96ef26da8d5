#include "recognition/face_evidence.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/angles.h"
#include "recognition/quantiles.h"

namespace geon::recognition {
namespace {

constexpr double kSameFace_rad = RadiansFromDegrees(20.0);
constexpr double kUpright_rad = RadiansFromDegrees(15.0);  // faces that lean no more than this
constexpr size_t kMostFaces = 3;
constexpr double kLeastSpread = 0.01;

// How far an angle, given by its cosine, is from 0 and from 90 degrees, whichever is nearer.
double Skew(double cosine) {
  const double angle_rad = std::acos(std::min(std::abs(cosine), 1.0));
  return std::min(angle_rad, kPi / 2 - angle_rad);
}

double Skew(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double lengths = a.norm() * b.norm();
  return lengths > 0.0 ? Skew(a.dot(b) / lengths) : 0.0;
}

// How far the angles between the faces that the crossings lie on are from 0 and 90 degrees, and how
// far the faces lean from upright and level: nothing of it on a cuboid, whichever side it stands
// on.
void AddSkews(const CrossingGrid& grid, EvidenceList* evidence) {
  std::vector<Eigen::Vector3d> normals;
  for (const auto& row : grid) {
    for (const auto& crossing : row) {
      if (crossing) normals.push_back(crossing->face_normal_L);
    }
  }
  std::vector<double> skews_rad, leans_rad;
  for (size_t a = 0; a < normals.size(); ++a) {
    leans_rad.push_back(Skew(normals[a].z()));
    for (size_t b = 0; b < a; ++b) skews_rad.push_back(Skew(normals[a].dot(normals[b])));
  }
  AddQuantiles("skew_", std::move(skews_rad), evidence);
  AddQuantiles("lean_", std::move(leans_rad), evidence);
}

// What crossings with about the same normal lie on.
struct Face {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // of the normals
  double crossings = 0.0;
  Eigen::Vector3d normal() const { return sum.normalized(); }
  // How far the normals of its crossings are apart: 0 if they agree.
  double spread() const { return std::sqrt(std::max(1.0 - sum.norm() / crossings, 0.0)); }
};

// The faces, those with the most crossings first.
std::vector<Face> FindFaces(const CrossingGrid& grid) {
  std::vector<Face> faces;
  for (const auto& row : grid) {
    for (const auto& crossing : row) {
      if (!crossing) continue;
      const auto same = std::find_if(faces.begin(), faces.end(), [&](const Face& face) {
        return face.normal().dot(crossing->face_normal_L) > std::cos(kSameFace_rad);
      });
      Face& face = same == faces.end() ? faces.emplace_back() : *same;
      face.sum += crossing->face_normal_L;
      face.crossings += 1.0;
    }
  }
  std::stable_sort(faces.begin(), faces.end(),
                   [](const Face& a, const Face& b) { return a.crossings > b.crossings; });
  return faces;
}

bool IsUpright(const Eigen::Vector3d& normal) {
  return std::abs(normal.z()) < std::sin(kUpright_rad);
}

// The same of whole faces: one number decides between a cuboid and a wedge that lies with its
// parallel sides up and down, the angle at which its upright faces meet.
void AddFaces(const std::vector<Face>& all, EvidenceList* evidence) {
  const std::span faces = std::span(all).first(std::min(all.size(), kMostFaces));
  evidence->Add("faces", static_cast<double>(all.size()));
  double most_rad = 0.0, upright_rad = 0.0, sum_rad = 0.0, lean_rad = 0.0, spread = 0.0;
  for (size_t a = 0; a < faces.size(); ++a) {
    const Eigen::Vector3d normal = faces[a].normal();
    lean_rad = std::max(lean_rad, Skew(normal.z()));
    spread = std::max(spread, faces[a].spread());
    for (size_t b = 0; b < a; ++b) {
      const double skew_rad = Skew(normal.dot(faces[b].normal()));
      most_rad = std::max(most_rad, skew_rad);
      sum_rad += skew_rad;
      if (IsUpright(normal) && IsUpright(faces[b].normal())) {
        upright_rad = std::max(upright_rad, skew_rad);
      }
    }
  }
  evidence->Add("skew", most_rad);
  evidence->Add("skews", sum_rad);
  evidence->Add("upright_skew", upright_rad);
  evidence->Add("lean", lean_rad);
  evidence->Add("askew", most_rad + lean_rad);
  evidence->Add("spread", spread);
  evidence->Add("skew_to_spread", most_rad / (spread + kLeastSpread));
}

// Along an edge of the outline, between the ends of two stripes; zero where one of them is missing.
Eigen::Vector3d EdgeBetween(const TargetStripe& a, const TargetStripe& b, bool last) {
  if (a.empty() || b.empty()) return Eigen::Vector3d::Zero();
  return last ? b.p_L_m.back() - a.p_L_m.back() : b.p_L_m.front() - a.p_L_m.front();
}

// How far from 0 and 90 degrees the outline's sides stand to its upper and lower edge, and all of
// them to the largest upright face: what is left to see of a wedge that turns one face to us.
void AddEdges(const std::vector<TargetStripe>& stripes, const std::vector<Face>& faces,
              EvidenceList* evidence) {
  const std::array<Eigen::Vector3d, 2> level = {EdgeBetween(stripes[3], stripes[5], false),
                                                EdgeBetween(stripes[3], stripes[5], true)};
  const auto upright = std::find_if(faces.begin(), faces.end(),
                                    [](const Face& face) { return IsUpright(face.normal()); });
  const Eigen::Vector3d normal =
      upright == faces.end() ? Eigen::Vector3d::Zero() : upright->normal();
  for (size_t half = 0; half < 2; ++half) {
    evidence->Add("edge_to_face_", half, Skew(level[half], normal));
    for (const bool last : {false, true}) {
      const Eigen::Vector3d side = EdgeBetween(stripes[half], stripes[half + 1], last);
      const size_t place = 10 * half + (last ? 1 : 0);
      evidence->Add("side_to_edge_", place, Skew(side, level[half]));
      evidence->Add("side_to_face_", place, Skew(side, normal));
    }
  }
}

}  // namespace

void AddFaceEvidence(const std::vector<TargetStripe>& stripes, const CrossingGrid& grid,
                     EvidenceList* evidence) {
  const std::vector<Face> faces = FindFaces(grid);
  AddSkews(grid, evidence);
  AddFaces(faces, evidence);
  AddEdges(stripes, faces, evidence);
}

}  // namespace geon::recognition
