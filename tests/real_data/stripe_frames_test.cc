#include <Eigen/Core>
#include <Eigen/QR>
#include <cmath>

#include "rangefinder/laser_light.h"
#include "rangefinder/stripe_peaks.h"
#include "tests/real_data/real_data.h"

namespace geon {
namespace {

using rangefinder::LaserColor;
using rangefinder::PeakReason;
using rangefinder::StripePeak;
using sensor::Laser;

struct Point {
  double line = 0.0;
  double position_px = 0.0;
};

// A polynomial through points, and how far they lie from it.
class SmoothFit {
 public:
  SmoothFit(const std::vector<Point>& points, int degree) : degree_(degree) {
    Eigen::MatrixXd rows(points.size(), degree + 1);
    Eigen::VectorXd right(points.size());
    for (Eigen::Index i = 0; i < right.size(); ++i) {
      rows.row(i) = Row(points[static_cast<size_t>(i)].line);
      right[i] = points[static_cast<size_t>(i)].position_px;
    }
    coefficients_ = rows.colPivHouseholderQr().solve(right);
    rms_px_ = std::sqrt((rows * coefficients_ - right).squaredNorm() /
                        static_cast<double>(points.size()));
  }
  double At(double line) const { return Row(line).dot(coefficients_); }
  double rms_px() const { return rms_px_; }

