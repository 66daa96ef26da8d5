#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "config/daemon_arguments.h"
#include "config/text_file.h"
#include "evaluation/background_scene.h"
#include "evaluation/point_counts.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"
#include "procs/geon/parallel_for.h"
#include "procs/geon/progress.h"
#include "recognition/label_points.h"

namespace geon::cli {
namespace {

using recognition::BackgroundMethod;

struct BackgroundArguments {
  uint64_t seed = 1;
  int scans = 600, jobs = 1;
  double baseline_mm = 62.5;
  bool json = false;
  std::filesystem::path output;
};

// How points are labelled, one row each of a scene's table.
struct Way {
  const char* name;
  BackgroundMethod method;
  bool colors;
};
constexpr std::array<Way, 3> kWays = {{{"thesis", BackgroundMethod::kThesis, false},
                                       {"fitted", BackgroundMethod::kFitted, false},
                                       {"fitted+color", BackgroundMethod::kFitted, true}}};
constexpr size_t kScenes = evaluation::kBackgroundScenes.size();

// A scan on which one in ten of the points that are called the target's are not, or as many lost.
constexpr double kPoor_f1 = 0.9;

struct SceneCell {
  int scans = 0;
  int poor = 0;
  evaluation::PointCounts points;
};
using SceneTable = std::array<std::array<SceneCell, kWays.size()>, kScenes>;

using TrialCounts = std::array<evaluation::PointCounts, kWays.size()>;

TrialCounts CountTrial(const evaluation::BackgroundTrial& trial) {
  TrialCounts counts;
  for (size_t w = 0; w < kWays.size(); ++w) {
    sensor::ScanSet scan = trial.labelled.scan;
    if (!kWays[w].colors) {
      for (sensor::RangeProfile& profile : scan.profiles) profile.on_color_1.clear();
    }
    recognition::BackgroundOptions options;
    options.method = kWays[w].method;
    const auto labels = recognition::FindTargetPoints(scan, options);
    for (size_t k = 0; k < labels.size(); ++k) {
      counts[w].Count(trial.labelled.on_object[k], labels[k]);
    }
  }
  return counts;
}

SceneTable CountPoints(const BackgroundArguments& arguments) {
  std::vector<TrialCounts> trials(static_cast<size_t>(arguments.scans));
  Progress progress("geon experiment background");
  // In pieces, between which it is said how far the work is.
  const int piece = 16 * arguments.jobs;
  for (int begin = 0; begin < arguments.scans; begin += piece) {
    progress.Say(static_cast<double>(begin) / arguments.scans);
    ParallelFor(arguments.jobs, std::min(piece, arguments.scans - begin), [&](int k) {
      const auto t = static_cast<size_t>(begin + k);
      trials[t] = CountTrial(
          evaluation::MakeBackgroundTrial(arguments.seed, t, 1e-3 * arguments.baseline_mm));
    });
  }
  SceneTable table;
  for (size_t t = 0; t < trials.size(); ++t) {
    for (size_t w = 0; w < kWays.size(); ++w) {
      SceneCell& cell = table[t % kScenes][w];  // MakeBackgroundTrial takes the scenes in turn
      ++cell.scans;
      if (trials[t][w].f1_1() < kPoor_f1) ++cell.poor;
      cell.points += trials[t][w];
    }
  }
  return table;
}

std::string SceneName(size_t scene) {
  return std::string(ToString(evaluation::kBackgroundScenes[scene]));
}

std::string SceneTableText(const SceneTable& table) {
  std::string text =
      "scene      labels        scans  target points   F1      lost %   strays %  scans below "
      "F1 0.9\n";
  for (size_t s = 0; s < kScenes; ++s) {
    for (size_t w = 0; w < kWays.size(); ++w) {
      const SceneCell& cell = table[s][w];
      const double all = std::max(1.0, static_cast<double>(cell.points.kept + cell.points.lost));
      char line[120];
      std::snprintf(line, sizeof line, "%-10s %-12s %6d %14lld   %.4f %8.2f %9.2f %8d\n",
                    SceneName(s).c_str(), kWays[w].name, cell.scans,
                    static_cast<long long>(cell.points.kept + cell.points.lost), cell.points.f1_1(),
                    100.0 * cell.points.lost_1(),
                    100.0 * static_cast<double>(cell.points.strays) / all, cell.poor);
      text += line;
    }
  }
  return text;
}

// Contract geon.experiment.v1; the same bytes for any number of jobs, hence no seconds.
std::string SceneRecordText(const BackgroundArguments& arguments, const SceneTable& table) {
  nlohmann::ordered_json record = {
      {"format", "geon.experiment.v1"},
      {"experiment", "background"},
      {"method", nullptr},
      {"seed", arguments.seed},
      {"git", config::BuildVersion()},
      {"conditions",
       {{"scans", arguments.scans}, {"baseline_mm", arguments.baseline_mm}, {"noise_px", 0.1}}},
      {"cells", nlohmann::ordered_json::array()}};
  nlohmann::ordered_json rates;
  for (size_t s = 0; s < kScenes; ++s) {
    for (size_t w = 0; w < kWays.size(); ++w) {
      const SceneCell& cell = table[s][w];
      record["cells"].push_back({{"scene", SceneName(s)},
                                 {"background", kWays[w].name},
                                 {"n", cell.scans},
                                 {"kept", cell.points.kept},
                                 {"lost", cell.points.lost},
                                 {"strays", cell.points.strays},
                                 {"poor", cell.poor}});
      rates[SceneName(s)][kWays[w].name] = {{"f1", cell.points.f1_1()},
                                            {"lost", cell.points.lost_1()}};
    }
  }
  record["rates"] = rates;
  record["seconds"] = nullptr;
  return record.dump(1) + "\n";
}

int RunBackgroundCommand(const BackgroundArguments& arguments) {
  const SceneTable table = CountPoints(arguments);
  const std::string record = SceneRecordText(arguments, table);
  std::cout << (arguments.json ? record : SceneTableText(table)) << std::flush;
  if (arguments.output.empty()) return kOk;
  std::error_code error;
  std::filesystem::create_directories(arguments.output, error);
  const std::filesystem::path file = arguments.output / "results.json";
  if (const Status written = config::WriteFileAtomically(file, record); !written.ok()) {
    std::cerr << "geon experiment background: " << written.message() << '\n';
    return kFailed;
  }
  std::cerr << "geon experiment background: wrote " << file.string() << '\n';
  return kOk;
}

}  // namespace

void AddExperimentBackgroundCommand(CLI::App& experiment, int* exit_code) {
  auto arguments = std::make_shared<BackgroundArguments>();
  CLI::App* command = experiment.add_subcommand(
      "background",
      "How well range points are told from floor, tiles, wall, box and a neighbour (section 5.1).");
  command->footer(
      "Random shapes, 0.7 to 2.0 m away, 0.1 px of noise; the robot leans by up to 3 degrees.\n"
      "Example: geon experiment background --scans 3000 --seed 7 --jobs 2 -o run/background");
  command->add_option("--scans", arguments->scans, "of all six scenes together")
      ->check(CLI::Range(static_cast<int>(kScenes), 10000000))
      ->capture_default_str();
  command->add_option("--baseline-mm", arguments->baseline_mm, "from the camera to a laser")
      ->check(CLI::Range(10.0, 500.0))
      ->capture_default_str();
  command->add_option("--seed", arguments->seed, "of shapes, scenes and noise")
      ->capture_default_str();
  command->add_option("--jobs", arguments->jobs, "scans made at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->output, "folder for results.json");
  command->add_flag("--json", arguments->json, "print results.json instead of the table");
  command->callback([arguments, exit_code] { *exit_code = RunBackgroundCommand(*arguments); });
}

}  // namespace geon::cli
