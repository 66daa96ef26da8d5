#pragma once

#include <array>
#include <optional>
#include <span>

#include "evaluation/shape_experiment.h"
#include "evaluation/success_rate.h"

namespace geon::evaluation {

// The order of the columns in tables 6.1-6.7, which is also the order of the tables.
inline constexpr std::array<GeonLabel, kGeonLabelCount> kThesisColumns = {
    GeonLabel::kTaperedCuboid, GeonLabel::kTaperedCylinder, GeonLabel::kBentCuboid,
    GeonLabel::kBentCylinder,  GeonLabel::kCuboid,          GeonLabel::kCylinder,
    GeonLabel::kEllipsoid};

// What the thesis printed for an object in a position, in percent, by kThesisColumns.
//
// Source: thesis tables 6.1-6.7. Object 1, position 2 of the tapered cylinders reads 88 there where
// its row then sums to 120; 68 is used.
std::optional<std::array<int, kGeonLabelCount>> ThesisRow(const Subject& subject);

// The mean of the thesis's rows of these subjects, in percent, by GeonLabel; nothing when it lacks
// one of them.
std::optional<std::array<double, kGeonLabelCount>> ThesisMeanRow(std::span<const Subject> subjects);

// Tables 6.8-6.10: what the thesis printed on the bench at 1.0, 1.3 and 1.6 m for a geon, in
// percent, by GeonLabel; nothing for other ranges. About eleven views a geon, hence the round
// figures.
std::optional<std::array<int, kGeonLabelCount>> ThesisBenchRow(double range_m, GeonLabel truth);

// Section 6.3: of 30 runs that came near the geon (it left out those that got trapped) 60 % named
// it: 47 % of the half on the floor, 73 % of the half on the box.
inline constexpr SuccessRate kThesisRunsOnFloor{7, 15};
inline constexpr SuccessRate kThesisRunsOnBox{11, 15};
inline constexpr SuccessRate kThesisRuns{18, 30};

// Figure 6.11: the lowest and the highest error of a viewing cell, in percent.
inline constexpr int kThesisLowestError = 3;
inline constexpr int kThesisHighestError = 30;

}  // namespace geon::evaluation
