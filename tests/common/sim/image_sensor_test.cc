#include "sim/image_sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/contracts.h"

namespace geon::sim {
namespace {

struct Moments {
  double mean, sigma;
};
Moments MomentsOf(const std::vector<uint8_t>& pixels) {
  const auto n = static_cast<double>(pixels.size());
  const double mean = std::accumulate(pixels.begin(), pixels.end(), 0.0) / n;
  double squares = 0.0;
  for (uint8_t p : pixels) squares += (p - mean) * (p - mean);
  return {mean, std::sqrt(squares / n)};
}

TEST(ImageSensorTest, ShotNoiseGrowsWithTheRootOfTheLight) {
  CameraOptions options;
  options.gamma_1 = 1.0;
  options.full_well_e = 2000.0;
  options.read_noise_e = 0.0;
  const ImageSensor sensor(options);
  for (const double level_1 : {0.2, 0.8}) {
    const std::vector<float> signal(40000, static_cast<float>(level_1));
    const Moments moments = MomentsOf(sensor.Expose(signal, 5));
    EXPECT_NEAR(moments.mean, 255 * level_1, 0.5);
    // Rounding to grey levels adds 1/12.
    const double expected = std::sqrt(255.0 * 255.0 * level_1 / 2000.0 + 1.0 / 12.0);
    EXPECT_NEAR(moments.sigma / expected, 1.0, 0.03);
  }
}

TEST(ImageSensorTest, GammaBrightensAndBrightLightSaturates) {
  CameraOptions options;
  const ImageSensor sensor(options);
  EXPECT_NEAR(MomentsOf(sensor.Expose(std::vector<float>(10000, 0.2F), 1)).mean,
              255 * std::pow(0.2, 1 / 2.2), 1.0);
  EXPECT_EQ(sensor.Expose(std::vector<float>(10, 7.0F), 1), std::vector<uint8_t>(10, 255));
}

TEST(ImageSensorTest, NoiseIsTheFramesOwn) {
  const ImageSensor sensor((CameraOptions()));
  const std::vector<float> signal(1001, 0.3F);
  EXPECT_EQ(sensor.Expose(signal, 1), sensor.Expose(signal, 1));
  EXPECT_NE(sensor.Expose(signal, 1), sensor.Expose(signal, 2));
}

TEST(BlurByLensTest, SpreadsAPointEvenlyAndKeepsItsLight) {
  std::vector<float> light(5 * 5 * 3, 0.0F);
  const auto at = [&](size_t u, size_t v) -> float& { return light[(v * 5 + u) * 3 + 1]; };
  at(2, 2) = 1.0F;
  BlurByLens(5, 5, 3, 0.1, &light);
  EXPECT_NEAR(at(2, 2), 0.64, 1e-6);
  EXPECT_NEAR(at(1, 2), 0.08, 1e-6);
  EXPECT_NEAR(at(2, 3), 0.08, 1e-6);
  EXPECT_NEAR(at(3, 3), 0.01, 1e-6);
  EXPECT_NEAR(std::accumulate(light.begin(), light.end(), 0.0), 1.0, 1e-5);
}

TEST(BlurByLensTest, WrongSizeIsAContractViolation) {
  std::vector<float> light(10);
  EXPECT_THROW(BlurByLens(5, 5, 1, 0.1, &light), ContractViolation);
}

}  // namespace
}  // namespace geon::sim
