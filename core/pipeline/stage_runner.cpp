#include "pipeline/stage_runner.h"

#include "base/error.h"
#include "base/memory.h"
#include "base/stopwatch.h"
#include "elastic/deposited.h"
#include "layers/walled_support.h"
#include "motion/motion_options.h"
#include "pipeline/automatic.h"
#include "pipeline/checked_program.h"
#include "pipeline/early_verdict.h"
#include "pipeline/given_paths.h"
#include "pipeline/item_events.h"
#include "pipeline/item_regions.h"
#include "pipeline/item_stages.h"
#include "pipeline/items/given_items.h"
#include "pipeline/items/layer_hindrance.h"
#include "pipeline/items/named_errors.h"
#include "pipeline/items/plate_parts.h"
#include "pipeline/judged_part.h"
#include "pipeline/part_motion.h"
#include "pipeline/part_size.h"
#include "pipeline/payload.h"
#include "pipeline/pedestal.h"
#include "pipeline/program_runner.h"
#include "pipeline/quality.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_keys.h"
#include "pipeline/stage_options.h"
#include "pipeline/stage_record.h"
#include "pipeline/stages.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "program/bead_words.h"
#include "program/dialect.h"
#include "program/extruder.h"
#include "toolpath/plan_toolpaths.h"
#include "toolpath/strength.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <span>
#include <utility>

namespace voluta::pipeline {

namespace {

// Throws Error{Usage} if the cell's tool changer has fewer docks than the job has tools.
void requireDocks(const robot::Cell& cell, std::size_t tools) {
  const robot::ToolChange& change = cell.toolChange();
  if (tools == 1 || change.by != robot::ToolChange::By::Changer || change.docks.size() >= tools)
    return;
  throw base::Error(base::ErrorCode::Usage,
                    base::message("cell {cell} has no dock for tool {tool}"_text, cell.id(),
                                  change.docks.size() + 1),
                    {}, "remove a tool, or choose another cell"_text);
}

// One plan: its stages in order, each taken from the cache or made.
class StageRunner {
public:
  StageRunner(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
              const PlanObservers& observers, Trial* trial)
      : context_(request.until, ctx, cache, observers, trial), ctx_(ctx),
        result_(emptyResult(request.choices)), resolved_(result_.resolved()),
        load_(toolpath::loadDirection(resolved_.values.text("loadDirection"))) {
    base::require(request.items.size() == request.choices.items.size(), "choices for each item");
    const std::size_t count = request.items.size();
    job().items.resize(count);
    report().items.resize(count);
    job().choices = request.choices;
    report().threads = ctx.threads();
    ctx.report(0.0, "load"_text);
    std::vector<project::StageKeys> keys;
    for (std::size_t i = 0; i < count; ++i) {
      items_.push_back(
          std::make_unique<ItemStages>(context_, request.choices, i, request.item(i), result_));
      keys.push_back(items_.back()->keys());
    }
    keys_ = joinedKeys(keys, resolved_.choices.printOrder);
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
  const ItemStages& first() const { return *items_.front(); }
  // Of the first tool, for stages that see one part.
  const process::Process& process() const { return resolved_.tooling.first().process; }
  base::RunContext span(project::Stage stage) const { return context_.span(stage); }

  template <typename T, typename Make> std::shared_ptr<const T> cachedOrMade(Make make) {
    return context_.cachedOrMade<T>(keys_[project::indexOf(T::kStage)], {}, make);
  }

  // Records that a stage is complete. Returns whether to continue.
  bool done(project::Stage stage, plan::Findings findings, const project::Timings& timings) {
    std::vector<bool> isGiven;
    for (const auto& item : items_)
      isGiven.push_back(item->hasGivenPaths());
    findings = withRemediesForGiven(std::move(findings), isGiven);
    const bool whole = !context_.isRejected(); // False: the stage ended early
    recordStage(job(), stage, whole ? keys_[project::indexOf(stage)] : std::string(), findings,
                timings, process().beadWidthMaxMm);
    report().timings.total = whole_.seconds();
    base::returnFreedMemory();
    if (whole && context_.observers().onStage)
      context_.observers().onStage(stage, result_);
    ctx_.checkpoint();
    return !context_.reject(stage, findings) && stage < context_.until();
  }

  // A stage of every item, one after the other.
  template <typename Run> ItemOutcome ofEachItem(const Run& run) {
    ItemOutcome all;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      ItemOutcome one =
          namingPart(items_.size() > 1, items_[i]->loaded().name, [&] { return run(*items_[i]); });
      if (items_.size() > 1)
        for (plan::Finding& finding : one.findings)
          finding.item = static_cast<int>(i);
      std::ranges::move(one.findings, std::back_inserter(all.findings));
      all.timings += one.timings;
      all.continues = all.continues && one.continues;
    }
    return all;
  }

