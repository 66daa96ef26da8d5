#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "config/text_file.h"
#include "procs/geon/commands.h"
#include "sim/random_world.h"
#include "sim/world_file.h"

namespace geon::cli {
namespace {

struct WorldArguments {
  uint64_t seed = 1;
  sim::GeonPlace place = sim::GeonPlace::kAny;
  int geons = 1;
  std::filesystem::path output;
  bool json = false;
};

// What was drawn: a line for every geon.
void Tell(const sim::World& world, const WorldArguments& arguments) {
  for (const sim::WorldObject& object : world.objects) {
    const auto label = sim::TrueLabel(object);
    if (!label) continue;
    const double foot_m = sim::FootHeight(world, object);
    if (arguments.json) {
      const nlohmann::json line = {{"file", arguments.output.string()},
                                   {"seed", arguments.seed},
                                   {"label", std::string(ToString(*label))},
                                   {"x_m", object.x_m},
                                   {"y_m", object.y_m},
                                   {"z_m", foot_m}};
      std::cout << line.dump() << '\n';
    } else {
      std::cout << arguments.output.string() << ": a " << ToString(*label)
                << (foot_m > 0.0 ? " on a box" : " on the floor") << ", "
                << world.objects.size() - static_cast<size_t>(arguments.geons)
                << " boxes in the pen\n";
    }
  }
}

int MakeWorld(const WorldArguments& arguments) {
  const sim::World world =
      sim::RandomWorldOfSeveral(arguments.seed, arguments.place, arguments.geons);
  const std::string count =
      arguments.geons == 1 ? "one geon" : std::to_string(arguments.geons) + " geons";
  const std::string text = "# geon world --seed " + std::to_string(arguments.seed) + ": " + count +
                           ", painted red, in a random pen.\n" + sim::WorldText(world);
  const Status written = config::WriteFileAtomically(arguments.output, text);
  if (!written.ok()) {
    std::cerr << "geon world: " << written.message() << '\n';
    return kFailed;
  }
  Tell(world, arguments);
  return kOk;
}

}  // namespace

void AddWorldCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<WorldArguments>();
  CLI::App* command = app.add_subcommand("world",
                                         "Makes a random world: a pen with geons the robot can "
                                         "reach. The same seed, the same file.");
  command->add_option("--seed", arguments->seed, "of the draw")->capture_default_str();
  const std::map<std::string, sim::GeonPlace> places = {{"floor", sim::GeonPlace::kFloor},
                                                        {"box", sim::GeonPlace::kBox},
                                                        {"any", sim::GeonPlace::kAny}};
  command->add_option("--on", arguments->place, "where the geon stands: floor, box (70 cm) or any")
      ->transform(CLI::CheckedTransformer(places, CLI::ignore_case));
  command->add_option("--geons", arguments->geons, "how many")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->output, "world file to write")->required();
  command->add_flag("--json", arguments->json, "tell what was drawn as one JSON object");
  command->footer(
      "Example: geon world --seed 7 --on box -o pen7.yaml && geon-sim --world pen7.yaml");
  command->callback([arguments, exit_code] { *exit_code = MakeWorld(*arguments); });
}

}  // namespace geon::cli
