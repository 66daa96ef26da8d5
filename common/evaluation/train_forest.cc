#include "evaluation/train_forest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/ml.hpp>
#include <sstream>

#include "base/contracts.h"
#include "evaluation/random_scan.h"
#include "recognition/measure_evidence.h"
#include "recognition/recognize_geon.h"

namespace geon::evaluation {
namespace {

using recognition::ForestNode;

constexpr double kDecidedShare = 0.96;  // of the answers should count as decided
constexpr int kFewestToSplit = 12;
constexpr int kViewsOfShape = 4;

struct Samples {
  cv::Mat values;  // a row a scan, float
  cv::Mat labels;  // int
};

// Shapes `first`, `first` + 1, ... of the seed, until there are `count` scans.
Samples MeasureScans(uint64_t seed, uint64_t first, int count,
                     const std::function<void(double)>& progress) {
  Samples samples;
  samples.labels.create(count, 1, CV_32S);
  for (int row = 0; row < count;) {
    for (const RandomScan& made : MakeStressedScans(seed, first++, kViewsOfShape)) {
      if (row == count) break;
      const std::vector<float> values = recognition::MeasureScan(made.scan).values();
      if (row == 0) samples.values.create(count, static_cast<int>(values.size()), CV_32F);
      std::copy(values.begin(), values.end(), samples.values.ptr<float>(row));
      samples.labels.at<int>(row++) = static_cast<int>(made.shape.label);
    }
    progress(static_cast<double>(row) / count);
  }
  return samples;
}

cv::Ptr<cv::ml::RTrees> Grow(Samples samples, const TrainingOptions& options) {
  if (options.shuffle_labels) {
    cv::RNG random(options.seed);
    cv::randShuffle(samples.labels, 1.0, &random);
  }
  const cv::Ptr<cv::ml::RTrees> trees = cv::ml::RTrees::create();
  trees->setMaxDepth(options.depth);
  trees->setMinSampleCount(kFewestToSplit);
  trees->setActiveVarCount(0);  // the square root of all
  trees->setTermCriteria(cv::TermCriteria(cv::TermCriteria::MAX_ITER, options.trees, 0.0));
  cv::theRNG().state = options.seed * 2 + 1;
  trees->train(cv::ml::TrainData::create(samples.values, cv::ml::ROW_SAMPLE, samples.labels));
  return trees;
}

// A tree of OpenCV's in our own layout: children side by side.
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
    if (node.split < 0) {
      copy.child = static_cast<int32_t>(std::lround(node.value));
    } else {
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

void Calibrate(const Samples& samples, OwnedForest* forest, TrainingReport* report) {
  std::vector<Answer> answers;
  for (int t = 0; t < samples.values.rows; ++t) {
    const std::span<const float> values(samples.values.ptr<float>(t),
                                        static_cast<size_t>(samples.values.cols));
    answers.push_back({recognition::CountVotes(forest->view(), values), samples.labels.at<int>(t)});
  }
  double best = -std::numeric_limits<double>::infinity();
  for (double sharpness_1 = 0.5; sharpness_1 < 6.0; sharpness_1 += 0.05) {
    const double likelihood = LogLikelihood(answers, sharpness_1);
    if (likelihood <= best) continue;
    best = likelihood;
    forest->sharpness_1 = sharpness_1;
  }
  std::vector<std::pair<double, bool>> confidences;  // and whether right
  for (const Answer& answer : answers) {
    const auto posterior = recognition::PosteriorOfVotes(answer.votes, forest->sharpness_1);
    const auto most = std::max_element(posterior.begin(), posterior.end());
    confidences.emplace_back(*most, most - posterior.begin() == answer.truth);
  }
  std::sort(confidences.begin(), confidences.end());
  const auto n = static_cast<double>(confidences.size());
  forest->decided_1 = confidences[static_cast<size_t>((1.0 - kDecidedShare) * (n - 1.0))].first;
  double right = 0.0, decided = 0.0, decided_right = 0.0;
  for (const auto& [confidence, is_right] : confidences) {
    right += is_right ? 1.0 : 0.0;
    if (confidence < forest->decided_1) continue;
    decided += 1.0;
    decided_right += is_right ? 1.0 : 0.0;
  }
  *report = {static_cast<int>(n), right / n, decided / n, decided_right / decided};
}

}  // namespace

OwnedForest TrainForest(const TrainingOptions& options, const std::function<void(double)>& progress,
                        TrainingReport* report) {
  Require(options.scans >= 100 && options.calibration_scans >= 100,
          "training wants at least 100 scans to grow on and 100 to calibrate on");
  const double all = options.scans + options.calibration_scans;
  const double growing = options.scans / all;
  const Samples grown_on = MeasureScans(options.seed, 0, options.scans,
                                        [&](double part) { progress(0.8 * growing * part); });
  const Samples calibration =
      MeasureScans(options.seed, static_cast<uint64_t>(options.scans), options.calibration_scans,
                   [&](double part) { progress(0.8 * (growing + (1.0 - growing) * part)); });
  const cv::Ptr<cv::ml::RTrees> trees = Grow(grown_on, options);
  OwnedForest forest;
  forest.features = grown_on.values.cols;
  for (int root : trees->getRoots()) forest.roots.push_back(CopyTree(*trees, root, &forest));
  Calibrate(calibration, &forest, report);
  progress(1.0);
  return forest;
}

std::string ForestSource(const OwnedForest& forest, const TrainingOptions& options) {
  std::ostringstream text;
  text.precision(9);
  text << "// Made by `geon train --seed " << options.seed << " --scans " << options.scans
       << " --trees " << options.trees << "`; do not edit.\n"
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
