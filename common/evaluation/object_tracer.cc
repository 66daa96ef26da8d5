#include "evaluation/object_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>

#include "base/contracts.h"

namespace geon::evaluation {
namespace {

constexpr size_t kPacket = 16;
constexpr unsigned kObject = 0;  // what Embree calls the mesh that is attached first

// One instruction set and one thread, so that every x86-64 machine finds the same hits to the last
// bit.
constexpr const char* kDeviceConfiguration = "threads=1,set_affinity=0,isa=sse4.2";

void AddMesh(RTCDevice device, RTCScene scene, const geons::TriangleMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                               RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                               mesh.vertices_m.size()));
  for (const Eigen::Vector3d& p_m : mesh.vertices_m) {
    for (int k = 0; k < 3; ++k) *vertices++ = static_cast<float>(p_m[k]);
  }
  auto* corners = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(unsigned), mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int corner : triangle) *corners++ = static_cast<unsigned>(corner);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

// Rays start .. start + 15 as Embree wants them; beyond the last they repeat and are not valid.
void Fill(std::span<const ObjectRay> rays, size_t start, RTCRay16* packet, int* valid) {
  for (size_t k = 0; k < kPacket; ++k) {
    const ObjectRay& ray = rays[std::min(start + k, rays.size() - 1)];
    valid[k] = start + k < rays.size() ? -1 : 0;
    packet->org_x[k] = static_cast<float>(ray.origin_m.x());
    packet->org_y[k] = static_cast<float>(ray.origin_m.y());
    packet->org_z[k] = static_cast<float>(ray.origin_m.z());
    packet->dir_x[k] = static_cast<float>(ray.direction.x());
    packet->dir_y[k] = static_cast<float>(ray.direction.y());
    packet->dir_z[k] = static_cast<float>(ray.direction.z());
    packet->tnear[k] = 0.0F;
    packet->tfar[k] = static_cast<float>(ray.reach_1);
    packet->time[k] = 0.0F;
    packet->mask[k] = ~0U;
    packet->flags[k] = 0;
  }
}

RTCIntersectContext CoherentContext() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

}  // namespace

struct ObjectTracer::Embree {
  RTCDevice device = rtcNewDevice(kDeviceConfiguration);
  RTCScene scene = rtcNewScene(device);
  Embree() = default;
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

ObjectTracer::ObjectTracer(const geons::TriangleMesh& mesh, const geons::TriangleMesh* beside)
    : embree_(std::make_unique<Embree>()), outline_m_(mesh.vertices_m) {
  Require(!mesh.triangles.empty(), "ObjectTracer: a mesh without triangles");
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
  AddMesh(embree_->device, embree_->scene, mesh);
  if (beside) AddMesh(embree_->device, embree_->scene, *beside);
  rtcCommitScene(embree_->scene);
  for (const Eigen::Vector3d& p_m : outline_m_) height_m_ = std::max(height_m_, p_m.z());
}

ObjectTracer::~ObjectTracer() = default;

std::vector<double> ObjectTracer::FirstHits(std::span<const ObjectRay> rays,
                                            std::vector<bool>* on_object) const {
  std::vector<double> hits(rays.size(), std::numeric_limits<double>::infinity());
  if (on_object) on_object->assign(rays.size(), false);
  RTCIntersectContext context = CoherentContext();
  alignas(64) RTCRayHit16 packet;
  alignas(64) int valid[kPacket];
  for (size_t start = 0; start < rays.size(); start += kPacket) {
    Fill(rays, start, &packet.ray, valid);
    std::fill_n(packet.hit.geomID, kPacket, RTC_INVALID_GEOMETRY_ID);
    std::fill_n(packet.hit.instID[0], kPacket, RTC_INVALID_GEOMETRY_ID);
    rtcIntersect16(valid, embree_->scene, &context, &packet);
    for (size_t k = 0; k < kPacket && start + k < rays.size(); ++k) {
      if (packet.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID) continue;
      hits[start + k] = static_cast<double>(packet.ray.tfar[k]);
      if (on_object) (*on_object)[start + k] = packet.hit.geomID[k] == kObject;
    }
  }
  return hits;
}

std::vector<bool> ObjectTracer::Hits(std::span<const ObjectRay> rays) const {
  std::vector<bool> hits(rays.size());
  RTCIntersectContext context = CoherentContext();
  alignas(64) RTCRay16 packet;
  alignas(64) int valid[kPacket];
  for (size_t start = 0; start < rays.size(); start += kPacket) {
    Fill(rays, start, &packet, valid);
    rtcOccluded16(valid, embree_->scene, &context, &packet);
    for (size_t k = 0; k < kPacket && start + k < rays.size(); ++k) {
      hits[start + k] = packet.tfar[k] < 0.0F;  // Embree's mark of a ray that was stopped
    }
  }
  return hits;
}

}  // namespace geon::evaluation
