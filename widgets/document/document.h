// The project being edited: a part, its choices, and the last plan.
#pragma once

#include "base/error.h"
#include "document/preview.h"
#include "pipeline/road.h"
#include "project/job.h"
#include "project/loaded_part.h"
#include "project/stage.h"

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::document {

enum class StageState {
  Nothing,   // no result of this stage
  Running,   // being computed
  Done,      // the shown result is that of the choices
  OutOfDate, // the choices have changed since
  Blocked,   // done, but something cannot be printed, reached or verified
  Failed     // the last run ended in an error here
};

// A run that ended in an error.
struct Failure {
  project::Stage stage;
  base::Error error;
};

// Edits are named commands on undoStack(); undo restores choices and part. Results are cached by
// key: those of the shown part, and those of the previous part for undo and redo. Lives on the
// thread of the window.
class Document : public QObject {
  Q_OBJECT

public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  // ---- the edited data
  const project::Choices& choices() const { return choices_; }
  // null: no part is open.
  std::shared_ptr<const project::LoadedPart> source() const;
  // File from which the part was read, or "sample:NAME"; empty if it came with a project.
  QString sourcePath() const;
  // False while the part is still being repaired; planning waits for it.
  bool sourceReady() const;
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
  void setChoices(const project::Choices& choices, const QString& editName);
  // To be called when a file named in the choices was written: results that depend on it become out
  // of date.
  void filesChanged();
  // A text of base::ParameterTable. The text of the default resets the parameter. Throws
  // Error{Usage} for an unknown key or an invalid value; then nothing changes.
  void setParameter(const QString& key, const QString& text);
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

  // All inputs of a run; the part is identified by its content.
  pipeline::PlanRequest request(project::Stage until) const;
  // All data to be saved, sharing the large arrays; may be passed to another thread. Results that
  // are out of date are omitted.
  project::Job snapshot() const;

signals:
  void choicesChanged();
  void sourceChanged();
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
  class EditCommand;
  // Source of the stage's shown data.
  struct Shown {
    std::shared_ptr<const pipeline::PlanResult> result;
    std::string key;
  };
  using ShownStages = std::array<Shown, project::kStageCount>;

  void push(const project::Choices& choices, std::shared_ptr<Source> source,
            const QString& editName);
  void apply(const project::Choices& choices, const std::shared_ptr<Source>& source);
  void replaceAll(const project::Choices& choices, std::shared_ptr<Source> source,
                  const QString& file, bool unsaved);
  // Returns the key of a stage's shown data; for a resumed print that of the choices with which it
  // was opened or run, `keys`.
  static std::string shownKey(const pipeline::PlanResult& result, std::size_t stage,
                              const project::StageKeys& keys);
  void refreshKeys();
  void dropResults() { showResults({}); }
  void showResults(ShownStages results);
  // Keeps the shown results of the part that is left, and drops those of any other.
  void keepResultsOf(const std::shared_ptr<Source>& left);
  project::Choices choicesOfNextPart(const QString& path) const;
  // For automatic choices: adopts the way of building that a plan has chosen. Cannot be undone.
  void takeWay(const project::Choices& planned);
  void endRun();
  bool hasUnsavedPlan() const;
  // A run continues briefly after undo has restored another part.
  bool isOfSource(const pipeline::PlanResult& result) const;
  void tellDirtyAndName();

  project::Choices start_; // of a new project
  project::Choices choices_;
  std::shared_ptr<Source> source_;
  std::vector<std::weak_ptr<Source>> sources_; // all that edits may refer to
  std::weak_ptr<Source> left_;                 // the previous part, with its results
  QString projectFile_;
  QUndoStack undo_;
  bool unsaved_ = false;         // changed in a way that the undo stack does not record
  project::StageKeys savedKeys_; // of the results in the project's file
  bool wasDirty_ = false;
  QString lastName_;
  std::uint64_t revision_ = 0;

  project::StageKeys keys_;         // of the choices; empty texts if they have none
  ShownStages shown_, shownBefore_; // now; before the present run
  std::optional<base::Error> unusable_;
  std::optional<Preview> preview_;
  std::optional<Failure> failure_;
  project::StageKeys runKeys_; // of the choices with which the last run began
  std::optional<project::Stage> running_;
  project::Stage until_ = project::Stage::Replay;
};

} // namespace voluta::document
