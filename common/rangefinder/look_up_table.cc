#include "rangefinder/look_up_table.h"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace geon::rangefinder {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Status CheckObservations(int lines, const std::vector<BoardObservation>& observations) {
  if (observations.size() < 2) return Status::Error("a calibration needs at least two distances");
  const double step_m = observations[1].distance_m - observations[0].distance_m;
  if (!(observations[0].distance_m > 0.0) || !(step_m > 0.0)) {
    return Status::Error("distances must be positive and listed from near to far");
  }
  for (size_t k = 0; k < observations.size(); ++k) {
    const double expected_m = observations[0].distance_m + static_cast<double>(k) * step_m;
    if (!(std::abs(observations[k].distance_m - expected_m) < 0.01 * step_m)) {
      return Status::Error("steps must be equal: board " + std::to_string(k) + " is at " +
                           std::to_string(observations[k].distance_m) + " m, expected " +
                           std::to_string(expected_m) + " m");
    }
    if (static_cast<int>(observations[k].peaks.size()) != lines) {
      return Status::Error("board " + std::to_string(k) + " has " +
                           std::to_string(observations[k].peaks.size()) + " lines, expected " +
                           std::to_string(lines));
    }
  }
  return Status::Ok();
}

// Takes out what moves against the run of the line, so that every position means one distance.
int DropReversed(double* line, int distances) {
  int first = 0;
  while (first < distances && std::isnan(line[first])) ++first;
  int last = distances - 1;
  while (last > first && std::isnan(line[last])) --last;
  if (first >= last) return 0;
  const double direction = line[last] > line[first] ? 1.0 : -1.0;
  int dropped = 0;
  double previous_px = line[first];
  for (int k = first + 1; k <= last; ++k) {
    if (std::isnan(line[k])) continue;
    if (direction * (line[k] - previous_px) > 0.0) {
      previous_px = line[k];
    } else {
      line[k] = kNone;
      ++dropped;
    }
  }
  return dropped;
}

struct HyperbolaFit {
  double rms_px = 0.0;
  double px_per_inverse_m = 0.0;  // A of (3.9), times the focal length in pixels
  int points = 0;
};

// Equation 3.9, position = A / z - k, by least squares: linear in A and k.
HyperbolaFit FitHyperbola(const LookUpTable& table, int line) {
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  HyperbolaFit fit;
  const auto each = [&](const auto& use) {
    for (int k = 0; k < table.distances; ++k) {
      const double position_px = table.PositionAt(line, k);
      if (std::isnan(position_px)) continue;
      use(Eigen::Vector2d(1.0 / (table.first_distance_m + table.step_m * k), 1.0), position_px);
    }
  };
  each([&](const Eigen::Vector2d& row, double position_px) {
    normal += row * row.transpose();
    right += row * position_px;
    ++fit.points;
  });
  if (fit.points < 2) return fit;
  const Eigen::Vector2d solution = normal.inverse() * right;
  double square_sum = 0.0;
  each([&](const Eigen::Vector2d& row, double position_px) {
    const double residual_px = position_px - row.dot(solution);
    square_sum += residual_px * residual_px;
  });
  fit.rms_px = std::sqrt(square_sum / fit.points);
  fit.px_per_inverse_m = solution.x();
  return fit;
}

// Fills in the residuals; the first line with fewer than two points is the error.
Status Judge(const LookUpTable& table, CalibrationReport* report) {
  double square_sum_px2 = 0.0;
  double square_sum_m2 = 0.0;
  int points = 0;
  for (int line = 0; line < table.lines(); ++line) {
    const HyperbolaFit fit = FitHyperbola(table, line);
    if (fit.points < 2) {
      return Status::Error("line " + std::to_string(line) +
                           " shows the stripe at fewer than two distances");
    }
    const double at_1m_m = fit.rms_px / std::abs(fit.px_per_inverse_m);
    square_sum_px2 += fit.points * fit.rms_px * fit.rms_px;
    square_sum_m2 += fit.points * at_1m_m * at_1m_m;
    points += fit.points;
    if (fit.rms_px > report->worst_line_rms_px) {
      report->worst_line_rms_px = fit.rms_px;
      report->worst_line = line;
    }
  }
  report->rms_residual_px = std::sqrt(square_sum_px2 / points);
  report->rms_residual_at_1m_m = std::sqrt(square_sum_m2 / points);
  return Status::Ok();
}

}  // namespace

std::optional<double> LookUpTable::Distance(int line, double wanted_px) const {
  Require(line >= 0 && line < lines(), "LookUpTable: no line " + std::to_string(line));
  const double* positions_px =
      position_px.data() + static_cast<size_t>(line) * static_cast<size_t>(distances);
  int previous = -1;
  for (int k = 0; k < distances; ++k) {
    if (std::isnan(positions_px[k])) continue;
    if (previous >= 0) {
      const double share =
          (wanted_px - positions_px[previous]) / (positions_px[k] - positions_px[previous]);
      if (share >= 0.0 && share <= 1.0) {
        return first_distance_m + step_m * (previous + share * (k - previous));
      }
    }
    previous = k;
  }
  return std::nullopt;
}

Result<Calibration> BuildLookUpTable(sensor::Laser laser, int width_px, int height_px, int frames,
                                     const std::string& date,
                                     const std::vector<BoardObservation>& observations,
                                     const CalibrationOptions& options) {
  Calibration calibration;
  LookUpTable& table = calibration.table;
  table.laser = laser;
  table.date = date;
  table.width_px = width_px;
  table.height_px = height_px;
  table.frames = frames;
  const Status checked = CheckObservations(table.lines(), observations);
  if (!checked.ok()) return checked;

  table.distances = static_cast<int>(observations.size());
  table.first_distance_m = observations.front().distance_m;
  table.step_m = observations[1].distance_m - observations[0].distance_m;
  const auto entries = static_cast<size_t>(table.lines()) * observations.size();
  table.position_px.assign(entries, kNone);
  CalibrationReport& report = calibration.report;
  for (size_t k = 0; k < observations.size(); ++k) {
    for (size_t line = 0; line < observations[k].peaks.size(); ++line) {
      const StripePeak& peak = observations[k].peaks[line];
      if (peak.reason == PeakReason::kFound) {
        table.position_px[line * observations.size() + k] = peak.position_px;
      } else {
        ++report.missing;
      }
    }
  }
  for (int line = 0; line < table.lines(); ++line) {
    report.reversed +=
        DropReversed(table.position_px.data() + static_cast<size_t>(line) * observations.size(),
                     table.distances);
  }
  const double lost = report.missing + report.reversed;
  if (lost > options.max_missing_fraction_1 * static_cast<double>(entries)) {
    return Status::Error(std::to_string(report.missing) + " of " + std::to_string(entries) +
                         " entries show no stripe and " + std::to_string(report.reversed) +
                         " move the wrong way: check that the board fills the view, stands still "
                         "and the light is dim");
  }
  const Status judged = Judge(table, &report);
  if (!judged.ok()) return judged;
  return calibration;
}

}  // namespace geon::rangefinder
