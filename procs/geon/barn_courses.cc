#include "procs/geon/barn_courses.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>

#include "base/angles.h"
#include "config/text_file.h"
#include "procs/geon/csv_table.h"

namespace geon::cli {
namespace {

constexpr double kStart_m = 3.0;      // from the field's lower edge
constexpr double kRoom_m = 1.5;       // beyond the goal, at least
constexpr double kFastest_m_s = 2.0;  // of BARN's own robot

// A file of the folder, and the first thing that is wrong with it.
class Sheet {
 public:
  static Result<Sheet> Load(const std::filesystem::path& file,
                            std::initializer_list<const char*> columns) {
    Result<std::string> text = config::ReadFile(file);
    if (!text.ok()) return text.status();
    Sheet sheet;
    sheet.name_ = file.string();
    sheet.table_ = ParseCsv(*text);
    for (const char* column : columns) {
      const auto& heading = sheet.table_.heading;
      if (std::find(heading.begin(), heading.end(), column) != heading.end()) continue;
      return Status::Error(sheet.name_ + ":1: column " + column + " is missing");
    }
    return sheet;
  }
  size_t rows() const { return table_.rows.size(); }
  std::string Text(size_t row, const std::string& column) {
    const std::string text = table_.At(row, column);
    if (text.empty()) Fail(row, column + " is missing");
    return text;
  }
  double Number(size_t row, const std::string& column) {
    const std::string text = Text(row, column);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
      Fail(row, column + " must be a number, is \"" + text + "\"");
    }
    return value;
  }
  double Positive(size_t row, const std::string& column) {
    const double value = Number(row, column);
    if (!(value > 0.0)) Fail(row, column + " must be above 0, is \"" + Text(row, column) + "\"");
    return value;
  }
  void Fail(size_t row, const std::string& why) {
    if (!status_.ok()) return;
    status_ = Status::Error(name_ + ":" + std::to_string(table_.lines[row]) + ": " + why);
  }
  const Status& status() const { return status_; }

 private:
  std::string name_;
  CsvTable table_;
  Status status_ = Status::Ok();
};

struct Cylinder {
  Eigen::Vector2d p_m;
  double radius_m;
};
using Fields = std::map<std::string, std::vector<Cylinder>>;  // by world

Result<Fields> LoadFields(const std::filesystem::path& file) {
  Result<Sheet> sheet = Sheet::Load(file, {"world", "x_m", "y_m", "r_m"});
  if (!sheet.ok()) return sheet.status();
  Fields fields;
  for (size_t row = 0; row < sheet->rows(); ++row) {
    fields[sheet->Text(row, "world")].push_back(
        {{sheet->Number(row, "x_m"), sheet->Number(row, "y_m")}, sheet->Positive(row, "r_m")});
  }
  if (!sheet->status().ok()) return sheet->status();
  return fields;
}

bool IsFree(const std::vector<Cylinder>& field, const Eigen::Vector2d& robot_m) {
  return std::all_of(field.begin(), field.end(), [&](const Cylinder& each) {
    return (each.p_m - robot_m).norm() > each.radius_m + sim::kRobotRadius_m;
  });
}

// The pen about a field, and the robot at its start; nothing where start or goal is not free.
std::optional<sim::World> WorldOf(const std::vector<Cylinder>& field, double straight_m) {
  Eigen::Vector2d low_m = field.front().p_m, high_m = low_m;
  for (const Cylinder& each : field) {
    const Eigen::Vector2d reach_m(each.radius_m, each.radius_m);
    low_m = low_m.cwiseMin(each.p_m - reach_m);
    high_m = high_m.cwiseMax(each.p_m + reach_m);
  }
  const Eigen::Vector2d start_m(0.5 * (low_m.x() + high_m.x()), low_m.y() + kStart_m);
  const Eigen::Vector2d goal_m = start_m + Eigen::Vector2d(0.0, straight_m);
  if (!IsFree(field, start_m) || !IsFree(field, goal_m)) return std::nullopt;
  high_m.y() = std::max(high_m.y(), goal_m.y() + kRoom_m);
  sim::World world;
  world.pen_size_m = high_m - low_m;
  world.lighting.lamp_W_m.head<2>() = 0.5 * world.pen_size_m;
  world.robot_x_m = start_m.x() - low_m.x();
  world.robot_y_m = start_m.y() - low_m.y();
  world.robot_heading_rad = 0.5 * kPi;
  for (const Cylinder& each : field) {
    sim::WorldObject object;
    object.shape = sim::CylinderShape{each.radius_m, world.wall_height_m};
    object.x_m = each.p_m.x() - low_m.x();
    object.y_m = each.p_m.y() - low_m.y();
    world.objects.push_back(object);
  }
  return world;
}

}  // namespace

Result<std::vector<BarnCourse>> LoadBarnCourses(const std::filesystem::path& folder) {
  Result<Sheet> sheet = Sheet::Load(
      folder / "worlds.csv",
      {"world", "n_cylinders", "straight_len_m", "opt_path_len_m", "len_nomad_r0267", "split"});
  if (!sheet.ok()) return sheet.status();
  const Result<Fields> fields = LoadFields(folder / "obstacles.csv");
  if (!fields.ok()) return fields.status();
  std::vector<BarnCourse> courses;
  for (size_t row = 0; row < sheet->rows(); ++row) {
    BarnCourse course;
    course.id = sheet->Text(row, "world");
    course.split = sheet->Text(row, "split");
    const double straight_m = sheet->Positive(row, "straight_len_m");
    course.destination_W_m = {straight_m, 0.0};
    course.shortest_m = sheet->Positive(row, "len_nomad_r0267");
    course.optimal_s = sheet->Positive(row, "opt_path_len_m") / kFastest_m_s;
    const auto field = fields->find(course.id);
    const size_t cylinders = field == fields->end() ? 0 : field->second.size();
    if (cylinders == 0 || static_cast<double>(cylinders) != sheet->Number(row, "n_cylinders")) {
      sheet->Fail(row, "n_cylinders is " + sheet->Text(row, "n_cylinders") +
                           ", obstacles.csv has " + std::to_string(cylinders) + " of world " +
                           course.id);
    }
    if (!sheet->status().ok()) return sheet->status();
    auto world = WorldOf(field->second, straight_m);
    if (!world) sheet->Fail(row, "a cylinder stands where the robot starts, or at the goal");
    if (!sheet->status().ok()) return sheet->status();
    course.world = *std::move(world);
    courses.push_back(std::move(course));
  }
  if (courses.empty()) return Status::Error((folder / "worlds.csv").string() + ": no worlds");
  return courses;
}

}  // namespace geon::cli