  bool load() {
    ItemOutcome all = ofEachItem([](ItemStages& item) { return item.load(); });
    if (items_.size() > 1 && all.continues)
      addFindingsBetween(all);
    return done(project::Stage::Load, all.findings, all.timings) && all.continues;
  }

  void addFindingsBetween(ItemOutcome& all) {
    plan::Findings found = findingsBetween(placedParts(), job().choices, process(), partNames());
    all.continues = std::ranges::none_of(found, &plan::Finding::blocking);
    std::ranges::move(found, std::back_inserter(all.findings));
  }

  bool decompose() {
    ItemOutcome all = ofEachItem([](ItemStages& item) { return item.decompose(); });
    result_.cell = std::make_shared<robot::Cell>(
        robot::loadCell(resolved_.choices.cell, process(), project::platformOf(job())));
    requireDocks(*result_.cell, resolved_.tooling.tools().size());
    for (const std::string& format : chosenFormats(resolved_.choices, *result_.cell)) {
      program::requireOwnRobot(program::findDialect(format), *result_.cell);
      program::requireRodTurns(program::findDialect(format), *result_.cell);
      program::requireBeadWords(format, resolved_.tooling);
      program::requireExtruder(format, program::findDialect(format).extruders, *result_.cell,
                               program::programOptions(resolved_.values));
    }
    for (std::size_t i = items_.size(); i-- > 0;)
      if (const double gap =
              adriftMm(items_[i]->choices().item().platform, *job().item(i).part, *result_.cell);
          gap > 0.0)
        all.findings.insert(
            all.findings.begin(),
            plan::makeFinding(plan::FindingKind::PlatformAdrift, {{"distance", base::mm(gap)}}));
    return done(project::Stage::Decompose, all.findings, all.timings);
  }

  bool layers() {
    ItemOutcome all = ofEachItem([](ItemStages& item) { return item.layers(); });
    if (!canTilt(resolved_.choices, *result_.cell)) // nor print along a surface
      std::erase_if(all.findings, [](const plan::Finding& finding) {
        return finding.kind == plan::FindingKind::Staircase;
      });
    const bool isByLayer =
        items_.size() > 1 && resolved_.choices.printOrder == layers::PrintOrder::ByLayer;
    if (isByLayer && std::ranges::any_of(job().items, [](const project::JobItem& item) {
          return tiltsHead(*item.layers);
        }))
      addHindrance(all);
    return done(project::Stage::Layers, all.findings, all.timings) && all.continues;
  }

  void addHindrance(ItemOutcome& all) {
    const auto stage = context_.cachedOrMade<HindranceStage>(
        keys_[project::indexOf(project::Stage::Layers)], "hindrance", [&] {
          return std::make_shared<const HindranceStage>(hindranceStage(
              layerHindrance(*joinedLayers(), *result_.cell, process(),
                             span(project::Stage::Layers).quiet()),
              partNames(), !printSequence(placedParts(), job().choices, process()).blocked));
        });
    all.continues = all.continues && stage->findings.empty();
    std::ranges::copy(stage->findings, std::back_inserter(all.findings));
  }

  std::vector<std::string> partNames() {
    std::vector<std::string> names;
    for (const project::JobItem& item : job().items)
      names.push_back(item.partName);
    return names;
  }

  std::vector<std::shared_ptr<const geometry::TriangleMesh>> placedParts() {
    std::vector<std::shared_ptr<const geometry::TriangleMesh>> parts;
    for (const project::JobItem& item : job().items)
      parts.push_back(item.part);
    return parts;
  }

  std::shared_ptr<const layers::LayerStack> joinedLayers() {
    if (items_.size() == 1)
      return job().item().layers;
    std::vector<std::shared_ptr<const layers::LayerStack>> stacks;
    for (const project::JobItem& item : job().items)
      stacks.push_back(item.layers);
    return layers::joinStacks(stacks, resolved_.choices.printOrder,
                              printSequence(placedParts(), job().choices, process()).order);
  }

