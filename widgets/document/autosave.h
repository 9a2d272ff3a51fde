// What is left after a crash: a copy of every unsaved project, at most seconds old.
#pragma once

#include "jobs/job_runner.h"

#include <QDateTime>
#include <QObject>
#include <QString>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

class QTimer;

namespace voluta::document {

class Document;

// A project whose program ended without closing it.
struct Recovered {
  QString file;         // the copy, a project file
  QString name;         // as in the title
  QString originalPath; // where the project was saved to; may be empty
  QDateTime time;       // of the copy
};

// VOLUTA_STATE_DIR if set, else QStandardPaths::AppLocalDataLocation; "/recovery" below it. Not
// made here.
QString recoveryFolder();
// Copies whose program is gone, the latest first; those of running programs are left alone.
std::vector<Recovered> recoverable(const QString& folder = recoveryFolder());
// Removes a copy and what belongs to it.
void discardRecovered(const Recovered& recovered);

struct AutosaveOptions {
  int pauseMs = 2000;     // after the last edit
  int atLatestMs = 20000; // after the first edit not yet written
  QString folder = recoveryFolder();
};

// Writes the document, while it differs from its file, to <folder>/<id>.voluta with <id>.json
// beside it (name, original path, time, process). Both are written whole or not at all, by a
// worker. They are removed when the document is clean again and when this is destroyed in good
// order: whoever closes a changed document has asked the user before.
class Autosave : public QObject {
  Q_OBJECT

public:
  // `document` outlives this.
  explicit Autosave(Document& document, AutosaveOptions options = {}, QObject* parent = nullptr);
  ~Autosave() override;

  // The document now holds that copy, which goes once there is a newer one.
  void adopt(const Recovered& recovered);
  // Of this document's copy.
  QString file() const { return file_; }

signals:
  void written();
  // Told once until a copy could be written again.
  void failed(const QString& message);

private:
  void noteChange();
  void write();
  void remove();

  Document& document_;
  AutosaveOptions options_;
  QString file_, metaFile_;
  jobs::JobRunner runner_;
  QTimer *pause_, *atLatest_;
  std::optional<Recovered> adopted_;
  std::shared_ptr<std::atomic<bool>> unwanted_; // of the write under way
  bool again_ = false, told_ = false;
};

} // namespace voluta::document
