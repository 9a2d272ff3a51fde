// The project being edited: a part, the choices made for it, and what was last planned.
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
  Running,   // being worked on now
  Done,      // the result on show is that of the choices
  OutOfDate, // the choices have changed since
  Blocked,   // done, but something of it cannot be printed, reached or verified
  Failed     // the last run ended in an error here
};

// A run that ended in an error.
struct Failure {
  project::Stage stage;
  base::Error error;
};

// Edits are commands on undoStack(), each with a name; undo brings back choices and part. Results
// are kept by what they were made from: those of the part on show, and those of the part that was
// left last, for undo and redo. Lives on the thread of the window.
class Document : public QObject {
  Q_OBJECT

public:
  explicit Document(QObject* parent = nullptr);
  ~Document() override;

  // ---- what is edited
  const project::Choices& choices() const { return choices_; }
  // null: no part is open.
  std::shared_ptr<const project::LoadedPart> source() const;
  // Where the part was read from, or "sample:NAME"; empty when it came with a project.
  QString sourcePath() const;
  // False while the part is still being repaired: planning waits for it.
  bool sourceReady() const;
  // Empty: never saved.
  const QString& projectFile() const { return projectFile_; }
  // For the title: the project's file name without folder and ending, else the part's (with "-rest"
  // where the print is taken up again), else "Untitled".
  QString name() const;
  // Are there edits, or a plan, that the project's file does not have?
  bool dirty() const;
  // Would another part or project take the place of work that no file has: a plan, also one that
  // runs, or edits other than that this part was opened?
  bool hasUnsavedWork() const;
  QUndoStack* undoStack() { return &undo_; }
  // Counts every change of choices or source, undo and redo included.
  std::uint64_t revision() const { return revision_; }

  // ---- edits; `editName` is what the Edit menu shows after "Undo". One that changes nothing is
  // not an edit.
  void setChoices(const project::Choices& choices, const QString& editName);
  // A file that the choices name was written: what was made from it before is out of date.
  void filesChanged();
  // A text of base::ParameterTable. The default's text takes the parameter back to unchanged.
  // Throws Error{Usage} for an unknown key or a wrong value; then nothing changes.
  void setParameter(const QString& key, const QString& text);
  void resetParameter(const QString& key);
  void resetParameters();
  void place(const geometry::Placement& placement, const QString& editName);
  void setScale(const QString& scale);
  // Shows another part; `ready` false when a repaired version will follow. It begins with the
  // choices of a new project; the cell, the process and the formats stay, being the workshop's.
  // Choices made before any part was open and those of the same file read again stay too, but for
  // the placement and the scale. Where the project has a file, that file stays as it is: the part
  // begins a project of its own, without file and undo. Else it is an edit like any other, and undo
  // brings back the part before it with its results.
  void openPart(std::shared_ptr<const project::LoadedPart> part, const QString& path, bool ready);
  // The repaired version of `part`, wherever edits refer to it; it is ready now. Not an edit.
  void replaceSource(const std::shared_ptr<const project::LoadedPart>& part,
                     std::shared_ptr<const project::LoadedPart> repaired);

  // What a new project begins with, this one too. Precondition: nothing is open.
  void startWith(const project::Choices& choices);
  // ---- whole projects; these clear the undo stack
  void clear();
  // What readJob and resultOf made of a file; `file` empty: a project without a file of its own.
  // `unsaved`: counts as changed. Precondition: the job has a part.
  void openJob(const pipeline::PlanResult& opened, const QString& file, bool unsaved);
  // After `written` was saved, a snapshot() of `revision`: the file is the project's, and clean if
  // nothing changed since.
  void saved(const QString& file, std::uint64_t revision, const project::Job& written);