  bool toolpath() {
    const bool given =
        std::ranges::any_of(items_, [](const auto& item) { return item->hasGivenPaths(); });
    const auto stage = cachedOrMade<ToolpathStage>([&] {
      const base::RunContext ctx = span(project::Stage::Toolpath);
      if (!given)
        return withInserts(plannedToolpaths({}, ctx));
      return withInserts(items_.size() == 1 ? givenToolpaths(0, ctx) : mixedToolpaths(ctx));
    });
    job().toolPlan = stage->toolPlan;
    report().toolpath = stage->report;
    requireFormatsTilt(stage->toolPlan->direction);
    plan::Findings findings = stage->findings;
    std::ranges::move(fieldFindings(), std::back_inserter(findings));
    if (const auto load = overload(*result_.cell, resolved_.tooling.printedG(*stage->toolPlan)))
      findings.push_back(*load);
    const bool continues = done(project::Stage::Toolpath, findings, stage->timings);
    if (continues && context_.isTrial() && !given && report().item().model.watertight)
      if (const auto mass = massOutOfReach(*stage->toolPlan, *judgedPart(job(), resolved_),
                                           process(), massLeeway()))
        return !context_.reject(project::Stage::Toolpath, {*mass});
    return continues;
  }

  // Not of the stage: its result does not depend on fields that no infill follows.
  plan::Findings fieldFindings() {
    plan::Findings findings;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      if (items_[i]->hasGivenPaths())
        continue;
      for (plan::Finding& finding : unusedFields(*result_.item(i).resolved)) {
        finding.item = items_.size() > 1 ? static_cast<int>(i) : -1;
        findings.push_back(std::move(finding));
      }
    }
    return findings;
  }

  // Material may be missing in places that are thinner than a bead.
  double massLeeway() const {
    const replay::ReplayThresholds limits = thresholdsOf(qualityOf(resolved_.values));
    return limits.massTolerance + limits.thinMax;
  }

  // Of the items without tool-paths of their own. `others`: where the other items are printed.
  std::shared_ptr<const ToolpathStage> plannedToolpaths(std::span<const Eigen::Vector3d> others,
                                                        const base::RunContext& ctx) {
    const auto joined = joinedLayers();
    requireFormatsTilt(directionsOf(*joined));
    MadeToolpaths made = toolpathStage(itemLayers(), *joined, *result_.cell,
                                       project::platformOf(job()), resolved_.tooling, ctx, others);
    grown_ = std::move(made.grown);
    return withLoad(withStrength(withWalledSupport(std::move(made.stage), *joined), *joined),
                    ctx.quiet());
  }

  std::vector<toolpath::ItemLayers> itemLayers() const {
    std::vector<toolpath::ItemLayers> all;
    for (const auto& item : items_) {
      all.push_back(item->forToolpaths());
      for (toolpath::CoverRules& rules : all.back().rules)
        rules.options.canTilt = canTilt(resolved_.choices, *result_.cell);
    }
    // What holds for the whole job is stated by the first item that is planned.
    const auto planned =
        std::ranges::find_if(items_, [](const auto& item) { return !item->hasGivenPaths(); });
    if (planned != items_.end() && first().hasGivenPaths())
      all.front().options() = all[static_cast<std::size_t>(planned - items_.begin())].options();
    return all;
  }

  std::shared_ptr<const ToolpathStage> givenToolpaths(std::size_t i, const base::RunContext& ctx) {
    return givenToolpathStage(*items_[i]->shaped().part, items_[i]->placed(),
                              result_.item(i).resolved->tooling, ctx);
  }

  // Of several items, at least one of which is printed along the tool-paths of its file.
  std::shared_ptr<const ToolpathStage> mixedToolpaths(const base::RunContext& ctx) {
    constexpr double kGivenShare = 0.2; // of the progress
    GivenItems given;
    for (std::size_t i = 0; i < items_.size(); ++i)
      if (items_[i]->hasGivenPaths())
        given.push_back({i, givenToolpaths(i, ctx.sub(0.0, kGivenShare))});
    const std::vector<Eigen::Vector3d> places = placesOf(given);
    const auto planned = given.size() < items_.size()
                             ? plannedToolpaths(places, ctx.sub(kGivenShare, 1.0))
                             : std::make_shared<const ToolpathStage>();
    grown_.reset(); // without the paths of the files
    return joinedStage(*planned, given, resolved_.choices.printOrder,
                       printSequence(placedParts(), job().choices, process()).order,
                       resolved_.tooling);
  }

