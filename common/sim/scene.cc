#include "sim/scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/contracts.h"
#include "sim/footprint.h"

namespace geon::sim {
namespace {

constexpr size_t kPacket = 16;
constexpr float kShadowEnd_1 =
    0.9995F;  // shadow rays end this far, short of the surface they ask for
constexpr double kRobotHeight_m = 0.9;  // what stands higher passes over the robot's body

// One instruction set and one thread, so that every x86-64 machine finds the same hits to the last
// bit.
constexpr const char* kDeviceConfiguration = "threads=1,set_affinity=0,isa=sse4.2";

unsigned AddBody(RTCDevice device, RTCScene scene, const Body& body) {
  const auto& mesh = body.surface_W;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.vertices_m.size()));
  for (const Eigen::Vector3d& p : mesh.vertices_m) {
    for (int k = 0; k < 3; ++k) *vertices++ = static_cast<float>(p[k]);
  }
  auto* corners = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int corner : triangle) *corners++ = static_cast<unsigned>(corner);
  }
  rtcCommitGeometry(geometry);
  const unsigned id = rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  return id;
}

// The unit normal at a point of a triangle given by barycentric coordinates, towards the viewer.
Eigen::Vector3f SmoothNormal(const geons::TriangleMesh& mesh, unsigned triangle, float u, float v,
                             const Eigen::Vector3f& direction) {
  const auto& [a, b, c] = mesh.triangles[triangle];
  const auto& n = mesh.normals;
  const Eigen::Vector3d smooth =
      (1.0 - static_cast<double>(u) - static_cast<double>(v)) * n[static_cast<size_t>(a)] +
      static_cast<double>(u) * n[static_cast<size_t>(b)] +
      static_cast<double>(v) * n[static_cast<size_t>(c)];
  const Eigen::Vector3f normal = smooth.normalized().cast<float>();
  return normal.dot(direction) > 0.0F ? Eigen::Vector3f(-normal) : normal;
}

}  // namespace