 private:
  Eigen::RowVectorXd Row(double line) const {
    Eigen::RowVectorXd row(degree_ + 1);
    for (int k = 0; k <= degree_; ++k) row[k] = std::pow(line / 320.0 - 1.0, k);
    return row;
  }
  int degree_;
  Eigen::VectorXd coefficients_;
  double rms_px_ = 0.0;
};

class StripeFramesTest : public RealDataTest {
 protected:
  std::vector<Point> Find(const std::string& file, Laser laser, LaserColor color) const {
    std::vector<Point> points;
    for (const StripePeak& peak :
         rangefinder::FindStripePeaks(rangefinder::LaserLight(Load(file), color), laser)) {
      if (peak.reason != PeakReason::kFound) continue;
      points.push_back({static_cast<double>(peak.pixel), peak.position_px});
    }
    return points;
  }
  static double Mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }
};

// How far a step's top shifts the stripe against the bed's line, in pixels: the middle seven tenths
// of the step against the bed clear of it.
double StepOffset(const std::vector<Point>& points) {
  const double bed_px = points.front().position_px;
  std::vector<Point> bed;
  std::vector<Point> step;
  for (const Point& point : points) {
    (std::abs(point.position_px - bed_px) < 10.0 ? bed : step).push_back(point);
  }
  const double first = step.front().line;
  const double last = step.back().line;
  std::erase_if(bed, [&](const Point& p) { return p.line > first - 8 && p.line < last + 8; });
  const SmoothFit line(bed, 1);
  double sum = 0.0;
  int count = 0;
  for (const Point& point : step) {
    const double margin = 0.15 * (last - first);
    if (point.line < first + margin || point.line > last - margin) continue;
    sum += line.At(point.line) - point.position_px;
    ++count;
  }
  return sum / count;
}

TEST_F(StripeFramesTest, GreyStepsShiftTheStripeByOneRule) {
  struct Step {
    std::string folder;
    double height_mm = 0.0;
    double offset_px = 0.0;
  };
  std::vector<Step> steps = {{"laser/anugrah/grey_step_3.68mm", 3.68},
                             {"laser/anugrah/grey_step_14mm", 14.0}};
  for (Step& step : steps) {
    std::vector<double> offsets_px;
    for (const std::string& file : Files(step.folder)) {
      offsets_px.push_back(StepOffset(Find(file, Laser::kVertical, LaserColor::kMono)));
    }
    step.offset_px = Mean(offsets_px);
    for (const double offset_px : offsets_px) {
      EXPECT_NEAR(offset_px, step.offset_px, 0.01 * step.offset_px) << step.folder;
    }
  }
  RecordProperty("offset_3.68mm_px", std::to_string(steps[0].offset_px));
  RecordProperty("offset_14mm_px", std::to_string(steps[1].offset_px));
  // The stripe's saturated cores, read off the frames by eye: 330.5 against the bed's 350.9, and
  // 264.0 against 348.7.
  EXPECT_NEAR(steps[0].offset_px, 20.4, 0.02 * 20.4);
  EXPECT_NEAR(steps[1].offset_px, 84.7, 0.02 * 84.7);
  // Nearer things shift more: offset = s h / (1 - h / H). The camera hangs 10 to 20 cm above the
  // bed.
  const double ratio = steps[1].offset_px / 14.0 / (steps[0].offset_px / 3.68);
  const double camera_mm = (14.0 * ratio - 3.68) / (ratio - 1.0);
  EXPECT_GT(camera_mm, 100.0);
  EXPECT_LT(camera_mm, 200.0);
}

TEST_F(StripeFramesTest, BarePlaneIsStraightToATwelfthOfAPixelOnAGoodRig) {
  for (const std::string& file : Files("laser/anugrah/reference_03")) {
    const auto points = Find(file, Laser::kVertical, LaserColor::kMono);
    EXPECT_EQ(points.size(), 480U) << file;
    EXPECT_LE(SmoothFit(points, 2).rms_px(), 0.08) << file;
  }
}

// A narrow stripe with strong speckle, in a colour frame of a camera that overdoes its contrast.
TEST_F(StripeFramesTest, SpeckledPlaneOfAColorCameraIsStraightToAThirdOfAPixel) {
  for (const std::string& file : Files("laser/anugrah/ref_0508")) {
    const auto points = Find(file, Laser::kVertical, LaserColor::kRed);
    EXPECT_GT(points.size(), 470U) << file;
    EXPECT_LT(SmoothFit(points, 1).rms_px(), 0.35) << file;
  }
}

TEST_F(StripeFramesTest, RobotsViewOfTheBareFloorIsFoundWhole) {
  for (const char* name : {"img0070", "img0078", "img0086"}) {
    auto points =
        Find(std::string("laser/neil/") + name + ".jpg", Laser::kHorizontal, LaserColor::kRed);
    // At the left edge a board lies on the floor.
    std::erase_if(points, [](const Point& point) { return point.line < 60.0; });
    EXPECT_GT(points.size(), 570U) << name;
    EXPECT_LT(SmoothFit(points, 3).rms_px(), 0.4) << name;
  }
}

TEST_F(StripeFramesTest, RobotsViewOfBlocksStaysOnTheStripe) {
  for (const std::string& file : Files("laser/neil")) {
    const auto points = Find(file, Laser::kHorizontal, LaserColor::kRed);
    EXPECT_GT(points.size(), 450U) << file;
    int strays = 0;
    for (const Point& point : points) {
      // Floor and block faces: nothing the laser can reach lies elsewhere in these frames.
      strays += point.position_px < 195.0 || point.position_px > 295.0 ? 1 : 0;
    }
    EXPECT_LE(strays, 13) << file;
  }
}

TEST_F(StripeFramesTest, NothingIsInventedWhereAStripeOnAGlossyWheelIsBroken) {
  for (const char* name : {"06", "09", "10"}) {
    const auto points =
        Find(std::string("laser/beihun/") + name + ".jpg", Laser::kVertical, LaserColor::kRed);
    int on_wall = 0;
    int on_wheel_and_floor = 0;
    for (const Point& point : points) {
      on_wall += point.line < 250 && std::abs(point.position_px - 554.0) < 6.0 ? 1 : 0;
      on_wheel_and_floor += point.line >= 530 && point.line < 710 ? 1 : 0;
      EXPECT_FALSE(point.line > 262 && point.line < 290) << name << ": the wheel's shadow";
      EXPECT_FALSE(point.line > 434 && point.line < 450) << name << ": the wheel's black rim";
      EXPECT_FALSE(point.line > 466 && point.line < 488) << name << ": the wheel's dark hub";
    }
    EXPECT_EQ(on_wall, 250) << name;
    EXPECT_GT(on_wheel_and_floor, 175) << name;
  }
}

// Neither laser, nowhere: barrels, cones, a ball, corridors with rails and painted lines.
TEST_F(StripeFramesTest, PhotosWithoutALaserShowNoStripe) {
  rangefinder::PeakOptions options;
  options.min_stripe_share_1 = 0.5;
  std::vector<std::string> photos;
  for (const char* index : {"redbarrel", "other"}) {
    for (const auto& row : ReadCsv(std::string("photos/") + index + ".csv")) {
      photos.push_back(index == std::string("redbarrel") ? "photos/redbarrel/" + row[0]
                                                         : "photos/" + row[0]);
    }
  }
  ASSERT_GE(photos.size(), 25U);
  for (const std::string& photo : photos) {
    const sensor::Image light = rangefinder::LaserLight(Load(photo), LaserColor::kRed);
    for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
      for (const StripePeak& peak : rangefinder::FindStripePeaks(light, laser, options)) {
        ASSERT_NE(peak.reason, PeakReason::kFound) << photo;
      }
    }
  }
}

TEST_F(StripeFramesTest, FramesWithAStripePassTheSameRule) {
  rangefinder::PeakOptions options;
  options.min_stripe_share_1 = 0.5;
  for (const char* folder : {"laser/anugrah/ref_0508", "laser/anugrah/pyramid_1mm", "laser/neil"}) {
    for (const std::string& file : Files(folder)) {
      const Laser laser =
          std::string(folder) == "laser/neil" ? Laser::kHorizontal : Laser::kVertical;
      const auto peaks = rangefinder::FindStripePeaks(
          rangefinder::LaserLight(Load(file), LaserColor::kRed), laser, options);
      EXPECT_NE(peaks[peaks.size() / 4].reason, PeakReason::kNoStripe) << file;
    }
  }
}

}  // namespace
}  // namespace geon
