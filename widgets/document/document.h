// The project being edited: one or more parts, their choices, and the last plan.
#pragma once

#include "base/error.h"
#include "document/preview.h"
#include "pipeline/road.h"
#include "project/file_parts.h"
#include "project/job.h"
#include "project/job_stage.h"

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::regions {
struct PieceOfPart;
}

namespace voluta::document {

enum class StageState {
  Nothing,   // no result of this stage
  Running,   // being computed
  Done,      // the shown result is that of the choices
  OutOfDate, // the choices have changed since
  Differs,   // done, and safe to run, but the part is not printed as asked
  Blocked,   // done, but something cannot be reached or verified
  Failed     // the last run ended in an error here
};

// A run that ended in an error.
struct Failure {
  project::Stage stage;
  base::Error error;
};

// Edits are named commands on undoStack(); undo restores choices and parts. Results are cached by
// key: those of the shown parts, and those of the previous parts for undo and redo. One part is
// active: edits and choices() concern it. Lives on the thread of the window.
class Document : public QObject {
  Q_OBJECT

public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  // ---- the edited data

  // Choices of the active part with those of the job, as of a job of one part.
  const project::Choices& choices() const { return activeChoices_; }
  const project::Choices& jobChoices() const { return choices_; } // of all parts
  // The active part; null: no part is open.
  std::shared_ptr<const project::LoadedPart> source() const;
  // File from which it was read, or "sample:NAME"; empty if it came with a project.
  QString sourcePath() const;
  // False while a part is still being repaired; planning waits for it.
  bool sourceReady() const;
  std::size_t partCount() const;                 // 0: no part is open
  std::size_t active() const { return active_; } // index of the active part
  // In the order of the job's items.
  std::vector<std::shared_ptr<const project::LoadedPart>> sources() const;
  // Empty: never saved.
  const QString& projectFile() const { return projectFile_; }
  // For the title: the project's file name without folder and ending, otherwise the part's (with
  // "-rest" if the print is resumed), otherwise "Untitled".
  QString name() const;
  // Returns whether there are edits, or a plan, that the project's file does not contain.
  bool dirty() const;
  // Returns whether opening another part or project would discard unsaved work: a plan, finished or
  // running, or edits other than opening this part.
  bool hasUnsavedWork() const;
  QUndoStack* undoStack() { return &undo_; }
  // Counts every change of choices or source, including undo and redo.
  std::uint64_t revision() const { return revision_; }

  // ---- edits; `editName` is shown after "Undo" in the Edit menu. A command that changes nothing
  // is not recorded.
  // `choices`: an edit of choices(). Job-wide choices are set for every part.
  void setChoices(const project::Choices& choices, const QString& editName);
  // `choices`: an edit of jobChoices(). Precondition: it has as many items.
  void setJobChoices(const project::Choices& choices, const QString& editName);
  // To be called when a file named in the choices was written: results that depend on it become out
  // of date.
  void filesChanged();
  // A text of base::ParameterTable. The text of the default resets the parameter. Throws
  // Error{Usage} for an unknown key or an invalid value; then nothing changes.
  void setParameter(const QString& key, const QString& text);
  // Back to the value of the preset, or else to the default.
  void resetParameter(const QString& key);
  void resetParameters();
  void place(const geometry::Placement& placement, const QString& editName);
  void setScale(const QString& scale);
  // Shows another part; `ready` is false if a repaired version will follow. It begins with the
  // choices of a new project, except cell, process and formats, which belong to the workshop.
  // Choices made before any part was open are kept too, and so are those for the same file read
  // again; placement and scale are always reset. If the project has a file, that file is not
  // changed: the part begins a new project, without file and undo. Otherwise this is an edit like
  // any other, and undo restores the previous part with its results.
  void openPart(std::shared_ptr<const project::LoadedPart> part, const QString& path, bool ready);
  // Opens all parts of a file, as above, in their places to each other; the first one is active.
  // Precondition: there is one at least.
  void openParts(const std::vector<project::PartInFile>& parts, const QString& path, bool ready);
  // Adds a part beside the others and makes it active. It is built as the active part is, without
  // that part's own settings. The first part is opened instead.
  void addPart(std::shared_ptr<const project::LoadedPart> part, const QString& path, bool ready);
  // Adds all parts of a file, as above, in their places to each other; the last one is active.
  // Precondition: there is one at least.
  void addParts(const std::vector<project::PartInFile>& parts, const QString& path, bool ready);
  // Adds a copy of the active part, with its choices, beside the others and makes it active.
  void duplicatePart();
  // Remembers the active part, or several, with their choices, for pasteParts().
  void copyParts(const std::vector<std::size_t>& items);
  bool hasCopiedParts() const { return !copied_.empty(); }
  // Adds what copyParts() has remembered beside the others; also after it was removed, or another
  // project was opened. Precondition: hasCopiedParts().
  void pasteParts();
  // A part that takes the place of another one.
  struct Successor {
    std::shared_ptr<const project::LoadedPart> part; // its mesh in mm
    geometry::Placement placement;
    bool keepsPlace = false; // if no successor before it is there; else it goes beside all
    bool hasRegions = true;  // those of the part, at the same places of the material
  };
  // Replaces a part by others, at scale 1, with its choices; the first one is active. Precondition:
  // item < partCount(), there is at least one successor, and their meshes are in the work frame.
  void replacePart(std::size_t item, const std::vector<Successor>& by, const QString& editName);
  // Gives the active part another name; the ending of the present one stays. An empty name changes
  // nothing. Precondition: there is a part, and sourceReady().
  void renamePart(const QString& name);
  // Removes the active part. Precondition: there is one.
  void removePart() { removeParts({active_}); }
  // Removes several parts; if all, the document has none, as a new one. Precondition: `items` are
  // indices of parts, one at least.
  void removeParts(std::vector<std::size_t> items);
  // Returns how many parts are copies of the active one, with it.
  std::size_t copiesOfActive() const;
  // Takes over the parts and places that pipeline::withCopies() has made from request().
  void setCopies(const pipeline::PlanRequest& made);
  // Moves all parts beside each other (pipeline::withArrangedParts()). Throws Error{UnusableInput}
  // if the plate has no room for them, Error{Usage} for choices that cannot be planned.
  void arrangeParts();
  void setPrintOrder(layers::PrintOrder order);
  // Makes another part active. Not an edit. Precondition: item < partCount().
  void setActive(std::size_t item);
  // Replaces `part` by its repaired version in all edits; it is ready now. Not an edit.
  void replaceSource(const std::shared_ptr<const project::LoadedPart>& part,
                     std::shared_ptr<const project::LoadedPart> repaired);

