#include "pipeline/one_way.h"

#include "base/error.h"
#include "base/key_text.h"
#include "base/memory.h"
#include "base/stopwatch.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/avoided.h"
#include "pipeline/choices.h"
#include "pipeline/early_verdict.h"
#include "pipeline/given_paths.h"
#include "pipeline/part_motion.h"
#include "pipeline/part_size.h"
#include "pipeline/part_ways.h"
#include "pipeline/pedestal.h"
#include "pipeline/replay_stage.h"
#include "pipeline/stage_keys.h"
#include "pipeline/start_check.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/extruder.h"
#include "replay/verification.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace voluta::pipeline {

namespace {

// Progress at which each stage ends when a typical part is planned completely.
constexpr std::array<double, project::kStageCount> kEnds{0.02, 0.14, 0.22, 0.44, 0.6, 1.0};

// Rounds of replanning the motion without the waypoints that replay found colliding
constexpr int kRounds = 6;

// Runs the stages of one plan in order, taking each from the cache or computing it.
class StageRunner {
public:
  StageRunner(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
              const PlanObservers& observers, Trial* trial)
      : trial_(trial), choices_(resolved(request.choices)), until_(request.until), ctx_(ctx),
        cache_(cache), observers_(observers), values_(parameterValues(choices_)),
        mode_(modes::findMode(choices_.mode)),
        process_(std::make_shared<process::Process>(chosenProcess(choices_, values_))) {
    result_.process = process_;
    result_.debug = values_.boolean("output.debug");
    result_.keepRefused = values_.boolean("output.refused");
    result_.proofs = values_.boolean("output.proof");
    result_.buildFile = values_.boolean("output.build3mf");
    job().choices = request.choices;
    report().threads = ctx.threads();
    report().decomposition.mode = choices_.mode;
    report().chosen = chosenReport(request.choices);
    ctx.report(0.0, "load"_text);
    loaded_ = request.loaded
                  ? project::withRepair(request.loaded, choices_.repair, span(project::Stage::Load))
                  : project::loadPart(request.part, choices_.repair, span(project::Stage::Load));
    job().loaded = loaded_;
    job().partName = loaded_->name;
    given_ = takesGivenPaths(*loaded_, values_);
    if (given_)
      requireOwnSize(choices_);
    keys_ = keysOf(*loaded_, choices_, values_, *process_);
  }

  PlanResult run() {
    if (load() && decompose() && layers() && toolpath() && motion())
      programs();
    report().timings.total = whole_.seconds();
    return std::move(result_);
  }

private:
  project::Job& job() { return result_.job; }
  project::Report& report() { return result_.job.report; }

  template <typename T, typename Make>
  std::shared_ptr<const T> cachedOrMade(const std::string& key, const std::string& slot,
                                        Make make) {
    std::shared_ptr<const T> stage = cache_ ? cache_->find<T>(key, slot) : nullptr;
    if (stage)
      return stage;
    stage = make();
    ctx_.checkpoint();
    if (cache_ && !isRejected())
      cache_->keep<T>(key, stage, slot);
    return stage;
  }
  template <typename T, typename Make> std::shared_ptr<const T> cachedOrMade(Make make) {
    return cachedOrMade<T>(keys_[project::indexOf(T::kStage)], {}, make);
  }

  // Returns the stage's share of this plan's progress.
  base::RunContext span(project::Stage stage) const {
    const std::size_t s = project::indexOf(stage);
    const double all = kEnds[project::indexOf(until_)];
    return ctx_.sub((s > 0 ? kEnds[s - 1] : 0.0) / all, std::min(1.0, kEnds[s] / all));
  }

  bool isRejected() const { return trial_ && trial_->rejection; }
  // In a trial, the first blocking finding ends the plan. Returns whether it has ended.
  bool reject(project::Stage stage, const plan::Findings& findings) {
    if (!trial_ || trial_->rejection)
      return isRejected();
    if (const auto blocking = std::ranges::find_if(findings, &plan::Finding::blocking);
        blocking != findings.end())
      trial_->rejection = {stage, *blocking};
    return isRejected();
  }

