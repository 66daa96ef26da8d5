#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "config/calibrated_rig_file.h"
#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "config/text_file.h"
#include "procs/geon/board_frames.h"
#include "procs/geon/calibrate_commands.h"
#include "procs/geon/commands.h"
#include "procs/geon/progress_bar.h"
#include "procs/geon/svg.h"
#include "rangefinder/look_up_table.h"
#include "sim/sim_config.h"

namespace geon::cli {
namespace {

using Json = nlohmann::ordered_json;
using sensor::Laser;

struct CompareArguments {
  std::string rig_file;
  std::string lut_dir = config::InstalledFile("scripts/config/calibration").string();
  std::string frames_dir;
  std::string robot_file = config::InstalledFile("scripts/config/robot.yaml").string();
  std::string sim_file = config::InstalledFile("scripts/config/sim.yaml").string();
  uint64_t seed = 2;
  BoardSteps steps{0.7, 2.0, 0.1, 10};
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

Result<rangefinder::LookUpTable> LoadTable(const CompareArguments& arguments, Laser laser) {
  const std::filesystem::path file =
      std::filesystem::path(arguments.lut_dir) /
      (laser == Laser::kVertical ? "vertical.lut" : "horizontal.lut");
  const Result<std::string> bytes = config::ReadFile(file);
  if (!bytes.ok()) return bytes.status();
  Result<rangefinder::LookUpTable> table = rangefinder::ParseLookUpTable(*bytes);
  if (!table.ok()) return table.status().In(file.string());
  return table;
}

// Depth where the ray through a stripe's pixel meets the rig's fan.
double DepthByRig(const geometry::SensorRig& rig, const Eigen::Vector2d& pixel_px, Laser which) {
  const geometry::LaserMount& laser =
      which == Laser::kVertical ? rig.vertical_laser : rig.horizontal_laser;
  const Eigen::Vector3d ray_T =
      rig.X_TB.linear() * rig.stripe_camera.Ray(pixel_px.x(), pixel_px.y());
  return laser.normal_T.dot(laser.p_TLaser_m - rig.X_TB.translation()) / laser.normal_T.dot(ray_T);
}

Result<std::vector<Row>> CompareLaser(const CompareArguments& arguments,
                                      const geometry::SensorRig& drawn,
                                      const geometry::SensorRig& rig, Laser laser) {
  const Result<rangefinder::LookUpTable> table = LoadTable(arguments, laser);
  if (!table.ok()) return table.status();
  BoardSeries series;
  if (arguments.frames_dir.empty()) {
    const Result<sim::SimOptions> options = sim::LoadSimOptions(arguments.sim_file);
    if (!options.ok()) return options.status();
    series = SimulatedBoard(drawn, options->renderer, arguments.seed, laser, arguments.steps);
  } else {
    Result<BoardSeries> recorded =
        RecordedBoard(arguments.frames_dir, laser, rangefinder::LaserColor::kMono);
    if (!recorded.ok()) return recorded.status();
    series = *std::move(recorded);
  }
  std::vector<Row> rows;
  for (int k = 0; k < series.distances; ++k) {
    const Result<BoardFrames> board = series.at(k);
    if (!board.ok()) return board.status();
    Row& row = rows.emplace_back();
    row.laser = laser;
    row.distance_m = board->distance_m;
    const sensor::Image mean = rangefinder::AverageImages(board->light);
    if (table->lines() != (laser == Laser::kVertical ? mean.height_px : mean.width_px)) {
      return Status::Error("the pictures have not the size of the look-up table's");
    }
    for (const rangefinder::StripePeak& peak : rangefinder::FindStripePeaks(mean, laser)) {
      if (peak.reason != rangefinder::PeakReason::kFound) continue;
      const Eigen::Vector2d pixel_px = laser == Laser::kVertical
                                           ? Eigen::Vector2d(peak.position_px, peak.pixel)
                                           : Eigen::Vector2d(peak.pixel, peak.position_px);
      row.rig.Add(peak.pixel, table->lines(), DepthByRig(rig, pixel_px, laser) - board->distance_m);
      if (const auto depth_m = table->Distance(peak.pixel, peak.position_px)) {
        row.lut.Add(peak.pixel, table->lines(), *depth_m - board->distance_m);
      }
    }
    ShowProgressBar(laser == Laser::kVertical ? "vertical" : "horizontal", k + 1, series.distances);
  }
  return rows;
}

void Print(const std::vector<Row>& rows) {
  std::cout << "| laser | distance m | lut: mean mm | worst tenth | rig: mean mm | worst tenth |\n"
               "|---|---|---|---|---|---|\n";
  for (const Row& row : rows) {
    std::cout << "| " << (row.laser == Laser::kVertical ? "vertical" : "horizontal") << " | "
              << Fixed(row.distance_m, 2) << " | " << Fixed(row.lut.mean_mm(), 2) << " | "
              << Fixed(row.lut.worst_part_mm(), 2) << " | " << Fixed(row.rig.mean_mm(), 2) << " | "
              << Fixed(row.rig.worst_part_mm(), 2) << " |\n";
  }
}

void PrintJson(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const auto of = [](const RangeErrors& errors) {
      return Json{{"mean_mm", errors.mean_mm()}, {"worst_tenth_mm", errors.worst_part_mm()}};
    };
    std::cout << Json{{"laser", row.laser == Laser::kVertical ? "vertical" : "horizontal"},
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
  Result<config::YamlDocument> robot = config::LoadRobotFile(arguments.robot_file, {"rig"});
  if (!robot.ok()) return fail(robot.status());
  const geometry::SensorRig drawn = config::ReadDrawnRig(robot->root().Child("rig"));
  if (const Status status = robot->Finish(); !status.ok()) return fail(status);
  const Result<std::string> text = config::ReadFile(arguments.rig_file, 1U << 20U);
  if (!text.ok()) return fail(text.status());
  const auto calibrated = config::ParseCalibratedRig(*text, arguments.rig_file, drawn);
  if (!calibrated.ok()) return fail(calibrated.status());

  std::vector<Row> rows;
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    const auto found = CompareLaser(arguments, drawn, calibrated->rig, laser);
    if (!found.ok()) return fail(found.status());
    rows.insert(rows.end(), found->begin(), found->end());
  }
  arguments.json ? PrintJson(rows) : Print(rows);
  return kOk;
}

}  // namespace

void AddCalibrateCompareCommand(CLI::App* calibrate, int* exit_code) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = calibrate->add_subcommand(
      "compare",
      "Measures a flat board at known distances by the look-up tables and by a calibrated rig, and "
      "says how far off each is.");
  command->add_option("RIG", arguments->rig_file, "A rig file (geon.rig.v1)")->required();
  command->add_option("--lut", arguments->lut_dir, "Folder of horizontal.lut and vertical.lut")
      ->capture_default_str();
  CLI::Option* frames = command->add_option("--frames", arguments->frames_dir,
                                            "Recorded boards, as geon calibrate lut reads them");
  command->add_option("--config", arguments->robot_file, "Robot file, for the rig as drawn")
      ->capture_default_str();
  const auto simulated = [&](CLI::Option* option) {
    option->excludes(frames)->capture_default_str();
  };
  simulated(
      command->add_option("--sim-config", arguments->sim_file, "What the simulated robot is like"));
  simulated(command->add_option("--seed", arguments->seed, "Of the frames' noise"));
  simulated(command->add_option("--from-m", arguments->steps.from_m, "Nearest board")
                ->check(CLI::Range(0.1, 10.0)));
  simulated(command->add_option("--to-m", arguments->steps.to_m, "Farthest board")
                ->check(CLI::Range(0.1, 10.0)));
  simulated(command->add_option("--step-m", arguments->steps.step_m, "Between boards")
                ->check(CLI::Range(0.0001, 1.0)));
  simulated(
      command->add_option("--frames-per-step", arguments->steps.frames, "Averaged at each distance")
          ->check(CLI::Range(1, 1000)));
  command->add_flag("--json", arguments->json, "One JSON object a line");
  command->footer("Example:\n  geon calibrate compare rig.yaml --step-m 0.1");
  command->callback([arguments, exit_code] { *exit_code = Compare(*arguments); });
}

}  // namespace geon::cli
