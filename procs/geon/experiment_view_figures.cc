#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "procs/geon/experiment_figures.h"
#include "procs/geon/experiment_rates.h"
#include "procs/geon/report_figures.h"
#include "procs/geon/svg.h"
#include "procs/geon/verdict_text.h"

namespace geon::cli {
namespace {

constexpr double kMm = 0.1;  // of a drawn stripe's unit
constexpr double kBar_mm = 50.0;

using Points = std::vector<Eigen::Vector2d>;
using Projection = Eigen::Vector2d (*)(const Eigen::Vector3d& p_B_mm);

// Horizontal stripes from above, the camera below the picture; vertical ones from the side, the
// camera on the left.
Eigen::Vector2d FromAbove(const Eigen::Vector3d& p_B_mm) { return {p_B_mm.x(), p_B_mm.z()}; }
Eigen::Vector2d FromTheSide(const Eigen::Vector3d& p_B_mm) { return {p_B_mm.z(), -p_B_mm.y()}; }

// From the camera's right and somewhat above it, so that depth can be seen.
Eigen::Vector2d Oblique(const Eigen::Vector3d& p_B_mm) {
  static const double kTurn_rad = RadiansFromDegrees(38.0), kTilt_rad = RadiansFromDegrees(22.0);
  const double right = std::cos(kTurn_rad) * p_B_mm.x() + std::sin(kTurn_rad) * p_B_mm.z();
  const double away = std::cos(kTurn_rad) * p_B_mm.z() - std::sin(kTurn_rad) * p_B_mm.x();
  return {right, -std::cos(kTilt_rad) * p_B_mm.y() + std::sin(kTilt_rad) * away};
}

std::vector<Points> Project(const DrawnStripe& stripe, Projection projection) {
  std::vector<Points> pieces;
  for (const auto& piece : stripe.pieces) {
    pieces.emplace_back();
    for (const Eigen::Vector3i& p : piece) {
      pieces.back().push_back(projection(kMm * p.cast<double>()));
    }
  }
  return pieces;
}

struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-1e9);
  void Add(const std::vector<Points>& pieces) {
    for (const Points& piece : pieces) {
      for (const Eigen::Vector2d& p : piece) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
    }
  }
  bool empty() const { return low.x() > high.x(); }
  Eigen::Vector2d middle() const { return 0.5 * (low + high); }
};

Projection ProfileProjection(sensor::Laser laser) {
  return laser == sensor::Laser::kVertical ? FromTheSide : FromAbove;
}

void DrawPieces(const std::vector<Points>& pieces, sensor::Laser laser, Plot* plot) {
  const std::string name(ToString(laser));
  for (const Points& piece : pieces) {
    if (piece.size() == 1) plot->Dots(piece, 1.1, "spot " + name);
    plot->Polyline(piece, "stripe " + name);
  }
}

void DrawBar(const Eigen::Vector2d& at_mm, Plot* plot) {
  plot->Line(at_mm, at_mm + Eigen::Vector2d(kBar_mm, 0), "scale");
  plot->Text(at_mm + Eigen::Vector2d(kBar_mm, 0), {4, 3}, "start", "small", "5 cm");
}

std::string ObliqueSvg(const WorstView& view) {
  Extent extent;
  for (const DrawnStripe& stripe : view.stripes) extent.Add(Project(stripe, Oblique));
  if (extent.empty()) return "<p class=\"muted\">No point on the target.</p>";
  const Eigen::Vector2d margin(10, 18);
  Plot plot(250, 250, extent.low - margin, extent.high + margin, true);
  for (const DrawnStripe& stripe : view.stripes) {
    DrawPieces(Project(stripe, Oblique), stripe.laser, &plot);
  }
  DrawBar(extent.low - Eigen::Vector2d(4, 14), &plot);
  return plot.Svg("the six stripes, from the right and above the camera");
}

