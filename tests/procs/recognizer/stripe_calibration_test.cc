#include "procs/recognizer/stripe_calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "config/text_file.h"
#include "tests/procs/recognizer/board_scene.h"

namespace geon::recognizer {
namespace {

using testing::HasSubstr;

class StripeCalibrationTest : public testing::Test {
 protected:
  StripeCalibrationTest()
      : directory_(std::filesystem::path(testing::TempDir()) / "geon_stripe_calibration_test") {
    std::filesystem::remove_all(directory_);
    std::filesystem::create_directories(directory_);
    Write("horizontal.lut", sensor::Laser::kHorizontal);
    Write("vertical.lut", sensor::Laser::kVertical);
  }
  ~StripeCalibrationTest() override { std::filesystem::remove_all(directory_); }

  void Write(const std::string& name, sensor::Laser laser) const {
    const Status written = config::WriteFileAtomically(
        directory_ / name, rangefinder::SerializeLookUpTable(TestTable(rig_, laser)));
    ASSERT_TRUE(written.ok()) << written.message();
  }

  geometry::SensorRig rig_ = TestConfig().rig;
  std::filesystem::path directory_;
};

TEST_F(StripeCalibrationTest, LoadsBothTablesAndNamesThemByTheirHash) {
  const auto calibration = LoadStripeCalibration(directory_, rig_);
  ASSERT_TRUE(calibration.ok()) << calibration.message();
  EXPECT_EQ(calibration->horizontal.laser, sensor::Laser::kHorizontal);
  EXPECT_EQ(calibration->vertical.laser, sensor::Laser::kVertical);
  EXPECT_EQ(calibration->hash.size(), 32U);
}

TEST_F(StripeCalibrationTest, SaysWhatToDoWhenThereIsNone) {
  std::filesystem::remove(directory_ / "vertical.lut");
  EXPECT_THAT(LoadStripeCalibration(directory_, rig_).message(),
              testing::AllOf(HasSubstr("vertical.lut"), HasSubstr("geon calibrate lut")));
}

TEST_F(StripeCalibrationTest, RefusesTablesThatWereExchanged) {
  Write("vertical.lut", sensor::Laser::kHorizontal);
  EXPECT_THAT(LoadStripeCalibration(directory_, rig_).message(), HasSubstr("other laser"));
}

TEST_F(StripeCalibrationTest, RefusesTablesOfAnotherCamera) {
  rig_.stripe_camera.width_px = 1280;
  EXPECT_THAT(LoadStripeCalibration(directory_, rig_).message(), HasSubstr("640 x 480"));
}

}  // namespace
}  // namespace geon::recognizer