  // ---- results
  // The plan that the data of a stage is shown from; null: none. Not always that of the choices:
  // see state().
  std::shared_ptr<const pipeline::PlanResult> result(project::Stage stage) const;
  // The plan of the furthest stage that has one.
  std::shared_ptr<const pipeline::PlanResult> lastResult() const;
  // The plan whose findings and figures count: that of the furthest stage beyond the first whose
  // data is that of the choices, else the last one.
  std::shared_ptr<const pipeline::PlanResult> presentResult() const;
  // Newer than the result of Decompose; none: nothing is under way, or not so far yet.
  const std::optional<Preview>& preview() const { return preview_; }
  // What is on show of the stage is that of the choices, and that of the next was made from
  // another.
  bool ahead(project::Stage stage) const;
  // The voxels on show are newer than layers and paths: a preview, or a plan that came so far.
  bool voxelsAhead() const;
  // The voxels on show were made from the part as it lies now.
  bool voxelsInPlace() const;
  StageState state(project::Stage stage) const;
  // What goes into a stage with the present choices; empty: nothing can be planned.
  const std::string& key(project::Stage stage) const { return keys_[project::indexOf(stage)]; }
  // The motion of a print that is taken up again is on show, and nothing that it is made from has
  // changed: planning writes its programs anew.
  bool isRest() const;
  // Why nothing can be planned with the choices; its context names the parameter, where it is one.
  // null: it can, or there is no part.
  const base::Error* unusable() const { return unusable_ ? &*unusable_ : nullptr; }
  // The result on show is that of the choices.
  bool upToDate(project::Stage stage) const;
  // Of the present choices; none: no run has failed since they are what they are.
  const Failure* failure() const;

  // Called by Planning. Results of another part than the one on show are ignored.
  void planStarted(project::Stage until);
  void stageDone(project::Stage stage, std::shared_ptr<const pipeline::PlanResult> result);
  void planEnded(std::shared_ptr<const pipeline::PlanResult> result); // of all stages
  // What was on show when the run began comes back, unless the run came further than that.
  void planCancelled();
  // Where the run stopped.
  project::Stage planFailed(const base::Error& error);

  // Called by Planning and LivePreview.
  void showPreview(Preview preview);
  // Back to the last result.
  void dropPreview();
  // Called by LivePreview: a result as far as Decompose, or why there is none.
  void previewDone(std::shared_ptr<const pipeline::PlanResult> result);
  void previewFailed(const base::Error& error);

  // All that a run needs; the part counts by its content.
  pipeline::PlanRequest request(project::Stage until) const;
  // Everything to be saved, sharing the big arrays: may go to another thread. Results that are out
  // of date are left out.
  project::Job snapshot() const;

signals:
  void choicesChanged();
  void sourceChanged();
  void resultChanged(voluta::project::Stage stage);
  void previewChanged();
  void stateChanged();
  void dirtyChanged(bool dirty);
  void nameChanged(const QString& name);
  // An edit, an undo or a redo; not for what Planning delivers.
  void edited();
  // Nothing would be lost now: the document was saved, opened from its file, or closed.
  void settled();

private:
  struct Source;
  class EditCommand;
  // What the stages' data on show was made from.
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
  // The key that the data of a stage has on show: of a print that is taken up again that of the
  // choices with which it was opened or run, `keys`.
  static std::string shownKey(const pipeline::PlanResult& result, std::size_t stage,
                              const project::StageKeys& keys);
  void refreshKeys();
  void dropResults() { showResults({}); }
  void showResults(ShownStages results);
  // Keeps what is on show of the part that is left, and of no other.
  void keepResultsOf(const std::shared_ptr<Source>& left);
  project::Choices choicesOfNextPart(const QString& path) const;
  // Of automatic choices: the way of building that a plan has come to. Nothing to be undone.
  void takeWay(const project::Choices& planned);
  void endRun();
  bool hasUnsavedPlan() const;
  // A run goes on for a moment after undo has brought back another part.
  bool isOfSource(const pipeline::PlanResult& result) const;
  void tellDirtyAndName();

  project::Choices start_; // of a new project
  project::Choices choices_;
  std::shared_ptr<Source> source_;
  std::vector<std::weak_ptr<Source>> sources_; // all that edits may refer to
  std::weak_ptr<Source> left_;                 // the part before, with its results
  QString projectFile_;
  QUndoStack undo_;
  bool unsaved_ = false;         // changed in a way that the undo stack does not know of
  project::StageKeys savedKeys_; // of the results in the project's file
  bool wasDirty_ = false;
  QString lastName_;
  std::uint64_t revision_ = 0;

  project::StageKeys keys_;         // of the choices; empty texts where they have none
  ShownStages shown_, shownBefore_; // now; before the run under way
  std::optional<base::Error> unusable_;
  std::optional<Preview> preview_;
  std::optional<Failure> failure_;
  project::StageKeys runKeys_; // of the choices that the last run began with
  std::optional<project::Stage> running_;
  project::Stage until_ = project::Stage::Replay;
};

} // namespace voluta::document
