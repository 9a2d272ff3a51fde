#include "document/document.h"

#include "document/choices_compare.h"
#include "document/mode_switch.h"
#include "language/words.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/choices.h"
#include "plan/finding_kinds.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

namespace voluta::document {

using project::indexOf;
using project::kStageCount;
using project::Stage;

namespace {
Stage stageAt(std::size_t index) {
  return static_cast<Stage>(index);
}
} // namespace

// Shared by all edits of one part, so that its repaired version applies to all.
struct Document::Source {
  std::shared_ptr<const project::LoadedPart> part;
  QString path;
  bool ready = true;
  ShownStages results = {}; // while another part is shown
};

class Document::EditCommand : public QUndoCommand {
public:
  struct State {
    project::Choices choices;
    std::shared_ptr<Source> source;
  };

  EditCommand(Document& document, State before, State after, const QString& name)
      : QUndoCommand(name), document_(document), before_(std::move(before)),
        after_(std::move(after)) {}

  bool opensPart() const { return before_.source != after_.source; }
  void undo() override { document_.apply(before_.choices, before_.source); }
  void redo() override { document_.apply(after_.choices, after_.source); }

private:
  Document& document_;
  State before_, after_;
};

Document::Document(QObject* parent) : QObject(parent) {
  lastName_ = name();
  connect(&undo_, &QUndoStack::cleanChanged, this, &Document::tellDirtyAndName);
}

// The stack's last signals must not reach the destroyed object.
Document::~Document() {
  undo_.disconnect(this);
}

std::shared_ptr<const project::LoadedPart> Document::source() const {
  return source_ ? source_->part : nullptr;
}

QString Document::sourcePath() const {
  return source_ ? source_->path : QString();
}

bool Document::sourceReady() const {
  return source_ && source_->ready;
}

QString Document::name() const {
  if (!projectFile_.isEmpty())
    return QFileInfo(projectFile_).completeBaseName();
  if (source_) {
    const auto motion = result(Stage::Motion);
    return QFileInfo(QString::fromStdString(source_->part->name)).completeBaseName() +
           (motion && motion->job.resumedAt > 0 ? "-rest" : "");
  }
  return tr("Untitled");
}

bool Document::dirty() const {
  return unsaved_ || !undo_.isClean() || hasUnsavedPlan();
}

// Excludes voxels: a preview computes them without being asked.
bool Document::hasUnsavedPlan() const {
  for (std::size_t s = indexOf(Stage::Layers); s < kStageCount; ++s)
    if (upToDate(stageAt(s)) && shown_[s].key != savedKeys_[s])
      return true;
  return false;
}

bool Document::hasUnsavedWork() const {
  const bool plans = running_ && until_ > Stage::Load;
  if (plans || unsaved_ || hasUnsavedPlan())
    return true;
  if (undo_.isClean())
    return false;
  const auto last = lastResult();
  if (!projectFile_.isEmpty() || (last && *last->job.reached > Stage::Load))
    return true;
  const int edits = undo_.index();
  // Without a part there are at most settings, which the first part keeps.
  return source_ && edits > 0 &&
         (!static_cast<const EditCommand*>(undo_.command(edits - 1))->opensPart() ||
          losesSettings(choices_, choicesOfNextPart({})));
}

void Document::tellDirtyAndName() {
  if (const bool now = dirty(); now != wasDirty_) {
    wasDirty_ = now;
    emit dirtyChanged(now);
  }
  if (const QString now = name(); now != lastName_) {
    lastName_ = now;
    emit nameChanged(now);
  }
}

// ---- edits

void Document::push(const project::Choices& choices, std::shared_ptr<Source> source,
                    const QString& editName) {
  if (source == source_ && sameChoices(choices, choices_))
    return;
  undo_.push(new EditCommand(*this, {choices_, source_}, {choices, std::move(source)}, editName));
  tellDirtyAndName();
}

void Document::apply(const project::Choices& choices, const std::shared_ptr<Source>& source) {
  const bool newChoices = !sameChoices(choices, choices_), newSource = source != source_;
  const bool otherPart =
      newSource && !(source && source_ && source->part->hash == source_->part->hash);
  // Taken first: the part may be the one that was left last.
  ShownStages kept = source ? std::exchange(source->results, {}) : ShownStages{};
  if (otherPart && source_)
    keepResultsOf(source_);
  choices_ = choices;
  source_ = source;
  ++revision_;
  refreshKeys();
  if (otherPart)
    showResults(std::move(kept));
  if (newSource)
    emit sourceChanged();
  if (newChoices)
    emit choicesChanged();
  emit stateChanged();
  tellDirtyAndName();
  emit edited();
}

void Document::setChoices(const project::Choices& choices, const QString& editName) {
  push(choices, source_, editName);
}

void Document::filesChanged() {
  ++revision_;
  refreshKeys();
  emit choicesChanged();
  emit stateChanged();
  emit edited();
}

void Document::setParameter(const QString& key, const QString& text) {
  const base::ParameterTable table = parametersFor(choices_);
  base::ParameterValues values(table);
  values.set(key.toStdString(), text.toStdString());
  const base::ParameterSpec& spec = *table.find(base::currentKey(key.toStdString()));
  const base::ParameterValue& value = values.changes().at(spec.key);
  project::Choices choices = choices_;
  if (value == spec.defaultValue)
    choices.item().parameters.erase(spec.key);
  else
    choices.item().parameters[spec.key] = base::formatParameter(value);
  push(choices, source_, tr("Change %1").arg(language::words(spec.label)));
}

void Document::resetParameter(const QString& key) {
  project::Choices choices = choices_;
  choices.item().parameters.erase(key.toStdString());
  const base::ParameterTable table = pipeline::allParameters();
  const base::ParameterSpec* spec = table.find(key.toStdString());
  push(choices, source_, tr("Reset %1").arg(spec ? language::words(spec->label) : key));
}

void Document::resetParameters() {
  project::Choices choices = choices_;
  choices.item().parameters.clear();
  push(choices, source_, tr("Reset all parameters"));
}

void Document::place(const geometry::Placement& placement, const QString& editName) {
  project::Choices choices = choices_;
  choices.item().placement = placement;
  push(choices, source_, editName);
}

void Document::setScale(const QString& scale) {
  project::Choices choices = choices_;
  choices.item().scale = scale.toStdString();
  push(choices, source_, tr("Scale the part"));
}

void Document::openPart(std::shared_ptr<const project::LoadedPart> part, const QString& path,
                        bool ready) {
  base::require(part != nullptr, "Document: a part to open");
  const project::Choices choices = choicesOfNextPart(path);
  const QString editName = tr("Open %1").arg(QString::fromStdString(part->name));
  const auto opened = std::make_shared<Source>(Source{std::move(part), path, ready});
  if (!projectFile_.isEmpty()) {
    replaceAll(choices, opened, {}, true);
    emit stateChanged();
    tellDirtyAndName();
    emit edited();
    return;
  }
  std::erase_if(sources_, [](const std::weak_ptr<Source>& s) { return s.expired(); });
  sources_.push_back(opened);
  push(choices, opened, editName);
}

project::Choices Document::choicesOfNextPart(const QString& path) const {
  const project::Choices usual;
  project::Choices same = choices_;
  same.item().placement = usual.item().placement;
  same.item().scale = usual.item().scale;
  if (!source_ || (!path.isEmpty() && path == source_->path))
    return same;
  project::Choices next = start_;
  // A cell and a process that were set by the way of building are reset with it.
  const modes::Mode* mode =
      choices_.item().automatic ? nullptr : modes::modeNamed(choices_.item().mode);
  if (mode && mode->usual.cell == choices_.cell && mode->usual.cell != start_.cell)
    return next;
  next.cell = choices_.cell;
  next.tool().process = choices_.tool().process;
  next.formats = choices_.formats;
  try {
    return next.item().automatic ? pipeline::automaticChoices(next).front() : fitting(next);
  } catch (const base::Error&) {
    return next; // the plan reports the cell's error
  }
}

void Document::replaceSource(const std::shared_ptr<const project::LoadedPart>& part,
                             std::shared_ptr<const project::LoadedPart> repaired) {
  for (const std::weak_ptr<Source>& held : sources_) {
    const std::shared_ptr<Source> any = held.lock();
    if (any && any->part == part) {
      any->part = repaired;
      any->ready = true;
    }
  }
  if (!source_ || source_->part != repaired)
    return;
  refreshKeys();
  emit sourceChanged();
  emit stateChanged();
}

// ---- whole projects

void Document::replaceAll(const project::Choices& choices, std::shared_ptr<Source> source,
                          const QString& file, bool unsaved) {
  undo_.clear();
  choices_ = choices;
  source_ = std::move(source);
  sources_.assign(source_ ? 1 : 0, source_);
  projectFile_ = file;
  savedKeys_ = {};
  unsaved_ = unsaved;
  ++revision_;
  refreshKeys();
  dropResults();
  emit sourceChanged();
  emit choicesChanged();
}

void Document::startWith(const project::Choices& choices) {
  start_ = choices;
  clear();
}

void Document::clear() {
  replaceAll(start_, nullptr, {}, false);
  emit stateChanged();
  tellDirtyAndName();
  emit settled();
}

void Document::openJob(const pipeline::PlanResult& opened, const QString& file, bool unsaved) {
  const project::Job& job = opened.job;
  base::require(job.item().loaded != nullptr, "Document: a project with a part");
  replaceAll(job.choices, std::make_shared<Source>(Source{job.item().loaded, {}, true}), file,
             unsaved);
  if (job.reached) {
    const auto result = std::make_shared<const pipeline::PlanResult>(opened);
    for (std::size_t s = 0; s <= indexOf(*job.reached); ++s) {
      shown_[s] = {result, shownKey(*result, s, keys_)};
      savedKeys_[s] = shown_[s].key;
      emit resultChanged(stageAt(s));
    }
  }
  emit stateChanged();
  tellDirtyAndName();
  if (!unsaved)
    emit settled();
}

void Document::saved(const QString& file, std::uint64_t revision, const project::Job& written) {
  projectFile_ = file;
  savedKeys_ = written.keys();
  if (revision == revision_) {
    unsaved_ = false;
    undo_.setClean();
  }
  tellDirtyAndName();
  if (!dirty())
    emit settled();
}

// ---- results

void Document::refreshKeys() {
  keys_ = {};
  unusable_.reset();
  if (!source_)
    return;
  try {
    keys_ = pipeline::stageKeys(request(Stage::Replay));
  } catch (const base::Error& error) {
    unusable_ = error;
  }
}

void Document::showResults(ShownStages results) {
  failure_.reset();
  shownBefore_ = {};
  dropPreview();
  std::swap(shown_, results);
  for (std::size_t s = 0; s < kStageCount; ++s)
    if (shown_[s].result != results[s].result)
      emit resultChanged(stageAt(s));
}

void Document::keepResultsOf(const std::shared_ptr<Source>& left) {
  if (const auto before = left_.lock())
    before->results = {};
  left->results = shown_;
  left_ = left;
}

std::shared_ptr<const pipeline::PlanResult> Document::result(Stage stage) const {
  return shown_[indexOf(stage)].result;
}

std::shared_ptr<const pipeline::PlanResult> Document::lastResult() const {
  for (std::size_t s = kStageCount; s-- > 0;)
    if (shown_[s].result)
      return shown_[s].result;
  return nullptr;
}

std::shared_ptr<const pipeline::PlanResult> Document::presentResult() const {
  for (std::size_t s = kStageCount; s-- > indexOf(Stage::Decompose);)
    if (upToDate(stageAt(s)))
      return shown_[s].result;
  return lastResult();
}

bool Document::ahead(Stage stage) const {
  const std::size_t s = indexOf(stage);
  if (!upToDate(stage) || s + 1 == kStageCount)
    return false;
  const auto& next = shown_[s + 1].result;
  return !next || (next != shown_[s].result && next->job.stages[s].key != shown_[s].key);
}

bool Document::voxelsAhead() const {
  return preview_ || ahead(Stage::Decompose);
}

bool Document::voxelsInPlace() const {
  const std::string& now = key(Stage::Load);
  if (now.empty())
    return false;
  if (preview_)
    return preview_->loadKey == now;
  const auto result = this->result(Stage::Decompose);
  return result && result->job.stages[indexOf(Stage::Load)].key == now;
}

bool Document::isRest() const {
  const auto motion = result(Stage::Motion);
  return motion && motion->job.resumedAt > 0 && upToDate(Stage::Motion);
}

std::string Document::shownKey(const pipeline::PlanResult& result, std::size_t stage,
                               const project::StageKeys& keys) {
  const std::string& key = result.job.stages[stage].key;
  return key == project::kResumedKey ? keys[stage] : key;
}

const Failure* Document::failure() const {
  return failure_ && state(failure_->stage) == StageState::Failed ? &*failure_ : nullptr;
}

bool Document::upToDate(Stage stage) const {
  const std::size_t s = indexOf(stage);
  return shown_[s].result && !keys_[s].empty() && shown_[s].key == keys_[s];
}

StageState Document::state(Stage stage) const {
  const std::size_t s = indexOf(stage);
  if (running_ == stage)
    return StageState::Running;
  if (!running_ && failure_ && failure_->stage == stage && runKeys_[s] == keys_[s])
    return StageState::Failed;
  if (!shown_[s].result)
    return StageState::Nothing;
  if (!upToDate(stage))
    return StageState::OutOfDate;
  const plan::Findings& findings = shown_[s].result->job.report.findings;
  const bool blocked = std::any_of(findings.begin(), findings.end(), [&](const plan::Finding& f) {
    return f.blocking && plan::stageOf(f) == stage;
  });
  if (blocked)
    return StageState::Blocked;
  // A reopened project has its verdict, but no programs to export.
  const bool toHandOver = stage != Stage::Replay || !shown_[s].result->checked.empty();
  return toHandOver ? StageState::Done : StageState::Nothing;
}

void Document::planStarted(Stage until) {
  if (!running_) // on a restart, the results of the aborted run are not those from before it
    shownBefore_ = shown_;
  running_ = Stage::Load;
  until_ = until;
  runKeys_ = keys_;
  failure_.reset();
  emit stateChanged();
}

bool Document::isOfSource(const pipeline::PlanResult& result) const {
  return source_ && result.job.item().loaded &&
         result.job.item().loaded->hash == source_->part->hash;
}

void Document::stageDone(Stage stage, std::shared_ptr<const pipeline::PlanResult> result) {
  if (!isOfSource(*result))
    return;
  takeWay(result->job.choices);
  const std::size_t done = indexOf(stage);
  const bool changed = shown_[done].key != shownKey(*result, done, runKeys_) ||
                       !shown_[done].result ||
                       stage == Stage::Replay; // a reopened project lacks the programs
  for (std::size_t s = 0; s <= done; ++s)
    shown_[s] = {result, shownKey(*result, s, runKeys_)};
  const bool aheadBefore = preview_ && stage == Stage::Decompose;
  if (aheadBefore)
    preview_.reset();
  running_ = stage < until_ ? std::optional(stageAt(done + 1)) : std::nullopt;
  if (changed)
    emit resultChanged(stage);
  else if (aheadBefore)
    emit previewChanged();
  emit stateChanged();
  tellDirtyAndName();
}

void Document::takeWay(const project::Choices& planned) {
  if (!choices_.item().automatic || !planned.item().automatic ||
      (planned.item().automaticWay == choices_.item().automaticWay &&
       planned.item().mode == choices_.item().mode &&
       planned.item().platform == choices_.item().platform))
    return;
  choices_.item().automaticWay = planned.item().automaticWay;
  choices_.item().mode = planned.item().mode;
  if (!choices_.item().platformStays)
    choices_.item().platform = planned.item().platform;
  refreshKeys();
  emit choicesChanged();
}

void Document::planEnded(std::shared_ptr<const pipeline::PlanResult> result) {
  if (result->job.reached && isOfSource(*result))
    for (std::size_t s = 0; s <= indexOf(*result->job.reached); ++s)
      shown_[s].result = result;
  endRun();
  if (until_ > Stage::Load)
    dropPreview();
  emit stateChanged();
  tellDirtyAndName();
}

void Document::planCancelled() {
  // number of stages that the run has completed
  const std::size_t came = running_ ? indexOf(*running_) : 0;
  const bool further = std::any_of(shownBefore_.begin() + static_cast<std::ptrdiff_t>(came),
                                   shownBefore_.end(), [](const Shown& s) { return s.result; });
  const ShownStages before = shownBefore_;
  endRun();
  dropPreview();
  // Except the first: the part's position corresponds to the numbers.
  for (std::size_t s = 1; further && s < came; ++s) {
    const bool changed = shown_[s].key != before[s].key;
    shown_[s] = before[s];
    if (changed)
      emit resultChanged(stageAt(s));
  }
  emit stateChanged();
  tellDirtyAndName();
}

void Document::endRun() {
  running_.reset();
  shownBefore_ = {};
}

Stage Document::planFailed(const base::Error& error) {
  const Stage where = running_.value_or(until_);
  failure_ = Failure{where, error};
  endRun();
  dropPreview();
  emit stateChanged();
  return where;
}

void Document::showPreview(Preview preview) {
  if (!source_ || preview.partHash != source_->part->hash)
    return;
  preview_ = std::move(preview);
  emit previewChanged();
  emit stateChanged();
}

void Document::dropPreview() {
  if (!preview_)
    return;
  preview_.reset();
  emit previewChanged();
  emit stateChanged();
}

void Document::previewDone(std::shared_ptr<const pipeline::PlanResult> result) {
  if (!isOfSource(*result))
    return;
  takeWay(result->job.choices);
  for (const Stage stage : {Stage::Load, Stage::Decompose}) {
    const std::string& key = result->job.stages[indexOf(stage)].key;
    Shown& shown = shown_[indexOf(stage)];
    const bool changed = shown.key != key || !shown.result;
    shown = {result, key};
    if (stage == Stage::Decompose)
      preview_.reset();
    if (changed || stage == Stage::Decompose)
      emit resultChanged(stage);
  }
  emit stateChanged();
}

void Document::previewFailed(const base::Error& error) {
  failure_ = Failure{Stage::Decompose, error};
  runKeys_ = keys_;
  dropPreview();
  emit stateChanged();
}

pipeline::PlanRequest Document::request(Stage until) const {
  pipeline::PlanRequest request;
  request.item().loaded = source();
  request.choices = choices_;
  request.until = until;
  return request;
}

project::Job Document::snapshot() const {
  std::size_t current = 0; // number of leading stages whose results are those of the choices
  while (current < kStageCount && upToDate(stageAt(current)))
    ++current;
  project::Job job;
  if (current > 0)
    job = project::upTo(shown_[current - 1].result->job, stageAt(current - 1));
  job.choices = choices_;
  job.item().loaded = source();
  if (job.item().loaded)
    job.item().partName = job.item().loaded->name;
  return job;
}

} // namespace voluta::document