  // Records that a stage is complete. Returns whether to continue.
  bool done(project::Stage stage, const plan::Findings& findings, const project::Timings& timings) {
    project::StageRecord& record = job().stages[project::indexOf(stage)];
    const bool whole = !isRejected(); // False: the stage ended early
    record = {whole ? keys_[project::indexOf(stage)] : std::string(), findings.size(), timings};
    report().findings.insert(report().findings.end(), findings.begin(), findings.end());
    report().timings += timings;
    report().timings.total = whole_.seconds();
    job().reached = stage;
    base::returnFreedMemory();
    if (whole && observers_.onStage)
      observers_.onStage(stage, result_);
    ctx_.checkpoint();
    return !reject(stage, findings) && stage < until_;
  }

  project::ChosenReport chosenReport(const project::Choices& given) const {
    return {.way = given.automatic ? given.automaticWay : std::string(),
            .name = nameOfWay(given),
            .mode = choices_.mode,
            .platform = choices_.platform.text(),
            .supports =
                mode_.requiresParameter("supports") ? values_.text("supports") : std::string(),
            .layerHeightMm = process_->layerHeightMm};
  }

  // Returns the repairs done on loading and on closing the mesh, each once.
  std::vector<base::Message> allRepairs(const modes::LoadStage& placed) const {
    std::vector<base::Message> all = loaded_->notes;
    for (const base::Message& repair : placed.report.repairs)
      if (std::ranges::find(all, repair) == all.end())
        all.push_back(repair);
    return all;
  }

  bool load() {
    placed_ = cachedOrMade<modes::LoadStage>(
        [&] { return loadStage(*loaded_, choices_, *process_, span(project::Stage::Load)); });
    const auto& stage = placed_;
    result_.placed = stage;
    job().scale = stage->scale;
    job().placement = stage->placement;
    job().part = stage->part;
    report().model = stage->report;
    report().model.file = loaded_->name;
    report().model.repairs = allRepairs(*stage);
    project::Timings timings = stage->timings;
    timings.load = loaded_->readS;
    timings.repair = loaded_->repairS;
    // A surface that encloses no volume cannot be measured.
    if (std::ranges::any_of(stage->findings, &plan::Finding::blocking))
      return done(project::Stage::Load, stage->findings, timings) && false;
    const auto size = cachedOrMade<SizeStage>(
        keys_[project::indexOf(project::Stage::Load)] +
            base::keyText(choices_.cell, process_->id, process_->beadWidthMinMm),
        "size", [&] {
          return sizeStage(*loaded_, *placed_, choices_, *process_,
                           span(project::Stage::Load).quiet());
        });
    const auto stand =
        cachedOrMade<StandStage>(standKey(*loaded_, *placed_, choices_, *process_), "stand", [&] {
          return standStage(*placed_, choices_, *process_, span(project::Stage::Load).quiet());
        });
    // A part drawn in other units cannot be planned.
    const bool odd = std::ranges::any_of(size->findings, [](const plan::Finding& f) {
      return f.kind == plan::FindingKind::TinyPart || f.kind == plan::FindingKind::HugePart;
    });
    plan::Findings findings = odd ? plan::Findings() : startFindings();
    const bool hopeless = odd || !findings.empty();
    findings.insert(findings.end(), size->findings.begin(), size->findings.end());
    findings.insert(findings.end(), stand->findings.begin(), stand->findings.end());
    const plan::Findings defects = remainingDefects(*loaded_);
    findings.insert(findings.end(), defects.begin(), defects.end());
    findings.insert(findings.end(), stage->findings.begin(), stage->findings.end());
    return done(project::Stage::Load, findings, timings) && !hopeless;
  }

