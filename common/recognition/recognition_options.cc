#include "recognition/recognition_options.h"

#include "base/contracts.h"

namespace geon::recognition {

std::optional<Method> MethodFromString(std::string_view name) {
  if (name == "thesis") return Method::kThesis;
  if (name == "evidence") return Method::kEvidence;
  return std::nullopt;
}

std::string_view ToString(Method method) {
  return method == Method::kThesis ? "thesis" : "evidence";
}

std::optional<CurvatureMethod> CurvatureMethodFromString(std::string_view name) {
  if (name == "ogorman") return CurvatureMethod::kOGorman;
  if (name == "ramer") return CurvatureMethod::kRamer;
  if (name == "wall") return CurvatureMethod::kWall;
  return std::nullopt;
}

std::optional<Smoothing> SmoothingFromString(std::string_view name) {
  if (name == "median") return Smoothing::kMedian;
  if (name == "gaussian") return Smoothing::kGaussian;
  if (name == "none") return Smoothing::kNone;
  return std::nullopt;
}

BackgroundOptions RecognitionOptions::BackgroundChosen() const {
  BackgroundOptions chosen = background;
  if (method == Method::kThesis) chosen.method = BackgroundMethod::kThesis;
  chosen.method = background_method.value_or(chosen.method);
  return chosen;
}

void RecognitionOptions::Validate() const {
  smoothing.Validate();
  background.Validate();
  segments.Validate();
  difference_of_slope.Validate();
  polyline.Validate();
  bending.Validate();
  tapering.Validate();
  const int shortest = 2 * difference_of_slope.window + difference_of_slope.gap;
  Require(samples > shortest, "samples", samples, "must exceed 2 W + M");
}

}  // namespace geon::recognition
