// Writes the project file in the background.
#pragma once

#include "jobs/job_runner.h"

#include <QObject>
#include <QString>
#include <optional>

namespace voluta::document {

class Document;

// Writes a snapshot taken at the time of the request; editing may continue. The file is written
// completely or left unchanged.
class Saving : public QObject {
  Q_OBJECT

public:
  // `document` has to outlive the object.
  explicit Saving(Document& document, QObject* parent = nullptr);

  // Saves to the project's own file. Precondition: it has one.
  void save();
  // Appends ".voluta" if the name has no ending. During a save the request waits; of several
  // waiting requests only the last is executed.
  void saveAs(const QString& file);
  bool running() const { return runner_.running(); }

signals:
  void saved(const QString& file);
  // One line; the document and the file are unchanged.
  void failed(const QString& file, const QString& message);

private:
  void write(const QString& file);

  Document& document_;
  jobs::JobRunner runner_;
  std::optional<QString> next_;
};

} // namespace voluta::document
