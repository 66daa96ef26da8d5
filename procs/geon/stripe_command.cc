#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "procs/geon/commands.h"
#include "procs/geon/image_file.h"
#include "rangefinder/laser_light.h"
#include "rangefinder/stripe_peaks.h"

namespace geon::cli {
namespace {

using Json = nlohmann::ordered_json;
using rangefinder::LaserColor;
using rangefinder::PeakReason;
using rangefinder::StripePeak;
using sensor::Laser;

// A photograph has many lines that are bright and narrow somewhere; a laser lays one.
constexpr double kMinStripeShare_1 = 0.5;

struct StripeArguments {
  std::string lit;
  std::string unlit;
  std::string laser;
  std::string laser_color;
  std::string peaks = "gaussian";
  bool json = false;
};

bool IsGray(const sensor::Image& bgr) {
  for (size_t i = 0; i + 2 < bgr.data.size(); i += 3) {
    if (bgr.data[i] != bgr.data[i + 1] || bgr.data[i] != bgr.data[i + 2]) return false;
  }
  return true;
}

LaserColor ChooseColor(const std::string& name, const sensor::Image& image) {
  if (name == "red") return LaserColor::kRed;
  if (name == "green") return LaserColor::kGreen;
  if (name == "mono" || IsGray(image)) return LaserColor::kMono;
  return LaserColor::kRed;
}

int CountFound(const std::vector<StripePeak>& peaks) {
  int count = 0;
  for (const StripePeak& peak : peaks) count += peak.reason == PeakReason::kFound ? 1 : 0;
  return count;
}

struct Found {
  Laser laser = Laser::kHorizontal;
  std::vector<StripePeak> peaks;
};

// Along the named direction, or along the one with the larger share of lines that show a stripe.
Found FindAlong(const std::string& name, const sensor::Image& light,
                const rangefinder::PeakOptions& options) {
  const auto find = [&](Laser laser) -> Found {
    return {laser, rangefinder::FindStripePeaks(light, laser, options)};
  };
  if (!name.empty()) return find(name == "vertical" ? Laser::kVertical : Laser::kHorizontal);
  Found horizontal = find(Laser::kHorizontal);
  Found vertical = find(Laser::kVertical);
  const double horizontal_share =
      static_cast<double>(CountFound(horizontal.peaks)) / light.width_px;
  const double vertical_share = static_cast<double>(CountFound(vertical.peaks)) / light.height_px;
  return vertical_share > horizontal_share ? vertical : horizontal;
}

// Thousandths: finer than any stripe can be measured.
double Rounded(double value) { return std::round(1000.0 * value) / 1000.0; }

Json ToJson(const StripePeak& peak, Laser laser) {
  const bool horizontal = laser == Laser::kHorizontal;
  const char* line = horizontal ? "u_px" : "v_px";
  if (peak.reason != PeakReason::kFound) {
    return {{line, peak.pixel}, {"reason", rangefinder::ToString(peak.reason)}};
  }
  const double position_px = Rounded(peak.position_px);
  Json json;
  if (horizontal) {
    json = {{"u_px", peak.pixel}, {"v_px", position_px}};
  } else {
    json = {{"u_px", position_px}, {"v_px", peak.pixel}};
  }
  json["peak"] = Rounded(peak.peak_1);
  json["width_px"] = Rounded(peak.width_px);
  json["sigma_px"] = Rounded(peak.sigma_px);
  return json;
}

int Stripe(const StripeArguments& arguments) {
  const auto fail = [](const std::string& message) {
    std::cerr << "geon stripe: " << message << "\n";
    return kFailed;
  };
  const Result<sensor::Image> lit = LoadImage(arguments.lit);
  if (!lit.ok()) return fail(lit.message());
  const LaserColor color = ChooseColor(arguments.laser_color, *lit);
  sensor::Image light;
  rangefinder::PeakOptions options;
  options.method = *rangefinder::PeakMethodFromString(arguments.peaks);
  if (arguments.unlit.empty()) {
    light = rangefinder::LaserLight(*lit, color);
    options.min_stripe_share_1 = kMinStripeShare_1;
  } else {
    const Result<sensor::Image> unlit = LoadImage(arguments.unlit);
    if (!unlit.ok()) return fail(unlit.message());
    if (unlit->width_px != lit->width_px || unlit->height_px != lit->height_px) {
      return fail(arguments.unlit + ": differs in size from " + arguments.lit);
    }
    light = rangefinder::LaserLight(*lit, *unlit, color);
  }

  const Found found = FindAlong(arguments.laser, light, options);
  for (const StripePeak& peak : found.peaks) std::cout << ToJson(peak, found.laser) << "\n";
  const int count = CountFound(found.peaks);
  if (!arguments.json) {
    const bool horizontal = found.laser == Laser::kHorizontal;
    std::cerr << arguments.lit << ": " << (horizontal ? "horizontal" : "vertical") << " stripe in "
              << count << " of " << found.peaks.size() << (horizontal ? " columns\n" : " rows\n");
  }
  if (count == 0) {
    return fail(arguments.lit + ": shows no laser stripe" +
                (arguments.unlit.empty() ? "; a second frame with the laser off helps (OFF)" : ""));
  }
  return kOk;
}

}  // namespace

void AddStripeCommand(CLI::App& app, int* exit_code) {
  auto arguments = std::make_shared<StripeArguments>();
  CLI::App* command = app.add_subcommand(
      "stripe",
      "Finds a laser stripe to a fraction of a pixel (thesis 3.1): one JSON object for every "
      "column "
      "of a horizontal stripe or row of a vertical one, with the reason where there is no stripe.");
  command->footer(
      "u_px, v_px   the line, and where the stripe's centre crosses it\n"
      "peak         grey levels above what the stripe stands on (more than 255: clipped)\n"
      "width_px     of the stripe: standard deviation of its brightness profile\n"
      "sigma_px     standard error of the centre, from the image's noise\n"
      "Examples:\n"
      "  geon stripe on.png off.png\n"
      "  geon stripe frame.jpg --laser vertical --peaks centroid\n"
      "Exit code 1: no stripe in the image.");
  command->add_option("ON", arguments->lit, "Image with the laser on")->required();
  command->add_option("OFF", arguments->unlit,
                      "The same view with the laser off; without it the background is estimated");
  command
      ->add_option("--laser", arguments->laser,
                   "horizontal or vertical; default: the one that fits the image")
      ->check(CLI::IsMember({"horizontal", "vertical"}));
  command
      ->add_option("--laser-color", arguments->laser_color,
                   "red, green or mono; default: red, mono for a grey image")
      ->check(CLI::IsMember({"red", "green", "mono"}));
  command
      ->add_option("--peaks", arguments->peaks,
                   "gaussian: a Gaussian profile; centroid: the thesis's equation 3.6")
      ->check(CLI::IsMember({"gaussian", "centroid"}))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Nothing but JSON: no summary on stderr");
  command->callback([arguments, exit_code] { *exit_code = Stripe(*arguments); });
}

}  // namespace geon::cli
