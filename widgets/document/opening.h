// Parts and projects read in the background.
#pragma once

#include "document/recovery.h"
#include "jobs/job_runner.h"
#include "project/loaded_part.h"

#include <QObject>
#include <QString>
#include <cstddef>
#include <memory>

namespace voluta::document {

class Document;
class Planning;

// A part comes in twice: as read, at once, and then repaired; and again repaired, or as read, when
// that choice changes. A new request replaces one under way.
class Opening : public QObject {
  Q_OBJECT

public:
  // Both outlive this.
  Opening(Document& document, Planning& planning, QObject* parent = nullptr);
  ~Opening() override;

  // A project by its ending .voluta, anything else as a part; "sample:NAME" too.
  void open(const QString& path);
  void openPart(const QString& path);
  void openProject(const QString& file);
  // As a project that is not saved, with the file it was saved to before, if any.
  void openRecovered(const Recovered& recovered);
  // The rest of the document's print, from a point of its trajectory on (motion::resumePoint), as a
  // project of its own that is not saved; the document is as it was until then, and where no way
  // leads back to that point. Precondition: the motion is there and up to date.
  void resume(std::size_t point);
  // A repair under way is given up: the part stays as read, and is repaired when it is planned.
  void cancel();
  bool running() const { return runner_.running(); }

signals:
  // Of a recovered project `path` is where it was saved to, else its name.
  void started(const QString& path);
  void progressed(const voluta::jobs::Progress& progress);
  // The part as read or the project is in the document. `path` is empty for a recovered project
  // that was never saved.
  void opened(const QString& path, bool project);
  // The repaired part is in the document.
  void repaired();
  void cancelled();
  // One line: what, where, what would help. The document is as it was.
  void failed(const QString& path, const QString& message);

private:
  void readProject(const QString& file, const QString& projectFile, const QString& told,
                   bool unsaved);
  void repair();
  void endRepair(const base::Outcome<std::shared_ptr<const project::LoadedPart>>& outcome,
                 const QString& path);
  void giveUpRepair();

  Document& document_;
  Planning& planning_;
  jobs::JobRunner runner_;
  std::shared_ptr<const project::LoadedPart> repairing_; // as it was before
  // Whose repair was given up or failed: not tried again until the choice or the part changes.
  std::shared_ptr<const project::LoadedPart> refused_;
};

} // namespace voluta::document