  static std::vector<Eigen::Vector3d> directionsOf(const layers::LayerStack& stack) {
    std::vector<Eigen::Vector3d> all;
    for (const layers::Patch& patch : stack.patches)
      all.insert(all.end(), patch.direction.begin(), patch.direction.end());
    return all;
  }
  // Throws Error{Usage} if a chosen format cannot state one of the nozzle's directions.
  void requireFormatsTilt(std::span<const Eigen::Vector3d> directions) const {
    for (const std::string& format : chosenFormats(resolved_.choices, *result_.cell))
      program::requireUpright(program::findDialect(format), directions);
  }

  // Of the first item, whose load is in the frame of its file.
  std::shared_ptr<const ToolpathStage> withWalledSupport(std::shared_ptr<const ToolpathStage> stage,
                                                         const layers::LayerStack& joined) {
    if (stage->report.rimSupportMm3 <= 0.0)
      return stage;
    auto walled = layers::walledSupport(*stage->toolPlan, joined, *judgedPart(job(), resolved_));
    if (!walled)
      return stage;
    auto withFinding = std::make_shared<ToolpathStage>(*stage);
    withFinding->findings.push_back(std::move(*walled));
    return withFinding;
  }

  std::shared_ptr<const ToolpathStage> withStrength(std::shared_ptr<const ToolpathStage> stage,
                                                    const layers::LayerStack& joined) {
    if (!load_ || first().hasGivenPaths())
      return stage;
    const Eigen::Quaterniond& rotation = first().placed().placement.rotation;
    auto judged = std::make_shared<ToolpathStage>(*stage);
    judged->report.strength = toolpath::strengthOf(joined, *stage->toolPlan, 0, rotation * *load_);
    return judged;
  }

  std::shared_ptr<const ToolpathStage> withInserts(std::shared_ptr<const ToolpathStage> stage) {
    if (std::ranges::all_of(items_, [](const auto& item) { return item->inserts().empty(); }))
      return stage;
    auto made = std::make_shared<ToolpathStage>(*stage);
    plan::ToolPlan plan = *stage->toolPlan;
    const platform::PlatformSolid platform = project::platformOf(job());
    const bool isOnPlate = !platform.rod && !platform.mesh;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const std::span<const PlacedInsert> own = items_[i]->inserts();
      const int item = static_cast<int>(i);
      std::ranges::move(insertsAmong(plan, own, item), std::back_inserter(plan.inserts));
      std::ranges::move(insertFindings(plan, own, item, isOnPlate),
                        std::back_inserter(made->findings));
    }
    made->toolPlan = std::make_shared<const plan::ToolPlan>(std::move(plan));
    grown_.reset(); // without what is put in
    return made;
  }

  // Of the first item with forces.
  std::shared_ptr<const ToolpathStage> withLoad(std::shared_ptr<const ToolpathStage> stage,
                                                const base::RunContext& ctx) {
    const auto loaded =
        std::ranges::find_if(items_, [](const auto& item) { return item->forces() != nullptr; });
    if (loaded == items_.end())
      return stage;
    const ItemLoad& load = *(*loaded)->forces();
    auto judged = std::make_shared<ToolpathStage>(*stage);
    const auto item = static_cast<int>(loaded - items_.begin());
    elastic::LoadFigures made = elastic::loadFigures(*stage->toolPlan, item, resolved_.tooling,
                                                     load.cells, load.principal, ctx);
    judged->report.load = made.figures;
    if (made.unknown) {
      made.unknown->item = items_.size() > 1 ? item : -1;
      judged->findings.push_back(std::move(*made.unknown));
    }
    return judged;
  }

  bool motion() {
    motion_ = cachedOrMade<MotionStage>([&] { return moved(span(project::Stage::Motion)); });
    return motionDone();
  }

