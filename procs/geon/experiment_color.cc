#include "procs/geon/experiment_color.h"

#include <cmath>
#include <mutex>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "attention/adapt_color_model.h"
#include "attention/color_model_text.h"
#include "attention/expose_for_target.h"
#include "attention/find_target.h"
#include "attention/learn_color_model.h"
#include "geometry/sensor_rig.h"
#include "procs/geon/parallel_for.h"
#include "procs/geon/svg.h"
#include "sim/color_trial.h"

namespace geon::cli {
namespace {

constexpr int kLawFrames = 6;  // that the exposure law is given
// Scenes of the lessons: far from every trial's.
constexpr uint64_t kLessonSeeds = 0x6c6573736f6eULL;

enum class Eye { kHead, kFloor };

// A colour camera of the simulated robot, before a scene that stands still.
class SceneCamera {
 public:
  SceneCamera(const sim::ColorTrial& trial, Eye eye, uint64_t noise_seed)
      : picture_(eye == Eye::kHead
                     ? sim::RenderColorTrial(trial, geometry::SensorRig().color_camera, trial.X_WC,
                                             options_)
                     : sim::RenderColorTrial(trial, geometry::SensorRig().floor_camera, trial.X_WF,
                                             options_)),
        noise_seed_(noise_seed) {}

  double usual_exposure_s() const { return 1e-6 * options_.exposure_us; }
  const std::vector<uint8_t>& is_target() const { return picture_.is_target; }

  sensor::Image Take(double exposure_s) {
    sensor::Image image;
    image.width_px = picture_.width_px;
    image.height_px = picture_.height_px;
    image.row_stride_bytes = 3 * picture_.width_px;
    image.format = sensor::PixelFormat::kBgr8;
    image.data = sim::ExposePicture(picture_, exposure_s / usual_exposure_s(), options_,
                                    noise_seed_ + 0x100000000ULL * ++frames_);
    return image;
  }

  // What the exposure law comes to when `find` marks the target in each frame.
  double ExposureFor(const std::function<std::vector<uint8_t>(const sensor::Image&)>& find) {
    double exposure_s = usual_exposure_s();
    for (int frame = 0; frame < kLawFrames; ++frame) {
      const sensor::Image image = Take(exposure_s);
      exposure_s =
          attention::NextExposure(exposure_s, attention::MeasureLight(image, find(image)), {});
    }
    return exposure_s;
  }

 private:
  sim::CameraOptions options_;
  sim::ColorPicture picture_;
  uint64_t noise_seed_;
  uint64_t frames_ = 0;
};

uint64_t NoiseSeed(uint64_t seed, int t, Eye eye) {
  return seed * 1000003U + static_cast<uint64_t>(t) * 2U + (eye == Eye::kFloor ? 1U : 0U);
}

// The colour of the light, from the floor, whose paint is known.
attention::LightGain GainOnTheFloor(const sim::ColorTrial& trial, uint64_t noise_seed) {
  SceneCamera camera(trial, Eye::kFloor, noise_seed);
  const double exposure_s =
      camera.ExposureFor([](const sensor::Image&) { return std::vector<uint8_t>(); });
  const Eigen::Vector3d& floor_rgb = trial.world.floor_color_rgb;
  const attention::Rgb known = {static_cast<uint8_t>(floor_rgb[0]),
                                static_cast<uint8_t>(floor_rgb[1]),
                                static_cast<uint8_t>(floor_rgb[2])};
  return attention::MeasureLightGain(camera.Take(exposure_s), known)
      .value_or(attention::LightGain());
}

attention::TeachingSample MakeLesson(uint64_t seed, int t) {
  const sim::ColorTrial trial = sim::RandomColorTrial(seed, t);
  const attention::LightGain gain = GainOnTheFloor(trial, NoiseSeed(seed, t, Eye::kFloor));
  SceneCamera camera(trial, Eye::kHead, NoiseSeed(seed, t, Eye::kHead));
  const double exposure_s =
      camera.ExposureFor([&camera](const sensor::Image&) { return camera.is_target(); });
  return {attention::UnderNeutralLight(camera.Take(exposure_s), gain), camera.is_target()};
}

ColorScore ScoreOf(const attention::TargetSighting& sighting,
                   const std::vector<uint8_t>& is_target) {
  if (!sighting.target) return {};
  const Eigen::Vector2d& center_px = sighting.target->center_px;
  const auto u = static_cast<size_t>(std::lround(center_px.x()));
  const auto v = static_cast<size_t>(std::lround(center_px.y()));
  ColorScore score;
  score.found = is_target[v * static_cast<size_t>(sighting.width_px) + u] != 0;
  int both = 0, either = 0;
  for (size_t i = 0; i < is_target.size(); ++i) {
    both += is_target[i] != 0 && sighting.mask[i] != 0 ? 1 : 0;
    either += is_target[i] != 0 || sighting.mask[i] != 0 ? 1 : 0;
  }
  score.iou_1 = static_cast<double>(both) / either;
  return score;
}

void Outline(std::vector<uint8_t> mask, const cv::Vec3b& color, cv::Mat3b* picture) {
  const cv::Mat1b filled(picture->rows, picture->cols, mask.data());
  cv::Mat1b edge;
  cv::morphologyEx(filled, edge, cv::MORPH_GRADIENT, cv::Mat1b::ones(3, 3));
  picture->setTo(color, edge);
}

// Half size, the true outline green, the found one yellow.
std::string Draw(const sensor::Image& image, const std::vector<uint8_t>& is_target,
                 const std::vector<uint8_t>& found_mask) {
  cv::Mat3b picture(image.height_px, image.width_px);
  std::copy(image.data.begin(), image.data.end(), picture.data);
  Outline(is_target, {60, 200, 60}, &picture);
  Outline(found_mask, {40, 220, 255}, &picture);
  cv::Mat3b half;
  cv::resize(picture, half, {}, 0.5, 0.5, cv::INTER_AREA);
  std::vector<uint8_t> file;
  cv::imencode(".jpg", half, file, {cv::IMWRITE_JPEG_QUALITY, 80});
  return DataUri("image/jpeg", file);
}

std::string NameOf(sim::LightCase light) {
  switch (light) {
    case sim::LightCase::kEven:
      return "even";
    case sim::LightCase::kHalfInSun:
      return "half in sun";
    case sim::LightCase::kShadowEdge:
      return "shadow edge";
    default:
      return "highlight";
  }
}

ColorOutcome DescribeTrial(const sim::ColorTrial& trial, int t) {
  ColorOutcome outcome;
  outcome.t = t;
  outcome.label = trial.label;
  outcome.kelvin = static_cast<int>(std::lround(trial.kelvin));
  outcome.stops = trial.stops;
  outcome.light = NameOf(trial.light);
  outcome.distractors = trial.distractors;
  return outcome;
}

// The worst pictures so far, for many threads.
class Gallery {
 public:
  void Offer(const ColorOutcome& outcome, const sensor::Image& image,
             const std::vector<uint8_t>& is_target, const std::vector<uint8_t>& found_mask) {
    WorstPicture picture{outcome.t, outcome.scores.front(), ""};
    const std::scoped_lock lock(mutex_);
    if (!IsAmongWorst(picture, worst_)) return;
    picture.data_uri = Draw(image, is_target, found_mask);
    AddWorstPicture(std::move(picture), &worst_);
  }
  std::vector<WorstPicture> Take() { return std::move(worst_); }

