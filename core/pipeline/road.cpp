#include "pipeline/road.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "modes/mode_table.h"
#include "pipeline/choices.h"
#include "pipeline/stage_keys.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

// Where each stage ends in the time that a whole plan of a usual part takes.
constexpr std::array<double, project::kStageCount> kEnds{0.02, 0.14, 0.22, 0.44, 0.6, 1.0};

// One plan: its stages in order, each taken from the cache or made.
class Road {
public:
  Road(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
       const StageObserver& onStage, const PreviewObserver& onPreview)
      : choices_(request.choices), until_(request.until), ctx_(ctx), cache_(cache),
        onStage_(onStage), onPreview_(onPreview), values_(parameterValues(choices_)),
        process_(std::make_shared<process::Process>(chosenProcess(choices_, values_))) {
    result_.process = process_;
    result_.debug = values_.boolean("output.debug");
    result_.keepRefused = values_.boolean("output.refused");
    job().choices = choices_;
    report().threads = ctx.threads();
    report().decomposition.mode = choices_.mode;
    ctx.report(0.0, "load"_text);
    loaded_ = request.loaded
                  ? project::withRepair(request.loaded, choices_.repair, span(project::Stage::Load))
                  : project::loadPart(request.part, choices_.repair, span(project::Stage::Load));
    job().loaded = loaded_;
    job().partName = loaded_->name;
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
  std::shared_ptr<const T> taken(const std::string& key, const std::string& slot, Make make) {
    std::shared_ptr<const T> stage = cache_ ? cache_->find<T>(key, slot) : nullptr;
    if (stage)
      return stage;
    stage = make();
    ctx_.checkpoint();
    if (cache_)
      cache_->keep<T>(key, stage, slot);
    return stage;
  }
  template <typename T, typename Make> std::shared_ptr<const T> taken(Make make) {
    return taken<T>(keys_[project::indexOf(T::kStage)], {}, make);
  }

  // A stage's share of what this plan comes to.
  base::RunContext span(project::Stage stage) const {
    const std::size_t s = project::indexOf(stage);
    const double all = kEnds[project::indexOf(until_)];
    return ctx_.sub((s > 0 ? kEnds[s - 1] : 0.0) / all, std::min(1.0, kEnds[s] / all));
  }

  // Notes that a stage is done; is there more to do?
  bool done(project::Stage stage, const plan::Findings& findings, const project::Timings& timings) {
    project::StageRecord& record = job().stages[project::indexOf(stage)];
    record = {keys_[project::indexOf(stage)], findings.size(), timings};
    report().findings.insert(report().findings.end(), findings.begin(), findings.end());
    report().timings += timings;
    report().timings.total = whole_.seconds();
    job().reached = stage;
    if (onStage_)
      onStage_(stage, result_);
    ctx_.checkpoint();
    return stage < until_;
  }

  bool load() {
    placed_ = taken<modes::LoadStage>(
        [&] { return loadStage(*loaded_, choices_, *process_, span(project::Stage::Load)); });
    const auto& stage = placed_;
    result_.placed = stage;
    job().scale = stage->scale;
    job().placement = stage->placement;
    job().part = stage->part;
    report().model = stage->report;
    report().model.file = loaded_->name;
    report().model.repairs = loaded_->notes;
    project::Timings timings = stage->timings;
    timings.load = loaded_->readS;
    timings.repair = loaded_->repairS;
    plan::Findings findings = remainingDefects(*loaded_);
    findings.insert(findings.end(), stage->findings.begin(), stage->findings.end());
    return done(project::Stage::Load, findings, timings);
  }

  modes::ModeChoices modeChoices() const { return {choices_, values_, *process_}; }

  // Most edits of a decomposition leave the voxels as they are.
  std::shared_ptr<const modes::PartVoxels> voxels(const base::RunContext& ctx) {
    const double voxelMm = values_.number("voxelMm");
    return taken<modes::PartVoxels>(
        fmt::format("{}voxels of {} mm\n", keys_[project::indexOf(project::Stage::Load)], voxelMm),
        "voxels", [&] { return modes::partVoxels(*placed_, voxelMm, ctx); });
  }

  bool decompose() {
    decomposed_ = taken<modes::DecomposeStage>([&] {
      const modes::ModeChoices choices = modeChoices();
      modes::DecomposeInput in{
          *placed_, choices, [&](const base::RunContext& ctx) { return voxels(ctx); }, {}};
      if (onPreview_)
        in.onPreview = [&](std::shared_ptr<const curved::Decomposition> soFar) {
          onPreview_(std::move(soFar), result_);
        };
      return modes::findMode(choices_.mode).decompose(in, span(project::Stage::Decompose));
    });
    job().platform = decomposed_->platform;
    job().lessPlatform = decomposed_->lessPlatform;
    job().decomposition = decomposed_->decomposition;
    job().pieces = decomposed_->pieces;
    report().decomposition = decomposed_->report;
    result_.cell = std::make_shared<robot::Cell>(
        robot::loadCell(choices_.cell, *process_, decomposed_->platform));
    for (const std::string& format : chosenFormats(choices_, *result_.cell))
      program::requireRodTurns(program::findDialect(format), *result_.cell);
    return done(project::Stage::Decompose, decomposed_->findings, decomposed_->timings);
  }

  bool layers() {
    const auto stage = taken<modes::LayersStage>([&] {
      return modes::findMode(choices_.mode)
          .layers(*decomposed_, job().printed(), modeChoices(), span(project::Stage::Layers));
    });
    job().layers = stage->layers;
    report().layers = stage->report;
    report().decomposition.supportVolumeMm3 =
        decomposed_->report.supportVolumeMm3 + stage->supportVolumeMm3;
    return done(project::Stage::Layers, stage->findings, stage->timings);
  }

  bool toolpath() {
    const auto stage = taken<ToolpathStage>([&] {
      return toolpathStage(*job().layers, job().platform, *process_, values_,
                           span(project::Stage::Toolpath));
    });
    job().toolPlan = stage->toolPlan;
    report().toolpath = stage->report;
    return done(project::Stage::Toolpath, stage->findings, stage->timings);
  }

  bool motion() {
    const auto stage = taken<MotionStage>([&] {
      return motionStage(*job().toolPlan, job().platform, *result_.cell, *process_, values_,
                         choices_.seed, span(project::Stage::Motion));
    });
    job().trajectory = stage->trajectory;
    report().motion = stage->report;
    return done(project::Stage::Motion, stage->findings, stage->timings) && job().trajectory;
  }

  void programs() {
    const std::vector<std::string> formats = chosenFormats(choices_, *result_.cell);
    const ProgramStageInput in{job().printed(),
                               job().platform,
                               *job().toolPlan,
                               *job().trajectory,
                               *result_.cell,
                               *process_,
                               std::filesystem::path(loaded_->name).stem().string()};
    plan::Findings findings;
    project::Timings timings;
    for (std::size_t i = 0; i < formats.size(); ++i) {
      const double count = static_cast<double>(formats.size()), at = static_cast<double>(i);
      const auto checked = taken<CheckedProgram>(
          programKey(keys_, loaded_->name, *process_, formats[i]), formats[i], [&] {
            return programStage(formats[i], in,
                                span(project::Stage::Replay).sub(at / count, (at + 1.0) / count));
          });
      result_.checked.push_back(checked);
      timings += checked->timings;
      tell(*checked, i == 0, findings);
    }
    done(project::Stage::Replay, findings, timings);
  }

  // The first program, the cell's own unless the user chose others, carries the verdict.
  void tell(const CheckedProgram& checked, bool first, plan::Findings& findings) {
    project::ProgramReport row;
    row.format = checked.program.format;
    row.foreign = checked.program.foreign;
    for (const plan::ProgramFile& file : checked.program.files) {
      row.files.push_back(file.name);
      row.bytes += file.text.size();
    }
    row.maxDeviationMm = checked.maxDeviationMm;
    row.maxDeviationRad = checked.maxDeviationRad;
    report().programs.push_back(std::move(row));
    if (first)
      report().replay = checked.verdict;
    if (first || !checked.passed)
      findings.insert(findings.end(), checked.findings.begin(), checked.findings.end());
    if (!checked.passed)
      findings.push_back(
          plan::makeFinding(plan::FindingKind::ProgramRefused,
                            {{"format", checked.program.format}, {"failed", checked.failed}}));
  }

  base::Stopwatch whole_;
  const project::Choices& choices_;
  project::Stage until_;
  const base::RunContext& ctx_;
  StageCache* cache_;
  const StageObserver& onStage_;
  const PreviewObserver& onPreview_;
  base::ParameterValues values_;
  std::shared_ptr<const process::Process> process_;
  std::shared_ptr<const project::LoadedPart> loaded_;
  std::shared_ptr<const modes::LoadStage> placed_;
  std::shared_ptr<const modes::DecomposeStage> decomposed_;
  project::StageKeys keys_;
  PlanResult result_;
};

} // namespace

