#include "sim/rig_renderer.h"

#include <array>
#include <optional>
#include <utility>

#include "base/contracts.h"
#include "sim/hash_noise.h"
#include "sim/laser_light.h"
#include "sim/mounting.h"
#include "sim/shading.h"
#include "sim/view.h"

namespace geon::sim {
namespace {

enum class CameraNumber : uint64_t { kColor = 1, kBw = 2, kFloor = 3 };

uint64_t FrameSeed(uint64_t seed, CameraNumber camera, int64_t seq) {
  return HashMix(HashMix(seed, static_cast<uint64_t>(camera)), static_cast<uint64_t>(seq));
}

// Speckle changes when the rig moves by more than a hair.
uint64_t SpeckleSeed(uint64_t seed, const geometry::RigidTransform& X_WC, int laser) {
  uint64_t mix = HashMix(seed, static_cast<uint64_t>(laser));
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      mix = HashMix(mix,
                    static_cast<uint64_t>(static_cast<int64_t>(X_WC.matrix()(row, column) * 1e6)));
    }
  }
  return mix;
}

LaserFan FanInWorld(const geometry::LaserMount& mount, const geometry::RigidTransform& X_WT,
                    bool along_u) {
  LaserFan fan;
  fan.origin_W_m = X_WT * mount.p_TLaser_m;
  fan.normal_W = X_WT.linear() * mount.normal_T;
  const Eigen::Vector3d ahead_W = X_WT.linear().col(0);
  fan.forward_W = (ahead_W - ahead_W.dot(fan.normal_W) * fan.normal_W).normalized();
  fan.stripe_runs_along_u = along_u;
  return fan;
}

}  // namespace

struct RigRenderer::Sight {
  View view;
  std::vector<float> signal;                        // the room's light, blurred by the lens
  std::array<std::vector<float>, 2> laser_signals;  // of each laser, computed when first burning
};

RigRenderer::RigRenderer(std::shared_ptr<const Scene> scene, const geometry::SensorRig& designed,
                         const RendererOptions& options, uint64_t seed)
    : scene_(std::move(scene)),
      mounted_rig_(AsMounted(designed, options.mounting)),
      options_(options),
      seed_(seed),
      color_sensor_(options.color),
      stripe_sensor_(options.stripe),
      floor_sensor_(options.floor) {
  Require(scene_ != nullptr, "RigRenderer: no scene");
  const Status valid = Validate(options_);
  Require(valid.ok(), "RigRenderer: " + valid.message());
}
RigRenderer::~RigRenderer() = default;
RigRenderer::RigRenderer(RigRenderer&&) noexcept = default;
RigRenderer& RigRenderer::operator=(RigRenderer&&) noexcept = default;

void RigRenderer::SetScene(std::shared_ptr<const Scene> scene) {
  Require(scene != nullptr, "RigRenderer: no scene");
  scene_ = std::move(scene);
  color_.reset();
  bw_.reset();
  floor_.reset();
}

geometry::RigidTransform RigRenderer::StripeCameraPose(const RigPose& pose) const {
  return pose.X_WR * mounted_rig_.StripeCameraPose(pose.pan_rad, pose.tilt_rad);
}

RigRenderer::Sight& RigRenderer::SightFrom(std::unique_ptr<Sight>* kept,
                                           const geometry::PinholeCamera& camera,
                                           const geometry::RigidTransform& X_WC) {
  if (*kept == nullptr) *kept = std::make_unique<Sight>();
  Sight& sight = **kept;
  if (sight.view.facet.empty() || sight.view.X_WC.matrix() != X_WC.matrix()) {
    LookThrough(*scene_, camera, X_WC, &sight.view);
    sight.signal.clear();
    for (std::vector<float>& laser : sight.laser_signals) laser.clear();
  }
  return sight;
}

