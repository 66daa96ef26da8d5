#include "attention/resolve_color.h"

#include <opencv2/imgproc.hpp>
#include <vector>

#include "attention/color_model.h"

namespace geon::attention {
namespace {

cv::Mat1b MaskOf(const cv::Mat1b& classes, ColorClass wanted) {
  cv::Mat1b mask;
  cv::compare(classes, static_cast<int>(wanted), mask, cv::CMP_EQ);
  return mask;
}

void TakeRim(const cv::Mat1b& rim, cv::Mat1b* target) {
  cv::Mat1b either;
  cv::bitwise_or(rim, *target, either);
  cv::Mat1i labels;
  const int count = cv::connectedComponents(either, labels, 8, CV_32S);
  std::vector<bool> taken(static_cast<size_t>(count), false);
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      if ((*target)(v, u) != 0) taken[static_cast<size_t>(labels(v, u))] = true;
    }
  }
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      if (taken[static_cast<size_t>(labels(v, u))]) (*target)(v, u) = 255;
    }
  }
}

void TakeGroups(const cv::Mat1b& cannot_tell, cv::Mat1b* target) {
  cv::Mat1i labels;
  const int count = cv::connectedComponents(cannot_tell, labels, 8, CV_32S);
  std::vector<int> balance(static_cast<size_t>(count), 0);  // sides on target less sides on others
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      if (labels(v, u) == 0) continue;
      const cv::Point around[] = {{u - 1, v}, {u + 1, v}, {u, v - 1}, {u, v + 1}};
      for (const cv::Point& side : around) {
        if (side.x < 0 || side.y < 0 || side.x >= labels.cols || side.y >= labels.rows) continue;
        if (labels(side) != 0) continue;
        balance[static_cast<size_t>(labels(v, u))] += (*target)(side) != 0 ? 1 : -1;
      }
    }
  }
  for (int v = 0; v < labels.rows; ++v) {
    for (int u = 0; u < labels.cols; ++u) {
      if (balance[static_cast<size_t>(labels(v, u))] > 0) (*target)(v, u) = 255;
    }
  }
}

}  // namespace

cv::Mat1b ResolveColor(const cv::Mat1b& classes) {
  cv::Mat1b target = MaskOf(classes, ColorClass::kTarget);
  TakeRim(MaskOf(classes, ColorClass::kRim), &target);
  TakeGroups(MaskOf(classes, ColorClass::kCannotTell), &target);
  return target;
}

}  // namespace geon::attention
