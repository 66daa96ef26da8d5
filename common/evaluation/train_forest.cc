#include "evaluation/train_forest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/ml.hpp>
#include <sstream>

#include "base/contracts.h"
#include "evaluation/random_scan.h"
#include "evaluation/success_rate.h"
#include "evaluation/training_scan.h"
#include "evaluation/trial_random.h"
#include "recognition/measure_evidence.h"

namespace geon::evaluation {
namespace {

using recognition::ForestNode;

constexpr double kDecidedRight_1 = 0.999;  // of the decided answers to ordinary scans are right
constexpr int kFewestToSplit = 8;
constexpr int kTriedAtSplit = 100;  // measurements; the square root of all would be 21
constexpr int kTreesOfGroup = 10;
constexpr int kViewsOfShape = 4;
constexpr double kScansShare_1 = 0.5;  // of the time goes into making scans

struct Samples {
  cv::Mat values;  // a row a scan, float
  cv::Mat labels;  // int
};

Samples MakeRoom(int count) {
  Samples samples;
  const int columns = static_cast<int>(recognition::MeasureScan({}).values().size());
  samples.values.create(count, columns, CV_32F);
  samples.labels.create(count, 1, CV_32S);
  return samples;
}

void Measure(const sensor::ScanSet& scan, int row, Samples* samples) {
  const std::vector<float> values = recognition::MeasureScan(scan).values();
  std::copy(values.begin(), values.end(), samples->values.ptr<float>(row));
  samples->labels.at<int>(row) = static_cast<int>(scan.truth.value());
}

// The scans of shapes `first`, `first` + 1, ... of the seed, kViewsOfShape of each.
Samples MeasureScans(uint64_t first, int count, double share_1, uint64_t seed,
                     const ForEach& for_each) {
  Samples samples = MakeRoom(count);
  const int shapes = (count + kViewsOfShape - 1) / kViewsOfShape;
  for_each(share_1, shapes, [&](int shape) {
    int row = shape * kViewsOfShape;
    for (const sensor::ScanSet& scan :
         MakeTrainingScans(seed, first + static_cast<uint64_t>(shape), kViewsOfShape)) {
      if (row < count) Measure(scan, row++, &samples);
    }
  });
  return samples;
}

// What the robot usually gets to see (random_scan.h), with nothing wrong but its noise.
Samples MeasureOrdinaryScans(int count, double share_1, uint64_t seed, const ForEach& for_each) {
  Samples samples = MakeRoom(count);
  for_each(share_1, count, [&](int t) {
    Measure(MakeRandomScan(seed, static_cast<uint64_t>(t)).scan, t, &samples);
  });
  return samples;
}

// The forest in groups of kTreesOfGroup trees, each with random numbers of its own, so that they
// can grow side by side.
std::vector<cv::Ptr<cv::ml::RTrees>> Grow(Samples samples, const TrainingOptions& options,
                                          double share_1, const ForEach& for_each) {
  if (options.shuffle_labels) {
    cv::RNG random(options.seed);
    cv::randShuffle(samples.labels, 1.0, &random);
  }
  const int count = (options.trees + kTreesOfGroup - 1) / kTreesOfGroup;
  std::vector<cv::Ptr<cv::ml::RTrees>> groups(static_cast<size_t>(count));
  for_each(share_1, count, [&](int group) {
    const int trees = std::min(kTreesOfGroup, options.trees - group * kTreesOfGroup);
    const cv::Ptr<cv::ml::RTrees> forest = cv::ml::RTrees::create();
    forest->setMaxDepth(options.depth);
    forest->setMinSampleCount(kFewestToSplit);
    forest->setActiveVarCount(kTriedAtSplit);
    forest->setTermCriteria(cv::TermCriteria(cv::TermCriteria::MAX_ITER, trees, 0.0));
    // OpenCV's random numbers belong to the thread.
    cv::theRNG().state = TrialRandom(options.seed, static_cast<uint64_t>(group))();
    forest->train(cv::ml::TrainData::create(samples.values, cv::ml::ROW_SAMPLE, samples.labels));
    groups[static_cast<size_t>(group)] = forest;
  });
  return groups;
}

// The label that all leaves below a node share, or -1.
int OnlyLabel(const std::vector<cv::ml::DTrees::Node>& nodes, int node) {
  const cv::ml::DTrees::Node& from = nodes[static_cast<size_t>(node)];
  if (from.split < 0) return static_cast<int>(std::lround(from.value));
  const int left = OnlyLabel(nodes, from.left);
  return left >= 0 && left == OnlyLabel(nodes, from.right) ? left : -1;
}

// A tree of OpenCV's in our own layout: children side by side, and a leaf where all below agree.
int32_t CopyTree(const cv::ml::RTrees& trees, int root, OwnedForest* forest) {
  const std::vector<cv::ml::DTrees::Node>& from = trees.getNodes();
  const std::vector<cv::ml::DTrees::Split>& splits = trees.getSplits();
  const auto begin = static_cast<int32_t>(forest->nodes.size());
  forest->nodes.emplace_back();
  std::vector<std::pair<int, int32_t>> open = {{root, begin}};
  while (!open.empty()) {
    const auto [source, target] = open.back();
    open.pop_back();
    const cv::ml::DTrees::Node& node = from[static_cast<size_t>(source)];
    ForestNode copy;
    copy.child = OnlyLabel(from, source);
    if (copy.child < 0) {
      const cv::ml::DTrees::Split& split = splits[static_cast<size_t>(node.split)];
      copy.feature = static_cast<int16_t>(split.varIdx);
      copy.threshold = split.c;
      copy.child = static_cast<int32_t>(forest->nodes.size());
      forest->nodes.resize(forest->nodes.size() + 2);
      open.emplace_back(split.inversed ? node.right : node.left, copy.child);
      open.emplace_back(split.inversed ? node.left : node.right, copy.child + 1);
    }
    forest->nodes[static_cast<size_t>(target)] = copy;
  }
  return begin;
}

struct Answer {
  std::array<int, kGeonLabelCount> votes{};
  int truth = 0;
};

double LogLikelihood(const std::vector<Answer>& answers, double sharpness_1) {
  double sum = 0.0;
  for (const Answer& answer : answers) {
    sum += std::log(recognition::PosteriorOfVotes(answer.votes,
                                                  sharpness_1)[static_cast<size_t>(answer.truth)]);
  }
  return sum;
}

std::vector<Answer> Ask(const OwnedForest& forest, const Samples& samples) {
  std::vector<Answer> answers;
  for (int t = 0; t < samples.values.rows; ++t) {
    const std::span<const float> values(samples.values.ptr<float>(t),
                                        static_cast<size_t>(samples.values.cols));
    answers.push_back({recognition::CountVotes(forest.view(), values), samples.labels.at<int>(t)});
  }
  return answers;
}

double FitSharpness(const std::vector<Answer>& answers) {
  double best = -std::numeric_limits<double>::infinity(), best_1 = 1.0;
  for (double sharpness_1 = 0.5; sharpness_1 < 6.0; sharpness_1 += 0.05) {
    const double likelihood = LogLikelihood(answers, sharpness_1);
    if (likelihood <= best) continue;
    best = likelihood;
    best_1 = sharpness_1;
  }
  return best_1;
}

struct Confidence {
  double posterior_1 = 0.0;
  bool right = false;
};

std::vector<Confidence> Confidences(const std::vector<Answer>& answers, double sharpness_1) {
  std::vector<Confidence> confidences;
  for (const Answer& answer : answers) {
    const auto posterior = recognition::PosteriorOfVotes(answer.votes, sharpness_1);
    const auto most = std::max_element(posterior.begin(), posterior.end());
    confidences.push_back({*most, most - posterior.begin() == answer.truth});
  }
  return confidences;
}

// The least posterior from which on kDecidedRight_1 of the answers are right: with what is known
// from so many answers, not just in them.
double DecidedFrom(std::vector<Confidence> confidences) {
  std::sort(confidences.begin(), confidences.end(), [](const Confidence& a, const Confidence& b) {
    return a.posterior_1 > b.posterior_1 || (a.posterior_1 == b.posterior_1 && a.right < b.right);
  });
  double decided_1 = 1.0;
  SuccessRate rate;
  for (size_t k = 0; k < confidences.size(); ++k) {
    rate.Count(confidences[k].right);
    const bool last_of_equals =
        k + 1 == confidences.size() || confidences[k + 1].posterior_1 < confidences[k].posterior_1;
    if (last_of_equals && WilsonInterval(rate).low_1 >= kDecidedRight_1) {
      decided_1 = confidences[k].posterior_1;
    }
  }
  return decided_1;
}

TrainingReport Report(const std::vector<Confidence>& confidences, double decided_1) {
  TrainingReport report;
  report.calibration_scans = static_cast<int>(confidences.size());
  double right = 0.0, decided = 0.0, decided_right = 0.0;
  for (const Confidence& confidence : confidences) {
    right += confidence.right ? 1.0 : 0.0;
    if (confidence.posterior_1 < decided_1) continue;
    decided += 1.0;
    decided_right += confidence.right ? 1.0 : 0.0;
  }
  report.right_1 = right / report.calibration_scans;
  report.decided_1 = decided / report.calibration_scans;
  report.decided_right_1 = decided_right / std::max(decided, 1.0);
  return report;
}

}  // namespace

OwnedForest TrainForest(const TrainingOptions& options, const ForEach& for_each,
                        TrainingReport* report) {
  Require(options.scans >= 100 && options.calibration_scans >= 100,
          "training wants at least 100 scans to grow on and 100 to calibrate on");
  const double scan_share_1 = kScansShare_1 / (options.scans + 2 * options.calibration_scans);
  const Samples grown_on =
      MeasureScans(0, options.scans, scan_share_1 * options.scans, options.seed, for_each);
  const Samples calibration =
      MeasureScans(static_cast<uint64_t>(options.scans), options.calibration_scans,
                   scan_share_1 * options.calibration_scans, options.seed, for_each);
  const Samples ordinary = MeasureOrdinaryScans(
      options.calibration_scans, scan_share_1 * options.calibration_scans, options.seed, for_each);
  OwnedForest forest;
  forest.features = grown_on.values.cols;
  for (const cv::Ptr<cv::ml::RTrees>& trees :
       Grow(grown_on, options, 1.0 - kScansShare_1, for_each)) {
    for (int root : trees->getRoots()) forest.roots.push_back(CopyTree(*trees, root, &forest));
  }
  const std::vector<Answer> answers = Ask(forest, calibration);
  forest.sharpness_1 = FitSharpness(answers);
  forest.decided_1 = DecidedFrom(Confidences(Ask(forest, ordinary), forest.sharpness_1));
  *report = Report(Confidences(answers, forest.sharpness_1), forest.decided_1);
  return forest;
}

std::string ForestSource(const OwnedForest& forest, const TrainingOptions& options) {
  std::ostringstream text;
  text.precision(9);
  text << "// Made by `geon train --seed " << options.seed << " --scans " << options.scans
       << " --calibration-scans " << options.calibration_scans << " --trees " << options.trees
       << " --depth " << options.depth << "`; do not edit.\n"
       << "constexpr int kFeatures = " << forest.features << ";\n"
       << "constexpr double kSharpness_1 = " << forest.sharpness_1 << ";\n"
       << "constexpr double kDecided_1 = " << forest.decided_1 << ";\n"
       << "constexpr int32_t kRoots[] = {";
  for (size_t i = 0; i < forest.roots.size(); ++i) {
    text << (i % 16 == 0 ? "\n    " : " ") << forest.roots[i] << ',';
  }
  text << "};\nconstexpr ForestNode kNodes[] = {";
  for (size_t i = 0; i < forest.nodes.size(); ++i) {
    const ForestNode& node = forest.nodes[i];
    text << (i % 6 == 0 ? "\n" : "") << '{' << node.feature << ',' << node.child;
    if (node.feature >= 0)
      text << ',' << std::hexfloat << node.threshold << std::defaultfloat << 'F';
    text << "},";
  }
  text << "\n};\n";
  return text.str();
}

}  // namespace geon::evaluation
