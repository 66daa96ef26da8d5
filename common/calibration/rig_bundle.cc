#include "calibration/rig_bundle.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <deque>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>

#include "base/median.h"
#include "calibration/rig_model.h"

namespace geon::calibration {
namespace {

using geometry::RigidTransform;
using geometry::SensorRig;

// A corner in a camera's picture: two residuals, in standard deviations.
struct CornerResidual {
  const geometry::PinholeCamera* camera;
  const RigidTransform* X_TC;
  Eigen::Vector3d p_Board_m;
  Eigen::Vector2d seen_px;
  const double* sigma_px;

  template <typename T>
  bool operator()(const T* lens, const T* mount, const T* axes, const T* angles, const T* board,
                  T* residual) const {
    const Vector3<T> p_P = Turned(board, Vector3<T>(p_Board_m.cast<T>())) + Vector3<T>(board + 3);
    const Vector3<T> p_C = PointInCamera(*X_TC, mount, PointInHead(axes, angles, p_P));
    const Eigen::Matrix<T, 2, 1> pixel = PixelOf(*camera, lens, p_C);
    residual[0] = (pixel[0] - seen_px[0]) / *sigma_px;
    residual[1] = (pixel[1] - seen_px[1]) / *sigma_px;
    return true;
  }
};

// A point of a stripe: how many standard deviations off the board it would have to be seen to lie
// in the fan. The height over the fan becomes pixels by the height of the next pixel's point.
struct StripeResidual {
  const SensorRig* drawn;
  const geometry::LaserMount* laser;
  LaserAxes axes_of_laser;
  Eigen::Vector2d seen_px;
  Eigen::Vector2d across_px;  // one pixel across the stripe
  const double* sigma_px;

  template <typename T>
  bool operator()(const T* lens, const T* mount, const T* axes, const T* angles, const T* board,
                  const T* fan, T* residual) const {
    const auto height = [&](const Eigen::Vector2d& pixel_px) {
      return HeightOverFan(*laser, axes_of_laser, fan,
                           BoardPointInHead(*drawn, lens, mount, axes, angles, board, pixel_px));
    };
    const T here = height(seen_px);
    residual[0] = here / ((height(seen_px + across_px) - here) * *sigma_px);
    return true;
  }
};

// A value near 0 within a standard deviation.
template <int kCount>
struct PriorResidual {
  std::array<double, kCount> middle;
  std::array<double, kCount> sigma;

  template <typename T>
  bool operator()(const T* values, T* residual) const {
    for (int k = 0; k < kCount; ++k) {
      const auto i = static_cast<size_t>(k);
      residual[k] = (values[k] - middle[i]) / sigma[i];
    }
    return true;
  }
};

// The board in P by the corners of one view, through the camera as drawn.
RigidTransform BoardByPnp(const Chessboard& board, const BoardView& view, const SensorRig& drawn) {
  std::vector<cv::Point3d> corners_m;
  std::vector<cv::Point2d> seen_1;
  for (int k = 0; k < board.corners(); ++k) {
    const Eigen::Vector3d corner_m = board.Corner(k);
    const Eigen::Vector2d& seen_px = view.stripe_corners_px[static_cast<size_t>(k)];
    const Eigen::Vector3d ray = drawn.stripe_camera.Ray(seen_px.x(), seen_px.y());
    corners_m.emplace_back(corner_m.x(), corner_m.y(), corner_m.z());
    seen_1.emplace_back(ray.x(), ray.y());
  }
  cv::Mat turn;
  cv::Mat position;
  cv::solvePnP(corners_m, seen_1, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), turn, position, false,
               cv::SOLVEPNP_IPPE);
  const Eigen::Vector3d turn_rad(turn.at<double>(0), turn.at<double>(1), turn.at<double>(2));
  const RigidTransform X_BBoard = geometry::MakeTransform(
      Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix(),
      {position.at<double>(0), position.at<double>(1), position.at<double>(2)});
  return drawn.X_RP.inverse() * drawn.StripeCameraPose(view.pan_rad, view.tilt_rad) * X_BBoard;
}

using BoardPose = std::array<double, 6>;
BoardPose PoseOf(const RigidTransform& X) {
  const Eigen::AngleAxisd turn(X.linear());
  const Eigen::Vector3d turn_rad = turn.angle() * turn.axis();
  const Eigen::Vector3d p = X.translation();
  return {turn_rad.x(), turn_rad.y(), turn_rad.z(), p.x(), p.y(), p.z()};
}
RigidTransform TransformOf(const BoardPose& pose) {
  const Eigen::Vector3d turn_rad(pose[0], pose[1], pose[2]);
  return geometry::MakeTransform(
      Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()).toRotationMatrix(),
      {pose[3], pose[4], pose[5]});
}

