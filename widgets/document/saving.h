// The project file written in the background.
#pragma once

#include "jobs/job_runner.h"

#include <QObject>
#include <QString>
#include <optional>

namespace voluta::document {

class Document;

// Writes a snapshot of the moment it is asked for; edits go on meanwhile. The file is written whole
// or stays as it was.
class Saving : public QObject {
  Q_OBJECT

public:
  // `document` outlives this.
  explicit Saving(Document& document, QObject* parent = nullptr);

  // To the project's own file. Precondition: it has one.
  void save();
  // Appends ".voluta" where the name has no ending. While a save is under way the request waits
  // for it; of several that wait the last counts.
  void saveAs(const QString& file);
  bool running() const { return runner_.running(); }

signals:
  void saved(const QString& file);
  // One line; nothing is lost: the document is as it was, and so is the file.
  void failed(const QString& file, const QString& message);

private:
  void write(const QString& file);

  Document& document_;
  jobs::JobRunner runner_;
  std::optional<QString> next_;
};

} // namespace voluta::document
