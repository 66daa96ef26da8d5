#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "evaluation/open_thresholds.h"
#include "evaluation/random_scan.h"
#include "evaluation/threshold_search.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_commands.h"
#include "procs/geon/recognition_arguments.h"

namespace geon::cli {
namespace {

struct TuneArguments {
  RecognitionArguments recognition;
  evaluation::ThresholdSearchOptions search;
  std::vector<std::string> settings;  // NAME=VALUE
  int scans = 1200, held_out = 4000;
  bool json = false;
};

std::vector<sensor::ScanSet> MakeScans(uint64_t seed, int count) {
  std::vector<sensor::ScanSet> scans;
  for (int t = 0; t < count; ++t) {
    scans.push_back(evaluation::MakeRandomScan(seed, static_cast<uint64_t>(t)).scan);
  }
  return scans;
}

// Sets one threshold as in "samples=90"; false when there is no such threshold or no number.
bool SetThreshold(const std::string& setting, recognition::RecognitionOptions* options) {
  const size_t sign = setting.find('=');
  double value = 0.0;
  if (sign == std::string::npos || !CLI::detail::lexical_cast(setting.substr(sign + 1), value)) {
    return false;
  }
  for (const evaluation::Threshold& threshold : evaluation::OpenThresholds(options->curvature)) {
    if (threshold.name != setting.substr(0, sign)) continue;
    threshold.set(options, value);
    return true;
  }
  return false;
}

std::string Percent(const evaluation::SuccessRate& rate) {
  const evaluation::Interval interval = evaluation::WilsonInterval(rate);
  char text[80];
  std::snprintf(text, sizeof text, "%.1f %% of %d (95 %%: %.1f-%.1f)", 100.0 * rate.value_1(),
                rate.n, 100.0 * interval.low_1, 100.0 * interval.high_1);
  return text;
}

int Tune(const TuneArguments& arguments) {
  recognition::RecognitionOptions defaults = ToOptions(arguments.recognition);
  defaults.method = recognition::Method::kThesis;  // the forest has no thresholds
  recognition::RecognitionOptions start = defaults;
  for (const std::string& setting : arguments.settings) {
    if (SetThreshold(setting, &start)) continue;
    std::cerr << "geon experiment tune: no threshold or no number in '" << setting << "'\n";
    return kUsage;
  }
  // Seeds 2 s and 2 s + 1: what one seed tunes on, no seed tests on.
  const uint64_t training_seed = 2 * arguments.search.seed;
  evaluation::ThresholdSearchResult found{start, {}};
  if (arguments.search.draws + arguments.search.steps > 0) {
    std::cerr << "making " << arguments.scans << " scans to search with\n";
    found = evaluation::SearchThresholds(
        MakeScans(training_seed, arguments.scans), start, arguments.search,
        [](int step, const evaluation::SuccessRate& best) {
          std::cerr << "step " << step << ": " << Percent(best) << '\n';
        });
  }
  const std::vector<sensor::ScanSet> held_out = MakeScans(training_seed + 1, arguments.held_out);
  const evaluation::SuccessRate before = evaluation::RecognitionRate(held_out, defaults);
  const evaluation::SuccessRate after = evaluation::RecognitionRate(held_out, found.options);
  nlohmann::json thresholds;
  for (const evaluation::Threshold& threshold : evaluation::OpenThresholds(start.curvature)) {
    thresholds[threshold.name] = {threshold.get(defaults), threshold.get(found.options)};
    if (arguments.json) continue;
    std::printf("%-20s %8.4g -> %8.4g\n", threshold.name.c_str(), threshold.get(defaults),
                threshold.get(found.options));
  }
  if (arguments.json) {
    std::cout << nlohmann::json{{"thresholds", thresholds},
                                {"training", found.training.value_1()},
                                {"held_out_before", before.value_1()},
                                {"held_out_after", after.value_1()},
                                {"held_out_n", after.n}}
                     .dump()
              << '\n';
    return kOk;
  }
  std::printf("scans searched with: %s\nother scans, before:  %s\nother scans, after:   %s\n",
              Percent(found.training).c_str(), Percent(before).c_str(), Percent(after).c_str());
  return kOk;
}

}  // namespace

void AddExperimentTuneCommand(CLI::App& experiment, int* exit_code) {
  auto arguments = std::make_shared<TuneArguments>();
  CLI::App* command =
      experiment.add_subcommand("tune",
                                "Searches the thresholds that the thesis leaves open on scans of "
                                "random shapes, and tells the "
                                "rate on others. Changes nothing: the defaults are in the source.");
  AddRecognitionArguments(*command, &arguments->recognition);
  command->add_option("--seed", arguments->search.seed, "of shapes, scans and search")
      ->capture_default_str();
  command->add_option("--scans", arguments->scans, "to search with")
      ->check(CLI::Range(4, 1000000))
      ->capture_default_str();
  command->add_option("--held-out", arguments->held_out, "scans that tell the rate")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--draws", arguments->search.draws, "of all thresholds at random")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command->add_option("--steps", arguments->search.steps, "from the best towards a better one")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command->add_option("--set", arguments->settings,
                      "NAME=VALUE: start from this; with --draws 0 --steps 0 its effect is told");
  command->add_flag("--json", arguments->json, "print one JSON object");
  command->callback([arguments, exit_code] { *exit_code = Tune(*arguments); });
}

}  // namespace geon::cli
