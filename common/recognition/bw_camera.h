#pragma once

#include <Eigen/Core>

#include "sensor/scan_set.h"

namespace geon::recognition {

// The B/W camera as it stood: frame B (x right, y down, z forward) in frame L.
//
// Source: the pinhole camera of thesis section 3.2.
struct BwCamera {
  Eigen::Vector3d p_LB_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d R_LB = Eigen::Matrix3d::Identity();

  // A point of frame L in frame B, metres. Its z is what the rangefinder measures: the depth.
  Eigen::Vector3d InCamera(const Eigen::Vector3d& p_L) const {
    return R_LB.transpose() * (p_L - p_LB_m);
  }
};

// Where a point stands in the image, whatever the focal length: x/z and y/z.
inline Eigen::Vector2d Tangents(const Eigen::Vector3d& p_B_m) {
  return p_B_m.head<2>() / p_B_m.z();
}

// The camera when the target was measured, and when one stripe was.
inline BwCamera CameraAtTarget(const sensor::ScanSet& scan) {
  return {scan.camera_position_L_m, scan.rotation_LB};
}
inline BwCamera CameraAtStripe(const sensor::ScanSet& scan, const sensor::RangeProfile& profile) {
  return {scan.camera_position_L_m, profile.rotation_LB.value_or(scan.rotation_LB)};
}

}  // namespace geon::recognition
