#include "tests/common/attention/naive_segmentation.h"

#include <algorithm>
#include <cmath>

#include "attention/rgb_image.h"

namespace geon::attention {
namespace {

struct Grid {
  int width_px;
  int height_px;
  bool Holds(int u, int v) const { return u >= 0 && v >= 0 && u < width_px && v < height_px; }
  size_t Index(int u, int v) const { return static_cast<size_t>(v * width_px + u); }
};

// The 8-connected groups of the pixels that `in` marks, in the order of their first pixels.
std::vector<NaiveBlob> Flood(const Grid& grid, const std::vector<bool>& in) {
  std::vector<NaiveBlob> groups;
  std::vector<bool> seen(in.size(), false);
  for (int v = 0; v < grid.height_px; ++v) {
    for (int u = 0; u < grid.width_px; ++u) {
      if (!in[grid.Index(u, v)] || seen[grid.Index(u, v)]) continue;
      NaiveBlob group;
      std::vector<std::pair<int, int>> open = {{u, v}};
      seen[grid.Index(u, v)] = true;
      while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        group.pixels.emplace_back(x, y);
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if (!grid.Holds(x + dx, y + dy)) continue;
            const size_t next = grid.Index(x + dx, y + dy);
            if (!in[next] || seen[next]) continue;
            seen[next] = true;
            open.emplace_back(x + dx, y + dy);
          }
        }
      }
      std::sort(group.pixels.begin(), group.pixels.end(), [](const auto& one, const auto& other) {
        return std::pair(one.second, one.first) < std::pair(other.second, other.first);
      });
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

std::vector<bool> ResolveNaively(const Grid& grid, const std::vector<ColorClass>& classes) {
  const auto marked = [&classes](auto... wanted) {
    std::vector<bool> in(classes.size());
    for (size_t i = 0; i < in.size(); ++i) in[i] = ((classes[i] == wanted) || ...);
    return in;
  };
  std::vector<bool> target = marked(ColorClass::kTarget);
  for (const NaiveBlob& group : Flood(grid, marked(ColorClass::kTarget, ColorClass::kRim))) {
    const bool touches = std::any_of(group.pixels.begin(), group.pixels.end(), [&](auto pixel) {
      return classes[grid.Index(pixel.first, pixel.second)] == ColorClass::kTarget;
    });
    for (const auto& [u, v] : group.pixels) target[grid.Index(u, v)] = touches;
  }
  const std::vector<bool> before = target;
  const std::vector<bool> cannot_tell = marked(ColorClass::kCannotTell);
  for (const NaiveBlob& group : Flood(grid, cannot_tell)) {
    int on_target = 0;
    int on_others = 0;
    for (const auto& [u, v] : group.pixels) {
      for (const auto& [du, dv] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
        if (!grid.Holds(u + du, v + dv) || cannot_tell[grid.Index(u + du, v + dv)]) continue;
        ++(before[grid.Index(u + du, v + dv)] ? on_target : on_others);
      }
    }
    for (const auto& [u, v] : group.pixels) {
      if (on_target > on_others) target[grid.Index(u, v)] = true;
    }
  }
  return target;
}

}  // namespace

NaiveSegmentation SegmentNaively(const sensor::Image& image, const ColorModel& model,
                                 int erosion_neighbors) {
  const Grid grid{image.width_px, image.height_px};
  const RgbImage pixels(image);
  NaiveSegmentation result;
  for (int v = 0; v < grid.height_px; ++v) {
    for (int u = 0; u < grid.width_px; ++u) {
      result.classes.push_back(model.Classify(pixels.At(u, v)));
    }
  }
  result.target = ResolveNaively(grid, result.classes);
  result.eroded = result.target;
  for (int v = 0; v < grid.height_px; ++v) {
    for (int u = 0; u < grid.width_px; ++u) {
      for (int dv = -1; dv <= 1; ++dv) {
        for (int du = -1; du <= 1; ++du) {
          if (erosion_neighbors == 4 && du != 0 && dv != 0) continue;
          if (!grid.Holds(u + du, v + dv) || result.target[grid.Index(u + du, v + dv)]) continue;
          result.eroded[grid.Index(u, v)] = false;
        }
      }
    }
  }
  result.blobs = Flood(grid, result.eroded);
  return result;
}

sensor::Image RandomImage(int width_px, int height_px, sensor::PixelFormat format,
                          std::mt19937& random) {
  sensor::Image image;
  image.width_px = width_px;
  image.height_px = height_px;
  image.row_stride_bytes = 3 * width_px + static_cast<int>(random() % 7);
  image.format = format;
  image.data.resize(static_cast<size_t>(image.row_stride_bytes * height_px));
  // Patches of few colours, so that there are groups of all sizes, and some noise.
  uint8_t colors[8][3];
  for (auto& color : colors) {
    for (uint8_t& level : color) level = static_cast<uint8_t>(random());
  }
  std::fill_n(colors[0], 3, uint8_t{5});
  std::fill_n(colors[1], 3, uint8_t{253});
  const int patch_px = 1 + static_cast<int>(random() % 6);
  std::vector<unsigned> patches(
      static_cast<size_t>((width_px / patch_px + 1) * (height_px / patch_px + 1)));
  for (unsigned& patch : patches) patch = random() % 8;
  for (int v = 0; v < height_px; ++v) {
    for (int u = 0; u < width_px; ++u) {
      const auto patch =
          static_cast<size_t>(v / patch_px * (width_px / patch_px + 1) + u / patch_px);
      const unsigned color = random() % 8 == 0 ? random() % 8 : patches[patch];
      std::copy_n(colors[color], 3,
                  &image.data[static_cast<size_t>(v * image.row_stride_bytes + 3 * u)]);
    }
  }
  return image;
}

ColorModel RandomModel(bool whole_numbered, std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const auto regions = [&](size_t count) {
    std::vector<HalfSpaceColor> list;
    while (list.size() < count) {
      HalfSpaceColor region;
      const double inside[] = {number(random) * 128 + 128, number(random) * 128 + 128,
                               number(random) * 128 + 128};
      for (int plane = 0; plane < 7; ++plane) {
        ColorHalfSpace half_space = {number(random), number(random), number(random), 0.0};
        if (plane % 3 == 1) half_space.green_1 = 0.0;  // planes of two channels, and of one
        if (plane == 4) half_space.blue_1 = 0.0;
        const double value = half_space.red_1 * inside[0] + half_space.green_1 * inside[1] +
                             half_space.blue_1 * inside[2];
        half_space.threshold_1 = value - 60.0 * std::abs(number(random));
        region.half_spaces.push_back(whole_numbered ? WholeNumbered(half_space) : half_space);
      }
      list.push_back(region);
    }
    return list;
  };
  return {"random", regions(1 + random() % 3), regions(random() % 3),
          static_cast<int>(random() % 60), 256 - static_cast<int>(random() % 30)};
}

}  // namespace geon::attention
