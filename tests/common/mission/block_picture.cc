#include "tests/common/mission/block_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace geon::mission {

namespace {

const cv::Scalar kFloor(140, 150, 150);
const cv::Vec3b kAbove(200, 190, 180);  // what is above the horizon: not floor, not target

}  // namespace

cv::Mat BlockPicture(std::vector<Block> blocks, const geometry::PinholeCamera& camera,
                     const geometry::RigidTransform& X_WC) {
  cv::Mat image(camera.height_px, camera.width_px, CV_8UC3, kFloor);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      if ((X_WC.linear() * camera.Ray(u, v)).z() >= 0.0) {
        image.at<cv::Vec3b>(v, u) = kAbove;
      }
    }
  }
  const auto distance = [&](const Block& block) {
    return (Eigen::Vector3d(block.center_W_m.x(), block.center_W_m.y(), block.top_m) -
            X_WC.translation())
        .norm();
  };
  std::sort(blocks.begin(), blocks.end(),
            [&](const Block& a, const Block& b) { return distance(a) > distance(b); });
  for (const Block& block : blocks) {
    std::vector<cv::Point> corners;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d p_W(block.center_W_m.x() + ((i & 1) != 0 ? 1 : -1) * block.half_m.x(),
                                block.center_W_m.y() + ((i & 2) != 0 ? 1 : -1) * block.half_m.y(),
                                (i & 4) != 0 ? block.top_m : block.bottom_m);
      const Eigen::Vector3d p_C = X_WC.inverse() * p_W;
      if (p_C.z() < 0.05) break;
      const Eigen::Vector2d pixel = camera.Project(p_C);
      corners.emplace_back(static_cast<int>(std::lround(pixel.x())),
                           static_cast<int>(std::lround(pixel.y())));
    }
    if (corners.size() < 8) continue;
    std::vector<cv::Point> hull;
    cv::convexHull(corners, hull);
    cv::fillConvexPoly(image, hull, block.color_bgr);
  }
  return image;
}

}  // namespace geon::mission
