#pragma once

#include "attention/bit_mask.h"
#include "attention/classify_pixels.h"

namespace geon::attention {

// Settles what pixels cannot say by themselves: which of them are target, given the classes of all.
//
//   1. Rim is target where a chain of rim pixels (8 neighbours) joins it to a target pixel.
//   2. A connected group of pixels that cannot tell is target when more of its contour lies on
//      target pixels than on others. So holes, highlights and dark spots of the target are filled,
//      and a window or a dark floor that touches it is left out.
// The contour is the sides of pixels between the group and the pixels around; the image's border is
// no part of it. One pass in this order: a filled group makes no more rim target.
//
// Source: own rules; the thesis takes every pixel by its colour alone (4.1.2).
BitMask ResolveColor(PixelClasses classes);

}  // namespace geon::attention
