#include "procs/geon/worst_views.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "recognition/label_points.h"
#include "recognition/remove_background.h"

namespace geon::cli {
namespace {

constexpr size_t kMostPoints = 90;  // of a drawn stripe
constexpr int kGap_px = 3;          // so many pixels without a point break a stripe
constexpr double kStep_m = 0.02;  // so does a step in depth, larger than between neighbours aslant
constexpr double kTenthsOfMm_m = 1e4;  // in a metre

bool IsWorse(const WorstView& a, const WorstView& b) {
  if (a.right != b.right) return !a.right;
  if (a.confidence_1 != b.confidence_1) return (a.confidence_1 > b.confidence_1) == !a.right;
  return a.t < b.t;
}

using Piece = std::vector<Eigen::Vector3i>;

// Every n-th point, and the last.
Piece Thinned(const std::vector<Eigen::Vector3d>& points_m, size_t n) {
  Piece piece;
  for (size_t i = 0; i < points_m.size(); ++i) {
    if (i % n != 0 && i + 1 != points_m.size()) continue;
    piece.emplace_back((kTenthsOfMm_m * points_m[i]).array().round().matrix().cast<int>());
  }
  return piece;
}

DrawnStripe DrawStripe(const sensor::RangeProfile& profile, const sensor::ScanSet& scan) {
  DrawnStripe stripe{profile.laser, profile.fraction, {}};
  const size_t n = profile.pixel.size() / kMostPoints + 1;
  std::vector<Eigen::Vector3d> piece_m;
  int last_px = 0;
  for (size_t i = 0; i < profile.pixel.size(); ++i) {
    const Eigen::Vector3d p_B_m =
        scan.rotation_LB.transpose() * (profile.p_L_m[i] - scan.camera_position_L_m);
    const bool broken = !piece_m.empty() && (profile.pixel[i] - last_px > kGap_px ||
                                             std::abs(p_B_m.z() - piece_m.back().z()) > kStep_m);
    if (broken) stripe.pieces.push_back(Thinned(std::exchange(piece_m, {}), n));
    piece_m.push_back(p_B_m);
    last_px = profile.pixel[i];
  }
  if (!piece_m.empty()) stripe.pieces.push_back(Thinned(piece_m, n));
  return stripe;
}

nlohmann::json StripeJson(const DrawnStripe& stripe) {
  nlohmann::json pieces = nlohmann::json::array();
  for (const Piece& piece : stripe.pieces) {
    nlohmann::json numbers = nlohmann::json::array();
    for (const Eigen::Vector3i& p : piece) {
      for (const int number : p) numbers.push_back(number);
    }
    pieces.push_back(std::move(numbers));
  }
  return {{"laser", ToString(stripe.laser)},
          {"fraction", stripe.fraction_1},
          {"pieces_tenth_mm", std::move(pieces)}};
}

DrawnStripe ParseStripe(const nlohmann::json& value) {
  DrawnStripe stripe;
  const std::string laser = value.at("laser");
  for (const auto known : {sensor::Laser::kHorizontal, sensor::Laser::kVertical}) {
    if (laser == ToString(known)) stripe.laser = known;
  }
  if (laser != ToString(stripe.laser)) throw std::runtime_error("no laser " + laser);
  stripe.fraction_1 = value.at("fraction");
  for (const auto& numbers : value.at("pieces_tenth_mm")) {
    if (numbers.size() % 3 != 0) throw std::runtime_error("a stripe's point without x, y or z");
    Piece piece;
    for (size_t i = 0; i < numbers.size(); i += 3) {
      piece.emplace_back(numbers[i].get<int>(), numbers[i + 1].get<int>(),
                         numbers[i + 2].get<int>());
    }
    stripe.pieces.push_back(std::move(piece));
  }
  return stripe;
}

}  // namespace

bool IsAmongWorst(const WorstView& view, const std::vector<WorstView>& worst) {
  if (!worst.empty() && view.right != worst.front().right) return !view.right;
  return worst.size() < kMostWorstViews || IsWorse(view, worst.back());
}

void AddWorstView(WorstView view, std::vector<WorstView>* worst) {
  if (!IsAmongWorst(view, *worst)) return;
  if (!worst->empty() && worst->front().right != view.right) worst->clear();
  const auto place = std::upper_bound(worst->begin(), worst->end(), view, IsWorse);
  worst->insert(place, std::move(view));
  if (worst->size() > kMostWorstViews) worst->pop_back();
}

std::vector<DrawnStripe> DrawStripes(const sensor::ScanSet& scan) {
  const std::vector<std::vector<bool>> on_target = recognition::FindTargetPoints(scan, {});
  std::vector<DrawnStripe> stripes;
  for (size_t k = 0; k < scan.profiles.size(); ++k) {
    stripes.push_back(
        DrawStripe(recognition::RemoveBackground(scan.profiles[k], on_target[k]), scan));
  }
  return stripes;
}

nlohmann::json ToJson(const WorstView& view) {
  nlohmann::json posterior, stripes = nlohmann::json::array();
  for (size_t k = 0; k < view.posterior.size(); ++k) {
    posterior[std::string(kGeonLabelNames[k])] = view.posterior[k];
  }
  for (const DrawnStripe& stripe : view.stripes) stripes.push_back(StripeJson(stripe));
  nlohmann::json json = {{"t", view.t},
                         {"posterior", std::move(posterior)},
                         {"reasons", view.reasons},
                         {"stripes", std::move(stripes)}};
  if (!view.picture_uri.empty()) json["picture"] = view.picture_uri;
  return json;
}

WorstView ParseWorstView(const nlohmann::json& value) {
  WorstView view;
  view.t = value.at("t");
  for (size_t k = 0; k < view.posterior.size(); ++k) {
    view.posterior[k] = value.at("posterior").at(std::string(kGeonLabelNames[k]));
  }
  view.reasons = value.at("reasons").get<std::vector<std::string>>();
  for (const auto& stripe : value.at("stripes")) view.stripes.push_back(ParseStripe(stripe));
  view.picture_uri = value.value("picture", "");
  return view;
}

}  // namespace geon::cli
