#include "mission/target_track.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/contracts.h"

namespace geon::mission {

namespace {

constexpr double kStillSigma_rad = 0.008;  // of a ray: mounting, colour edge, odometry
constexpr double kMovingSigma_rad = 0.03;  // the head was turning
constexpr double kFloorSigma_rad = 0.012;  // the floor camera has large pixels
constexpr double kFootSigma_m = 0.05;      // the nearest point of a foot is another from each side
constexpr double kDriftSigma_m = 0.02;     // between two sightings
constexpr double kMaxSurprise_1 = 16.0;    // no single sighting decides everything
constexpr double kDecisive_1 = 9.0;        // difference of misfits that rules a height out
constexpr double kRefuted_1 = 100.0;
constexpr int kSurprisesToRestart = 4;  // in a row, by every height: the target is elsewhere

struct Foot {
  Eigen::Vector2d p_W_m;
  Eigen::Matrix2d covariance_m2;
};

// Where a ray meets the plane of a support, and how sure that is.
std::optional<Foot> FootOn(double support_height_m, const Eigen::Vector3d& p_WC,
                           const Eigen::Vector3d& ray_W, double sigma_rad, double max_distance_m) {
  const double above_m = p_WC.z() - support_height_m;
  if (above_m <= 0.0 || ray_W.z() >= 0.0) return std::nullopt;
  const Eigen::Vector2d along_m = (ray_W * (above_m / -ray_W.z())).head<2>();
  const double distance_m = along_m.norm();
  if (distance_m > max_distance_m || distance_m < 1e-3) return std::nullopt;
  const Eigen::Vector2d outward = along_m / distance_m;
  const Eigen::Vector2d across(-outward.y(), outward.x());
  const double outward_sigma_m =
      sigma_rad * (distance_m * distance_m + above_m * above_m) / above_m;
  const double across_sigma_m = sigma_rad * distance_m;
  const double foot_m2 = kFootSigma_m * kFootSigma_m;
  return Foot{p_WC.head<2>() + along_m,
              (outward_sigma_m * outward_sigma_m + foot_m2) * outward * outward.transpose() +
                  (across_sigma_m * across_sigma_m + foot_m2) * across * across.transpose()};
}

// One step of a Kalman filter of a thing that stands still; returns the squared normalised
// surprise. What surprises too much does not move the estimate.
double Update(const Foot& foot, SupportHypothesis* hypothesis) {
  if (hypothesis->sightings == 0) {
    hypothesis->sightings = 1;
    hypothesis->p_WFoot_m = foot.p_W_m;
    hypothesis->covariance_m2 = foot.covariance_m2;
    return 0.0;
  }
  Eigen::Matrix2d& P = hypothesis->covariance_m2;
  P += kDriftSigma_m * kDriftSigma_m * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d surprise_m = foot.p_W_m - hypothesis->p_WFoot_m;
  const Eigen::Matrix2d S_inverse = (P + foot.covariance_m2).inverse();
  const double surprise_1 = surprise_m.dot(S_inverse * surprise_m);
  if (surprise_1 >= kMaxSurprise_1) return surprise_1;
  ++hypothesis->sightings;
  const Eigen::Matrix2d gain = P * S_inverse;
  hypothesis->p_WFoot_m += gain * surprise_m;
  P = ((Eigen::Matrix2d::Identity() - gain) * P).eval();
  return surprise_1;
}

// Where it was thought to be speaks against a support; that it stands on it somewhere else, does
// not.
void Restart(const Foot& foot, SupportHypothesis* hypothesis) {
  hypothesis->sightings = hypothesis->surprises = 0;
  Update(foot, hypothesis);
}

}  // namespace

TargetTrack::TargetTrack(const LookingOptions& options, const geometry::SensorRig& rig)
    : options_(options), rig_(rig) {
  std::string error;
  Require(options.IsValid(&error), error);
  Clear();
}

void TargetTrack::Clear() {
  hypotheses_.clear();
  for (const double height_m : options_.support_heights_m) {
    hypotheses_.emplace_back().support_height_m = height_m;
  }
  surprises_ = 0;
}

void TargetTrack::See(const HeadSighting& sighting) {
  if (!sighting.seen.target || sighting.seen.touched.bottom) return;
  const auto& bottom_px = sighting.seen.bottom_px;
  Observe(sighting.X_WR * rig_.ColorCameraPose(sighting.head.pan_rad, sighting.head.tilt_rad),
          rig_.color_camera.Ray(bottom_px.x(), bottom_px.y()),
          sighting.still ? kStillSigma_rad : kMovingSigma_rad);
}

void TargetTrack::See(const FloorSighting& sighting) {
  if (sighting.seen.target && !sighting.seen.touched.bottom) {
    const auto& bottom_px = sighting.seen.bottom_px;
    Observe(sighting.X_WR * rig_.X_RF, rig_.floor_camera.Ray(bottom_px.x(), bottom_px.y()),
            kFloorSigma_rad);
  }
  RefuteDesksOverFreeFloor(sighting);
}

void TargetTrack::Observe(const geometry::RigidTransform& X_WC, const Eigen::Vector3d& ray_C,
                          double sigma_rad) {
  const Eigen::Vector3d ray_W = X_WC.linear() * ray_C;
  bool explained = false;
  for (SupportHypothesis& hypothesis : hypotheses_) {
    const auto foot = FootOn(hypothesis.support_height_m, X_WC.translation(), ray_W, sigma_rad,
                             options_.max_target_distance_m);
    const double surprise_1 = foot ? Update(*foot, &hypothesis) : kMaxSurprise_1;
    hypothesis.misfit_1 += std::min(surprise_1, kMaxSurprise_1);
    const bool fits = surprise_1 < kMaxSurprise_1;
    explained = explained || fits;
    hypothesis.surprises = fits ? 0 : hypothesis.surprises + 1;
    if (foot && hypothesis.surprises >= kSurprisesToRestart) Restart(*foot, &hypothesis);
  }
  surprises_ = explained ? 0 : surprises_ + 1;
  if (surprises_ >= kSurprisesToRestart) {
    Clear();
    Observe(X_WC, ray_C, sigma_rad);
  }
}

// A desk reaches at least to the foot of what stands on it: floor seen there means no desk.
void TargetTrack::RefuteDesksOverFreeFloor(const FloorSighting& sighting) {
  constexpr double kMargin_m = 0.15;
  const geometry::RigidTransform X_RW = sighting.X_WR.inverse();
  for (SupportHypothesis& hypothesis : hypotheses_) {
    if (hypothesis.sightings == 0 || hypothesis.support_height_m <= 0.0) continue;
    const Eigen::Vector3d foot_R =
        X_RW * Eigen::Vector3d(hypothesis.p_WFoot_m.x(), hypothesis.p_WFoot_m.y(), 0.0);
    const double bearing_rad = std::atan2(foot_R.y(), foot_R.x());
    for (size_t i = 1; i < sighting.columns.size(); ++i) {
      const Eigen::Vector2d& left_m = sighting.columns[i - 1].end_R_m;
      const Eigen::Vector2d& right_m = sighting.columns[i].end_R_m;
      if (std::atan2(left_m.y(), left_m.x()) < bearing_rad ||
          std::atan2(right_m.y(), right_m.x()) > bearing_rad) {
        continue;
      }
      const double free_m = std::min(left_m.norm(), right_m.norm());
      if (free_m > foot_R.head<2>().norm() + kMargin_m) hypothesis.misfit_1 += 0.6 * kDecisive_1;
      break;
    }
  }
}

void TargetTrack::Refute(double support_height_m) {
  double most_1 = 0.0;
  for (const SupportHypothesis& hypothesis : hypotheses_) {
    most_1 = std::max(most_1, hypothesis.misfit_1);
  }
  for (SupportHypothesis& hypothesis : hypotheses_) {
    if (hypothesis.support_height_m == support_height_m) hypothesis.misfit_1 = most_1 + kRefuted_1;
  }
}

const SupportHypothesis* TargetTrack::Best() const {
  const SupportHypothesis* best = nullptr;
  for (const SupportHypothesis& hypothesis : hypotheses_) {
    if (hypothesis.sightings == 0) continue;
    if (best == nullptr || hypothesis.misfit_1 < best->misfit_1) best = &hypothesis;
  }
  return best;
}

const SupportHypothesis* TargetTrack::NearestLikely(const Eigen::Vector2d& p_WRobot_m) const {
  const SupportHypothesis* best = Best();
  const SupportHypothesis* nearest = best;
  for (const SupportHypothesis& hypothesis : hypotheses_) {
    if (hypothesis.sightings == 0 || hypothesis.misfit_1 > best->misfit_1 + kDecisive_1) continue;
    if ((hypothesis.p_WFoot_m - p_WRobot_m).norm() < (nearest->p_WFoot_m - p_WRobot_m).norm()) {
      nearest = &hypothesis;
    }
  }
  return nearest;
}

}  // namespace geon::mission
