// What is left after a crash: a copy of every unsaved project, at most seconds old.
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
// beside it (name, original path, time, process): after edits, and after each stage of a plan.
// Both are written whole or not at all, by a worker. They are removed when the document is as it is
// in its file and when this is destroyed in good order: whoever closes a changed document has asked
// the user before.
class Autosave : public QObject {
  Q_OBJECT

public:
  // `document` outlives this.
  explicit Autosave(Document& document, AutosaveOptions options = {}, QObject* parent = nullptr);
  ~Autosave() override;

  // The document now holds that copy (to be called once it does), which goes when there is a newer
  // one.
  void adopt(const Recovered& recovered);
  // Of this document's next copy; another one after it was removed.
  QString file() const { return file_; }

signals:
  void written();
  // Told once until a copy could be written again.
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
  std::shared_ptr<std::atomic<bool>> unwanted_; // of the write under way
  bool again_ = false, told_ = false;
};

} // namespace voluta::document
