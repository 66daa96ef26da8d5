#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "config/calibrated_rig_file.h"
#include "config/daemon_arguments.h"
#include "config/text_file.h"
#include "procs/geon/board_frames.h"
#include "procs/geon/calibrate_commands.h"
#include "procs/geon/commands.h"
#include "procs/geon/progress_bar.h"
#include "procs/geon/svg.h"
#include "procs/recognizer/stripe_calibration.h"
#include "rangefinder/look_up_table.h"

namespace geon::cli {
namespace {

using Json = nlohmann::ordered_json;
using sensor::Laser;

struct CompareArguments {
  std::string rig_file;
  std::string lut_dir = config::InstalledFile("scripts/config/calibration").string();
  std::string frames_dir;
  SimulatedBoardArguments simulated = InstalledRobot();
  bool json = false;
};

// How far off a calibration puts the board, over the lines of the picture. The picture is cut into
// ten parts, so that what is noise averages out and what bends stays.
struct RangeErrors {
  static constexpr size_t kParts = 10;
  double sum_m[kParts] = {};
  int count[kParts] = {};

  void Add(int line, int lines, double error_m) {
    const auto part = static_cast<size_t>(line) * kParts / static_cast<size_t>(lines);
    sum_m[part] += error_m;
    ++count[part];
  }
  double mean_mm() const {
    double sum = 0.0;
    int all = 0;
    for (size_t k = 0; k < kParts; ++k) sum += sum_m[k], all += count[k];
    return all == 0 ? std::numeric_limits<double>::quiet_NaN() : 1000.0 * sum / all;
  }
  double worst_part_mm() const {
    double worst_mm = 0.0;
    for (size_t k = 0; k < kParts; ++k) {
      if (count[k] < 8) continue;
      const double part_mm = 1000.0 * sum_m[k] / count[k];
      if (std::abs(part_mm) > std::abs(worst_mm)) worst_mm = part_mm;
    }
    return worst_mm;
  }
};

struct Row {
  Laser laser = Laser::kHorizontal;
  double distance_m = 0.0;
  RangeErrors lut, rig;
};

Result<std::vector<Row>> CompareLaser(const CompareArguments& arguments,
                                      const rangefinder::LookUpTable& table,
                                      const geometry::SensorRig& rig) {
  const Laser laser = table.laser;
  const Result<BoardSeries> series =
      arguments.frames_dir.empty()
          ? OpenSimulatedBoard(arguments.simulated, laser)
          : RecordedBoard(arguments.frames_dir, laser, rangefinder::LaserColor::kMono);
  if (!series.ok()) return series.status();
  const geometry::LaserMount& fan =
      laser == Laser::kVertical ? rig.vertical_laser : rig.horizontal_laser;
  std::vector<Row> rows;
  for (int k = 0; k < series->distances; ++k) {
    const Result<BoardFrames> board = series->at(k);
    if (!board.ok()) return board.status();
    Row& row = rows.emplace_back();
    row.laser = laser;
    row.distance_m = board->distance_m;
    const sensor::Image mean = rangefinder::AverageImages(board->light);
    if (table.lines() != (laser == Laser::kVertical ? mean.height_px : mean.width_px)) {
      return Status::Error("the pictures have not the size of the look-up table's");
    }
    for (const rangefinder::StripePeak& peak : rangefinder::FindStripePeaks(mean, laser)) {
      if (peak.reason != rangefinder::PeakReason::kFound) continue;
      const Eigen::Vector2d pixel_px = laser == Laser::kVertical
                                           ? Eigen::Vector2d(peak.position_px, peak.pixel)
                                           : Eigen::Vector2d(peak.pixel, peak.position_px);
      const Eigen::Vector3d ray_B = rig.stripe_camera.Ray(pixel_px.x(), pixel_px.y());
      row.rig.Add(peak.pixel, table.lines(), rig.DistanceToFan(fan, ray_B) - board->distance_m);
      if (const auto depth_m = table.Distance(peak.pixel, peak.position_px)) {
        row.lut.Add(peak.pixel, table.lines(), *depth_m - board->distance_m);
      }
    }
    ShowProgressBar(std::string(ToString(laser)), k + 1, series->distances);
  }
  return rows;
}

void Print(const std::vector<Row>& rows) {
  std::cout << "| laser | distance m | lut: mean mm | worst tenth | rig: mean mm | worst tenth |\n"
               "|---|---|---|---|---|---|\n";
  for (const Row& row : rows) {
    std::cout << "| " << ToString(row.laser) << " | " << Fixed(row.distance_m, 2) << " | "
              << Fixed(row.lut.mean_mm(), 2) << " | " << Fixed(row.lut.worst_part_mm(), 2) << " | "
              << Fixed(row.rig.mean_mm(), 2) << " | " << Fixed(row.rig.worst_part_mm(), 2)
              << " |\n";
  }
}

void PrintJson(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const auto of = [](const RangeErrors& errors) {
      return Json{{"mean_mm", errors.mean_mm()}, {"worst_tenth_mm", errors.worst_part_mm()}};
    };
    std::cout << Json{{"laser", ToString(row.laser)},
                      {"distance_m", row.distance_m},
                      {"lut", of(row.lut)},
                      {"rig", of(row.rig)}}
                     .dump()
              << "\n";
  }
}

int Compare(const CompareArguments& arguments) {
  const auto fail = [](const Status& status) {
    std::cerr << "geon calibrate compare: " << status.message() << "\n";
    return kFailed;
  };
  const Result<geometry::SensorRig> drawn = LoadDrawing(arguments.simulated.robot_file);
  if (!drawn.ok()) return fail(drawn.status());
  const auto tables = recognizer::LoadStripeCalibration(arguments.lut_dir, *drawn);
  if (!tables.ok()) return fail(tables.status());
  const Result<std::string> text = config::ReadFile(arguments.rig_file, 1U << 20U);
  if (!text.ok()) return fail(text.status());
  const auto calibrated = config::ParseCalibratedRig(*text, arguments.rig_file, *drawn);
  if (!calibrated.ok()) return fail(calibrated.status());

  std::vector<Row> rows;
  for (const rangefinder::LookUpTable* table : {&tables->horizontal, &tables->vertical}) {
    const auto found = CompareLaser(arguments, *table, calibrated->rig);
    if (!found.ok()) return fail(found.status());
    rows.insert(rows.end(), found->begin(), found->end());
  }
  arguments.json ? PrintJson(rows) : Print(rows);
  return kOk;
}

}  // namespace

