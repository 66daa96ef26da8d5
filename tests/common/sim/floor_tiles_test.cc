#include "sim/floor_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace geon::sim {
namespace {

// A walk of a thousand steps of 5 mm along x through tiles of 0.6 m.
struct Walk {
  Walk(float y_m, float footprint_m) : shade_1(1000) {
    SurfaceRow row;
    for (int u = 0; u < 1000; ++u) row.x_m.push_back(-2.0F + 0.005F * static_cast<float>(u));
    row.y_m.assign(1000, y_m);
    DrawTiles(row, {0, 1000, 0, true}, 0.6F, std::vector<float>(1000, footprint_m), &shade_1);
  }
  float darkest() const { return *std::min_element(shade_1.begin(), shade_1.end()); }
  std::vector<float> shade_1;
};

TEST(FloorTilesTest, GroovesAreDarkAndFadeWhereAPixelSeesMoreThanAGroove) {
  EXPECT_LT(Walk(0.3F, 0.001F).darkest(), 0.5F);
  const float faded = Walk(0.3F, 0.05F).darkest();
  EXPECT_GT(faded, 0.8F);
  EXPECT_LT(faded, 0.93F);
  for (const float shade_1 : Walk(0.6F, 0.001F).shade_1) EXPECT_LT(shade_1, 0.5F);  // along one
}

TEST(FloorTilesTest, GroovesAreEightMillimetresWideAtEverySixtyCentimetres) {
  const Walk walk(0.3F, 0.0005F);
  for (size_t u = 0; u < walk.shade_1.size(); ++u) {
    const float x_m = -2.0F + 0.005F * static_cast<float>(u);
    const float from_groove_m = std::abs(x_m - 0.6F * std::round(x_m / 0.6F));
    if (from_groove_m < 0.0035F) {
      EXPECT_LT(walk.shade_1[u], 0.5F) << x_m;
    } else if (from_groove_m > 0.0045F) {
      EXPECT_GT(walk.shade_1[u], 0.94F) << x_m;
    }
  }
}

TEST(FloorTilesTest, TilesAreMottledAndTheMottleFadesFarAway) {
  const auto spread = [](const Walk& walk) {  // within the tile from 0 to 0.6 m
    const auto [low, high] =
        std::minmax_element(walk.shade_1.begin() + 430, walk.shade_1.begin() + 490);
    return *high - *low;
  };
  EXPECT_GT(spread(Walk(0.3F, 0.002F)), 0.03F);
  EXPECT_LT(spread(Walk(0.3F, 0.2F)), 0.005F);
}

}  // namespace
}  // namespace geon::sim
