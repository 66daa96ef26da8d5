#include "recognition/outline_evidence.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace geon::recognition {
namespace {

using Points = std::array<Eigen::Vector3d, 3>;

double Along(const Eigen::Vector3d& direction) {
  return std::atan2(direction.z(), direction.head<2>().norm());
}

// One side of the outline: the same ends of three stripes. `across` is the image axis along the
// stripes, `outward` the sign on it that leads away from the object.
struct Side {
  Points p_B_m;
  Points p_L_m;
  int across = 0;
  double outward = 1.0;
};

// Inside a straight edge through the outer two (5.3), in the image, scaled to metres.
double ConcaveInImage(const Side& side) {
  const auto along = [&](int k) {
    return side.p_B_m[static_cast<size_t>(k)][1 - side.across] /
           side.p_B_m[static_cast<size_t>(k)].z();
  };
  const auto across = [&](int k) {
    return side.p_B_m[static_cast<size_t>(k)][side.across] / side.p_B_m[static_cast<size_t>(k)].z();
  };
  const double span = along(2) - along(0);
  const double t = std::abs(span) > 1e-6 ? (along(1) - along(0)) / span : 0.5;
  const double straight = across(0) + t * (across(2) - across(0));
  return side.outward * (straight - across(1)) * side.p_B_m[1].z();
}

void AddSide(const Side& side, double scale_m, EvidenceList* evidence) {
  const Eigen::Vector3d chord = side.p_L_m[2] - side.p_L_m[0];
  const Eigen::Vector3d off = side.p_L_m[1] - side.p_L_m[0];
  const double chord_m = std::max(chord.norm(), 1e-6);
  const Eigen::Vector3d foot = off - chord * (chord.dot(off) / (chord_m * chord_m));
  evidence->Add("concave", ConcaveInImage(side) / scale_m);
  evidence->Add("off_chord", foot.norm() / scale_m);
  evidence->Add("off_chord_z", foot.z() / scale_m);
  evidence->Add("slope", Along(chord));
  evidence->Add("azimuth", std::atan2(chord.x(), chord.y()));
  evidence->Add("lean", std::atan2(side.p_B_m[2][side.across] - side.p_B_m[0][side.across],
                                   std::abs(side.p_B_m[2][1 - side.across] -
                                            side.p_B_m[0][1 - side.across])));
  evidence->Add("bend", (side.p_L_m[2] - 2.0 * side.p_L_m[1] + side.p_L_m[0]).norm() / chord_m);
  evidence->Add("chord", chord_m / scale_m);
}

void AddZeros(int count, EvidenceList* evidence) {
  for (int k = 0; k < count; ++k) evidence->Add("none", 0.0);
}

// Lengths of the three stripes against each other, in the image plane and in space.
void AddGrowth(const Side& first, const Side& last, double scale_m, EvidenceList* evidence) {
  std::array<double, 3> flat_m{}, space_m{};
  for (size_t k = 0; k < 3; ++k) {
    flat_m[k] = std::abs(last.p_B_m[k][last.across] - first.p_B_m[k][first.across]);
    space_m[k] = (last.p_L_m[k] - first.p_L_m[k]).norm();
  }
  const double mean_m = (flat_m[0] + flat_m[1] + flat_m[2]) / 3.0;
  const double one = (flat_m[1] - flat_m[0]) / mean_m, two = (flat_m[2] - flat_m[1]) / mean_m;
  evidence->Add("grow_1", one);
  evidence->Add("grow_2", two);
  evidence->Add("grow", one + two);
  evidence->Add("grow_bend", two - one);
  evidence->Add("steady",
                one * two > 0.0 ? std::copysign(std::min(std::abs(one), std::abs(two)), one) : 0.0);
  evidence->Add("space_1", (space_m[1] - space_m[0]) / scale_m);
  evidence->Add("space_2", (space_m[2] - space_m[1]) / scale_m);
  evidence->Add("space_grow", (space_m[2] - space_m[0]) / scale_m);
  evidence->Add("mean", mean_m / scale_m);
}

// Whether the two sides run apart (5.8), in the image and in space.
void AddConvergence(const Side& first, const Side& last, double scale_m, EvidenceList* evidence) {
  const auto step_m = [](const Side& side, size_t a, size_t b) {
    return side.p_B_m[b][side.across] - side.p_B_m[a][side.across];
  };
  evidence->Add("asymmetry_1", (step_m(first, 0, 1) + step_m(last, 0, 1)) / scale_m);
  evidence->Add("asymmetry_2", (step_m(first, 1, 2) + step_m(last, 1, 2)) / scale_m);
  const auto apart_rad = [&](size_t a, size_t b) {
    const Eigen::Vector3d u = first.p_L_m[b] - first.p_L_m[a], v = last.p_L_m[b] - last.p_L_m[a];
    return std::atan2(u.cross(v).norm(), u.dot(v));
  };
  evidence->Add("convergence", apart_rad(0, 2));
  evidence->Add("convergence_1", apart_rad(0, 1));
  evidence->Add("convergence_2", apart_rad(1, 2));
  const Eigen::Vector3d u = first.p_L_m[2] - first.p_L_m[0], v = last.p_L_m[2] - last.p_L_m[0];
  evidence->Add("slope_difference", Along(u) - Along(v));
  const Eigen::Vector3d middle = (last.p_L_m[1] - first.p_L_m[1]).normalized();
  evidence->Add("slope_across", Along(middle));
}

}  // namespace

void AddOutlineEvidence(const std::vector<TargetStripe>& stripes, const BwCamera& camera,
                        double scale_m, EvidenceList* evidence) {
  for (int direction = 0; direction < 2; ++direction) {
    Side first, last;
    first.across = last.across = direction;
    first.outward = -1.0;
    bool complete = true;
    for (size_t k = 0; k < 3; ++k) {
      const TargetStripe& stripe = stripes[3 * static_cast<size_t>(direction) + k];
      complete = complete && !stripe.empty();
      if (!complete) break;
      first.p_L_m[k] = stripe.p_L_m.front();
      last.p_L_m[k] = stripe.p_L_m.back();
      first.p_B_m[k] = camera.InCamera(first.p_L_m[k]);
      last.p_B_m[k] = camera.InCamera(last.p_L_m[k]);
    }
    const char* names[] = {"left", "right", "top", "bottom", "horizontal", "vertical"};
    if (!complete) {
      evidence->BeginGroup(names[4 + direction]);
      AddZeros(8 + 8 + 9 + 7, evidence);
      continue;
    }
    evidence->BeginGroup(names[2 * direction]);
    AddSide(first, scale_m, evidence);
    evidence->BeginGroup(names[2 * direction + 1]);
    AddSide(last, scale_m, evidence);
    evidence->BeginGroup(names[4 + direction]);
    AddGrowth(first, last, scale_m, evidence);
    AddConvergence(first, last, scale_m, evidence);
  }
}

}  // namespace geon::recognition
