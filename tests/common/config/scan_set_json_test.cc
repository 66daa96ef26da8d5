#include "config/scan_set_json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

namespace geon::config {
namespace {

using testing::HasSubstr;

std::string WithStripe(const std::string& stripe) {
  return R"({"format":"geon.scan_set.v1","camera":{"position_m":[0,0,1.0],)"
         R"("rotation_LB":[0,0,1,-1,0,0,0,-1,0]},"stripes":[)" +
         stripe + "]}";
}

constexpr const char* kGoodStripe =
    R"({"laser":"vertical","fraction":0.25,"pixel":[4,7],"points_m":[[1,0,0.5],[1,0,0.4]]})";

std::string ErrorOf(const std::string& text) { return ParseScanSet(text, "x.json").message(); }

TEST(ScanSetJson, ReadsWhatTheFormatHolds) {
  const Result<sensor::ScanSet> scan = ParseScanSet(
      R"({"format":"geon.scan_set.v1","truth":"bent_cuboid","note":"by hand",
          "camera":{"position_m":[0,0.1,1.0],"rotation_LB":[0,0,1,-1,0,0,0,-1,0]},
          "target_box_px":{"u":210,"v":140,"w":180,"h":190},
          "stripes":[{"laser":"horizontal","fraction":0.75,"laser_origin_m":[0,0,1.12],
                      "camera_rotation_LB":[0,0,1,-1,0,0,0,-1,0],
                      "pixel":[212,213],"points_m":[[1.02,0.08,0.11],[1.03,0.07,0.12]]}]})",
      "x.json");
  ASSERT_TRUE(scan.ok()) << scan.message();
  EXPECT_EQ(scan->truth, GeonLabel::kBentCuboid);
  EXPECT_EQ(scan->camera_position_L_m, Eigen::Vector3d(0, 0.1, 1.0));
  EXPECT_EQ(scan->target_box, (sensor::PixelBox{210, 140, 180, 190}));
  ASSERT_EQ(scan->profiles.size(), 1U);
  const sensor::RangeProfile& profile = scan->profiles[0];
  EXPECT_EQ(profile.laser, sensor::Laser::kHorizontal);
  EXPECT_EQ(profile.fraction, 0.75);
  EXPECT_EQ(profile.pixel, (std::vector<int>{212, 213}));
  EXPECT_EQ(profile.p_L_m[1], Eigen::Vector3d(1.03, 0.07, 0.12));
  EXPECT_EQ(profile.laser_origin_L_m, Eigen::Vector3d(0, 0, 1.12));
  EXPECT_TRUE(profile.rotation_LB.has_value());
}

TEST(ScanSetJson, MayTellThePointsColours) {
  const std::string stripe = kGoodStripe;
  const auto with = [&](const std::string& colors) {
    return WithStripe(stripe.substr(0, stripe.size() - 1) + ",\"color\":" + colors + "}");
  };
  const Result<sensor::ScanSet> scan = ParseScanSet(with("[0.25,1]"), "x.json");
  ASSERT_TRUE(scan.ok()) << scan.message();
  EXPECT_EQ(scan->profiles[0].on_color_1, (std::vector<double>{0.25, 1.0}));
  EXPECT_EQ(ParseScanSet(SerializeScanSet(*scan), "x.json")->profiles[0].on_color_1,
            scan->profiles[0].on_color_1);
  EXPECT_TRUE(ParseScanSet(WithStripe(stripe), "x.json")->profiles[0].on_color_1.empty());
  EXPECT_THAT(ErrorOf(with("[0.25]")), HasSubstr("color: has 1 numbers for 2 points"));
  EXPECT_THAT(ErrorOf(with("[0.25,1.5]")), HasSubstr("must be between 0 and 1"));
}

TEST(ScanSetJson, WritingAndReadingGivesTheSameBits) {
  sensor::ScanSet scan;
  scan.rotation_LB << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  scan.camera_position_L_m = {0.1, 1.0 / 3.0, 1.2345678901234567};
  scan.target_box = sensor::PixelBox{1, 2, 3, 4};
  scan.truth = GeonLabel::kEllipsoid;
  sensor::RangeProfile profile;
  profile.laser = sensor::Laser::kVertical;
  profile.fraction = 0.1;
  profile.pixel = {-3, 12};
  profile.p_L_m = {{1.0 / 7.0, 2.0, 3.0}, {1e-17, -2.0, 0.0}};
  profile.laser_origin_L_m = Eigen::Vector3d(0, 0, 1);
  profile.rotation_LB = scan.rotation_LB;
  scan.profiles = {profile};

  const Result<sensor::ScanSet> again = ParseScanSet(SerializeScanSet(scan), "x.json");
  ASSERT_TRUE(again.ok()) << again.message();
  EXPECT_EQ(again->camera_position_L_m, scan.camera_position_L_m);
  EXPECT_EQ(again->rotation_LB, scan.rotation_LB);
  EXPECT_EQ(again->target_box, scan.target_box);
  EXPECT_EQ(again->truth, scan.truth);
  EXPECT_EQ(again->profiles[0].pixel, profile.pixel);
  EXPECT_EQ(again->profiles[0].p_L_m, profile.p_L_m);
  EXPECT_EQ(again->profiles[0].rotation_LB, profile.rotation_LB);
  EXPECT_EQ(SerializeScanSet(*again), SerializeScanSet(scan));
}

