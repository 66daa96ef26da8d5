#pragma once

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "geons/triangle_mesh.h"

namespace geon::evaluation {

// A ray in the object's frame; `reach_1` ends it, in lengths of its direction.
struct ObjectRay {
  Eigen::Vector3d origin_m;
  Eigen::Vector3d direction;  // of any length
  double reach_1 = std::numeric_limits<double>::infinity();
};

// One object as rays find it (Embree). Immutable: many threads may ask at once. Results are the
// same on every x86-64 machine: the instruction set is pinned.
class ObjectTracer {
 public:
  // `beside`: what else stands there; rays find it too, but it is no part of the object's outline.
  explicit ObjectTracer(const geons::TriangleMesh& mesh,
                        const geons::TriangleMesh* beside = nullptr);
  ~ObjectTracer();
  ObjectTracer(const ObjectTracer&) = delete;
  ObjectTracer& operator=(const ObjectTracer&) = delete;

  // Where each ray first meets the object or what stands beside it, in lengths of its direction;
  // infinity where it passes. `on_object`, where asked for, tells which of the two it met.
  std::vector<double> FirstHits(std::span<const ObjectRay> rays,
                                std::vector<bool>* on_object = nullptr) const;

  // Whether each ray meets the object at all within its reach.
  std::vector<bool> Hits(std::span<const ObjectRay> rays) const;

  double height_m() const { return height_m_; }
  std::span<const Eigen::Vector3d> outline_m() const { return outline_m_; }

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
  std::vector<Eigen::Vector3d> outline_m_;  // the mesh's vertices
  double height_m_ = 0.0;                   // of the highest vertex above z = 0
};

}  // namespace geon::evaluation
