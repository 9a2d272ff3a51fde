// Crash recovery: a copy of each unsaved project, at most seconds old.
#pragma once

#include "document/recovery.h"
#include "jobs/job_runner.h"

#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <optional>

class QTimer;

namespace voluta::document {

class Document;

struct AutosaveOptions {
  int pauseMs = 2000;     // after the last edit
  int atLatestMs = 20000; // after the first edit not yet written
  QString folder = recoveryFolder();
};

// Writes the document, while it differs from its file, to <folder>/<id>.voluta with <id>.json
// beside it (name, original path, time, process): after edits, and after each stage of a plan. A
// worker writes both, each completely or not at all. They are removed when the document equals its
// file, and when this object is destroyed regularly: before closing a changed document the user was
// asked.
class Autosave : public QObject {
  Q_OBJECT

public:
  // `document` has to outlive the object.
  explicit Autosave(Document& document, AutosaveOptions options = {}, QObject* parent = nullptr);
  ~Autosave() override;

  // Call once the document holds that recovered copy; the copy is removed when a newer one exists.
  void adopt(const Recovered& recovered);
  // File of this document's next copy; it changes after a copy was removed.
  QString file() const { return file_; }

signals:
  void written();
  // Emitted once until a copy could be written again.
  void failed(const QString& message);

private:
  void noteChange();
  void write();
  void writeEnded(const base::Outcome<bool>& outcome);
  void remove();

  Document& document_;
  AutosaveOptions options_;
  QString file_;
  jobs::JobRunner runner_;
  QTimer *pause_, *atLatest_;
  std::optional<Recovered> adopted_;
  std::shared_ptr<std::atomic<bool>> unwanted_; // of the pending write
  bool again_ = false, reported_ = false;
};

} // namespace voluta::document
