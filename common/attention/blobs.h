#pragma once

#include <Eigen/Core>
#include <vector>

#include "attention/pixel_groups.h"
#include "sensor/image.h"

namespace geon::attention {

// A group of connected (8-neighbour) pixels.
//
// Source: blob analysis of thesis section 4.2.1.
struct Blob {
  sensor::PixelBox box;
  int pixels = 0;
  Eigen::Vector2d center_px = Eigen::Vector2d::Zero();  // centre of gravity (u, v)
};

// One blob a group, by its number.
std::vector<Blob> MeasureBlobs(const PixelGroups& groups);

// The middle of a group's lowest row of pixels, (u, v).
Eigen::Vector2d BottomPoint(const PixelGroups& groups, int group);

}  // namespace geon::attention