  // Sets the initial choices of new projects, including this one. Precondition: nothing is open.
  void startWith(const project::Choices& choices);
  // ---- whole projects; these clear the undo stack
  void clear();
  // Opens the result of readJob and resultOf for a file; `file` empty: a project without a file.
  // `unsaved`: counts as changed. Precondition: the job has a part.
  void openJob(const pipeline::PlanResult& opened, const QString& file, bool unsaved);
  // To be called after `written`, a snapshot() of `revision`, was saved: the file becomes the
  // project's, and the document is clean if nothing has changed since.
  void saved(const QString& file, std::uint64_t revision, const project::Job& written);

  // ---- results

  // Returns the plan whose data of a stage is shown; null: none. It may not be that of the present
  // choices: see state().
  std::shared_ptr<const pipeline::PlanResult> result(project::Stage stage) const;
  // Returns that plan as one of the active part only (document/item_result.h); the same plan if
  // the job has one part.
  std::shared_ptr<const pipeline::PlanResult> itemResult(project::Stage stage) const;
  // Returns the plan of the furthest stage that has one.
  std::shared_ptr<const pipeline::PlanResult> lastResult() const;
  // Returns the plan whose findings and figures apply: that of the furthest stage after the first
  // whose data is that of the choices, otherwise the last one.
  std::shared_ptr<const pipeline::PlanResult> presentResult() const;
  // Newer than the result of Decompose; nullopt: nothing is being computed, or not far enough yet.
  const std::optional<Preview>& preview() const { return preview_; }
  // Returns whether the shown data of the stage is that of the choices, while the next stage's was
  // made from another.
  bool ahead(project::Stage stage) const;
  // Returns whether the shown voxels are newer than layers and paths: a preview, or a plan that got
  // this far.
  bool voxelsAhead() const;
  // Returns whether the shown voxels were made from the part in its present position.
  bool voxelsInPlace() const;
  StageState state(project::Stage stage) const;
  // Key of a stage's inputs with the present choices; empty: nothing can be planned.
  const std::string& key(project::Stage stage) const { return keys_[project::indexOf(stage)]; }
  // Returns whether the motion of a resumed print is shown and none of its inputs has changed:
  // planning then only rewrites its programs.
  bool isRest() const;
  // Error that prevents planning with the choices; its context names the parameter, if it concerns
  // one. null: there is none, or no part.
  const base::Error* unusable() const { return unusable_ ? &*unusable_ : nullptr; }
  // Returns whether the shown result is that of the choices.
  bool upToDate(project::Stage stage) const;
  // Failure of a run with the present choices; null: none.
  const Failure* failure() const;

  // Called by Planning. Results for another part than the shown one are ignored.
  void planStarted(project::Stage until);
  void stageDone(project::Stage stage, std::shared_ptr<const pipeline::PlanResult> result);
  void planEnded(std::shared_ptr<const pipeline::PlanResult> result); // of all stages
  // Restores the results shown before the run, unless the run got further.
  void planCancelled();
  // Returns the stage in which the run stopped.
  project::Stage planFailed(const base::Error& error);

  // Called by Planning and LivePreview.
  void showPreview(Preview preview);
  // Back to the last result.
  void dropPreview();
  // Called by LivePreview: a result up to Decompose, or the reason why there is none.
  void previewDone(std::shared_ptr<const pipeline::PlanResult> result);
  void previewFailed(const base::Error& error);

