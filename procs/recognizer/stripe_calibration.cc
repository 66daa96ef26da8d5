#include "procs/recognizer/stripe_calibration.h"

#include "config/daemon_arguments.h"
#include "config/text_file.h"

namespace geon::recognizer {
namespace {

Result<rangefinder::LookUpTable> LoadTable(const std::filesystem::path& file, sensor::Laser laser,
                                           const geometry::PinholeCamera& camera) {
  const Result<std::string> bytes = config::ReadFile(file);
  if (!bytes.ok()) {
    return Status::Error(bytes.message() + "; calibrate the range finder: geon calibrate lut");
  }
  Result<rangefinder::LookUpTable> table = rangefinder::ParseLookUpTable(*bytes);
  if (!table.ok()) return table.status().In(file.string());
  if (table->laser != laser) return Status::Error(file.string() + ": the table of the other laser");
  if (table->width_px != camera.width_px || table->height_px != camera.height_px) {
    return Status::Error(
        file.string() + ": made with images of " + std::to_string(table->width_px) + " x " +
        std::to_string(table->height_px) + " pixels, the camera has " +
        std::to_string(camera.width_px) + " x " + std::to_string(camera.height_px));
  }
  return table;
}

}  // namespace

Result<StripeCalibration> LoadStripeCalibration(const std::filesystem::path& directory,
                                                const geometry::SensorRig& rig) {
  const std::filesystem::path horizontal_file = directory / "horizontal.lut";
  const std::filesystem::path vertical_file = directory / "vertical.lut";
  auto horizontal = LoadTable(horizontal_file, sensor::Laser::kHorizontal, rig.stripe_camera);
  if (!horizontal.ok()) return horizontal.status();
  auto vertical = LoadTable(vertical_file, sensor::Laser::kVertical, rig.stripe_camera);
  if (!vertical.ok()) return vertical.status();
  return StripeCalibration{std::move(horizontal).value(), std::move(vertical).value(),
                           directory.string(),
                           config::FileHash(horizontal_file) + config::FileHash(vertical_file)};
}

}  // namespace geon::recognizer
