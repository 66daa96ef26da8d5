#include "sim/rig_renderer.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/contracts.h"
#include "sim/hash_noise.h"
#include "sim/laser_light.h"
#include "sim/lens_map.h"
#include "sim/shading.h"
#include "sim/view.h"

namespace geon::sim {
namespace {

// The more poses a picture is the mean of, the more it is smeared, and the larger the pixels that
// each of them is worth.
constexpr size_t kLargest = 4;
size_t PixelsOf(const std::vector<geometry::RigidTransform>& way_X_WC) {
  return std::clamp<size_t>(way_X_WC.size() / 2, 1, kLargest);
}

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

LaserFan FanInWorld(const BuiltLaser& laser, const geometry::RigidTransform& X_WT, bool along_u) {
  LaserFan fan;
  fan.origin_W_m = X_WT * laser.p_TLaser_m;
  fan.normal_W = X_WT.linear() * laser.normal_T;
  fan.forward_W = X_WT.linear() * laser.forward_T;
  fan.bow_1 = laser.bow_1;
  fan.stripe_runs_along_u = along_u;
  return fan;
}

// Adds the laser's light, spread by the lens as BlurByLens spreads a picture's.
void AddSpread(const std::vector<LitPixel>& lit, int width_px, int height_px, double blur_1,
               float share_1, std::vector<float>* signal) {
  const auto blur = static_cast<float>(blur_1);
  const float weights[3] = {blur, 1.0F - 2.0F * blur, blur};
  for (const LitPixel& pixel : lit) {
    for (int dv = -1; dv <= 1; ++dv) {
      const int v = std::clamp(pixel.v_px + dv, 0, height_px - 1);
      float* row = signal->data() + static_cast<size_t>(v) * static_cast<size_t>(width_px);
      const float level = share_1 * pixel.level_1 * weights[dv + 1];
      for (int du = -1; du <= 1; ++du) {
        row[std::clamp(pixel.u_px + du, 0, width_px - 1)] += level * weights[du + 1];
      }
    }
  }
}

// The k-th of `count` poses looks through another place of the large pixels, so that the mean of
// all is that of the light within: eight places, or the first four, one in each row and column.
geometry::PinholeCamera Aside(geometry::PinholeCamera camera, size_t k, size_t count) {
  constexpr double kColumns_1[] = {0, 4, 2, 6, 1, 5, 3, 7}, kRows_1[] = {0, 4, 6, 2, 3, 7, 1, 5};
  const double middle_1 = 0.5 - 0.5 / static_cast<double>(count);
  camera.cx_px += kColumns_1[k % 8] / 8.0 - middle_1;
  camera.cy_px += kRows_1[k % 8] / 8.0 - middle_1;
  return camera;
}

bool SamePoses(const std::vector<geometry::RigidTransform>& a,
               const std::vector<geometry::RigidTransform>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.matrix() == y.matrix(); });
}

}  // namespace

struct RigRenderer::Sight {
  // The mean of the room's light along the camera's way, through the lens; anew only when that way,
  // or the size of the ideal camera's pixels, is another. `fine`: those of a camera that stands
  // still are no larger than the picture's. `shade` fills the light of a view.
  template <typename Shade>
  const std::vector<float>& RoomLight(const Scene& scene, const BuiltCamera& camera,
                                      std::vector<geometry::RigidTransform> way_X_WC, bool fine,
                                      int channels, double blur_1, Shade shade) {
    const size_t shrink = std::max<size_t>(PixelsOf(way_X_WC), fine ? 1 : 2);
    if (shrink == room_shrink && SamePoses(way_X_WC, room_X_WC)) return room;
    std::optional<LensMap>& map = maps[shrink - 1];
    if (!map) map.emplace(camera, static_cast<int>(shrink));
    const bool large = PixelsOf(way_X_WC) > 1;
    sum.clear();
    for (size_t pose = 0; pose < way_X_WC.size(); ++pose) {
      LookThrough(scene, large ? Aside(map->wide(), pose, way_X_WC.size()) : map->wide(),
                  way_X_WC[pose], &view);
      shade(view, &light);
      if (sum.empty()) {
        std::swap(sum, light);
      } else {
        for (size_t k = 0; k < sum.size(); ++k) sum[k] += light[k];
      }
    }
    if (way_X_WC.size() > 1) {
      const float share_1 = 1.0F / static_cast<float>(way_X_WC.size());
      for (float& value : sum) value *= share_1;
    }
    map->Apply(channels, sum, &between, &room);
    BlurByLens(camera.ideal.width_px, camera.ideal.height_px, channels, blur_1, &room);
    room_X_WC = std::move(way_X_WC);
    room_shrink = shrink;
    return room;
  }
  void Forget() {
    room_X_WC.clear();
    for (KeptLaser& kept : lasers) kept.X_WT.clear();
  }

  std::array<std::optional<LensMap>, kLargest> maps;  // with ideal pixels as large, twice ...
  std::vector<geometry::RigidTransform> room_X_WC;
  size_t room_shrink = 0;
  std::vector<float> room;
  struct KeptLaser {
    std::vector<geometry::RigidTransform> X_WT;
    std::vector<LitPixel> lit;
  };
  std::array<KeptLaser, 2> lasers;
  View view;                               // memory that is used again,
  std::vector<float> light, sum, between;  // as is this
};

RigRenderer::RigRenderer(std::shared_ptr<const Scene> scene, const geometry::SensorRig& designed,
                         const RendererOptions& options, uint64_t seed)
    : scene_(std::move(scene)),
      built_rig_(AsBuilt(designed, options.mounting)),
      options_(options),
      seed_(seed),
      color_sensor_(options.color),
      stripe_sensor_(options.stripe),
      floor_sensor_(options.floor),
      color_(std::make_unique<Sight>()),
      bw_(std::make_unique<Sight>()),
      floor_(std::make_unique<Sight>()) {
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
  for (Sight* sight : {color_.get(), bw_.get(), floor_.get()}) sight->Forget();
}

