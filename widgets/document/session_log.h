// Log file of a session of the window, for diagnosing faults.
#pragma once

#include "base/log.h"
#include "project/job_stage.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>

namespace voluta::document {

class Document;
class Opening;
class Planning;

// VOLUTA_STATE_DIR if set, else QStandardPaths::AppDataLocation; "/voluta.log" below it.
QString logFile();

// Logs the environment, opened files (names without folders), the duration of each stage, findings
// and failures. If the file cannot be written, there is no log.
class SessionLog : public QObject {
  Q_OBJECT

public:
  // All have to outlive the object.
  SessionLog(const QString& file, Document& document, Planning& planning, Opening& opening,
             QObject* parent = nullptr);

  void note(const QString& line) const;

private:
  void listenToOpening(Opening& opening);
  void listenToPlanning(Planning& planning);
  void noteStage(project::Stage stage);
  void noteFindings() const;

  base::Log log_;
  Document& document_;
  QElapsedTimer sinceStage_, sinceStart_;
};

} // namespace voluta::document
