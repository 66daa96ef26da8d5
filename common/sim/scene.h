#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geons/triangle_mesh.h"
#include "sim/facets.h"
#include "sim/lighting.h"
#include "sim/material.h"
#include "sim/surroundings.h"

namespace geon::sim {

// One thing of the world, in its place (frame W).
struct Body {
  std::string name;
  geons::TriangleMesh surface_W;
  Material material;
  bool obstacle = true;  // stands in the robot's way when its foot is below the robot's head
};

// A surface seen by a ray. `body` is -1 where the ray leaves the world.
struct Sighting {
  Eigen::Vector3f p_W_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal_W =
      Eigen::Vector3f::UnitZ();  // unit, of the smooth surface, towards the viewer
  int body = -1;
};

// The world as rays find it (Embree). Immutable: many threads may ask at once. Results are the same
// on every x86-64 machine: the instruction set is pinned.
class Scene : public Surroundings {
 public:
  Scene(std::vector<Body> bodies, const Lighting& lighting);
  ~Scene() override;
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  std::optional<RayHit> CastRay(const Eigen::Vector3d& origin_W_m,
                                const Eigen::Vector3d& direction_W,
                                double reach_m = kEndless_m) const override;
  // A body's foot is the convex hull of its outline from above.
  std::vector<DiscContact> ContactsOfDisc(const Eigen::Vector2d& center_W_m,
                                          double radius_m) const override;

  // What rays from one point meet; directions need not be unit vectors.
  void Look(const Eigen::Vector3f& origin_W_m, std::span<const Eigen::Vector3f> directions_W,
            std::span<Sighting> sightings) const;

  // How far a straight line over the ground is open: there, nothing stands on the floor or over it.
  double OpenGround_m(const Eigen::Vector2d& from_W_m, const Eigen::Vector2d& direction_W) const;

  // Whether light from one point reaches each of the others (which lie on surfaces).
  void Illuminate(const Eigen::Vector3f& light_W_m, std::span<const Eigen::Vector3f> points_W_m,
                  std::span<uint8_t> lit) const;

  const std::vector<Body>& bodies() const { return bodies_; }
  const Lighting& lighting() const { return lighting_; }
  const Facets& facets() const { return facets_; }  // of all bodies, in their order

 private:
  struct Tracer;  // Embree's handles
  struct Foot {
    std::vector<Eigen::Vector2d> outline_m;  // from above: convex, counter-clockwise
    Eigen::AlignedBox2d bounds_m;
    bool obstacle;
  };
  std::vector<Body> bodies_;
  Lighting lighting_;
  Facets facets_;
  std::vector<Foot> feet_W_;  // of all that does not lie flat on the floor
  std::unique_ptr<Tracer> tracer_;
};

}  // namespace geon::sim