  // Uses the choices as given: in mode auto the user may have fixed the platform.
  plan::Findings startFindings() {
    const project::Choices& given = job().choices;
    return cachedOrMade<StartStage>(startKey(*placed_, given, *process_), "start",
                                    [&] {
                                      return startStage(*placed_, given, *process_,
                                                        span(project::Stage::Load).quiet());
                                    })
        ->findings;
  }

  modes::ModeChoices modeChoices() const { return {choices_, values_, *process_}; }

  // Most edits of a decomposition do not change the voxels.
  std::shared_ptr<const modes::PartVoxels> voxels(double voxelMm, const base::RunContext& ctx) {
    return cachedOrMade<modes::PartVoxels>(
        placedPartKey(*loaded_, *placed_, modeChoices()) + base::keyText(voxelMm), "voxels",
        [&] { return modes::partVoxels(*placed_, voxelMm, ctx); });
  }

  bool decompose() {
    decomposed_ = cachedOrMade<modes::DecomposeStage>([&] {
      modes::DecomposeInput in{*placed_, [&](double voxelMm, const base::RunContext& ctx) {
                                 return voxels(voxelMm, ctx);
                               }};
      if (observers_.onPreview)
        in.onPreview = [&](std::shared_ptr<const curved::Decomposition> soFar) {
          observers_.onPreview(std::move(soFar), result_);
        };
      if (trial_)
        in.isRejected = [&](const plan::Findings& soFar) {
          return reject(project::Stage::Decompose, soFar);
        };
      auto made = mode_.decompose(modeChoices(), in, span(project::Stage::Decompose));
      return given_ ? onlyGround(*made) : made;
    });
    job().platform = decomposed_->platform;
    job().result = decomposed_->result;
    report().decomposition = decomposed_->report;
    report().decomposition.mode = choices_.mode;
    result_.cell = std::make_shared<robot::Cell>(
        robot::loadCell(choices_.cell, *process_, decomposed_->platform));
    for (const std::string& format : chosenFormats(choices_, *result_.cell)) {
      program::requireOwnRobot(program::findDialect(format), *result_.cell);
      program::requireRodTurns(program::findDialect(format), *result_.cell);
      program::requireExtruder(format, program::findDialect(format).extruders, *result_.cell,
                               program::programOptions(values_));
    }
    plan::Findings findings = decomposed_->findings;
    if (const double gap = adriftMm(choices_.platform, *job().part, *result_.cell); gap > 0.0)
      findings.insert(findings.begin(), plan::makeFinding(plan::FindingKind::PlatformAdrift,
                                                          {{"distance", base::mm(gap)}}));
    return done(project::Stage::Decompose, findings, decomposed_->timings);
  }

  bool layers() {
    const auto stage = cachedOrMade<modes::LayersStage>([&] {
      if (given_)
        return layersOfGiven(*loaded_->toolPaths);
      return mode_.layers(modeChoices(), *decomposed_, job().printed(),
                          span(project::Stage::Layers));
    });
    job().layers = stage->layers;
    report().layers = stage->report;
    report().decomposition.supportVolumeMm3 =
        decomposed_->report.supportVolumeMm3 + stage->supportVolumeMm3;
    return done(project::Stage::Layers, stage->findings, stage->timings);
  }

  bool toolpath() {
    const auto stage = cachedOrMade<ToolpathStage>([&] {
      if (given_)
        return givenToolpathStage(*loaded_, *placed_, *process_, span(project::Stage::Toolpath));
      MadeToolpaths made =
          toolpathStage(*job().layers, *result_.cell, job().platform, *process_,
                        toolpathOptionsOf(values_, *process_), span(project::Stage::Toolpath));
      grown_ = std::move(made.grown);
      return made.stage;
    });
    job().toolPlan = stage->toolPlan;
    report().toolpath = stage->report;
    for (const std::string& format : chosenFormats(choices_, *result_.cell))
      program::requireUpright(program::findDialect(format), stage->toolPlan->direction);
    const bool goesOn = done(project::Stage::Toolpath, stage->findings, stage->timings);
    if (goesOn && trial_ && !given_ && report().model.watertight)
      if (const auto mass = massOutOfReach(*stage->toolPlan, job().printed(), *process_))
        return !reject(project::Stage::Toolpath, {*mass});
    return goesOn;
  }

