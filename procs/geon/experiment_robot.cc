#include "procs/geon/experiment_robot.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "procs/geon/parallel_for.h"
#include "procs/geon/picture_uri.h"
#include "procs/lockstep/robot_trial.h"
#include "sim/trouble.h"
#include "sim/world_file.h"

namespace geon::cli {
namespace {

sim::GeonPlace PlaceOfTrial(sim::GeonPlace place, int t) {
  if (place != sim::GeonPlace::kAny) return place;
  return t % 2 == 0 ? sim::GeonPlace::kFloor : sim::GeonPlace::kBox;
}

Status CheckTargets(const std::filesystem::path& file, const sim::World& world) {
  bool any = false;
  for (const sim::WorldObject& object : world.objects) {
    if (!sim::IsTarget(object)) continue;
    any = true;
    if (!sim::TrueLabel(object)) {
      return Status::Error(file.string() +
                           ": a mesh without `truth`: say which of the seven shapes it is");
    }
  }
  if (any) return Status::Ok();
  return Status::Error(file.string() + ": there is no geon and no mesh to name among its objects");
}

// What the mission was to name: of several geons the one nearest to where it believed its target
// to be, or, if it had none, to where it started.
evaluation::Subject SubjectOf(const sim::World& world,
                              const std::optional<Eigen::Vector2d>& target_W_m) {
  const Eigen::Vector2d start_m(world.robot_x_m, world.robot_y_m);
  const sim::WorldObject& geon = *sim::NearestTarget(world, target_W_m.value_or(start_m));
  const auto* shape = std::get_if<geons::GeonShape>(&geon.shape);
  return {*sim::TrueLabel(geon), sim::FootHeight(world, geon) > 0.0 ? "box" : "floor",
          shape != nullptr ? shape->position : 1};
}

// Every geon of the world with what the mission found there, the nearest finding first served.
std::vector<RobotGeonRecord> GeonsOf(const sim::World& world,
                                     const std::vector<sensor::GeonFinding>& findings) {
  std::vector<RobotGeonRecord> geons;
  std::vector<Eigen::Vector2d> places_m;
  for (const sim::WorldObject& object : world.objects) {
    if (!sim::IsTarget(object)) continue;
    geons.emplace_back().truth = *sim::TrueLabel(object);
    geons.back().place = sim::FootHeight(world, object) > 0.0 ? "box" : "floor";
    places_m.emplace_back(object.x_m, object.y_m);
  }
  constexpr double kSame_m = 0.5;
  std::vector<bool> taken(findings.size(), false);
  while (true) {
    std::optional<std::pair<size_t, size_t>> nearest;
    double nearest_m = kSame_m;
    for (size_t g = 0; g < geons.size(); ++g) {
      for (size_t f = 0; f < findings.size(); ++f) {
        const double off_m = (findings[f].p_W_m - places_m[g]).norm();
        if (geons[g].found || taken[f] || off_m >= nearest_m) continue;
        nearest_m = off_m;
        nearest = {g, f};
      }
    }
    if (!nearest) return geons;
    RobotGeonRecord& geon = geons[nearest->first];
    const sensor::GeonFinding& finding = findings[nearest->second];
    taken[nearest->second] = true;
    geon.found = true;
    geon.label = finding.label;
    geon.decided = finding.decided;
    geon.views = finding.views;
    geon.off_m = nearest_m;
  }
}

RobotTrialRecord RobotTrialOf(const RobotCase& each, const lockstep::RobotOutcome& outcome) {
  RobotTrialRecord trial;
  trial.t = each.t;
  trial.seed = each.seed;
  trial.world = each.name;
  trial.subject = SubjectOf(each.world, outcome.target_W_m);
  trial.end = outcome.end;
  trial.why = outcome.why;
  if (outcome.verdict) {
    trial.label = outcome.verdict->label;
    trial.confidence = outcome.verdict->confidence;
    trial.decided = outcome.verdict->decided;
    trial.views = outcome.findings.empty() ? 1 : outcome.findings.front().views;
  }
  trial.geons = GeonsOf(each.world, outcome.findings);
  trial.others = static_cast<int>(outcome.findings.size());
  for (const RobotGeonRecord& geon : trial.geons) trial.others -= geon.found ? 1 : 0;
  trial.end_s = outcome.end_s;
  const lockstep::RunTrack& track = outcome.track;
  trial.first_sight_s = track.first_sight_s;
  trial.contacts = track.contacts;
  trial.hardest_contact_m_s = track.hardest_contact_m_s;
  trial.path_m = track.path_m;
  return trial;
}

RobotFilm FilmOf(const RobotCase& each, const lockstep::RobotOutcome& outcome) {
  constexpr int kWidth_px = 320;
  RobotFilm film{DrawRun(each.t, each.world, outcome.track.path_W_m), {}};
  for (const lockstep::FilmFrame& frame : outcome.film) {
    film.stills.push_back({frame.time_s, std::string(ToString(frame.phase)), frame.text,
                           frame.place_W_m, PictureUri(frame.image, {}, kWidth_px)});
  }
  // The end: what the verdict is about, as it was seen.
  if (!film.stills.empty() && film.stills.back().picture_uri.empty()) {
    film.stills.back().picture_uri = PictureUri(outcome.view, outcome.mask, kWidth_px);
  }
  return film;
}

}  // namespace

sim::World RandomWorldAsWritten(uint64_t seed, sim::GeonPlace place, int geons) {
  const sim::World world = sim::RandomWorldOfSeveral(seed, place, geons);
  return sim::ParseWorld(sim::WorldText(world), "random world", "").value();
}

Result<std::vector<RobotCase>> RobotCases(const RobotPlan& plan, const sim::SimOptions& sim,
                                          Shard shard) {
  std::vector<RobotCase> cases;
  const int runs = plan.worlds.empty() ? plan.runs : static_cast<int>(plan.worlds.size());
  for (int t = shard.index - 1; t < runs; t += shard.count) {
    RobotCase each;
    each.t = t;
    each.seed = plan.seed + static_cast<uint64_t>(t);
    if (plan.worlds.empty()) {
      const sim::GeonPlace place = plan.geons == 1 ? PlaceOfTrial(plan.place, t) : plan.place;
      each.world = RandomWorldAsWritten(each.seed, place, plan.geons);
    } else {
      const std::filesystem::path& file = plan.worlds[static_cast<size_t>(t)];
      Result<sim::World> world = sim::LoadWorld(file);
      if (!world.ok()) return world.status();
      if (Status status = CheckTargets(file, *world); !status.ok()) return status;
      each.name = file.filename().string();
      each.world = std::move(*world);
    }
    each.sim = sim;
    if (plan.trouble) sim::AddTrouble(each.seed, &each.world, &each.sim);
    cases.push_back(std::move(each));
  }
  return cases;
}

Status RunRobotCases(const lockstep::LockstepSettings& settings,
                     const std::optional<recognizer::StripeCalibration>& calibration,
                     const std::vector<RobotCase>& cases, double longest_s, int jobs,
                     const std::function<void(double)>& progress, RobotRecord* record) {
  record->trials.resize(cases.size());
  Status failed = Status::Ok();
  std::mutex mutex;  // over all of these
  size_t done = 0;
  ParallelFor(jobs, static_cast<int>(cases.size()), [&](int k) {
    const RobotCase& each = cases[static_cast<size_t>(k)];
    lockstep::LockstepSettings own = settings;
    own.sim = each.sim;
    const Result<lockstep::RobotOutcome> outcome =
        lockstep::RunRobotTrial(own, calibration, each.world, each.seed, longest_s);
    const std::lock_guard lock(mutex);
    progress(static_cast<double>(++done) / static_cast<double>(cases.size()));
    if (!outcome.ok()) {
      failed = outcome.status();
      return;
    }
    const RobotTrialRecord& trial = record->trials[static_cast<size_t>(k)] =
        RobotTrialOf(each, *outcome);
    if (each.t == 0) record->film = FilmOf(each, *outcome);
    if (trial.right()) return;
    DrawnRun run = DrawRun(each.t, each.world, outcome->track.path_W_m);
    run.picture_uri = PictureUri(outcome->view, outcome->mask, 480);
    AddDrawnRun(std::move(run), &record->maps);
  });
  return failed;
}

}  // namespace geon::cli