geometry::RigidTransform RigRenderer::StripeCameraPose(const RigPose& pose) const {
  return pose.X_WR * built_rig_.StripeCameraPose(pose.pan_rad, pose.tilt_rad);
}

Frame RigRenderer::ColorFrame(const BuiltCamera& camera, const CameraOptions& options,
                              const ImageSensor& sensor, std::vector<geometry::RigidTransform> X_WC,
                              double exposure_1, uint64_t noise_seed, Sight* sight) const {
  constexpr int kChannels = 3;
  const std::vector<float>& light =
      sight->RoomLight(*scene_, camera, std::move(X_WC), true, kChannels, options.blur_1,
                       [this](const View& view, std::vector<float>* out) {
                         ShadeColor(*scene_, view, LampShadows::kSoft, out);
                       });
  const auto white_1 = static_cast<float>(options.white_1 * exposure_1);
  std::vector<float> signal(light.size());
  for (size_t k = 0; k < light.size(); ++k) signal[k] = white_1 * light[k];
  return {camera.ideal.width_px, camera.ideal.height_px, kChannels,
          sensor.Expose(signal, noise_seed)};
}

Frame RigRenderer::HeadColor(const RigPath& path, int64_t seq, double exposure_1) {
  std::vector<geometry::RigidTransform> X_WC;
  for (const RigPose& pose : path.poses) {
    X_WC.push_back(pose.X_WR * built_rig_.ColorCameraPose(pose.pan_rad, pose.tilt_rad));
  }
  return ColorFrame(built_rig_.color_camera, options_.color, color_sensor_, std::move(X_WC),
                    exposure_1, FrameSeed(seed_, CameraNumber::kColor, seq), color_.get());
}

Frame RigRenderer::FloorColor(const RigPath& path, int64_t seq, double exposure_1) {
  std::vector<geometry::RigidTransform> X_WC;
  for (const RigPose& pose : path.poses) X_WC.push_back(pose.X_WR * built_rig_.X_RF);
  return ColorFrame(built_rig_.floor_camera, options_.floor, floor_sensor_, std::move(X_WC),
                    exposure_1, FrameSeed(seed_, CameraNumber::kFloor, seq), floor_.get());
}

void RigRenderer::AddLaser(size_t laser, const RigPath& path, float share_1, Sight* sight,
                           std::vector<float>* signal) const {
  std::vector<geometry::RigidTransform> X_WT;
  for (const RigPose& pose : path.poses) {
    X_WT.push_back(pose.X_WR * built_rig_.HeadPose(pose.pan_rad, pose.tilt_rad));
  }
  const BuiltCamera& camera = built_rig_.stripe_camera;
  Sight::KeptLaser& kept = sight->lasers[laser];
  if (!SamePoses(X_WT, kept.X_WT)) {
    kept.lit.clear();
    const bool horizontal = laser == 0;
    const BuiltLaser& built = horizontal ? built_rig_.horizontal_laser : built_rig_.vertical_laser;
    for (const geometry::RigidTransform& X_WT_now : X_WT) {
      const geometry::RigidTransform X_WC = X_WT_now * built_rig_.X_TB;
      const std::vector<LitPixel> lit =
          LaserLight(*scene_, camera, X_WC, FanInWorld(built, X_WT_now, horizontal),
                     options_.lasers, SpeckleSeed(seed_, X_WC, static_cast<int>(laser)));
      kept.lit.insert(kept.lit.end(), lit.begin(), lit.end());
    }
    kept.X_WT = std::move(X_WT);
  }
  AddSpread(kept.lit, camera.ideal.width_px, camera.ideal.height_px, options_.stripe.blur_1,
            share_1 / static_cast<float>(path.poses.size()), signal);
}

Frame RigRenderer::HeadBw(const RigPath& path, const LaserFractions& lasers, int64_t seq,
                          double exposure_1) {
  // Behind the filter the room is a few grey levels: neither its finest detail nor its smear nor
  // the lamp's shadows are worth their rays. Unless the exposure is long.
  constexpr double kFaint_1 = 0.06;
  const BuiltCamera& camera = built_rig_.stripe_camera;
  const Lighting& lighting = scene_->lighting();
  const double white_1 = options_.stripe.white_1 * exposure_1;
  const bool faint = white_1 * (lighting.level_1 + lighting.sun.level_1) <= kFaint_1;
  std::vector<geometry::RigidTransform> X_WC;
  if (faint) {
    X_WC.push_back(StripeCameraPose(path.middle()));
  } else {
    for (const RigPose& pose : path.poses) X_WC.push_back(StripeCameraPose(pose));
  }
  const std::vector<float>& room =
      bw_->RoomLight(*scene_, camera, std::move(X_WC), !faint, 1, options_.stripe.blur_1,
                     [this](const View& view, std::vector<float>* out) {
                       ShadeRed(*scene_, view, out);  // 670 nm
                     });
  std::vector<float> signal(room.size());
  for (size_t k = 0; k < room.size(); ++k) signal[k] = static_cast<float>(white_1) * room[k];
  const double fractions_1[2] = {lasers.horizontal_1, lasers.vertical_1};
  for (size_t laser = 0; laser < 2; ++laser) {
    if (fractions_1[laser] <= 0.0) continue;
    AddLaser(laser, path, static_cast<float>(fractions_1[laser] * exposure_1), bw_.get(), &signal);
  }
  return {camera.ideal.width_px, camera.ideal.height_px, 1,
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
