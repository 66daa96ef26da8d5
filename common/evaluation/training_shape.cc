#include "evaluation/training_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "evaluation/trial_random.h"
#include "geometry/rigid_transform.h"
#include "geons/geon_shape.h"
#include "geons/polygon_geon.h"
#include "geons/stable_position.h"
#include "geons/superquadric.h"

namespace geon::evaluation {
namespace {

using geometry::RotationAboutX;
using geometry::RotationAboutY;
using geons::GeonShape;
using geons::TriangleMesh;

constexpr geons::MeshResolution kTrainingResolution{128, 96};

double LogUniform(std::mt19937_64& random, double low, double high) {
  return std::exp(Uniform(random, std::log(low), std::log(high)));
}
bool Chance(std::mt19937_64& random, double share_1) { return Uniform(random, 0.0, 1.0) < share_1; }

// A shape upright, before it is laid down.
struct Upright {
  GeonLabel label = GeonLabel::kCuboid;
  Eigen::Vector3d size_m = Eigen::Vector3d::Zero();  // half way up
  Eigen::Vector2d taper_1 =
      Eigen::Vector2d::Zero();  // at the top 1 - taper, at the bottom 1 + taper
  double bend_rad = 0.0;
};

Eigen::Vector3d DrawSize(GeonLabel label, std::mt19937_64& random) {
  const double scale = Uniform(random, 0.55, 1.1);
  const auto side = [&](double low_m, double high_m) {
    return scale * LogUniform(random, low_m, high_m);
  };
  if (geons::IsBent(label)) return {side(.025, .10), side(.025, .11), side(.16, .38)};
  if (label == GeonLabel::kEllipsoid) return {side(.08, .22), side(.08, .22), side(.08, .26)};
  return {side(.06, .22), side(.06, .22), side(.05, .28)};
}

Eigen::Vector2d DrawTaper(GeonLabel label, std::mt19937_64& random) {
  const double strength = Uniform(random, 0.0, 1.0);
  const double most_1 = 0.1 + 0.75 * strength * strength;
  if (geons::IsTapered(label)) {
    double other_1 = most_1;
    const double kind = Uniform(random, 0.0, 1.0);
    if (geons::IsRound(label)) {
      if (kind < 0.15) other_1 *= Uniform(random, 0.6, 1.0);
    } else if (kind < 0.4) {
      other_1 = 0.0;
    } else if (kind < 0.6) {
      other_1 *= Uniform(random, 0.0, 1.0);
    }
    return Chance(random, 0.5) ? Eigen::Vector2d(most_1, other_1)
                               : Eigen::Vector2d(other_1, most_1);
  }
  if (geons::IsBent(label)) {
    return Eigen::Vector2d::Constant(Chance(random, 0.25) ? Uniform(random, 0.0, 0.4) : 0.0);
  }
  if (label == GeonLabel::kEllipsoid || Chance(random, 0.5)) return Eigen::Vector2d::Zero();
  return Eigen::Vector2d::Constant(Uniform(random, -0.01, 0.01));
}

Upright DrawUpright(std::mt19937_64& random) {
  for (;;) {
    Upright shape;
    shape.label = static_cast<GeonLabel>(random() % kGeonLabelCount);
    shape.size_m = DrawSize(shape.label, random);
    if (geons::IsRound(shape.label) && shape.label != GeonLabel::kEllipsoid) {
      shape.size_m.y() =
          shape.size_m.x() * (Chance(random, 0.15) ? Uniform(random, 0.8, 1.0) : 1.0);
    }
    shape.taper_1 = DrawTaper(shape.label, random);
    if (geons::IsBent(shape.label)) shape.bend_rad = RadiansFromDegrees(Uniform(random, 40, 180));
    // A bend must leave a hole in the middle.
    const double inner = 0.6 * shape.size_m.x() * (1.0 + shape.taper_1.x()) * shape.bend_rad;
    if (inner < shape.size_m.z()) return shape;
  }
}

TriangleMesh MakeSuperquadric(const Upright& shape, std::mt19937_64& random) {
  const double edge_1 = Chance(random, 0.5) ? 0.02 : LogUniform(random, 0.02, 0.25);
  geons::Superquadric superquadric;
  superquadric.half_axes_m = 0.5 * shape.size_m;
  const bool ellipsoid = shape.label == GeonLabel::kEllipsoid;
  superquadric.profile_exponent_1 = ellipsoid ? Uniform(random, 0.85, 1.15) : edge_1;
  superquadric.section_exponent_1 = geons::IsRound(shape.label) ? 1.0 : edge_1;
  return geons::SuperquadricMesh(superquadric, kTrainingResolution);
}

// The box or prism whose deformation is the shape; a bent one and an ellipsoid as they are.
TriangleMesh MakePolygon(const Upright& shape, std::mt19937_64& random) {
  const int sides = 24 + 4 * static_cast<int>(random() % 19);
  GeonShape polygon;
  polygon.label = shape.label;
  polygon.size_m = shape.size_m;
  polygon.bend_rad = shape.bend_rad;
  if (shape.label == GeonLabel::kTaperedCuboid) polygon.label = GeonLabel::kCuboid;
  if (shape.label == GeonLabel::kTaperedCylinder) polygon.label = GeonLabel::kCylinder;
  TriangleMesh mesh = geons::PolygonGeon(polygon, sides);
  const Eigen::Matrix3d upright = geons::StablePositionRotation(polygon).transpose();
  geons::Transform(geometry::MakeTransform(upright, Eigen::Vector3d::Zero()), &mesh);
  const Eigen::Vector3d middle_m = geons::Bounds(mesh).center();
  geons::Transform(geometry::MakeTransform(Eigen::Matrix3d::Identity(), -middle_m), &mesh);
  return mesh;
}

// How the shape is put down.
Eigen::Matrix3d DrawPose(const Upright& shape, std::mt19937_64& random) {
  const double kind = Uniform(random, 0.0, 1.0);
  if (geons::IsBent(shape.label)) {
    if (kind < 0.40) return RotationAboutX(kPi / 2);   // on its side
    if (kind < 0.65) return RotationAboutY(kPi / 2);   // arch
    if (kind < 0.85) return RotationAboutY(-kPi / 2);  // trough
    return Eigen::Matrix3d::Identity();                // on an end
  }
  if (kind < 0.3) return Eigen::Matrix3d::Identity();
  if (kind < 0.56) return RotationAboutX(kPi);
  // A wedge lies on the flanks that are parallel about twice as often as on the others.
  if (geons::IsTapered(shape.label) && shape.taper_1.minCoeff() == 0.0 && Chance(random, 0.3)) {
    return shape.taper_1.x() == 0.0 ? RotationAboutY(kPi / 2) : RotationAboutX(-kPi / 2);
  }
  // On a flank, which leans inward by the taper.
  const int across = Chance(random, 0.5) ? 0 : 1;
  const double lean_rad =
      std::atan(shape.taper_1[across] * shape.size_m[across] / shape.size_m.z());
  return across == 0 ? RotationAboutY(kPi / 2 + lean_rad) : RotationAboutX(-kPi / 2 - lean_rad);
}

// What use and making leave on a body: no face is quite flat, no two quite parallel. Every vertex
// moves by a smooth random field of three waves about as long as the body, together up to
// `most_1` of its size.
void Warp(double most_1, std::mt19937_64& random, TriangleMesh* mesh) {
  const double size_m = geons::Bounds(*mesh).sizes().maxCoeff();
  std::normal_distribution<double> gauss;
  for (int wave = 0; wave < 3; ++wave) {
    const Eigen::Vector3d step_m =
        NormalVector(random, gauss).normalized() * (most_1 * size_m / 3.0);
    const Eigen::Vector3d number_per_m = NormalVector(random, gauss) * (kPi / size_m);
    const double phase_rad = Uniform(random, 0.0, 2.0 * kPi);
    for (Eigen::Vector3d& p_m : mesh->vertices_m) {
      p_m += step_m * std::sin(number_per_m.dot(p_m) + phase_rad);
    }
  }
}

bool CanBeVessel(const Upright& shape) {
  return !geons::IsBent(shape.label) && shape.label != GeonLabel::kEllipsoid;
}

TriangleMesh MakeVessel(const Upright& shape, std::mt19937_64& random) {
  GeonShape vessel;
  vessel.label = shape.label;
  vessel.taper_1 = geons::IsTapered(shape.label) ? shape.taper_1.maxCoeff() : 0.0;
  vessel.size_m = shape.size_m * (1.0 + vessel.taper_1);
  vessel.size_m.z() = shape.size_m.z();
  if (geons::IsRound(shape.label)) vessel.size_m.y() = vessel.size_m.x();
  vessel.position = geons::IsTapered(shape.label) && Chance(random, 0.7) ? 3 : 1;
  const int sides = 24 + 4 * static_cast<int>(random() % 19);
  return geons::PolygonVessel(vessel, Uniform(random, 0.03, 0.2), sides);
}

}  // namespace

TrainingShape MakeTrainingShape(std::mt19937_64& random) {
  const Upright shape = DrawUpright(random);
  if (CanBeVessel(shape) && Chance(random, 0.125)) return {shape.label, MakeVessel(shape, random)};
  const bool superquadric = Chance(random, 0.5);
  TriangleMesh mesh = superquadric ? MakeSuperquadric(shape, random) : MakePolygon(shape, random);
  // The polygon meshes of bent shapes are bent already, and too coarse to be tapered across.
  if (superquadric || !geons::IsBent(shape.label)) {
    geons::TaperAlongZ(-shape.taper_1 / (0.5 * shape.size_m.z()), &mesh);
  }
  if (superquadric && shape.bend_rad > 0.0) {
    geons::BendAlongZ(shape.bend_rad / shape.size_m.z(), &mesh);
  }
  if (Chance(random, 0.4)) Warp(Uniform(random, 0.0, 0.01), random, &mesh);
  geons::Transform(geometry::MakeTransform(DrawPose(shape, random), Eigen::Vector3d::Zero()),
                   &mesh);
  geons::StandOnGround(&mesh);
  return {shape.label, std::move(mesh)};
}

}  // namespace geon::evaluation
