#include "procs/geon/recognition_arguments.h"

namespace geon::cli {

void AddRecognitionArguments(CLI::App& command, RecognitionArguments* arguments) {
  command
      .add_option(
          "--method", arguments->method,
          "evidence: weighed by a trained forest (the default); thesis: the decision tree of "
          "chapter 5")
      ->check(CLI::IsMember({"thesis", "evidence"}));
  command
      .add_option("--curvature", arguments->curvature,
                  "corners and curves by O'Gorman's, Ramer's or Wall's method (section 5.3)")
      ->check(CLI::IsMember({"ogorman", "ramer", "wall"}));
  command.add_option("--smoothing", arguments->smoothing, "of the profiles (section 5.1)")
      ->check(CLI::IsMember({"median", "gaussian", "none"}));
  command
      .add_option("--background", arguments->background,
                  "told from the target by the thesis's two tests (section 5.1) or by the support "
                  "fitted to each scan; the default is the method's own")
      ->check(CLI::IsMember({"thesis", "fitted"}));
}

recognition::RecognitionOptions ToOptions(const RecognitionArguments& arguments,
                                          recognition::RecognitionOptions base) {
  if (const auto method = recognition::MethodFromString(arguments.method)) base.method = *method;
  if (const auto curvature = recognition::CurvatureMethodFromString(arguments.curvature)) {
    base.curvature = *curvature;
  }
  if (const auto smoothing = recognition::SmoothingFromString(arguments.smoothing)) {
    base.smoothing.kind = *smoothing;
  }
  if (const auto method = recognition::BackgroundMethodFromString(arguments.background)) {
    base.background_method = *method;
  }
  return base;
}

}  // namespace geon::cli