void AddCalibrateCompareCommand(CLI::App* calibrate, int* exit_code) {
  auto arguments = std::make_shared<CompareArguments>();
  arguments->simulated.seed = 2;  // not that of the tables
  arguments->simulated.steps = {0.7, 2.0, 0.1, 10};
  CLI::App* command = calibrate->add_subcommand(
      "compare",
      "Measures a flat board at known distances by the look-up tables and by a calibrated rig, and "
      "says how far off each is.");
  command->add_option("RIG", arguments->rig_file, "A rig file (geon.rig.v1)")->required();
  command->add_option("--lut", arguments->lut_dir, "Folder of horizontal.lut and vertical.lut")
      ->capture_default_str();
  CLI::Option* frames = command->add_option("--frames", arguments->frames_dir,
                                            "Recorded boards, as geon calibrate lut reads them");
  command
      ->add_option("--config", arguments->simulated.robot_file, "Robot file, for the rig as drawn")
      ->capture_default_str();
  AddSimulatedBoardArguments(*command, frames, &arguments->simulated);
  command->add_flag("--json", arguments->json, "One JSON object a line");
  command->footer("Example:\n  geon calibrate compare rig.yaml --step-m 0.1");
  command->callback([arguments, exit_code] { *exit_code = Compare(*arguments); });
}

}  // namespace geon::cli
