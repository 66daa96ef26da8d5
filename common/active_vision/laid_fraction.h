#pragma once

#include <optional>

#include "geometry/pinhole_camera.h"
#include "geometry/rigid_transform.h"
#include "sensor/image.h"
#include "sensor/scan_set.h"

namespace geon::active_vision {

// Where on the target a stripe lies: the part of the box from its top (horizontal stripe) or its
// left (vertical) to the points that the profile has in the box's middle third along the stripe, 1
// cm or more above the support; their median. Nothing with fewer than 5 such points.
//
// `X_CL`: of the colour camera as it stood when the box was seen, in the profile's level frame.
//
// Source: ours; thesis 4.2.4 supposes that stripes lie where they were meant to.
std::optional<double> LaidFraction(const sensor::RangeProfile& profile,
                                   const geometry::RigidTransform& X_CL,
                                   const geometry::PinholeCamera& color_camera,
                                   const sensor::PixelBox& box);

}  // namespace geon::active_vision
