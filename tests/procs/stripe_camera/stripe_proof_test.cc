#include "procs/stripe_camera/stripe_proof.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/contracts.h"

namespace geon::stripe_camera {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

// Differences of two noisy frames, with a stripe drawn on top.
class Scene {
 public:
  explicit Scene(double noise_level) : difference_(kWidth * kHeight) {
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, noise_level);
    for (int16_t& value : difference_) {
      value = static_cast<int16_t>(std::lround(noise_level > 0 ? noise(random) : 0.0));
    }
  }
  Scene& Horizontal(int from_column, int to_column, double level, double slope = 0.0) {
    for (int column = from_column; column < to_column; ++column) {
      const int center = 60 + static_cast<int>(slope * column);
      for (int row = center - 2; row <= center + 2; ++row) At(column, row, level);
    }
    return *this;
  }
  Scene& Vertical(int from_row, int to_row, double level) {
    for (int row = from_row; row < to_row; ++row) {
      for (int column = 78; column <= 82; ++column) At(column, row, level);
    }
    return *this;
  }
  Scene& Brighter(int level) {
    for (int16_t& value : difference_) value = static_cast<int16_t>(value + level);
    return *this;
  }
  StripeProof Prove(sensor::Laser laser) const {
    return ProveStripe(difference_, kWidth, kHeight, laser, {});
  }

 private:
  void At(int column, int row, double level) {
    difference_[static_cast<size_t>(row * kWidth + column)] = static_cast<int16_t>(level);
  }
  std::vector<int16_t> difference_;
};

TEST(StripeProof, AStripeIsSeen) {
  const StripeProof proof =
      Scene(2.0).Horizontal(10, 150, 180, 0.1).Prove(sensor::Laser::kHorizontal);
  EXPECT_TRUE(proof.lit) << proof.reason;
  EXPECT_EQ(proof.lit_columns, 140);
  EXPECT_EQ(proof.peak_level, 180.0);
  EXPECT_NEAR(proof.noise_level, 2.0, 0.2);
  EXPECT_TRUE(Scene(2.0).Vertical(10, 110, 90).Prove(sensor::Laser::kVertical).lit);
}

TEST(StripeProof, NoiseAloneIsNoStripe) {
  for (const double noise_level : {0.0, 0.5, 2.0, 8.0}) {
    const StripeProof proof = Scene(noise_level).Prove(sensor::Laser::kHorizontal);
    EXPECT_FALSE(proof.lit) << noise_level;
    EXPECT_NEAR(proof.noise_level, noise_level, 0.1 + 0.1 * noise_level);
  }
}

TEST(StripeProof, TheWrongLaserIsFoundOut) {
  const StripeProof proof = Scene(2.0).Vertical(0, 120, 180).Prove(sensor::Laser::kHorizontal);
  EXPECT_FALSE(proof.lit);
  EXPECT_FALSE(Scene(2.0).Horizontal(0, 160, 180).Prove(sensor::Laser::kVertical).lit);
  const StripeProof long_enough =
      Scene(2.0).Vertical(0, 120, 180).Horizontal(0, 100, 180).Prove(sensor::Laser::kHorizontal);
  EXPECT_NE(long_enough.reason.find("does not lie"), std::string::npos) << long_enough.reason;
}

TEST(StripeProof, AFewLitColumnsAreAReflectionNotAStripe) {
  const StripeProof proof = Scene(2.0).Horizontal(50, 60, 250).Prove(sensor::Laser::kHorizontal);
  EXPECT_FALSE(proof.lit);
  EXPECT_EQ(proof.lit_columns, 10);
}

TEST(StripeProof, LampFlickerIsTakenOff) {
  EXPECT_FALSE(Scene(2.0).Brighter(40).Prove(sensor::Laser::kHorizontal).lit);
  EXPECT_TRUE(
      Scene(2.0).Horizontal(0, 160, 90).Brighter(-20).Prove(sensor::Laser::kHorizontal).lit);
}

TEST(StripeProof, AFaintStripeInNoiseIsNotBelieved) {
  EXPECT_FALSE(Scene(8.0).Horizontal(0, 160, 35).Prove(sensor::Laser::kHorizontal).lit);
  EXPECT_TRUE(Scene(1.0).Horizontal(0, 160, 35).Prove(sensor::Laser::kHorizontal).lit);
}

sensor::Image Grey(uint8_t level) {
  sensor::Image image;
  image.width_px = 3;
  image.height_px = 2;
  image.row_stride_bytes = 4;  // one byte of padding
  image.data.assign(8, level);
  return image;
}

TEST(FrameSum, TakesTheDifferenceOfMeans) {
  FrameSum unlit;
  FrameSum lit;
  unlit.Add(Grey(10));
  unlit.Add(Grey(20));
  lit.Add(Grey(115));
  EXPECT_EQ(unlit.MeanDifference(lit), std::vector<int16_t>(6, 100));
  EXPECT_EQ(lit.MeanDifference(unlit), std::vector<int16_t>(6, -100));
  EXPECT_EQ(SaturatedDifference(lit.MeanDifference(unlit), 3, 2).data, std::vector<uint8_t>(6, 0));
  EXPECT_EQ(SaturatedDifference({300, 7, -1, 0, 255, 254}, 3, 2).data,
            (std::vector<uint8_t>{255, 7, 0, 0, 255, 254}));
}

TEST(FrameSum, RefusesFramesOfAnotherSize) {
  FrameSum sum;
  sum.Add(Grey(1));
  sensor::Image other = Grey(1);
  other.height_px = 1;
  EXPECT_THROW(sum.Add(other), ContractViolation);
}

}  // namespace
}  // namespace geon::stripe_camera
