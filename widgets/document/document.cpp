#include "document/document.h"

#include "document/choices_compare.h"
#include "document/document_parts.h"
#include "document/item_choices.h"
#include "document/mode_switch.h"
#include "document/stage_at.h"
#include "language/words.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/presets/chosen_preset.h"
#include "pipeline/stage_options.h"

#include <QFileInfo>
#include <QUndoCommand>
#include <algorithm>
#include <utility>

namespace voluta::document {

using project::indexOf;
using project::kStageCount;
using project::Stage;

class Document::EditCommand : public QUndoCommand {
public:
  EditCommand(Document& document, State before, State after, const QString& name)
      : QUndoCommand(name), document_(document), before_(std::move(before)),
        after_(std::move(after)) {}

  bool changesParts() const { return before_.parts != after_.parts; }
  void undo() override { document_.apply(before_); }
  void redo() override { document_.apply(after_); }

private:
  Document& document_;
  State before_, after_;
};

Document::Document(QObject* parent) : QObject(parent) {
  lastName_ = name();
  connect(&undo_, &QUndoStack::cleanChanged, this, &Document::emitDirtyAndName);
}

// The stack's last signals must not reach the destroyed object.
Document::~Document() {
  undo_.disconnect(this);
}

QString Document::name() const {
  if (!projectFile_.isEmpty())
    return QFileInfo(projectFile_).completeBaseName();
  if (parts_) {
    const auto motion = result(Stage::Motion);
    const std::string& first = parts_->items.front()->part->name;
    return QFileInfo(QString::fromStdString(first)).completeBaseName() +
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
  return parts_ && edits > 0 &&
         (parts_->items.size() > 1 ||
          !static_cast<const EditCommand*>(undo_.command(edits - 1))->changesParts() ||
          losesSettings(choices_, choicesOfNextPart({})));
}

void Document::emitDirtyAndName() {
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

void Document::push(State after, const QString& editName) {
  if (after.choices.cell != choices_.cell)
    after.choices.formats = writableFormats(after.choices);
  if (after.parts == parts_ && sameChoices(after.choices, choices_))
    return;
  undo_.push(new EditCommand(*this, present(), std::move(after), editName));
  emitDirtyAndName();
}

void Document::set(const State& state) {
  choices_ = state.choices;
  parts_ = state.parts;
  active_ = state.active;
  activeChoices_ = project::onlyItem(choices_, active_);
}

void Document::apply(const State& state) {
  const bool newChoices = !sameChoices(state.choices, choices_) || state.active != active_;
  const bool newParts = state.parts != parts_;
  const bool newSource = newParts || activeSourceOf(state.parts, state.active) != activeSource();
  const bool otherParts = newParts && !haveSameContent(state.parts, parts_);
  const bool partsChange = newParts || state.active != active_;
  // Taken first: the parts may be those that were left last.
  ShownStages kept = state.parts ? std::exchange(state.parts->results, {}) : ShownStages{};
  if (otherParts && parts_)
    keepResultsOf(parts_);
  set(state);
  ++revision_;
  refreshKeys();
  if (otherParts)
    showResults(std::move(kept));
  if (newSource)
    emit sourceChanged();
  if (newChoices)
    emit choicesChanged();
  if (partsChange)
    emit partsChanged();
  emit stateChanged();
  emitDirtyAndName();
  emit edited();
}

void Document::setChoices(const project::Choices& choices, const QString& editName) {
  project::Choices next = withItem(choices_, active_, choices);
  for (std::size_t i = 0; i < partCount(); ++i)
    if (parts_->items[i] == parts_->items[active_]) // Copies share one mesh, repaired or not
      next.item(i).repair = choices.item().repair;
  push({std::move(next), parts_, active_}, editName);
}

void Document::setJobChoices(const project::Choices& choices, const QString& editName) {
  base::require(choices.items.size() == choices_.items.size(), "Document: choices of all parts");
  push({choices, parts_, active_}, editName);
}

void Document::filesChanged() {
  ++revision_;
  refreshKeys();
  emit choicesChanged();
  emit stateChanged();
  emit edited();
}

void Document::setParameter(const QString& key, const QString& text) {
  project::Choices choices = activeChoices_;
  pipeline::setParameters(choices, {key.toStdString() + '=' + text.toStdString()});
  const base::ParameterTable table = parametersFor(choices);
  const base::ParameterSpec& spec = *table.find(base::currentKey(key.toStdString()));
  auto& given = pipeline::parametersOf(choices, spec.scope);
  if (given.at(spec.key) == base::formatParameter(spec.defaultValue))
    given.erase(spec.key);
  setChoices(choices, tr("Change %1").arg(language::words(spec.label)));
}

void Document::resetParameter(const QString& key) {
  project::Choices choices = activeChoices_;
  choices.parameters.erase(key.toStdString());
  choices.item().parameters.erase(key.toStdString());
  const pipeline::Settings preset = pipeline::settingsOfPreset(choices);
  if (const auto at = preset.find(key.toStdString()); at != preset.end())
    pipeline::setParameters(choices, {at->first + '=' + at->second});
  const base::ParameterTable table = pipeline::allParameters();
  const base::ParameterSpec* spec = table.find(key.toStdString());
  setChoices(choices, tr("Reset %1").arg(spec ? language::words(spec->label) : key));
}

void Document::resetParameters() {
  project::Choices choices = activeChoices_;
  choices.parameters.clear();
  choices.item().parameters.clear();
  setChoices(withPresetOr(choices, choices.preset), tr("Reset all parameters"));
}

void Document::place(const geometry::Placement& placement, const QString& editName) {
  project::Choices choices = activeChoices_;
  choices.item().placement = placement;
  setChoices(choices, editName);
}

void Document::setScale(const QString& scale) {
  project::Choices choices = activeChoices_;
  choices.item().scale = scale.toStdString();
  setChoices(choices, tr("Scale the part"));
}

// ---- whole projects

void Document::replaceAll(const State& state, const QString& file, bool unsaved) {
  undo_.clear();
  set(state);
  sources_.clear();
  if (parts_)
    sources_.assign(parts_->items.begin(), parts_->items.end());
  projectFile_ = file;
  savedKeys_ = {};
  unsaved_ = unsaved;
  ++revision_;
  refreshKeys();
  dropResults();
  emit sourceChanged();
  emit choicesChanged();
  emit partsChanged();
}

void Document::startWith(const project::Choices& choices) {
  start_ = choices;
  clear();
}

void Document::clear() {
  replaceAll({start_, nullptr, 0}, {}, false);
  emit stateChanged();
  emitDirtyAndName();
  emit settled();
}

void Document::openJob(const pipeline::PlanResult& opened, const QString& file, bool unsaved) {
  const project::Job& job = opened.job;
  const auto parts = std::make_shared<Parts>();
  for (const project::JobItem& item : job.items) {
    base::require(item.loaded != nullptr, "Document: a project with its parts");
    const auto same =
        std::ranges::find(parts->items, item.loaded, [](const auto& s) { return s->part; });
    parts->items.push_back(same != parts->items.end()
                               ? *same
                               : std::make_shared<Source>(Source{item.loaded, {}, true}));
  }
  replaceAll({job.choices, parts, 0}, file, unsaved);
  if (job.reached) {
    const auto result = std::make_shared<const pipeline::PlanResult>(opened);
    for (std::size_t s = 0; s <= indexOf(*job.reached); ++s) {
      shown_[s] = {result, shownKey(*result, s, keys_)};
      savedKeys_[s] = shown_[s].key;
      emit resultChanged(stageAt(s));
    }
  }
  emit stateChanged();
  emitDirtyAndName();
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
  emitDirtyAndName();
  if (!dirty())
    emit settled();
}

} // namespace voluta::document
