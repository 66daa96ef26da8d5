#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/angles.h"
#include "calibration/calibrate_rig.h"
#include "config/calibrated_rig_file.h"
#include "config/daemon_arguments.h"
#include "config/rig_config.h"
#include "config/text_file.h"
#include "procs/geon/calibrate_commands.h"
#include "procs/geon/calibration_page.h"
#include "procs/geon/commands.h"
#include "procs/geon/progress_bar.h"
#include "procs/geon/rig_frames.h"
#include "procs/geon/simulated_rig_frames.h"
#include "procs/geon/svg.h"

namespace geon::cli {
namespace {

using Json = nlohmann::ordered_json;

struct RigArguments {
  std::string output;
  std::string report;
  std::string frames_dir;
  std::string save_dir;
  std::string robot_file = config::InstalledFile("scripts/config/robot.yaml").string();
  std::string sim_file = config::InstalledFile("scripts/config/sim.yaml").string();
  std::string date;
  std::vector<int> squares = {11, 8};
  double square_mm = 20.0;
  RigSweepOptions sweep;
  std::vector<int> poses = {5, 3};
  uint64_t seed = 1;
  bool json = false;
};

calibration::Chessboard BoardOf(const RigArguments& arguments) {
  return {arguments.squares[0] - 1, arguments.squares[1] - 1, 1e-3 * arguments.square_mm};
}

Result<RigSeries> OpenSeries(const RigArguments& arguments, const geometry::SensorRig& drawn) {
  if (!arguments.frames_dir.empty()) return RecordedRig(arguments.frames_dir);
  const Result<sim::SimOptions> options = sim::LoadSimOptions(arguments.sim_file);
  if (!options.ok()) return options.status();
  RigSweepOptions sweep = arguments.sweep;
  sweep.columns = arguments.poses[0];
  sweep.rows = arguments.poses[1];
  return SimulatedRig(drawn, *options, BoardOf(arguments), sweep, arguments.seed);
}

Result<calibration::RigObservations> Observe(const RigArguments& arguments,
                                             const geometry::SensorRig& drawn) {
  const Result<RigSeries> series = OpenSeries(arguments, drawn);
  if (!series.ok()) return series.status();
  std::optional<RigRecorder> recorder;
  if (!arguments.save_dir.empty()) {
    Result<RigRecorder> created = RigRecorder::Create(arguments.save_dir);
    if (!created.ok()) return created.status();
    recorder = *std::move(created);
  }
  calibration::RigObservations observations;
  observations.board = BoardOf(arguments);
  for (int k = 0; k < series->shots; ++k) {
    const Result<RigShot> shot = series->at(k);
    if (!shot.ok()) return shot.status();
    Status status = recorder ? recorder->Add(*shot) : Status::Ok();
    if (status.ok()) status = ObserveShot(*shot, drawn, &observations);
    if (!status.ok()) return status;
    ShowProgressBar("looking", k + 1, series->shots);
  }
  if (recorder) {
    const Status finished = recorder->Finish();
    if (!finished.ok()) return finished;
  }
  return observations;
}

Json JsonOf(const geometry::CalibratedRig& record, const calibration::RigCalibration& found,
            const RigArguments& arguments) {
  Json root = {{"format", "geon.rig_calibration.v1"},
               {"file", arguments.output.empty() ? Json() : Json(arguments.output)},
               {"date", record.date},
               {"stops", record.stops},
               {"views", record.views},
               {"baseline_scale", found.baseline_scale_1},
               {"residuals", Json::array()},
               {"range_sigmas", Json::array()},
               {"floor", nullptr},
               {"estimates", Json::array()}};
  for (const geometry::RigResidual& residual : record.residuals) {
    root["residuals"].push_back({{"what", residual.what},
                                 {"count", residual.count},
                                 {"rms_px", residual.rms_px},
                                 {"outliers", residual.outliers}});
  }
  for (const geometry::RigRangeSigma& range : record.range_sigmas) {
    root["range_sigmas"].push_back({{"laser", range.laser},
                                    {"distance_m", range.distance_m},
                                    {"sigma_mm", 1000.0 * range.sigma_m}});
  }
  if (found.floor) {
    root["floor"] = {{"points", found.floor->points},
                     {"rms_mm", 1000.0 * found.floor->rms_m},
                     {"pitch_deg", DegreesFromRadians(found.floor->pitch_rad)},
                     {"roll_deg", DegreesFromRadians(found.floor->roll_rad)},
                     {"height_mm", 1000.0 * found.floor->height_m}};
  }
  for (const geometry::RigEstimate& estimate : record.estimates) {
    root["estimates"].push_back({{"part", estimate.part},
                                 {"what", estimate.what},
                                 {"unit", estimate.unit},
                                 {"difference", estimate.difference},
                                 {"sigma", estimate.sigma},
                                 {"weak", estimate.weak}});
  }
  return root;
}

void Print(const geometry::CalibratedRig& record, const calibration::RigCalibration& found) {
  std::cout << record.views << " views of the board from " << record.stops << " stops\n";
  for (const geometry::RigResidual& residual : record.residuals) {
    std::cout << "  " << residual.what << ": " << residual.count << ", "
              << Fixed(residual.rms_px, 3) << " px rms, " << residual.outliers << " outliers\n";
  }
  std::cout << "range, one standard deviation of what is common to all points:\n";
  for (const geometry::RigRangeSigma& range : record.range_sigmas) {
    std::cout << "  " << range.laser << " laser at " << Fixed(range.distance_m, 1)
              << " m: " << Fixed(1000.0 * range.sigma_m, 2) << " mm\n";
  }
  if (found.floor) {
    std::cout << "floor: " << found.floor->points << " points, "
              << Fixed(1000.0 * found.floor->rms_m, 1) << " mm rms; the head stands "
              << Fixed(1000.0 * found.floor->height_m, 1) << " mm higher than drawn\n";
  } else {
    std::cout << "no pictures of the floor: where the head stands over it stays as drawn\n";
  }
  std::cout << WeakInWords(record) << "\n";
}

int CalibrateRigs(const RigArguments& arguments) {
  const auto fail = [](const Status& status) {
    std::cerr << "geon calibrate rig: " << status.message() << "\n";
    return kFailed;
  };
  const Result<geometry::SensorRig> drawn = LoadDrawing(arguments.robot_file);
  if (!drawn.ok()) return fail(drawn.status());
  const Result<calibration::RigObservations> observations = Observe(arguments, *drawn);
  if (!observations.ok()) return fail(observations.status());
  std::cerr << "fitting\n";
  const Result<calibration::RigCalibration> found =
      calibration::CalibrateRig(*observations, *drawn);
  if (!found.ok()) return fail(found.status());
  const geometry::CalibratedRig record =
      calibration::RecordOf(*found, arguments.date.empty() ? Today() : arguments.date);
  const Status plausible = config::CheckAgainstDrawing(record.rig, *drawn);
  if (!plausible.ok()) return fail(plausible);

  if (!arguments.output.empty()) {
    const Status written =
        config::WriteFileAtomically(arguments.output, config::SerializeCalibratedRig(record));
    if (!written.ok()) return fail(written);
  }
  if (!arguments.report.empty()) {
    const Status written = config::WriteFileAtomically(
        arguments.report, CalibrationPage(record, *found, *observations));
    if (!written.ok()) return fail(written);
  }
  if (arguments.json) {
    std::cout
        << JsonOf(record, *found, arguments).dump(-1, ' ', false, Json::error_handler_t::replace)
        << "\n";
  } else {
    Print(record, *found);
  }
  return kOk;
}

}  // namespace

void AddCalibrateRigCommand(CLI::App* calibrate, int* exit_code) {
  auto arguments = std::make_shared<RigArguments>();
  CLI::App* command = calibrate->add_subcommand(
      "rig",
      "Calibrates the whole rig - lenses, axes, laser planes, where the head stands - from one "
      "chessboard seen at many head poses from a few stops: before the simulated robot, or from "
      "recorded frames.");
  command->add_option("-o", arguments->output, "The rig file (geon.rig.v1) for rig.calibrated");
  command->add_option("--report", arguments->report, "A page that says how good it is (HTML)");
  CLI::Option* frames = command->add_option(
      "--frames", arguments->frames_dir,
      "Folder of recorded frames; its frames.csv lists "
      "stop,pan_deg,tilt_deg,camera,laser,exposure_s,file (docs/calibration.md)");
  command->add_option("--squares", arguments->squares, "Of the board, along its sides")
      ->expected(2)
      ->delimiter('x')
      ->check(CLI::Range(4, 60))
      ->capture_default_str();
  command->add_option("--square-mm", arguments->square_mm, "Side of a square, as measured")
      ->check(CLI::Range(2.0, 500.0))
      ->capture_default_str();
  command->add_option("--config", arguments->robot_file, "Robot file, for the rig as drawn")
      ->capture_default_str();
  const auto simulated = [&](CLI::Option* option) {
    option->excludes(frames)->capture_default_str();
  };
  simulated(
      command->add_option("--sim-config", arguments->sim_file, "What the simulated robot is like"));
  simulated(command->add_option("--seed", arguments->seed, "Of the frames' noise"));
  simulated(command->add_option("--stops", arguments->sweep.stops, "Of the robot, 0.8 to 1.8 m off")
                ->check(CLI::Range(1, 20)));
  simulated(
      command->add_option("--poses", arguments->poses, "Of the head at each stop: pans x tilts")
          ->expected(2)
          ->delimiter('x')
          ->check(CLI::Range(1, 20)));
  simulated(command
                ->add_option("--exposure-s", arguments->sweep.exposure_s,
                             "Of the B/W frames that show the board")
                ->check(CLI::Range(0.001, 2.0)));
  simulated(command->add_option("--save-frames", arguments->save_dir,
                                "Write the frames into this folder, as --frames reads them"));
  command->add_option("--date", arguments->date, "Written into the file; default: today");
  command->add_flag("--json", arguments->json, "One JSON object (geon.rig_calibration.v1)");
  command->footer(
      "Examples:\n"
      "  geon calibrate rig -o rig.yaml --report rig.html\n"
      "  geon calibrate rig --frames recorded/ --squares 11x8 --square-mm 20.05 -o rig.yaml");
  command->callback([arguments, exit_code] {
    if (arguments->date.find_first_of("\"\\\r\n") != std::string::npos) {
      throw CLI::ValidationError("--date", "must be one line without quotes");
    }
    *exit_code = CalibrateRigs(*arguments);
  });
}

}  // namespace geon::cli