TEST(ScanSetJson, RefusalsNameFileAndPlace) {
  EXPECT_TRUE(ParseScanSet(WithStripe(kGoodStripe), "x.json").ok());
  EXPECT_THAT(ErrorOf("{\"format\":"), HasSubstr("x.json: not JSON"));
  EXPECT_THAT(ErrorOf("[]"), HasSubstr("the whole: must be an object"));
  EXPECT_THAT(ErrorOf(R"({"format":"geon.scan_set.v9"})"), HasSubstr("x.json: /format: must be"));
  EXPECT_THAT(ErrorOf(R"({"format":"geon.scan_set.v1"})"), HasSubstr("has no \"camera\""));
  EXPECT_THAT(ErrorOf(WithStripe("")), HasSubstr("/stripes: holds no stripe"));
  EXPECT_THAT(ErrorOf(WithStripe(R"({"laser":"sideways","fraction":0.5})")),
              HasSubstr("/stripes/0/laser: must be"));
  EXPECT_THAT(
      ErrorOf(WithStripe(R"({"laser":"vertical","fraction":1.5,"pixel":[],"points_m":[]})")),
      HasSubstr("/stripes/0/fraction: must be between 0 and 1"));
  EXPECT_THAT(ErrorOf(WithStripe(
                  R"({"laser":"vertical","fraction":0.5,"pixel":[1,2],"points_m":[[1,2,3]]})")),
              HasSubstr("/stripes/0/points_m: has 1 points for 2 pixels"));
  EXPECT_THAT(
      ErrorOf(WithStripe(
          R"({"laser":"vertical","fraction":0.5,"pixel":[2,2],"points_m":[[1,2,3],[1,2,3]]})")),
      HasSubstr("/stripes/0/pixel/1: must be larger"));
  EXPECT_THAT(ErrorOf(WithStripe(
                  R"({"laser":"vertical","fraction":0.5,"pixel":[2],"points_m":[[1,2,"3"]]})")),
              HasSubstr("/stripes/0/points_m/0/2: must be a number"));
  EXPECT_THAT(ErrorOf(WithStripe(
                  R"({"laser":"vertical","fraction":0.5,"pixel":[2.5],"points_m":[[1,2,3]]})")),
              HasSubstr("/stripes/0/pixel/0: must be an integer"));
  EXPECT_THAT(ErrorOf(WithStripe(
                  R"({"laser":"vertical","fraction":0.5,"pixel":[2],"points_m":[[1,2,1e999]]})")),
              HasSubstr("x.json: not JSON"));
  EXPECT_THAT(ErrorOf(R"({"format":"geon.scan_set.v1","truth":"banana"})"),
              HasSubstr("/truth: is none of the seven labels"));
}

TEST(ScanSetJson, RefusesAMatrixThatDoesNotRotate) {
  EXPECT_THAT(ErrorOf(R"({"format":"geon.scan_set.v1","camera":{"position_m":[0,0,1],
      "rotation_LB":[1,0,0,0,1,0,0,0,2]},"stripes":[]})"),
              HasSubstr("/camera/rotation_LB: is no rotation matrix"));
  EXPECT_THAT(ErrorOf(R"({"format":"geon.scan_set.v1","camera":{"position_m":[0,0,1],
      "rotation_LB":[1,0,0,0,1,0,0,0,-1]},"stripes":[]})"),
              HasSubstr("is no rotation matrix"));
}

TEST(ScanSetJson, SaysWhichFileIsMissing) {
  EXPECT_THAT(LoadScanSet("/no/such/scan.json").message(), HasSubstr("/no/such/scan.json"));
}

TEST(ScanSetJson, ReadsEveryRealScanSet) {
  const char* variable = std::getenv("GEON_DATA");
  const std::filesystem::path data =
      variable != nullptr ? std::filesystem::path(variable)
                          : std::filesystem::path(GEON_SOURCE_DIR) / "../shared/data";
  if (!std::filesystem::is_directory(data / "scan_sets")) {
    GTEST_SKIP() << "no real scan sets: set GEON_DATA to the folder that holds scan_sets/";
  }
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "scan_sets")) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    const Result<sensor::ScanSet> scan = LoadScanSet(entry.path());
    EXPECT_TRUE(scan.ok()) << scan.message();
  }
  EXPECT_GT(files, 0);
}

}  // namespace
}  // namespace geon::config