  motion::MotionOptions motionOptions() const {
    motion::MotionOptions options = motionOptionsOf(resolved_.values, resolved_.choices.seed);
    options.layerEvents.clear();
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const int item = static_cast<int>(i);
      std::ranges::move(eventsOfItem(items_[i]->loaded(), result_.item(i).resolved->values, item),
                        std::back_inserter(options.layerEvents));
      std::ranges::move(insertPauses(*result_.job.toolPlan, items_[i]->inserts(), item),
                        std::back_inserter(options.layerEvents));
    }
    return options;
  }

  std::unique_ptr<PartMotion> partMotion(const base::RunContext& ctx) {
    return std::make_unique<PartMotion>(*result_.job.toolPlan, project::platformOf(result_.job),
                                        *result_.cell, resolved_.tooling, motionOptions(),
                                        std::exchange(grown_, {}), ctx);
  }
  // Replay may require replanning of some paths. The planner's state is as large as the trajectory:
  // keep it of large plans only if motion skipped waypoints, when that is likely.
  std::shared_ptr<const MotionStage> moved(const base::RunContext& ctx) {
    std::unique_ptr<PartMotion> moving = partMotion(ctx.sub(0, 0.05));
    std::shared_ptr<const MotionStage> stage =
        moving->plan(ctx.sub(0.05, 1.0), context_.isTrial() ? plan::kBlockingShare : 1.0);
    if (!stage->trajectory && context_.reject(project::Stage::Motion, stage->findings))
      return stage;
    constexpr std::size_t kSmallPlan = 300'000; // waypoints
    if (stage->report.unreachable + stage->report.collisions > 0 ||
        result_.job.toolPlan->waypointCount() <= kSmallPlan)
      moving_ = std::move(moving);
    return stage;
  }

  bool motionDone() {
    job().trajectory = motion_->trajectory;
    report().motion = motion_->report;
    plan::Findings findings = motion_->findings;
    if (motion_->tooLarge) {
      const bool anyScale = items_.size() == 1 && !first().hasGivenPaths() &&
                            takesAnyScale(first().loaded(), resolved_.choices);
      findings.insert(findings.begin(),
                      tooLargeFinding(*motion_->tooLarge,
                                      anyScale ? std::optional(job().item().scale) : std::nullopt));
    }
    return done(project::Stage::Motion, findings, motion_->timings) && job().trajectory;
  }

  // Replans the motion without these waypoints too, at which replay found collisions.
  bool replanSkipping(const std::vector<std::size_t>& met) {
    const std::size_t motionFindings =
        job().stages[project::indexOf(project::Stage::Motion)].findings;
    report().findings.resize(report().findings.size() - motionFindings);
    const base::RunContext ctx = span(project::Stage::Replay).quiet();
    if (!moving_) {
      moving_ = partMotion(ctx);
      // Again, or for the first time if the motion came from the cache
      report().timings += moving_->plan(ctx)->timings;
    }
    motion_ = moving_->planWithout(met, ctx);
    fresh_ = true;
    return motionDone();
  }

  void programs() {
    ProgramHooks hooks;
    // Cached programs were written for the previous motion.
    hooks.take = [this](const std::string& format,
                        const std::function<ProgramHooks::Program()>& make) {
      return fresh_ ? make() : context_.cachedOrMade<CheckedProgram>(keyOf(format), format, make);
    };
    hooks.planWithout = [this](const std::vector<std::size_t>& waypoints) {
      return replanSkipping(waypoints);
    };
    hooks.isTrial = context_.isTrial();
    const ProgramsOutcome out = runPrograms(result_, hooks, span(project::Stage::Replay));
    keepFresh();
    if (out.isHopeless) // Some formats may not have been written
      context_.reject(project::Stage::Replay, out.findings);
    done(project::Stage::Replay, out.findings, out.timings);
  }

  std::string keyOf(const std::string& format) const {
    return programKey(keys_, first().loaded().name, resolved_, format) +
           base::keyText(motion::layerTimes(resolved_.values));
  }

  // Caches motion and programs together, so that the cache stays consistent whenever a plan is
  // cancelled.
  void keepFresh() {
    if (!fresh_ || !context_.cache() ||
        context_.isRejected()) // the programs are of the motion before
      return;
    context_.cache()->keep<MotionStage>(keys_[project::indexOf(project::Stage::Motion)], motion_);
    for (const auto& checked : result_.checked)
      context_.cache()->keep<CheckedProgram>(keyOf(checked->program.format), checked,
                                             checked->program.format);
  }

  base::Stopwatch whole_;
  const StageContext context_;
  const base::RunContext& ctx_;
  PlanResult result_;
  const Resolved& resolved_;                  // of the job: the first item's choices, in the result
  const std::optional<Eigen::Vector3d> load_; // in the frame of the part's file
  std::vector<std::unique_ptr<ItemStages>> items_;
  std::shared_ptr<const MotionStage> motion_;
  // Volume filled by the tool-paths made here, handed to motion planning
  std::shared_ptr<const collision::GrowingPart> grown_;
  std::unique_ptr<PartMotion> moving_; // nullptr: released
  bool fresh_ = false;                 // the motion is another one than its key's
  project::StageKeys keys_;
};

} // namespace

PlanResult planChosenStrategy(const PlanRequest& request, const base::RunContext& ctx,
                              StageCache* cache, const PlanObservers& observers, Trial* trial) {
  return StageRunner(request, ctx, cache, observers, trial).run();
}

} // namespace voluta::pipeline
