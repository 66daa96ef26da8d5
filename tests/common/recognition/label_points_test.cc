#include "recognition/label_points.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "base/angles.h"
#include "tests/common/recognition/synthetic_geons.h"

namespace geon::recognition {
namespace {

// A camera at 1 m, pitched down, looks at a panel that stands on the floor 1 m ahead, 20 cm high
// and 20 cm wide; every stripe runs over it and the floor. The truth comes with it.
struct PanelScan {
  sensor::ScanSet scan;
  std::vector<std::vector<bool>> on_panel;
};

PanelScan MakePanelScan(double lean_rad, double noise_m) {
  PanelScan made;
  std::mt19937 random(1);
  std::normal_distribution<double> gauss(0.0, noise_m);
  sensor::ScanSet& scan = made.scan;
  scan.camera_position_L_m = {0.0, 0.0, 1.0};
  scan.rotation_LB =
      geometry::RotationAboutY(RadiansFromDegrees(42)) * geometry::CameraAxesInBody();
  const Eigen::AngleAxisd lean(lean_rad, Eigen::Vector3d(0.6, 0.8, 0.0));
  for (int k = 0; k < 6; ++k) {
    sensor::RangeProfile profile;
    profile.laser = k < 3 ? sensor::Laser::kHorizontal : sensor::Laser::kVertical;
    profile.fraction = 0.25 * (k % 3 + 1);
    std::vector<bool>& on_panel = made.on_panel.emplace_back();
    for (int line = 0; line < 480; ++line) {
      const double along_1 = (line - 239.5) / 1000.0;
      // The rows of the panel in tangents of the pitched camera: about -0.06 to 0.05.
      const double across_1 =
          k < 3 ? -0.055 + 0.11 * profile.fraction : -0.07 + 0.14 * profile.fraction;
      const Eigen::Vector3d ray_B(k < 3 ? along_1 : across_1, k < 3 ? across_1 : along_1, 1.0);
      const Eigen::Vector3d ray_L = scan.rotation_LB * ray_B;
      double reach = -1.0 / ray_L.z();
      const double panel = 1.0 / ray_L.x();
      const Eigen::Vector3d on_m = scan.camera_position_L_m + panel * ray_L;
      const bool hit = on_m.z() > 0.0 && on_m.z() < 0.2 && std::abs(on_m.y()) < 0.1;
      if (hit) reach = panel;
      reach += gauss(random);
      profile.pixel.push_back(line);
      profile.p_L_m.push_back(lean * (scan.camera_position_L_m + reach * ray_L));
      on_panel.push_back(hit);
    }
    scan.profiles.push_back(profile);
  }
  scan.camera_position_L_m = lean * scan.camera_position_L_m;
  scan.rotation_LB = lean * scan.rotation_LB;
  const int left_px = static_cast<int>(239.5 - 1000.0 * 0.1 / 1.35);
  scan.target_box = sensor::PixelBox{left_px, 0, 2 * (239 - left_px), 480};
  return made;
}

// Points labelled wrongly, of the panel and of the rest.
std::pair<int, int> Wrong(const PanelScan& made, const BackgroundOptions& options) {
  const auto labels = FindTargetPoints(made.scan, options);
  std::pair<int, int> wrong;
  for (size_t k = 0; k < labels.size(); ++k) {
    for (size_t i = 0; i < labels[k].size(); ++i) {
      if (made.on_panel[k][i] && !labels[k][i]) ++wrong.first;
      if (!made.on_panel[k][i] && labels[k][i]) ++wrong.second;
    }
  }
  return wrong;
}

int PanelPoints(const PanelScan& made) {
  int points = 0;
  for (const auto& on_panel : made.on_panel) {
    points += static_cast<int>(std::count(on_panel.begin(), on_panel.end(), true));
  }
  return points;
}

TEST(LabelPoints, FollowsTheSupportOfALeaningRobot) {
  for (const double lean_deg : {-3.0, 0.0, 3.0}) {
    const PanelScan made = MakePanelScan(RadiansFromDegrees(lean_deg), 0.001);
    ASSERT_GT(PanelPoints(made), 600);
    const auto [lost, strays] = Wrong(made, {});
    EXPECT_LE(lost, PanelPoints(made) / 100) << lean_deg;
    EXPECT_LE(strays, PanelPoints(made) / 100) << lean_deg;
  }
}

TEST(LabelPoints, TheThesissTestsDoNot) {
  BackgroundOptions thesis;
  thesis.method = BackgroundMethod::kThesis;
  const PanelScan made = MakePanelScan(RadiansFromDegrees(3.0), 0.001);
  const auto [lost, strays] = Wrong(made, thesis);
  EXPECT_GT(lost + strays, PanelPoints(made) / 10);
  const PanelScan level = MakePanelScan(0.0, 0.001);
  EXPECT_LE(Wrong(level, thesis).first, PanelPoints(level) / 20);  // the lowest centimetre
}

TEST(LabelPoints, KeepsMoreOfTheFootTheLessNoiseThereIs) {
  const auto [lost, strays] = Wrong(MakePanelScan(0.0, 0.0001), {});
  EXPECT_LE(lost, 6);  // a point for each stripe
  EXPECT_LE(strays, 6);
}

TEST(LabelPoints, BelievesColoursThatSayBackground) {
  PanelScan made = MakePanelScan(0.0, 0.001);
  for (size_t k = 0; k < 6; ++k) {  // the panel's left half is another's
    for (size_t i = 0; i < made.on_panel[k].size(); ++i) {
      const bool other = made.scan.profiles[k].p_L_m[i].y() > 0.01;
      made.on_panel[k][i] = made.on_panel[k][i] && !other;
      made.scan.profiles[k].on_color_1.push_back(made.on_panel[k][i] ? 1.0 : 0.0);
    }
  }
  const auto [lost, strays] = Wrong(made, {});
  EXPECT_LE(lost, 12);
  EXPECT_LE(strays, 12);
}

TEST(LabelPoints, CutsAtACentimetreWhereNothingShowsTheSupport) {
  PanelScan made = MakePanelScan(0.0, 0.001);
  for (size_t k = 0; k < 6; ++k) {
    sensor::RangeProfile kept = made.scan.profiles[k];
    kept.pixel.clear();
    kept.p_L_m.clear();
    std::vector<bool> on_panel;
    for (size_t i = 0; i < made.on_panel[k].size(); ++i) {
      if (!made.on_panel[k][i] || made.scan.profiles[k].p_L_m[i].z() < 0.015) continue;
      kept.pixel.push_back(made.scan.profiles[k].pixel[i]);
      kept.p_L_m.push_back(made.scan.profiles[k].p_L_m[i]);
      on_panel.push_back(true);
    }
    made.scan.profiles[k] = kept;
    made.on_panel[k] = on_panel;
  }
  EXPECT_EQ(Wrong(made, {}).first, 0);
}

TEST(LabelPoints, HasNothingToSayAboutAnEmptyScan) {
  EXPECT_TRUE(FindTargetPoints({}, {}).empty());
}

}  // namespace
}  // namespace geon::recognition
