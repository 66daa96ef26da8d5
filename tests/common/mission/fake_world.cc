#include "tests/common/mission/fake_world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/core.hpp>

#include "base/angles.h"
#include "base/time.h"

namespace geon::mission {

namespace {

constexpr double kStep_s = 0.05;
constexpr double kHeadSpeed_rad_s = 1.5;
constexpr double kAnswer_s = 0.3;
constexpr double kSweptAnswer_s = 0.1;
const cv::Scalar kWall(120, 90, 90);

double Toward(double value, double target, double step) {
  return value + std::clamp(target - value, -step, step);
}

sensor::Image AsImage(const cv::Mat& bgr, int64_t utime, int32_t seq) {
  sensor::Image image;
  image.utime = utime;
  image.seq = seq;
  image.width_px = bgr.cols;
  image.height_px = bgr.rows;
  image.row_stride_bytes = 3 * bgr.cols;
  image.format = sensor::PixelFormat::kBgr8;
  image.data.assign(bgr.datastart, bgr.dataend);
  return image;
}

}  // namespace

geometry::SensorRig SmallRig() {
  using geometry::CameraAxesInBody;
  using geometry::MakeTransform;
  using geometry::RotationAboutY;
  geometry::SensorRig rig;
  rig.color_camera = {160, 120, 400.0, 400.0, 79.5, 59.5};
  rig.stripe_camera = rig.color_camera;
  rig.floor_camera = {160, 120, 80.0, 80.0, 79.5, 59.5};
  rig.X_RP = MakeTransform(RotationAboutY(RadiansFromDegrees(15)), Eigen::Vector3d(0, 0, 1.2));
  rig.X_TC = MakeTransform(CameraAxesInBody(), Eigen::Vector3d(0.05, 0, 0.11));
  rig.X_TB = MakeTransform(CameraAxesInBody(), Eigen::Vector3d(0.05, 0, 0.045));
  rig.X_RF = MakeTransform(RotationAboutY(RadiansFromDegrees(40)) * CameraAxesInBody(),
                           Eigen::Vector3d(0.15, 0, 0.85));
  const double tilt_rad = std::atan2(0.125, 0.987);
  rig.horizontal_laser = {Eigen::Vector3d(0.05, 0, 0.17),
                          Eigen::Vector3d(std::sin(tilt_rad), 0, std::cos(tilt_rad))};
  rig.vertical_laser = {Eigen::Vector3d(0.05, 0.125, 0.045),
                        Eigen::Vector3d(std::sin(tilt_rad), std::cos(tilt_rad), 0)};
  return rig;
}

MissionOptions FastOptions() {
  MissionOptions options;
  options.seeing.target_color = *attention::NamedColorModel("super-red");
  options.seeing.floor_model = navigation::FloorModel::OfColor({150, 150, 140});
  options.seeing.head.min_target_pixels = 20;
  options.seeing.floor.min_target_pixels = 8;
  options.seeing.floor_obstacles.column_step_px = 2;
  options.patience.mission_s = 240.0;
  options.patience.device_s = 15.0;
  return options;
}

FakeWorld::FakeWorld(const MissionOptions& options) : options_(options), rig_(SmallRig()) {
  Block target;
  target.center_W_m = {2.2, 0.3};
  target.label = GeonLabel::kTaperedCuboid;
  blocks.push_back(target);
  mission_ = std::make_unique<Mission>(options_, rig_, 1'000'000, now_s_);
}

void FakeWorld::AddGeon(const Eigen::Vector2d& center_W_m, GeonLabel label) {
  Block geon;
  geon.center_W_m = center_W_m;
  geon.label = label;
  blocks.push_back(geon);
}

void FakeWorld::Fence(const Eigen::Vector2d& center_W_m, double half_m, double top_m) {
  const int pieces = static_cast<int>(std::ceil(2.0 * half_m / 0.4));
  const double piece_m = half_m / pieces;  // half its length
  constexpr double kThick_m = 0.02;        // half of it
  for (int k = 0; k < pieces; ++k) {
    const double along_m = -half_m + (2 * k + 1) * piece_m;
    for (const double side_m : {-half_m, half_m}) {
      blocks.push_back(
          {center_W_m + Eigen::Vector2d(along_m, side_m), {piece_m, kThick_m}, 0.0, top_m, kWall});
      blocks.push_back(
          {center_W_m + Eigen::Vector2d(side_m, along_m), {kThick_m, piece_m}, 0.0, top_m, kWall});
    }
  }
}

int64_t FakeWorld::RobotUtime() const {
  return 1'500'000'000'000'000 + MicrosecondsFromSeconds(now_s_);
}

void FakeWorld::Step() {
  now_s_ += kStep_s;
  ++step_;
  Move();
  TellStates();
  if (step_ % 4 == 0) TellPictures();
  if (sweep_) AnswerSweep();
  TellProfiles();
  wishes_ = mission_->Step(now_s_);
  if (phases.empty() || phases.back() != mission_->phase()) phases.push_back(mission_->phase());
  Obey(wishes_);
}

void FakeWorld::TellProfiles() {
  for (auto due = pending_.begin(); due != pending_.end();) {
    if (due->first > now_s_) {
      ++due;
      continue;
    }
    sensor::RangeProfile& profile = due->second;
    if (recognizer_up) {
      profile.seq = ++recognizer_seq;
      mission_->Take(profile);
      const bool good = profile.status == sensor::ProfileStatus::kOk;
      const bool swept = profile.attempt == sensor::kSweptStripe;
      int& answered = answered_[profile.scan_id];
      if (good && swept) answered = std::max(answered, 1);
      if (good && !swept && ++answered == 6) GiveVerdict(profile.scan_id);
    }
    due = pending_.erase(due);
  }
}

void FakeWorld::GiveVerdict(int64_t scan_id) {
  const auto plan = std::find_if(plans.begin(), plans.end(),
                                 [&](const auto& each) { return each.scan_id == scan_id; });
  const Block& geon = blocks[scanned[static_cast<size_t>(plan - plans.begin())]];
  sensor::GeonVerdict verdict;
  verdict.scan_id = scan_id;
  verdict.label = geon.label.value_or(GeonLabel::kTaperedCuboid);
  verdict.decided = decided;
  verdict.confidence = confidence_1;
  // The next label is the likeliest of the others.
  constexpr double kNext_1 = 0.6;
  const auto label = static_cast<size_t>(verdict.label);
  verdict.posterior.fill((1.0 - confidence_1) * (1.0 - kNext_1) / (kGeonLabelCount - 2));
  verdict.posterior[(label + 1) % kGeonLabelCount] = (1.0 - confidence_1) * kNext_1;
  verdict.posterior[label] = confidence_1;
  mission_->Take(verdict);
}

bool FakeWorld::RunUntil(const std::function<bool()>& done, double limit_s) {
  const double end_s = now_s_ + limit_s;
  while (now_s_ < end_s) {
    Step();
    if (done()) return true;
  }
  return false;
}

bool FakeWorld::RunUntil(Phase phase, double limit_s) {
  return RunUntil([&] { return mission_->phase() == phase; }, limit_s);
}

bool FakeWorld::RunToTheEnd(double limit_s) { return RunUntil(Phase::kDone, limit_s); }

bool FakeWorld::Touches() const {
  const double radius_m = options_.driving.velocity.body_radius_m;
  return std::any_of(blocks.begin(), blocks.end(), [&](const Block& block) {
    if (block.bottom_m > 0.0) return false;
    const Eigen::Vector2d outside_m =
        ((pose.head<2>() - block.center_W_m).cwiseAbs() - block.half_m).cwiseMax(0.0);
    return outside_m.norm() < radius_m;
  });
}

void FakeWorld::Move() {
  if (base_up) {
    const auto& velocity = wishes_.velocity;
    pose.z() = WrapAngle(pose.z() + (velocity.turn_rate_rad_s + coast_rad_s) * kStep_s);
    pose.x() += velocity.speed_m_s * kStep_s * std::cos(pose.z());
    pose.y() += velocity.speed_m_s * kStep_s * std::sin(pose.z());
    const bool moves = velocity.speed_m_s != 0.0 || velocity.turn_rate_rad_s != 0.0;
    drove_while_scanning = drove_while_scanning || (moves && mission_->phase() == Phase::kScan);
  }
  if (!ptu_up) return;
  const active_vision::HeadAngles before = head;
  const double speed_rad_s = head_speed_rad_s_ > 0.0 ? head_speed_rad_s_ : kHeadSpeed_rad_s;
  head.pan_rad = Toward(head.pan_rad, head_target_.pan_rad, speed_rad_s * kStep_s);
  head.tilt_rad = Toward(head.tilt_rad, head_target_.tilt_rad, speed_rad_s * kStep_s);
  head_moving_ = !(head == before);
}

void FakeWorld::TellStates() {
  Senses* senses = mission_->senses();
  if (ptu_up) {
    sensor::PtuState ptu;
    ptu.utime = RobotUtime();
    ptu.status = sensor::DeviceStatus::kReady;
    ptu.pan_rad = head.pan_rad;
    ptu.tilt_rad = head.tilt_rad;
    const active_vision::HeadLimits limits;
    ptu.pan_min_rad = limits.pan_min_rad;
    ptu.pan_max_rad = limits.pan_max_rad;
    ptu.tilt_min_rad = limits.tilt_min_rad;
    ptu.tilt_max_rad = limits.tilt_max_rad;
    ptu.moving = head_moving_;
    ptu.command_id = head_command_id_;
    senses->Take(now_s_, ptu);
  } else {
    head_command_id_ = 0;  // a PTU that comes back knows of no command
  }
  if (base_up) {
    sensor::BaseState base;
    base.utime = RobotUtime();
    base.seq = ++base_seq_;
    base.status = sensor::DeviceStatus::kReady;
    base.x_m = pose.x();
    base.y_m = pose.y();
    base.heading_rad = pose.z();
    base.moving = wishes_.velocity.speed_m_s != 0.0 || wishes_.velocity.turn_rate_rad_s != 0.0 ||
                  coast_rad_s != 0.0;
    senses->Take(now_s_, base);
    sensor::BumperState bumpers;
    bumpers.pressed[0] = bumper_pressed;
    bumpers.bearing_rad[0] = bumper_bearing_rad;
    senses->Take(now_s_, bumpers);
    sensor::SonarScan sonar;
    sonar.range_m.fill(std::numeric_limits<double>::quiet_NaN());
    senses->Take(now_s_, sonar);
  }
  if (stripe_camera_up) {
    sensor::LaserState laser;
    laser.status = sensor::DeviceStatus::kReady;
    senses->Take(now_s_, laser);
  }
}

void FakeWorld::TellPictures() {
  const auto X_WR = geometry::PlanarPose(pose.x(), pose.y(), pose.z());
  Senses* senses = mission_->senses();
  const int32_t seq = step_ / 4;
  if (head_camera_up) {
    senses->TakeHeadImage(
        now_s_, AsImage(BlockPicture(Seen(), rig_.color_camera,
                                     X_WR * rig_.ColorCameraPose(head.pan_rad, head.tilt_rad)),
                        RobotUtime(), seq));
  }
  if (floor_camera_up) {
    senses->TakeFloorImage(
        now_s_,
        AsImage(BlockPicture(Seen(), rig_.floor_camera, X_WR * rig_.X_RF), RobotUtime(), seq));
  }
}

std::vector<Block> FakeWorld::Seen() const {
  return {blocks.begin() + (target_hidden ? 1 : 0), blocks.end()};
}

void FakeWorld::Obey(const Wishes& wishes) {
  if (wishes.head && ptu_up) {
    head_target_ = {wishes.head->pan_rad, wishes.head->tilt_rad};
    head_speed_rad_s_ = wishes.head->speed_rad_s;
    if (head_command_id_ != wishes.head->command_id) head_moving_ = true;
    head_command_id_ = wishes.head->command_id;
  }
  if (wishes.scan_plan && (plans.empty() || plans.back().scan_id != wishes.scan_plan->scan_id)) {
    plans.push_back(*wishes.scan_plan);
    scanned.push_back(GeonInView());
    scan_poses.push_back(pose);
    if (wishes.target_mask) masks.push_back(*wishes.target_mask);
  }
  if (!wishes.scan_command) return;
  const sensor::ScanCommand& command = *wishes.scan_command;
  sweep_.reset();
  if (command.stripe_index == sensor::kSweptStripe) {
    if (sweeps.empty() || sweeps.back() != command.laser) sweeps.push_back(command.laser);
    sweep_ = command;
    return;
  }
  if (command.laser != sensor::Laser::kNone) {
    if (stripe_camera_up) AnswerStripe(command);
  } else if (recognizer_up && command.scan_id != 0 && answered_[command.scan_id] > 0) {
    GiveVerdict(command.scan_id);  // told that the scan is over
  }
}

size_t FakeWorld::GeonInView() const {
  const auto X_WB = geometry::PlanarPose(pose.x(), pose.y(), pose.z()) *
                    rig_.StripeCameraPose(head.pan_rad, head.tilt_rad);
  size_t in_view = 0;
  double most_1 = -1.0;  // cosine of the angle to the camera's axis
  for (size_t k = 0; k < blocks.size(); ++k) {
    if (!blocks[k].label) continue;
    const Block& block = blocks[k];
    const Eigen::Vector3d middle_B =
        X_WB.inverse() * Eigen::Vector3d(block.center_W_m.x(), block.center_W_m.y(),
                                         0.5 * (block.bottom_m + block.top_m));
    const double cosine_1 = middle_B.normalized().z();
    if (cosine_1 <= most_1) continue;
    most_1 = cosine_1;
    in_view = k;
  }
  return in_view;
}

double FakeWorld::TrueDistance() const {
  const auto X_WB = geometry::PlanarPose(pose.x(), pose.y(), pose.z()) *
                    rig_.StripeCameraPose(head.pan_rad, head.tilt_rad);
  const Block& geon = blocks[GeonInView()];
  const Eigen::Vector2d away_m = geon.center_W_m - X_WB.translation().head<2>();
  return away_m.norm() - geon.half_m.x();
}

void FakeWorld::AnswerStripe(const sensor::ScanCommand& command) {
  const auto same = [&](const sensor::ScanCommand& other) {
    return other.scan_id == command.scan_id && other.stripe_index == command.stripe_index &&
           other.attempt == command.attempt;
  };
  if (std::any_of(stripe_calls.begin(), stripe_calls.end(), same)) return;
  if (!recognizer_up) return;
  stripe_calls.push_back(command);
  stripe_heads.push_back(head);
  sensor::RangeProfile profile = Measured(command);
  int& missing = missing_attempts[command.stripe_index];
  if (missing > 0 || TrueDistance() > reach_m) {
    missing = std::max(0, missing - 1);
    profile = {};
    profile.scan_id = command.scan_id;
    profile.stripe_index = command.stripe_index;
    profile.attempt = command.attempt;
    profile.laser = command.laser;
    profile.status = sensor::ProfileStatus::kMissing;
  }
  pending_.emplace_back(now_s_ + kAnswer_s, profile);
}

sensor::RangeProfile FakeWorld::Measured(const sensor::ScanCommand& command) const {
  sensor::RangeProfile profile;
  profile.scan_id = command.scan_id;
  profile.stripe_index = command.stripe_index;
  profile.attempt = command.attempt;
  profile.laser = command.laser;
  for (int u = 60; u < 100; ++u) {
    profile.pixel.push_back(u);
    profile.p_L_m.emplace_back(TrueDistance(), 0.005 * (80 - u), 0.1);
  }
  profile.on_target = 40;
  return profile;
}

// A stripe where the head is now, between those that the plan has for this laser.
void FakeWorld::AnswerSweep() {
  const std::vector<sensor::PlannedStripe>& planned = plans.back().stripes;
  const size_t first = sweep_->laser == sensor::Laser::kHorizontal ? 0 : 3;
  const auto at = [&](const sensor::PlannedStripe& stripe) {
    return first == 0 ? stripe.tilt_rad : stripe.pan_rad;
  };
  const double head_rad = first == 0 ? head.tilt_rad : head.pan_rad;
  const double low_rad = at(planned[first]), high_rad = at(planned[first + 2]);
  sensor::RangeProfile profile = Measured(*sweep_);
  profile.fraction = 0.25 + 0.5 * (head_rad - low_rad) / (high_rad - low_rad);
  const double quarter = std::clamp(std::round(4.0 * profile.fraction), 1.0, 3.0);
  profile.stripe_index = static_cast<int32_t>(first + static_cast<size_t>(quarter) - 1);
  if (never_swept.contains(profile.stripe_index)) profile.status = sensor::ProfileStatus::kMissing;
  pending_.emplace_back(now_s_ + kSweptAnswer_s, profile);
}

}  // namespace geon::mission