PlanResult planPart(const PlanRequest& request, const base::RunContext& ctx, StageCache* cache,
                    const StageObserver& onStage, const PreviewObserver& onPreview) {
  checkChoices(request.choices);
  return Road(request, ctx, cache, onStage, onPreview).run();
}

project::StageKeys stageKeys(const PlanRequest& request) {
  base::require(request.loaded != nullptr, "stageKeys: a part that is loaded");
  checkChoices(request.choices);
  const base::ParameterValues values = parameterValues(request.choices);
  return keysOf(*request.loaded, request.choices, values, chosenProcess(request.choices, values));
}

PlanResult resultOf(project::Job job) {
  checkChoices(job.choices);
  PlanResult result;
  const base::ParameterValues values = parameterValues(job.choices);
  result.process = std::make_shared<process::Process>(chosenProcess(job.choices, values));
  if (job.platform.known())
    result.cell = std::make_shared<robot::Cell>(
        robot::loadCell(job.choices.cell, *result.process, job.platform));
  result.debug = values.boolean("output.debug");
  result.keepRefused = values.boolean("output.refused");
  if (job.part) {
    if (!job.placement)
      job.placement =
          placementByHandOrMode(*job.loaded->mesh, job.scale * unitMm(*job.loaded, job.choices),
                                {job.choices, values, *result.process});
    result.placed = loadStageOf(job);
  }
  result.job = std::move(job);
  return result;
}

bool nothingBlocks(const project::Report& report) {
  return std::none_of(report.findings.begin(), report.findings.end(),
                      [](const plan::Finding& f) { return f.blocking; });
}

} // namespace voluta::pipeline
