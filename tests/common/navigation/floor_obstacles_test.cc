#include "navigation/floor_obstacles.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <random>

#include "base/contracts.h"
#include "navigation/floor_model.h"
#include "tests/common/navigation/floor_picture.h"

namespace geon::navigation {
namespace {

std::vector<FloorColumn> Look(const cv::Mat& image) {
  return FloorObstacles(NotFloorMask(image, std::array{kModel}), kCamera, CameraPose(), {});
}

TEST(FloorObstaclesTest, BareFloorHasNone) {
  for (const FloorColumn& column : Look(Picture([](double, double) { return kFloor; }))) {
    EXPECT_FALSE(column.obstacle);
    // Far to the sides the picture ends sooner.
    if (std::abs(column.end_R_m.y()) < column.end_R_m.x()) {
      EXPECT_GT(column.end_R_m.norm(), 1.4);
    }
  }
}

TEST(FloorObstaclesTest, OnlyWhatIsBrighterThanTheFloorAndHasNoColourIsBright) {
  // An image of a lamp that fades to its rim, warmer than the floor; a red box; a dark one.
  const auto columns = Look(Picture([](double x_m, double y_m) {
    const double away_m = std::hypot(x_m - 1.2, y_m);
    const auto lit = [&](double level, double lamp) {
      return cv::saturate_cast<uint8_t>(level + lamp * std::max(0.0, 1.0 - away_m / 0.25));
    };
    if (away_m < 0.25) return cv::Vec3b(lit(140, 150), lit(150, 170), lit(150, 180));
    if (x_m > 1.0 && y_m > 0.4) return cv::Vec3b(60, 60, 200);
    if (x_m > 1.0 && y_m < -0.4) return cv::Vec3b(70, 75, 75);
    return kFloor;
  }));
  int lamps = 0, boxes = 0;
  for (const FloorColumn& column : columns) {
    if (!column.obstacle) {
      EXPECT_FALSE(column.bright);
      continue;
    }
    const bool ahead = std::abs(column.end_R_m.y()) < 0.25 && column.end_R_m.x() > 0.9;
    EXPECT_EQ(column.bright, ahead) << column.end_R_m.transpose();
    ++(ahead ? lamps : boxes);
  }
  EXPECT_GE(lamps, 3);
  EXPECT_GE(boxes, 6);
}

TEST(FloorObstaclesTest, ABoxIsFoundWhereItStands) {
  const auto columns = Look(Picture([](double x_m, double y_m) {
    return x_m > 1.2 && std::abs(y_m) < 0.2 ? cv::Vec3b(120, 90, 90) : kFloor;
  }));
  int obstacles = 0;
  for (const FloorColumn& column : columns) {
    if (!column.obstacle) continue;
    ++obstacles;
    EXPECT_NEAR(column.end_R_m.x(), 1.2, 0.03);
    EXPECT_LT(std::abs(column.end_R_m.y()), 0.23);
  }
  EXPECT_GT(obstacles, 5);
}

TEST(FloorObstaclesTest, TileSeamsShadowsAndSpecksAreFloor) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0.0, 1.5);
  const auto image = Picture([&](double x_m, double y_m) {
    double level = 1.0;
    if (std::abs(std::remainder(x_m, 0.6)) < 0.004 || std::abs(std::remainder(y_m, 0.6)) < 0.004) {
      level = 0.45;  // a seam, darker than the window
    } else if (x_m > 1.0 && x_m < 1.3) {
      level = 0.7;  // a shadow
    }
    cv::Vec3b pixel;
    for (int c = 0; c < 3; ++c) {
      pixel[c] = cv::saturate_cast<uint8_t>(level * kFloor[c] + noise(random));
    }
    return random() % 500 == 0 ? cv::Vec3b(0, 0, 255) : pixel;
  });
  for (const FloorColumn& column : Look(image)) EXPECT_FALSE(column.obstacle);
}

TEST(FloorObstaclesTest, AWhiteWallInTheFloorsBrightnessIsNotFloor) {
  // Pixels of rendered pictures: white boards lit from above are no brighter than the floor.
  const auto columns = Look(Picture([](double x_m, double) {
    return x_m > 1.5 ? cv::Vec3b(159, 155, 154) : cv::Vec3b(138, 147, 147);
  }));
  for (const FloorColumn& column : columns) {
    if (std::abs(column.end_R_m.y()) < 0.6 * column.end_R_m.x()) {
      EXPECT_TRUE(column.obstacle);
    }
  }
}

// An upright box is seen with its sides: no obstacle is where only its top hides the floor.
TEST(FloorObstaclesTest, WhatLeansOutwardInThePictureStandsAtItsFoot) {
  const auto X_RF = CameraPose();
  cv::Mat mask(kCamera.height_px, kCamera.width_px, CV_8UC1, cv::Scalar(0));
  // The side x = 1.0 of a box 0.5 m high that ends at y = 0.6, on the left.
  for (int v = 0; v < mask.rows; ++v) {
    for (int u = 0; u < mask.cols; ++u) {
      const Eigen::Vector3d ray = X_RF.linear() * kCamera.Ray(u, v);
      const double to_side = (1.0 - X_RF.translation().x()) / ray.x();
      const Eigen::Vector3d p = X_RF.translation() + to_side * ray;
      if (to_side > 0.0 && p.y() < 0.6 && p.z() > 0.0 && p.z() < 0.5) mask.at<uint8_t>(v, u) = 255;
    }
  }
  for (const FloorColumn& column : FloorObstacles(mask, kCamera, X_RF, {})) {
    if (column.obstacle) {
      EXPECT_NEAR(column.end_R_m.x(), 1.0, 0.05);
    }
  }
}

TEST(FloorObstaclesTest, SomethingAtTheLowestRowEndsTheColumnThere) {
  const auto columns = Look(Picture([](double, double) { return cv::Vec3b(30, 30, 180); }));
  for (const FloorColumn& column : columns) {
    EXPECT_TRUE(column.obstacle);
    EXPECT_EQ(column.begin_R_m, column.end_R_m);
  }
  EXPECT_NEAR(columns[columns.size() / 2].end_R_m.x(), 0.35, 0.02);
}

TEST(FloorObstaclesTest, RefusesWhatIsNotAPictureOfThisCamera) {
  EXPECT_THROW(NotFloorMask(cv::Mat(240, 320, CV_8UC1), std::array{kModel}), ContractViolation);
  EXPECT_THROW(FloorObstacles(cv::Mat::zeros(10, 10, CV_8UC1), kCamera, CameraPose(), {}),
               ContractViolation);
}

}  // namespace
}  // namespace geon::navigation
