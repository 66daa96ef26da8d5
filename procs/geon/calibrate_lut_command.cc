#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "config/text_file.h"
#include "procs/geon/board_frames.h"
#include "procs/geon/calibrate_commands.h"
#include "procs/geon/commands.h"
#include "procs/geon/progress_bar.h"
#include "rangefinder/look_up_table.h"

namespace geon::cli {
namespace {

using Json = nlohmann::ordered_json;
using sensor::Laser;

struct LutArguments {
  std::string output;
  std::string frames_dir;
  std::string laser_color = "mono";
  SimulatedBoardArguments simulated = InstalledRobot();
  std::string date;
  bool json = false;
};

std::string Name(Laser laser) { return std::string(ToString(laser)); }

Result<BoardSeries> OpenBoard(const LutArguments& arguments, Laser laser) {
  if (!arguments.frames_dir.empty()) {
    const auto color = arguments.laser_color == "red"     ? rangefinder::LaserColor::kRed
                       : arguments.laser_color == "green" ? rangefinder::LaserColor::kGreen
                                                          : rangefinder::LaserColor::kMono;
    return RecordedBoard(arguments.frames_dir, laser, color);
  }
  return OpenSimulatedBoard(arguments.simulated, laser);
}

Result<rangefinder::Calibration> Calibrate(const LutArguments& arguments, Laser laser) {
  const Result<BoardSeries> series = OpenBoard(arguments, laser);
  if (!series.ok()) return series.status();
  std::vector<rangefinder::BoardObservation> observations;
  int width_px = 0;
  int height_px = 0;
  for (int k = 0; k < series->distances; ++k) {
    const Result<BoardFrames> board = series->at(k);
    if (!board.ok()) return board.status();
    const sensor::Image mean = rangefinder::AverageImages(board->light);
    width_px = mean.width_px;
    height_px = mean.height_px;
    observations.push_back({board->distance_m, rangefinder::FindStripePeaks(mean, laser)});
    ShowProgressBar(Name(laser), k + 1, series->distances);
  }
  const std::string date = arguments.date.empty() ? Today() : arguments.date;
  return rangefinder::BuildLookUpTable(laser, width_px, height_px, series->frames, date,
                                       observations);
}

void Report(const LutArguments& arguments, Laser laser, const std::filesystem::path& file,
            const rangefinder::Calibration& calibration) {
  const rangefinder::CalibrationReport& report = calibration.report;
  const rangefinder::LookUpTable& table = calibration.table;
  if (arguments.json) {
    const Json line = {{"laser", Name(laser)},
                       {"file", file.string()},
                       {"first_distance_m", table.first_distance_m},
                       {"last_distance_m", table.last_distance_m()},
                       {"distances", table.distances},
                       {"frames", table.frames},
                       {"rms_residual_px", report.rms_residual_px},
                       {"rms_residual_at_1m_mm", 1000.0 * report.rms_residual_at_1m_m},
                       {"worst_line", report.worst_line},
                       {"worst_line_rms_px", report.worst_line_rms_px},
                       {"missing", report.missing},
                       {"reversed", report.reversed}};
    std::cout << line.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
    return;
  }
  std::cout << file.string() << ": " << Name(laser) << " laser, " << table.distances
            << " distances from " << table.first_distance_m << " to " << table.last_distance_m()
            << " m, " << table.frames
            << " frames each\n  rms residual of dh = A/z - k: " << report.rms_residual_px << " px, "
            << 1000.0 * report.rms_residual_at_1m_m << " mm at 1 m; worst line "
            << report.worst_line << ": " << report.worst_line_rms_px << " px\n  " << report.missing
            << " entries without a stripe, " << report.reversed
            << " left out because the stripe moved the wrong way\n";
}

int CalibrateLut(const LutArguments& arguments) {
  const auto fail = [](const std::string& message) {
    std::cerr << "geon calibrate lut: " << message << "\n";
    return kFailed;
  };
  std::error_code error;
  std::filesystem::create_directories(arguments.output, error);
  if (error) return fail(arguments.output + ": cannot create: " + error.message());
  for (const Laser laser : {Laser::kHorizontal, Laser::kVertical}) {
    const Result<rangefinder::Calibration> calibration = Calibrate(arguments, laser);
    if (!calibration.ok()) {
      return fail(Name(laser) + " laser: " + calibration.message());
    }
    const std::filesystem::path file =
        std::filesystem::path(arguments.output) / (Name(laser) + ".lut");
    const Status written =
        config::WriteFileAtomically(file, rangefinder::SerializeLookUpTable(calibration->table));
    if (!written.ok()) return fail(written.message());
    Report(arguments, laser, file, *calibration);
  }
  return kOk;
}

}  // namespace

void AddCalibrateLutCommand(CLI::App* calibrate, int* exit_code) {
  auto arguments = std::make_shared<LutArguments>();
  CLI::App* command =
      calibrate->add_subcommand("lut",
                                "Builds the range finder's look-up tables (thesis 3.2) from a flat "
                                "board across the B/W camera's "
                                "axis: before the simulated robot, or from recorded frames.");
  command->add_option("-o", arguments->output, "Folder for horizontal.lut and vertical.lut")
      ->required();
  CLI::Option* frames = command->add_option(
      "--frames", arguments->frames_dir,
      "Folder of recorded frames; its frames.csv lists laser,distance_m,lit,unlit");
  command
      ->add_option("--laser-color", arguments->laser_color,
                   "Of recorded colour frames: red, green or mono")
      ->check(CLI::IsMember({"red", "green", "mono"}))
      ->needs(frames)
      ->capture_default_str();
  command->add_option("--config", arguments->simulated.robot_file, "Robot file, for the rig")
      ->excludes(frames)
      ->capture_default_str();
  AddSimulatedBoardArguments(*command, frames, &arguments->simulated);
  command->add_option("--date", arguments->date, "Written into the tables; default: today");
  command->add_flag("--json", arguments->json, "The report as JSON, one line a laser");
  command->callback([arguments, exit_code] {
    if (arguments->date.find_first_of("\r\n") != std::string::npos) {
      throw CLI::ValidationError("--date", "must be one line");
    }
    *exit_code = CalibrateLut(*arguments);
  });
}

}  // namespace geon::cli