  bool motion() {
    motion_ = cachedOrMade<MotionStage>([&] { return moved(span(project::Stage::Motion)); });
    return motionDone();
  }

  std::unique_ptr<PartMotion> partMotion(const base::RunContext& ctx) {
    return std::make_unique<PartMotion>(*result_.job.toolPlan, result_.job.platform, *result_.cell,
                                        *process_, motionOptionsOf(values_, choices_.seed),
                                        std::exchange(grown_, {}), ctx);
  }
  // Keep the planner only if motion skipped waypoints: then replay is likely to require replanning
  // of some paths. Its state is as large as the trajectory.
  std::shared_ptr<const MotionStage> moved(const base::RunContext& ctx) {
    std::unique_ptr<PartMotion> moving = partMotion(ctx.sub(0, 0.05));
    std::shared_ptr<const MotionStage> stage =
        moving->plan(ctx.sub(0.05, 1.0), trial_ ? plan::kBlockingShare : 1.0);
    if (!stage->trajectory && reject(project::Stage::Motion, stage->findings))
      return stage;
    if (stage->report.unreachable + stage->report.collisions > 0)
      moving_ = std::move(moving);
    return stage;
  }

  bool motionDone() {
    job().trajectory = motion_->trajectory;
    report().motion = motion_->report;
    plan::Findings findings = motion_->findings;
    if (motion_->tooLarge) {
      const bool anyScale = !given_ && takesAnyScale(*loaded_, choices_);
      findings.insert(findings.begin(),
                      tooLargeFinding(*motion_->tooLarge,
                                      anyScale ? std::optional(job().scale) : std::nullopt));
    }
    return done(project::Stage::Motion, findings, motion_->timings) && job().trajectory;
  }

  // Replans the motion without these waypoints too, at which replay found collisions.
  bool replanSkipping(const std::vector<std::size_t>& met) {
    const std::size_t told = job().stages[project::indexOf(project::Stage::Motion)].findings;
    report().findings.resize(report().findings.size() - told);
    const base::RunContext ctx = span(project::Stage::Replay).quiet();
    if (!moving_) {
      moving_ = partMotion(ctx);
      moving_->plan(ctx); // Again, or for the first time if the motion came from the cache
    }
    motion_ = moving_->planWithout(met, ctx);
    fresh_ = true;
    return motionDone();
  }

  void programs() {
    Avoided avoided;
    for (int round = 0;; ++round) {
      write(round < kRounds);
      std::vector<std::size_t> found;
      for (const auto& checked : result_.checked)
        std::ranges::copy(metIn(*checked), std::back_inserter(found));
      const std::vector<std::size_t> met = avoided.next(*result_.job.toolPlan, found);
      if (met.empty() || round == kRounds || isHopeless() || !replanSkipping(met))
        break;
    }
    keepFresh();
    plan::Findings findings;
    project::Timings timings;
    bool told = false; // The verdict has been reported
    for (std::size_t i = 0; i < result_.checked.size(); ++i) {
      timings += result_.checked[i]->timings;
      const bool counts = decides(*result_.checked[i]), first = !told && counts;
      told = told || first;
      tellProgram(*result_.checked[i], first, counts, report(), findings);
    }
    if (isHopeless()) // Some formats may not have been written
      reject(project::Stage::Replay, findings);
    done(project::Stage::Replay, findings, timings);
  }

