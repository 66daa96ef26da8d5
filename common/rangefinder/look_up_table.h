#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "rangefinder/stripe_peaks.h"
#include "sensor/stripe.h"

namespace geon::rangefinder {

// Where the stripe lies in every column (row) for a flat board at known distances.
//
// Source: thesis 3.2, figures 3.5-3.7: columns are calibrated each for itself, and neighbouring
// distances are joined by straight lines. Distances are along the optical axis, from the lens
// centre (errata to 3.10).
struct LookUpTable {
  sensor::Laser laser = sensor::Laser::kHorizontal;
  std::string date;  // of the calibration, YYYY-MM-DD
  int width_px = 0;  // of the camera's images
  int height_px = 0;
  int frames = 0;  // averaged at each distance
  double first_distance_m = 0.0;
  double step_m = 0.005;
  int distances = 0;
  // position_px[line * distances + k]: row (column) of the stripe in column (row) `line` with the
  // board at first_distance_m + k * step_m; NaN where none was measured. Strictly monotone in k for
  // a line.
  std::vector<double> position_px;

  int lines() const { return laser == sensor::Laser::kVertical ? height_px : width_px; }
  double last_distance_m() const { return first_distance_m + step_m * (distances - 1); }
  double PositionAt(int line, int k) const {
    return position_px[static_cast<size_t>(line) * static_cast<size_t>(distances) +
                       static_cast<size_t>(k)];
  }

  // Distance along the optical axis of a stripe seen at `wanted_px` in column (row) `line`;
  // nothing outside the calibrated range.
  std::optional<double> Distance(int line, double wanted_px) const;
};

// The board at one distance, as seen in the average of several frames.
struct BoardObservation {
  double distance_m = 0.0;
  std::vector<StripePeak> peaks;
};

struct CalibrationOptions {
  double max_missing_fraction_1 = 0.02;  // of all table entries; more is a bad set-up
};

// How good a calibration is: how well columns follow equation 3.9, dh = A/z - k, which the table
// itself does not assume.
struct CalibrationReport {
  double rms_residual_px = 0.0;
  double worst_line_rms_px = 0.0;
  int worst_line = 0;
  double rms_residual_at_1m_m = 0.0;  // the same as distance at 1 m
  int missing = 0;                    // entries without a stripe
  int reversed = 0;                   // entries left out because the stripe moved the wrong way
};

struct Calibration {
  LookUpTable table;
  CalibrationReport report;
};

// Builds the table from observations at equal steps, nearest first. Fails, saying where, when steps
// are uneven, too many entries are missing or reversed, or a column has fewer than two.
Result<Calibration> BuildLookUpTable(sensor::Laser laser, int width_px, int height_px, int frames,
                                     const std::string& date,
                                     const std::vector<BoardObservation>& observations,
                                     const CalibrationOptions& options = {});

// The file format geon.lut.v1: a text header (units in the keys, hash of the data), then 16-bit
// positions. Parsing is strict: any damage is an error that says what is wrong.
std::string SerializeLookUpTable(const LookUpTable& table);
Result<LookUpTable> ParseLookUpTable(const std::string& bytes);

}  // namespace geon::rangefinder
