#include "evaluation/open_thresholds.h"

namespace geon::evaluation {
namespace {

using recognition::CurvatureMethod;
using recognition::RecognitionOptions;

// `member` finds the number within the options.
template <typename Member>
Threshold Real(const char* name, double low, double high, Member member) {
  return {name,
          low,
          high,
          false,
          [member](const RecognitionOptions& options) {
            return member(const_cast<RecognitionOptions&>(options));
          },
          [member](RecognitionOptions* options, double value) { member(*options) = value; }};
}

template <typename Member>
Threshold Integer(const char* name, int low, int high, Member member) {
  return {name,
          static_cast<double>(low),
          static_cast<double>(high),
          true,
          [member](const RecognitionOptions& options) {
            return static_cast<double>(member(const_cast<RecognitionOptions&>(options)));
          },
          [member](RecognitionOptions* options, double value) {
            member(*options) = static_cast<int>(value);
          }};
}

}  // namespace

std::vector<Threshold> OpenThresholds(CurvatureMethod curvature) {
  using O = RecognitionOptions;
  std::vector<Threshold> all = {
      Integer("samples", 50, 150, [](O& o) -> int& { return o.samples; }),
      Integer("half_width_px", 1, 12, [](O& o) -> int& { return o.smoothing.half_width_px; }),
      Real("split_m", 0.008, 0.10, [](O& o) -> double& { return o.segments.split_m; }),
      Real("shortest_m", 0.002, 0.03, [](O& o) -> double& { return o.segments.shortest_m; }),
      Real("shortest_share_1", 0.0, 0.3,
           [](O& o) -> double& { return o.segments.shortest_share_1; }),
      Real("concave_edge_m", 0.0001, 0.01,
           [](O& o) -> double& { return o.bending.concave_edge_m; }),
      Real("concave_edge_1", 0.0, 0.08, [](O& o) -> double& { return o.bending.concave_edge_1; }),
      Real("horizontal_length_m", 0.0, 0.02,
           [](O& o) -> double& { return o.tapering.horizontal_length.absolute_m; }),
      Real("horizontal_length_1", 0.0, 0.15,
           [](O& o) -> double& { return o.tapering.horizontal_length.relative_1; }),
      Real("vertical_length_m", 0.0, 0.03,
           [](O& o) -> double& { return o.tapering.vertical_length.absolute_m; }),
      Real("vertical_length_1", 0.0, 0.2,
           [](O& o) -> double& { return o.tapering.vertical_length.relative_1; }),
      Real("horizontal_step_m", 0.002, 0.08,
           [](O& o) -> double& { return o.tapering.horizontal_step.absolute_m; }),
      Real("horizontal_step_1", 0.0, 0.2,
           [](O& o) -> double& { return o.tapering.horizontal_step.relative_1; }),
      Real("vertical_step_m", 0.002, 0.08,
           [](O& o) -> double& { return o.tapering.vertical_step.absolute_m; }),
      Real("vertical_step_1", 0.0, 0.2,
           [](O& o) -> double& { return o.tapering.vertical_step.relative_1; }),
  };
  const auto add = [&all](const Threshold& threshold) { all.push_back(threshold); };
  if (curvature == CurvatureMethod::kOGorman) {
    add(Real("zero_range_rad", 0.005, 0.25,
             [](O& o) -> double& { return o.difference_of_slope.zero_range_rad; }));
    add(Integer("curve_width", 8, 80,
                [](O& o) -> int& { return o.difference_of_slope.curve_width; }));
    add(Real("corner_rad", 0.3, 2.5,
             [](O& o) -> double& { return o.difference_of_slope.corner_rad; }));
    add(Real("concave_rad", 0.05, 0.6,
             [](O& o) -> double& { return o.difference_of_slope.concave_rad; }));
    add(Integer("concave_width", 0, 25,
                [](O& o) -> int& { return o.difference_of_slope.concave_width; }));
    add(Real("concave_noise_1", 0.0, 8.0,
             [](O& o) -> double& { return o.difference_of_slope.concave_noise_1; }));
  } else {
    add(Real("tolerance_m", 0.0005, 0.008, [](O& o) -> double& { return o.polyline.tolerance_m; }));
    add(Real("straight_rad", 0.03, 0.4, [](O& o) -> double& { return o.polyline.straight_rad; }));
    add(Real("corner_rad", 0.3, 1.5, [](O& o) -> double& { return o.polyline.corner_rad; }));
    add(Real("curve_step_1", 0.1, 0.9, [](O& o) -> double& { return o.polyline.curve_step_1; }));
    add(Real("concave_rad", 0.05, 0.8, [](O& o) -> double& { return o.polyline.concave_rad; }));
  }
  return all;
}

}  // namespace geon::evaluation