  // In a trial: returns whether a program fails for another reason than collisions, which no other
  // motion can repair.
  bool isHopeless() const {
    return trial_ && std::ranges::any_of(result_.checked, [this](const auto& checked) {
             return decides(*checked) &&
                    checked->failed.size() > (checked->collidingWaypoints.empty() ? 0 : 1);
           });
  }
  bool decides(const CheckedProgram& checked) const {
    return program::decidesOnPlan(checked.program.format, chosenFormats(choices_, *result_.cell),
                                  *result_.cell);
  }
  // Returns the colliding waypoints to skip. In a program for another controller, which moves
  // differently, many collisions are not worth replanning; only isolated ones are, so that they
  // alone do not get the program refused.
  std::vector<std::size_t> metIn(const CheckedProgram& checked) const {
    constexpr double kHereAndThere = 0.002; // Share of the waypoints
    const auto waypoints = static_cast<double>(result_.job.toolPlan->waypointCount());
    return decides(checked) || static_cast<double>(checked.collidingWaypoints.size()) <=
                                   kHereAndThere * waypoints
               ? checked.collidingWaypoints
               : std::vector<std::size_t>();
  }

  // `untilMet`: stop after the first program with collisions.
  void write(bool untilMet) {
    const std::vector<std::string> formats = chosenFormats(choices_, *result_.cell);
    const ProgramStageInput in{job().printed(),
                               job().platform,
                               *job().toolPlan,
                               *job().trajectory,
                               *result_.cell,
                               *process_,
                               std::filesystem::path(loaded_->name).stem().string(),
                               program::programOptions(values_)};
    result_.checked.clear();
    replay::JudgedRuns judged;
    for (std::size_t i = 0; i < formats.size(); ++i) {
      if (i > 0 && ((untilMet && !metIn(*result_.checked.back()).empty()) || isHopeless()))
        return;
      const double count = static_cast<double>(formats.size()), at = static_cast<double>(i);
      const auto make = [&] {
        return programStage(formats[i], in,
                            span(project::Stage::Replay).sub(at / count, (at + 1.0) / count),
                            &judged);
      };
      // Cached programs were written for the previous motion.
      result_.checked.push_back(
          fresh_ ? make() : cachedOrMade<CheckedProgram>(keyOf(formats[i]), formats[i], make));
    }
  }

  std::string keyOf(const std::string& format) const {
    return programKey(keys_, loaded_->name, *process_, program::programOptions(values_), format);
  }

  // Caches motion and programs together, so that the cache stays consistent whenever a plan is
  // cancelled.
  void keepFresh() {
    // Unless the motion is fresh, the programs belong to the cached motion
    if (!fresh_ || !cache_ || isRejected())
      return;
    cache_->keep<MotionStage>(keys_[project::indexOf(project::Stage::Motion)], motion_);
    for (const auto& checked : result_.checked)
      cache_->keep<CheckedProgram>(keyOf(checked->program.format), checked,
                                   checked->program.format);
  }

  base::Stopwatch whole_;
  Trial* trial_; // nullptr: blocking findings do not end the plan
  const project::Choices choices_;
  project::Stage until_;
  const base::RunContext& ctx_;
  StageCache* cache_;
  const PlanObservers& observers_;
  base::ParameterValues values_;
  const modes::Mode& mode_;
  std::shared_ptr<const process::Process> process_;
  std::shared_ptr<const project::LoadedPart> loaded_;
  std::shared_ptr<const modes::LoadStage> placed_;
  std::shared_ptr<const modes::DecomposeStage> decomposed_;
  std::shared_ptr<const MotionStage> motion_;
  // Volume filled by the tool-paths made here, handed to motion planning
  std::shared_ptr<const collision::GrowingPart> grown_;
  std::unique_ptr<PartMotion> moving_; // nullptr: released
  bool given_ = false;                 // The part is printed along the tool-paths of its file
  bool fresh_ = false;                 // The motion differs from the one cached under its key
  project::StageKeys keys_;
  PlanResult result_;
};

} // namespace

PlanResult planOneWay(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                      const PlanObservers& observers, Trial* trial) {
  return StageRunner(request, ctx, cache, observers, trial).run();
}

} // namespace voluta::pipeline