// All six to one scale, so that lengths can be compared.
std::string ProfilesHtml(const WorstView& view) {
  double half_mm = 10.0;
  for (const DrawnStripe& stripe : view.stripes) {
    Extent extent;
    extent.Add(Project(stripe, ProfileProjection(stripe.laser)));
    if (!extent.empty()) half_mm = std::max(half_mm, 0.5 * (extent.high - extent.low).maxCoeff());
  }
  const Eigen::Vector2d window = Eigen::Vector2d::Constant(1.12 * half_mm);
  std::string html = "<div class=\"profiles\">";
  for (const DrawnStripe& stripe : view.stripes) {
    const std::vector<Points> pieces = Project(stripe, ProfileProjection(stripe.laser));
    Extent extent;
    extent.Add(pieces);
    const Eigen::Vector2d middle = extent.empty() ? Eigen::Vector2d(0, 0) : extent.middle();
    Plot plot(122, 122, middle - window, middle + window, true);
    DrawPieces(pieces, stripe.laser, &plot);
    if (&stripe == &view.stripes.front()) {
      DrawBar(middle - 0.88 * window, &plot);
    }
    const std::string name = StripeName(stripe.laser, stripe.fraction_1);
    html += "<figure>" + plot.Svg("profile of the stripe " + name) + "<figcaption>" + name +
            (extent.empty() ? ": nothing" : "") + "</figcaption></figure>";
  }
  return html + "</div>";
}

std::string Heading(const ShownView& shown) {
  std::string text = WithArticle(shown.truth);
  text[0] = 'A';
  if (!shown.answer) return text + ", without an answer";
  return text + (shown.truth == *shown.answer ? ", rightly named"
                                              : ", taken for " + WithArticle(*shown.answer));
}

std::string Card(size_t number, const ShownView& shown) {
  const WorstView& view = *shown.view;
  sensor::GeonVerdict verdict;
  verdict.label = shown.answer.value_or(shown.truth);
  verdict.posterior = view.posterior;
  std::string html = "<article class=\"card view-card\"><h3>" + std::to_string(number) + ". " +
                     Heading(shown) + "</h3><p class=\"muted\">";
  if (shown.answer) {
    html += "Confidence " + Fixed(100.0 * shown.confidence_1, 1) + " %, " +
            (shown.decided ? "decided" : "undecided") + ". ";
  }
  html += Escape(shown.where) + "; trial " + std::to_string(view.t) + ".</p>";
  if (!view.picture_uri.empty()) {
    html += "<img class=\"seen\" alt=\"what the camera saw, the target outlined\" src=\"" +
            view.picture_uri + "\"/>";
  }
  html += "<div class=\"oblique\">" + ObliqueSvg(view) + "</div>" + ProfilesHtml(view) +
          "<div><h4>How probable each shape seemed</h4>" + PosteriorFigure(verdict) +
          "<h4 style=\"margin-top:12px\">Evidence</h4><ul class=\"reasons\">";
  for (const std::string& reason : view.reasons) html += "<li>" + Escape(reason) + "</li>";
  return html + "</ul></div></article>";
}

}  // namespace

std::string WorstViewFigures(std::span<const ShownView> views) {
  std::string html = "<div class=\"views\">";
  for (size_t k = 0; k < views.size(); ++k) html += Card(k + 1, views[k]);
  return html + "</div>";
}

std::vector<ShownView> ShownViews(const ShapeRecord& record) {
  std::vector<ShownView> shown;
  for (const WorstView& view : record.worst) {
    const auto trial =
        std::find_if(record.trials.begin(), record.trials.end(),
                     [&view](const evaluation::ShapeTrial& each) { return each.t == view.t; });
    if (trial == record.trials.end()) continue;
    const evaluation::Subject& subject = record.subjects[static_cast<size_t>(trial->subject)];
    shown.push_back({&view, subject.truth, trial->answer, trial->confidence, trial->decided,
                     "Object " + subject.object + ", position " + std::to_string(subject.position) +
                         "; camera at elevation " +
                         std::to_string(WholeDegrees(trial->cell.elevation_rad)) + "°, azimuth " +
                         std::to_string(WholeDegrees(trial->cell.azimuth_rad)) + "°"});
  }
  return shown;
}

}  // namespace geon::cli
