#include "procs/geon/train_views_command.h"

#include <filesystem>
#include <iomanip>
#include <iostream>
#include <memory>
#include <string>

#include "config/text_file.h"
#include "evaluation/train_views.h"
#include "procs/geon/commands.h"
#include "procs/geon/training_jobs.h"

namespace geon::cli {
namespace {

using evaluation::ClusteredMean;
using evaluation::Interval;

struct TrainViewsArguments {
  evaluation::ViewTrainingOptions training;
  int jobs = 1;
  std::filesystem::path output;
};

void PrintShare(const std::string& name, const ClusteredMean& share) {
  const Interval interval = share.ShareInterval();
  std::cout << "  " << std::left << std::setw(44) << name << std::right << std::setw(6)
            << 100.0 * share.mean_1() << "   (" << 100.0 * interval.low_1 << " to "
            << 100.0 * interval.high_1 << ")\n";
}

void PrintReport(const char* shapes, const evaluation::ViewReport& report) {
  std::cout << "held out, " << shapes << ": " << report.looks << " first looks, "
            << report.undecided << " undecided, at " << report.first.clusters()
            << " shapes; right in %, and 95 % by shapes:\n";
  PrintShare("first look", report.first);
  PrintShare("two looks, the second by the table", report.table);
  PrintShare("two looks, 30 to 180 degrees apart at random", report.random);
  for (size_t k = 0; k < report.turned.size(); ++k) {
    const std::string degrees = std::to_string(30 * (k + 1));
    PrintShare("two looks, " + degrees + " degrees apart", report.turned[k]);
  }
  PrintShare("a third by the table where two do not decide", report.three);
  PrintShare("  so many of these answers are decided,", report.decided);
  PrintShare("  and right are of the decided ones", report.decided_right);
  const Interval nats = report.nats_more.MeanInterval(), right = report.right_more.MeanInterval();
  std::cout << std::showpos << std::setprecision(4)
            << "by the table instead of at random: " << report.nats_more.mean_1() << " nats ("
            << nats.low_1 << " to " << nats.high_1 << "), " << std::setprecision(2)
            << 100.0 * report.right_more.mean_1() << " % right (" << 100.0 * right.low_1 << " to "
            << 100.0 * right.high_1 << "): " << std::noshowpos << std::setprecision(1)
            << (nats.low_1 > 0.0 ? "the table tells more" : "not shown that the table tells more")
            << '\n';
}

int TrainViews(const TrainViewsArguments& arguments) {
  evaluation::ViewTrainingReport report;
  TrainingJobs jobs("geon train views", arguments.jobs);
  const active_vision::ViewTable table =
      evaluation::TrainViews(arguments.training, jobs.ForEach(), &report);
  const Status written = config::WriteFileAtomically(
      arguments.output, evaluation::ViewTableSource(table, arguments.training));
  if (!written.ok()) {
    std::cerr << "geon train views: " << written.message() << '\n';
    return kFailed;
  }
  std::cout << std::fixed << std::setprecision(2) << "weight of a view: " << table.fusion.weight_1
            << ", by " << report.weighted_by << " undecided looks\n"
            << "gains: by " << report.learned_from << " undecided looks\n"
            << std::setprecision(3) << "decided from: " << table.fusion.decided_1 << ", by "
            << report.decided_by << " undecided looks at ordinary shapes; more than "
            << std::setprecision(1) << 100.0 * report.decided_right_1
            << " % of the decided answers are right (lower end of Wilson's interval)\n";
  PrintReport("shapes of training", report.training);
  PrintReport("ordinary shapes", report.ordinary);
  return kOk;
}

}  // namespace

CLI::App* AddTrainViewsCommand(CLI::App& train, int* exit_code) {
  auto arguments = std::make_shared<TrainViewsArguments>();
  evaluation::ViewTrainingOptions& training = arguments->training;
  CLI::App* command = train.add_subcommand(
      "views", "Learns what another look from another side tells, and how to weigh several.");
  command->add_option("--seed", training.seed, "of shapes and scans")->capture_default_str();
  const auto add_shapes = [&](const char* name, int* shapes, const char* what) {
    command->add_option(name, *shapes, what)
        ->check(CLI::Range(10, 10000000))
        ->capture_default_str();
  };
  add_shapes("--shapes", &training.shapes, "to learn the gains from, each seen from 12 sides");
  add_shapes("--calibration-shapes", &training.calibration_shapes, "to fit a view's weight on");
  add_shapes("--ordinary-shapes", &training.ordinary_shapes,
             "to find out from when on an answer is decided");
  add_shapes("--held-out-shapes", &training.held_out_shapes,
             "of either kind, for the report; the table does not depend on it");
  command->add_option("--jobs", arguments->jobs, "shapes looked at at a time")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("-o,--output", arguments->output, "C++ source of the table")->required();
  command->footer(
      "Same options, same bytes, whatever the number of jobs. To use it: geon train views --jobs 2 "
      "-o common/active_vision/view_gain_table.inc, then build again.");
  command->callback([arguments, exit_code] { *exit_code = TrainViews(*arguments); });
  return command;
}

}  // namespace geon::cli
