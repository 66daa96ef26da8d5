#include <chrono>
#include <iostream>
#include <memory>

#include "config/daemon_arguments.h"
#include "procs/geon/commands.h"
#include "procs/geon/experiment_color.h"
#include "procs/geon/experiment_color_page.h"
#include "procs/geon/experiment_commands.h"
#include "procs/geon/image_file.h"
#include "procs/geon/progress.h"

namespace geon::cli {
namespace {

constexpr const char* kTaught = "taught";

struct ColorArguments {
  ColorConditions conditions;
  std::string color = kTaught, shard = "1/1";
  std::filesystem::path output;
  int jobs = 1;
  bool json = false;
};

Result<attention::ColorModel> ChooseModel(const ColorArguments& arguments) {
  if (arguments.color != kTaught) return LoadColorModel(arguments.color);
  Progress progress("geon experiment color: teaching");
  return TeachOnScenes(arguments.conditions, [&](double share) { progress.Say(share); });
}

int RunColor(const ColorArguments& arguments) {
  const auto begin = std::chrono::steady_clock::now();
  const Result<attention::ColorModel> model = ChooseModel(arguments);
  if (!model.ok()) {
    std::cerr << "geon experiment color: " << model.message() << '\n';
    return kFailed;
  }
  Progress progress("geon experiment color");
  ColorRecord record = RunColorTrials(*model, arguments.conditions, ParseShard(arguments.shard),
                                      arguments.jobs, [&](double share) { progress.Say(share); });
  record.git = config::BuildVersion();
  record.conditions = {{"images", arguments.conditions.images},
                       {"lessons", arguments.conditions.lessons},
                       {"color", arguments.color}};
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  std::cerr << record.outcomes.size() << " pictures made and searched in " << seconds << " s\n";
  return Deliver(record, seconds, arguments.json, arguments.output);
}

}  // namespace

int Deliver(const ColorRecord& record, double seconds, bool json,
            const std::filesystem::path& output) {
  return DeliverText({ColorRecordText(record), ColorTables(record), ColorPage(record)}, seconds,
                     json, output);
}

void AddExperimentColorCommand(CLI::App& experiment, int* exit_code) {
  auto arguments = std::make_shared<ColorArguments>();
  CLI::App* command = experiment.add_subcommand(
      "color", "Finds a red geon by its colour in rendered pictures, whatever the light.");
  command->footer(
      "Examples:\n"
      "  geon experiment color --images 140 -o /tmp/color\n"
      "  geon experiment color --color super-red --jobs 2\n"
      "  geon experiment color --shard 1/4 -o /tmp/color/1");
  command->add_option("--seed", arguments->conditions.seed, "of the scenes and the noise")
      ->capture_default_str();
  command
      ->add_option("--images", arguments->conditions.images,
                   "pictures; 1400 hold every combination of light, geon and surroundings")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command
      ->add_option("--color", arguments->color,
                   "taught (on scenes of other seeds), super-red, thesis-lab, thesis-lab-sun, or a "
                   "file of geon teach")
      ->capture_default_str();
  AddSpreadArguments(*command, &arguments->shard, &arguments->jobs);
  command->add_option("-o,--output", arguments->output, "folder for results.json and report.html");
  command->add_flag("--json", arguments->json, "print results.json instead of the tables");
  command->callback([arguments, exit_code] { *exit_code = RunColor(*arguments); });
}

}  // namespace geon::cli