  // All inputs of a run; the parts are identified by their content.
  pipeline::PlanRequest request(project::Stage until) const;
  // The same for the active part alone.
  pipeline::PlanRequest itemRequest(project::Stage until) const;
  // All data to be saved, sharing the large arrays; may be passed to another thread. Results that
  // are out of date are omitted.
  project::Job snapshot() const;

signals:
  void choicesChanged();
  void sourceChanged();
  // Another part is active, or a part was added or removed; after the other signals.
  void partsChanged();
  void resultChanged(voluta::project::Stage stage);
  void previewChanged();
  void stateChanged();
  void dirtyChanged(bool dirty);
  void nameChanged(const QString& name);
  // An edit, an undo or a redo; not emitted for results of Planning.
  void edited();
  // Nothing unsaved is left: the document was saved, opened from its file, or closed.
  void settled();

private:
  struct Source;
  struct Parts;
  class EditCommand;
  // Source of the stage's shown data.
  struct Shown {
    std::shared_ptr<const pipeline::PlanResult> result;
    std::string key;
  };
  using ShownStages = std::array<Shown, project::kStageCount>;

  // What an edit changes.
  struct State {
    project::Choices choices;
    std::shared_ptr<Parts> parts;
    std::size_t active = 0;
  };
  State present() const { return {choices_, parts_, active_}; }
  void push(State after, const QString& editName);
  void apply(const State& state);
  void set(const State& state);
  void replaceAll(const State& state, const QString& file, bool unsaved);
  std::shared_ptr<Source> newSource(std::shared_ptr<const project::LoadedPart> part,
                                    const QString& path, bool ready);
  std::shared_ptr<Source> activeSource() const { return activeSourceOf(parts_, active_); }
  static std::shared_ptr<Source> activeSourceOf(const std::shared_ptr<Parts>& parts,
                                                std::size_t active);
  static bool haveSameContent(const std::shared_ptr<Parts>& a, const std::shared_ptr<Parts>& b);
  // Returns the state with more items, the last ones of `choices`, moved together beside the
  // others.
  State withSources(project::Choices choices,
                    const std::vector<std::shared_ptr<Source>>& sources) const;
  std::vector<std::shared_ptr<Source>> newSources(const std::vector<project::PartInFile>& parts,
                                                  const QString& path, bool ready);
  // Bounding box on the plate of a part in its place.
  Eigen::AlignedBox3d placedBox(std::size_t item) const;
  regions::PieceOfPart pieceOf(std::size_t item) const;
  // Returns the key of a stage's shown data; for a resumed print that of the choices with which it
  // was opened or run, `keys`.
  static std::string shownKey(const pipeline::PlanResult& result, std::size_t stage,
                              const project::StageKeys& keys);
  void refreshKeys();
  void dropResults() { showResults({}); }
  void showResults(ShownStages results);
  // Keeps the shown results of the parts that are left; of all parts left before, two plans.
  void keepResultsOf(const std::shared_ptr<Parts>& left);
  project::Choices choicesOfNextPart(const QString& path) const;
  // For automatic choices: adopts the way of building that a plan has chosen. Cannot be undone.
  void takeStrategy(const project::Choices& planned);
  void endRun();
  bool hasUnsavedPlan() const;
  // A run continues briefly after undo has restored another part.
  bool isOfSource(const pipeline::PlanResult& result) const;
  void emitDirtyAndName();

  project::Choices start_;         // of a new project
  project::Choices choices_;       // of all parts
  project::Choices activeChoices_; // of the active part only
  std::shared_ptr<Parts> parts_;   // null: no part is open
  std::size_t active_ = 0;
  std::vector<std::weak_ptr<Source>> sources_; // all that edits may refer to
  struct CopiedPart {
    project::ItemChoices choices;
    std::shared_ptr<Source> source;
  };
  std::vector<CopiedPart> copied_;
  std::weak_ptr<Parts> left_; // the previous parts, with their results
  QString projectFile_;
  QUndoStack undo_;
  bool unsaved_ = false;         // changed in a way that the undo stack does not record
  project::StageKeys savedKeys_; // of the results in the project's file
  bool wasDirty_ = false;
  QString lastName_;
  std::uint64_t revision_ = 0;

  project::StageKeys keys_;         // of the choices; empty texts if they have none
  ShownStages shown_, shownBefore_; // now; before the present run
  // The plan of the active part only, by stage, made from the shown plan.
  struct ItemShown {
    std::shared_ptr<const pipeline::PlanResult> of, one;
    std::size_t item = 0;
  };
  mutable std::array<ItemShown, project::kStageCount> itemShown_;
  std::optional<base::Error> unusable_;
  std::optional<Preview> preview_;
  std::optional<Failure> failure_;
  project::StageKeys runKeys_; // of the choices with which the last run began
  std::optional<project::Stage> running_;
  project::Stage until_ = project::Stage::Replay;
};

} // namespace voluta::document
