#pragma once

#include <optional>
#include <string_view>

#include "recognition/difference_of_slope.h"
#include "recognition/find_bending.h"
#include "recognition/find_tapering.h"
#include "recognition/polyline_fit.h"
#include "recognition/profile_curve.h"
#include "recognition/remove_background.h"
#include "recognition/smooth_profile.h"

namespace geon::recognition {

// Source: thesis section 5.3.
//
// How corners, curves and lines are found (section 5.3). The thesis compared the three and kept
// O'Gorman's.
enum class CurvatureMethod { kOGorman, kRamer, kWall };

// What people write: ogorman, ramer, wall; median, gaussian, none. Nothing for other names.
std::optional<CurvatureMethod> CurvatureMethodFromString(std::string_view name);
std::optional<Smoothing> SmoothingFromString(std::string_view name);

// Who decides: the decision tree of section 5.6, or a forest that weighs the evidence.
enum class Method { kThesis, kEvidence };
std::optional<Method> MethodFromString(std::string_view name);
std::string_view ToString(Method method);

// Everything that can be set about recognition.
struct RecognitionOptions {
  Method method = Method::kEvidence;
  SmoothingOptions smoothing;
  BackgroundOptions background;
  // Nothing: the thesis's tests with Method::kThesis, else background.method.
  std::optional<BackgroundMethod> background_method;
  SegmentOptions segments;
  CurvatureMethod curvature = CurvatureMethod::kOGorman;
  int samples = 105;  // equal steps of arc length a profile is resampled to
  DifferenceOfSlopeOptions difference_of_slope;
  PolylineOptions polyline;
  BendingOptions bending;
  TaperingOptions tapering;
  // `background` with the method that was chosen.
  BackgroundOptions BackgroundChosen() const;
  void Validate() const;  // throws ContractViolation
};

}  // namespace geon::recognition