Frame RigRenderer::HeadColor(const RigPose& pose, int64_t seq) {
  const geometry::PinholeCamera& camera = mounted_rig_.color_camera;
  const auto X_WC = pose.X_WR * mounted_rig_.ColorCameraPose(pose.pan_rad, pose.tilt_rad);
  Sight& sight = SightFrom(&color_, camera, X_WC);
  if (sight.signal.empty()) {
    ShadeColor(*scene_, sight.view, LampShadows::kSoft, &sight.signal);
    for (float& value : sight.signal) value *= static_cast<float>(options_.color.white_1);
    BlurByLens(camera.width_px, camera.height_px, 3, options_.color.blur_1, &sight.signal);
  }
  return {camera.width_px, camera.height_px, 3,
          color_sensor_.Expose(sight.signal, FrameSeed(seed_, CameraNumber::kColor, seq))};
}

Frame RigRenderer::FloorColor(const RigPose& pose, int64_t seq) {
  const geometry::PinholeCamera& camera = mounted_rig_.floor_camera;
  Sight& sight = SightFrom(&floor_, camera, pose.X_WR * mounted_rig_.X_RF);
  if (sight.signal.empty()) {
    ShadeColor(*scene_, sight.view, LampShadows::kSoft, &sight.signal);
    for (float& value : sight.signal) value *= static_cast<float>(options_.floor.white_1);
    BlurByLens(camera.width_px, camera.height_px, 3, options_.floor.blur_1, &sight.signal);
  }
  return {camera.width_px, camera.height_px, 3,
          floor_sensor_.Expose(sight.signal, FrameSeed(seed_, CameraNumber::kFloor, seq))};
}

Frame RigRenderer::HeadBw(const RigPose& pose, const LaserFractions& lasers, int64_t seq) {
  const geometry::PinholeCamera& camera = mounted_rig_.stripe_camera;
  const auto X_WT = pose.X_WR * mounted_rig_.HeadPose(pose.pan_rad, pose.tilt_rad);
  Sight& sight = SightFrom(&bw_, camera, X_WT * mounted_rig_.X_TB);
  if (sight.signal.empty()) {
    // Behind the filter a shadow of the lamp would be a grey level or two: not worth its rays.
    ShadeRed(*scene_, sight.view, &sight.signal);  // 670 nm
    for (float& value : sight.signal) value *= static_cast<float>(options_.stripe.white_1);
    BlurByLens(camera.width_px, camera.height_px, 1, options_.stripe.blur_1, &sight.signal);
  }
  std::vector<float> signal = sight.signal;
  const double fractions_1[2] = {lasers.horizontal_1, lasers.vertical_1};
  for (size_t k = 0; k < 2; ++k) {
    if (fractions_1[k] <= 0.0) continue;
    std::vector<float>& laser = sight.laser_signals[k];
    if (laser.empty()) {
      const auto& mount = k == 0 ? mounted_rig_.horizontal_laser : mounted_rig_.vertical_laser;
      laser = LaserLight(*scene_, sight.view, FanInWorld(mount, X_WT, k == 0), options_.lasers,
                         SpeckleSeed(seed_, sight.view.X_WC, static_cast<int>(k)));
      BlurByLens(camera.width_px, camera.height_px, 1, options_.stripe.blur_1, &laser);
    }
    const auto fraction = static_cast<float>(fractions_1[k]);
    for (size_t i = 0; i < signal.size(); ++i) signal[i] += fraction * laser[i];
  }
  return {camera.width_px, camera.height_px, 1,
          stripe_sensor_.Expose(signal, FrameSeed(seed_, CameraNumber::kBw, seq))};
}

std::shared_ptr<const Scene> BoardScene(const geometry::RigidTransform& X_WB, double distance_m) {
  constexpr double kHalfSide_m = 1.0;
  Body board;
  board.name = "board";
  for (const auto& [x_m, y_m] : {std::pair{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
    board.surface_W.vertices_m.push_back(
        X_WB * Eigen::Vector3d(kHalfSide_m * x_m, kHalfSide_m * y_m, distance_m));
    board.surface_W.normals.push_back(-X_WB.linear().col(2));
  }
  board.surface_W.triangles = {{0, 2, 1}, {0, 3, 2}};
  board.material = Paint({150, 150, 150});
  board.material.gloss_1 = 0.0F;
  return std::make_shared<Scene>(std::vector<Body>{board}, Lighting());
}

}  // namespace geon::sim
