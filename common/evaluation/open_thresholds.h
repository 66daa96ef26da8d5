#pragma once

#include <functional>
#include <string>
#include <vector>

#include "recognition/recognition_options.h"

namespace geon::evaluation {

// One number of RecognitionOptions that the thesis leaves open, and where to look for it.
struct Threshold {
  std::string name;
  double low = 0.0;
  double high = 1.0;
  bool integer = false;
  std::function<double(const recognition::RecognitionOptions&)> get;
  std::function<void(recognition::RecognitionOptions*, double)> set;
};

// All thresholds that play a part with the given curvature method.
std::vector<Threshold> OpenThresholds(recognition::CurvatureMethod curvature);

}  // namespace geon::evaluation
