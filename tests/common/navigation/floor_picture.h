#pragma once

#include <Eigen/Core>
#include <functional>
#include <opencv2/core.hpp>

#include "base/angles.h"
#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"
#include "navigation/floor_model.h"

namespace geon::navigation {

inline const geometry::PinholeCamera kCamera{320, 240, 160.0, 160.0, 159.5, 119.5};

inline geometry::RigidTransform CameraPose() {
  return geometry::MakeTransform(
      geometry::RotationAboutY(RadiansFromDegrees(40)) * geometry::CameraAxesInBody(),
      Eigen::Vector3d(0.15, 0.0, 0.85));
}

// A picture of the floor, each pixel coloured by where its ray meets the floor (BGR).
inline cv::Mat Picture(const std::function<cv::Vec3b(double x_m, double y_m)>& color) {
  const auto X_RF = CameraPose();
  cv::Mat image(kCamera.height_px, kCamera.width_px, CV_8UC3);
  for (int v = 0; v < image.rows; ++v) {
    for (int u = 0; u < image.cols; ++u) {
      const Eigen::Vector3d ray = X_RF.linear() * kCamera.Ray(u, v);
      const Eigen::Vector3d p = X_RF.translation() - ray * (0.85 / ray.z());
      image.at<cv::Vec3b>(v, u) = color(p.x(), p.y());
    }
  }
  return image;
}

inline const cv::Vec3b kFloor(140, 150, 150);
inline const FloorModel kModel = FloorModel::OfColor({150, 150, 140});

}  // namespace geon::navigation