// The problem and all it points to.
class Adjustment {
 public:
  Adjustment(const RigObservations& observations, const SensorRig& drawn,
             const BundleOptions& options)
      : observations_(observations), drawn_(drawn), options_(options) {
    sigma_px_ = {options.corner_px, options.corner_px, options.stripe_px, options.stripe_px};
    for (const BoardView& view : observations.views)
      angles_.push_back({view.pan_rad, view.tilt_rad});
    PlaceBoards();
    AddPriors();
    for (size_t k = 0; k < observations.views.size(); ++k) AddView(k);
  }

  Status Solve() {
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_SCHUR;
    solver.max_num_iterations = options_.iterations;
    solver.function_tolerance = 1e-9;
    solver.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem_, &summary);
    if (summary.termination_type == ceres::CONVERGENCE) return Status::Ok();
    return Status::Error("the fit did not converge: " + summary.message +
                         "; are the pictures of one board, and the angles those of the pictures?");
  }

  // The noise of each kind, by its residuals; nothing else follows from it than their weights.
  void MeasureNoise() {
    for (size_t kind = 0; kind < kMeasurements; ++kind) {
      residuals_[kind] = {};
      std::vector<double> sizes_px;
      for (const ceres::ResidualBlockId id : blocks_[kind]) {
        std::array<double, 2> values{};
        problem_.EvaluateResidualBlock(id, false, nullptr, values.data(), nullptr);
        const bool corner = kind < 2;
        sizes_px.push_back(std::abs(values[0]) * sigma_px_[kind]);
        if (corner) sizes_px.push_back(std::abs(values[1]) * sigma_px_[kind]);
      }
      if (sizes_px.empty()) continue;
      constexpr double kMedianOfGaussian = 0.6745;
      Residuals& found = residuals_[kind];
      found.count = static_cast<int>(blocks_[kind].size());
      found.rms_px = Median(sizes_px) / kMedianOfGaussian;
      found.outliers =
          static_cast<int>(std::count_if(sizes_px.begin(), sizes_px.end(),
                                         [&](double size) { return size > 4.0 * found.rms_px; }));
    }
  }
  void WeighByNoise() {
    constexpr double kBestNoise_px = 0.005;  // no picture is better, though data without noise are
    for (size_t kind = 0; kind < kMeasurements; ++kind) {
      if (residuals_[kind].count > 0) {
        sigma_px_[kind] = std::max(kBestNoise_px, residuals_[kind].rms_px);
      }
    }
  }

  Result<Bundle> Finish() {
    Bundle bundle;
    bundle.unknowns = unknowns_;
    bundle.residuals = residuals_;
    for (const BoardPose& board : boards_) bundle.boards.push_back(TransformOf(board));
    ceres::Covariance::Options covariance_options;
    covariance_options.algorithm_type = ceres::SPARSE_QR;
    ceres::Covariance covariance(covariance_options);
    std::vector<const double*> all;
    for (size_t b = 0; b < RigUnknowns::kSize.size(); ++b) {
      all.push_back(unknowns_[static_cast<RigUnknowns::Block>(b)]);
    }
    if (!covariance.Compute(all, &problem_) ||
        !covariance.GetCovarianceMatrix(all, bundle.covariance.data())) {
      return Status::Error("the views do not hold every unknown; take more, from more stops");
    }
    return bundle;
  }

 private:
  void PlaceBoards() {
    for (const BoardView& view : observations_.views) {
      Require(view.stop >= 0, "AdjustRig: a stop is negative");
      boards_.resize(std::max(boards_.size(), static_cast<size_t>(view.stop) + 1));
    }
    std::vector<bool> placed(boards_.size(), false);
    for (const BoardView& view : observations_.views) {
      const auto stop = static_cast<size_t>(view.stop);
      if (placed[stop] || view.stripe_corners_px.empty()) continue;
      boards_[stop] = PoseOf(BoardByPnp(observations_.board, view, drawn_));
      placed[stop] = true;
    }
    Require(std::find(placed.begin(), placed.end(), false) == placed.end(),
            "AdjustRig: a stop without a view of the board");
  }

  template <int kCount>
  void AddPrior(double* values, const double* middle, const double* sigma) {
    auto* prior = new PriorResidual<kCount>();
    std::copy_n(middle, kCount, prior->middle.begin());
    std::copy_n(sigma, kCount, prior->sigma.begin());
    problem_.AddResidualBlock(
        new ceres::AutoDiffCostFunction<PriorResidual<kCount>, kCount, kCount>(prior), nullptr,
        values);
  }

  void AddPriors() {
    const auto sigmas = PriorSigmas(options_.tolerances, drawn_);
    const std::array<double, RigUnknowns::kAll> as_drawn{};
    for (size_t b = 0; b < RigUnknowns::kSize.size(); ++b) {
      const auto block = static_cast<RigUnknowns::Block>(b);
      const double* sigma = sigmas.data() + RigUnknowns::Offset(block);
      switch (RigUnknowns::kSize[b]) {
        case 2:
          AddPrior<2>(unknowns_[block], as_drawn.data(), sigma);
          break;
        case 3:
          AddPrior<3>(unknowns_[block], as_drawn.data(), sigma);
          break;
        default:
          AddPrior<6>(unknowns_[block], as_drawn.data(), sigma);
          break;
      }
    }
    const std::array<double, 2> encoder = {options_.ptu_rad, options_.ptu_rad};
    for (std::array<double, 2>& angles : angles_) {
      const std::array<double, 2> told = angles;
      AddPrior<2>(angles.data(), told.data(), encoder.data());
    }
  }

  void AddView(size_t k) {
    const BoardView& view = observations_.views[k];
    double* angles = angles_[k].data();
    double* board = boards_[static_cast<size_t>(view.stop)].data();
    AddCorners(view.stripe_corners_px, Measurement::kStripeCorners, &drawn_.stripe_camera,
               &drawn_.X_TB, RigUnknowns::kStripeLens, RigUnknowns::kStripeMount, angles, board);
    AddCorners(view.color_corners_px, Measurement::kColorCorners, &drawn_.color_camera,
               &drawn_.X_TC, RigUnknowns::kColorLens, RigUnknowns::kColorMount, angles, board);
    AddStripe(view.horizontal_px, Measurement::kHorizontalStripe, drawn_.horizontal_laser,
              RigUnknowns::kHorizontal, angles, board);
    AddStripe(view.vertical_px, Measurement::kVerticalStripe, drawn_.vertical_laser,
              RigUnknowns::kVertical, angles, board);
  }

  void AddCorners(const std::vector<Eigen::Vector2d>& corners_px, Measurement kind,
                  const geometry::PinholeCamera* camera, const RigidTransform* X_TC,
                  RigUnknowns::Block lens, RigUnknowns::Block mount, double* angles,
                  double* board) {
    const auto i = static_cast<size_t>(kind);
    for (size_t k = 0; k < corners_px.size(); ++k) {
      auto* cost = new ceres::AutoDiffCostFunction<CornerResidual, 2, 6, 6, 2, 2, 6>(
          new CornerResidual{camera, X_TC, observations_.board.Corner(static_cast<int>(k)),
                             corners_px[k], &sigma_px_[i]});
      blocks_[i].push_back(problem_.AddResidualBlock(cost, new ceres::CauchyLoss(kLossSigmas),
                                                     unknowns_[lens], unknowns_[mount],
                                                     unknowns_[RigUnknowns::kAxes], angles, board));
    }
  }

  void AddStripe(const std::vector<Eigen::Vector2d>& points_px, Measurement kind,
                 const geometry::LaserMount& laser, RigUnknowns::Block fan, double* angles,
                 double* board) {
    const auto i = static_cast<size_t>(kind);
    const Eigen::Vector2d across_px = kind == Measurement::kHorizontalStripe
                                          ? Eigen::Vector2d::UnitY()
                                          : Eigen::Vector2d::UnitX();
    const auto step = std::max<size_t>(
        1, points_px.size() / static_cast<size_t>(std::max(1, options_.stripe_points)));
    for (size_t k = 0; k < points_px.size(); k += step) {
      auto* cost =
          new ceres::AutoDiffCostFunction<StripeResidual, 1, 6, 6, 2, 2, 6, 3>(new StripeResidual{
              &drawn_, &laser, AxesOf(laser), points_px[k], across_px, &sigma_px_[i]});
      blocks_[i].push_back(problem_.AddResidualBlock(
          cost, new ceres::CauchyLoss(kLossSigmas), unknowns_[RigUnknowns::kStripeLens],
          unknowns_[RigUnknowns::kStripeMount], unknowns_[RigUnknowns::kAxes], angles, board,
          unknowns_[fan]));
    }
  }

  static constexpr double kLossSigmas = 3.0;

  const RigObservations& observations_;
  const SensorRig& drawn_;
  const BundleOptions& options_;
  ceres::Problem problem_;
  RigUnknowns unknowns_;
  std::vector<std::array<double, 2>> angles_;
  std::vector<BoardPose> boards_;
  std::array<double, kMeasurements> sigma_px_{};  // the residuals look here
  std::array<std::vector<ceres::ResidualBlockId>, kMeasurements> blocks_;
  std::array<Residuals, kMeasurements> residuals_;
};

}  // namespace

Result<Bundle> AdjustRig(const RigObservations& observations, const SensorRig& drawn,
                         const BundleOptions& options) {
  Adjustment adjustment(observations, drawn, options);
  Status solved = adjustment.Solve();
  if (!solved.ok()) return solved;
  adjustment.MeasureNoise();
  adjustment.WeighByNoise();
  solved = adjustment.Solve();
  if (!solved.ok()) return solved;
  adjustment.MeasureNoise();
  return adjustment.Finish();
}

}  // namespace geon::calibration