struct Scene::Tracer {
  RTCDevice device = rtcNewDevice(kDeviceConfiguration);
  RTCScene scene = rtcNewScene(device);
  Tracer() = default;
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;
  ~Tracer() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

Scene::Scene(std::vector<Body> bodies, const Lighting& lighting)
    : bodies_(std::move(bodies)), lighting_(lighting), tracer_(std::make_unique<Tracer>()) {
  rtcSetSceneFlags(tracer_->scene, RTC_SCENE_FLAG_ROBUST);
  for (size_t k = 0; k < bodies_.size(); ++k) {
    const geons::TriangleMesh& mesh = bodies_[k].surface_W;
    Require(mesh.normals.size() == mesh.vertices_m.size() && !mesh.triangles.empty(),
            "Scene: " + bodies_[k].name + " needs triangles and a normal for every vertex");
    Require(AddBody(tracer_->device, tracer_->scene, bodies_[k]) == k,
            "Scene: unexpected body number");
    facets_.Append(mesh);
    const Eigen::AlignedBox3d bounds_m = geons::Bounds(mesh);
    if (bounds_m.max().z() <= 0.0) continue;
    feet_W_.push_back({ConvexFootprint(mesh),
                       {bounds_m.min().head<2>(), bounds_m.max().head<2>()},
                       bodies_[k].obstacle && bounds_m.min().z() < kRobotHeight_m});
  }
  rtcCommitScene(tracer_->scene);
}

Scene::~Scene() = default;

void Scene::Look(const Eigen::Vector3f& origin, std::span<const Eigen::Vector3f> directions,
                 std::span<Sighting> sightings) const {
  Require(directions.size() == sightings.size(), "Scene::Look: one sighting for each direction");
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) RTCRayHit16 packet;
  alignas(64) int valid[kPacket];
  for (size_t start = 0; start < directions.size(); start += kPacket) {
    for (size_t k = 0; k < kPacket; ++k) {
      const Eigen::Vector3f& d = directions[std::min(start + k, directions.size() - 1)];
      valid[k] = start + k < directions.size() ? -1 : 0;
      packet.ray.org_x[k] = origin.x();
      packet.ray.org_y[k] = origin.y();
      packet.ray.org_z[k] = origin.z();
      packet.ray.dir_x[k] = d.x();
      packet.ray.dir_y[k] = d.y();
      packet.ray.dir_z[k] = d.z();
      packet.ray.tnear[k] = 0.0F;
      packet.ray.tfar[k] = std::numeric_limits<float>::infinity();
      packet.ray.time[k] = 0.0F;
      packet.ray.mask[k] = ~0U;
      packet.ray.flags[k] = 0;
      packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcIntersect16(valid, tracer_->scene, &context, &packet);
    for (size_t k = 0; k < kPacket && start + k < directions.size(); ++k) {
      Sighting& sighting = sightings[start + k];
      if (packet.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) {
        sighting = Sighting();
        continue;
      }
      const Eigen::Vector3f& d = directions[start + k];
      sighting.body = static_cast<int>(packet.hit.geomID[k]);
      sighting.p_W_m = origin + packet.ray.tfar[k] * d;
      sighting.normal_W = SmoothNormal(bodies_[packet.hit.geomID[k]].surface_W,
                                       packet.hit.primID[k], packet.hit.u[k], packet.hit.v[k], d);
    }
  }
}

void Scene::Illuminate(const Eigen::Vector3f& light, std::span<const Eigen::Vector3f> points,
                       std::span<uint8_t> lit) const {
  Require(points.size() == lit.size(), "Scene::Illuminate: one answer for each point");
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(64) RTCRay16 packet;
  alignas(64) int valid[kPacket];
  for (size_t start = 0; start < points.size(); start += kPacket) {
    for (size_t k = 0; k < kPacket; ++k) {
      const Eigen::Vector3f d = points[std::min(start + k, points.size() - 1)] - light;
      valid[k] = start + k < points.size() ? -1 : 0;
      packet.org_x[k] = light.x();
      packet.org_y[k] = light.y();
      packet.org_z[k] = light.z();
      packet.dir_x[k] = d.x();
      packet.dir_y[k] = d.y();
      packet.dir_z[k] = d.z();
      packet.tnear[k] = 0.0F;
      packet.tfar[k] = kShadowEnd_1;
      packet.time[k] = 0.0F;
      packet.mask[k] = ~0U;
      packet.flags[k] = 0;
    }
    rtcOccluded16(valid, tracer_->scene, &context, &packet);
    for (size_t k = 0; k < kPacket && start + k < points.size(); ++k) {
      lit[start + k] = packet.tfar[k] >= 0.0F ? 1 : 0;
    }
  }
}

std::optional<RayHit> Scene::CastRay(const Eigen::Vector3d& origin_W_m,
                                     const Eigen::Vector3d& direction_W, double reach_m) const {
  const Eigen::Vector3f origin = origin_W_m.cast<float>();
  const Eigen::Vector3f direction = direction_W.cast<float>();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  constexpr double kBeyond_1 = 1.01;  // not to miss by rounding what is at the reach's end
  RTCRayHit ray;
  ray.ray = {origin.x(),
             origin.y(),
             origin.z(),
             0.0F,
             direction.x(),
             direction.y(),
             direction.z(),
             0.0F,
             static_cast<float>(kBeyond_1 * reach_m),
             ~0U,
             0,
             0};
  ray.hit.geomID = ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(tracer_->scene, &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const Body& body = bodies_[ray.hit.geomID];
  const Eigen::Vector3f p_W_m = origin + ray.ray.tfar * direction;
  RayHit hit;
  hit.distance_m = static_cast<double>((p_W_m - origin).norm());
  hit.normal_W = SmoothNormal(body.surface_W, ray.hit.primID, ray.hit.u, ray.hit.v, direction)
                     .cast<double>()
                     .normalized();
  hit.reflectance_1 = static_cast<double>(body.material.laser_reflectance_1);
  return hit;
}

std::vector<DiscContact> Scene::ContactsOfDisc(const Eigen::Vector2d& center_W_m,
                                               double radius_m) const {
  const Eigen::Vector2d reach_m = Eigen::Vector2d::Constant(radius_m + kContactReach_m);
  const Eigen::AlignedBox2d around(center_W_m - reach_m, center_W_m + reach_m);
  std::vector<DiscContact> contacts;
  for (const Foot& foot : feet_W_) {
    if (!foot.obstacle || !foot.bounds_m.intersects(around)) continue;
    const NearestPoint nearest = NearestPointOfConvex(foot.outline_m, center_W_m);
    const double clearance_m = nearest.distance_m - radius_m;
    if (clearance_m > kContactReach_m) continue;
    contacts.push_back({std::atan2(nearest.direction.y(), nearest.direction.x()), clearance_m});
  }
  return contacts;
}

double Scene::OpenGround_m(const Eigen::Vector2d& from_W_m,
                           const Eigen::Vector2d& direction_W) const {
  const Eigen::Vector2d left_W(-direction_W.y(), direction_W.x());
  double open_m = kEndless_m;
  for (const Foot& foot : feet_W_) {
    // Most feet lie wholly to one side of the line.
    const Eigen::Vector2d middle_m = foot.bounds_m.center() - from_W_m;
    const Eigen::Vector2d half_m = 0.5 * foot.bounds_m.sizes();
    if (std::abs(left_W.dot(middle_m)) > left_W.cwiseAbs().dot(half_m)) continue;
    open_m = std::min(open_m, DistanceAlongRay(foot.outline_m, from_W_m, direction_W));
  }
  return open_m;
}

}  // namespace geon::sim