 private:
  std::mutex mutex_;
  std::vector<WorstPicture> worst_;
};

// `models`: the first adapts to the light, the others are the thesis's.
ColorOutcome RunTrial(uint64_t seed, int t, std::vector<attention::ColorModel> models,
                      Gallery* gallery) {
  const sim::ColorTrial trial = sim::RandomColorTrial(seed, t);
  ColorOutcome outcome = DescribeTrial(trial, t);
  models.front() = attention::AdaptColorModel(
      models.front(), GainOnTheFloor(trial, NoiseSeed(seed, t, Eye::kFloor)));
  SceneCamera camera(trial, Eye::kHead, NoiseSeed(seed, t, Eye::kHead));
  for (const uint8_t pixel : camera.is_target()) outcome.target_pixels += pixel != 0 ? 1 : 0;
  const double exposure_s = camera.ExposureFor([&models](const sensor::Image& image) {
    return attention::FindTarget(image, models.front()).mask;
  });
  outcome.exposure_1 = exposure_s / camera.usual_exposure_s();
  const sensor::Image exposed = camera.Take(exposure_s);
  const sensor::Image usual = camera.Take(camera.usual_exposure_s());
  std::vector<uint8_t> found_mask;
  for (const attention::ColorModel& model : models) {
    for (const sensor::Image* image : {&exposed, &usual}) {
      attention::TargetSighting sighting = attention::FindTarget(*image, model);
      outcome.scores.push_back(ScoreOf(sighting, camera.is_target()));
      if (found_mask.empty()) found_mask = std::move(sighting.mask);
    }
  }
  gallery->Offer(outcome, exposed, camera.is_target(), found_mask);
  return outcome;
}

}  // namespace

Result<attention::ColorModel> TeachOnScenes(const ColorConditions& conditions,
                                            const std::function<void(double)>& say) {
  std::vector<attention::TeachingSample> lessons;
  for (int k = 0; k < conditions.lessons; ++k) {
    // 39 has no factor in common with the moduli of the trials: all that varies varies.
    lessons.push_back(MakeLesson(conditions.seed ^ kLessonSeeds, 39 * k));
    say(static_cast<double>(k + 1) / conditions.lessons);
  }
  Result<attention::LearnedColor> learned = attention::LearnColorModel(lessons, "taught");
  if (!learned.ok()) return learned.status();
  return std::move(learned->model);
}

ColorRecord RunColorTrials(const attention::ColorModel& model, const ColorConditions& conditions,
                           const Shard& shard, int jobs, const std::function<void(double)>& say) {
  std::vector<attention::ColorModel> models = {model};
  for (const std::string& name : attention::NamedColorModels()) {
    if (name != model.name) models.push_back(*attention::NamedColorModel(name));
  }
  ColorRecord record;
  record.seed = conditions.seed;
  record.model = attention::SerializeColorModel(model, {});
  for (const attention::ColorModel& each : models) {
    record.methods.push_back(each.name);
    record.methods.push_back(each.name + ", fixed");
  }
  std::vector<int> mine;
  for (int t = 0; t < conditions.images; ++t) {
    if (t % shard.count == shard.index - 1) mine.push_back(t);
  }
  record.outcomes.resize(mine.size());
  Gallery gallery;
  std::mutex saying;
  size_t done = 0;
  ParallelFor(jobs, static_cast<int>(mine.size()), [&](int k) {
    const auto at = static_cast<size_t>(k);
    record.outcomes[at] = RunTrial(conditions.seed, mine[at], models, &gallery);
    const std::scoped_lock lock(saying);
    say(static_cast<double>(++done) / static_cast<double>(mine.size()));
  });
  record.worst = gallery.Take();
  return record;
}

}  // namespace geon::cli
