// Reads parts and projects in the background.
#pragma once

#include "document/recovery.h"
#include "jobs/job_runner.h"
#include "project/file_parts.h"

#include <QObject>
#include <QString>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::geometry {
struct Tessellation;
}

namespace voluta::document {

class Document;
class Planning;

// A part is delivered twice: first as read, then repaired; and again repaired, or as read, when
// that choice changes. A new request replaces a pending one.
class Opening : public QObject {
  Q_OBJECT

public:
  // Both have to outlive the object.
  Opening(Document& document, Planning& planning, QObject* parent = nullptr);
  ~Opening() override;

  // Opens a project if the ending is .voluta, otherwise a part; also "sample:NAME".
  void open(const QString& path);
  void openPart(const QString& path);
  // Adds a part to those that are open; also "sample:NAME".
  void addPart(const QString& path);
  // Sets the question whether a file of which two parts touch is opened as one part; without it, it
  // is opened as several. Called with the file and the names of the two parts.
  using AsOneQuestion =
      std::function<bool(const QString& path, const QString& first, const QString& second)>;
  void setAsOneQuestion(AsOneQuestion asks) { asksAsOne_ = std::move(asks); }
  void openProject(const QString& file);
  // Opens it as an unsaved project, with the file to which it was saved before, if any.
  void openRecovered(const Recovered& recovered);
  // Opens the rest of the document's print, from a point of its trajectory on
  // (motion::resumePoint), as a new unsaved project. The document is unchanged until then, and also
  // if no path leads back to that point. Precondition: the motion exists and is up to date.
  void resume(std::size_t point);
  // Aborts a pending repair: the part stays as read, and is repaired when it is planned.
  void cancel();
  bool running() const { return runner_.running(); }

signals:
  // For a recovered project, `path` is the file to which it was saved, otherwise its name.
  void started(const QString& path);
  void progressed(const voluta::jobs::Progress& progress);
  // The part as read, or the project, is in the document. `path` is empty for a recovered project
  // that was never saved.
  void opened(const QString& path, bool project);
  // The repaired part is in the document.
  void repaired();
  void cancelled();
  // One line: error, place, remedy. The document is unchanged.
  void failed(const QString& path, const QString& message);

private:
  using Part = std::shared_ptr<const project::LoadedPart>;
  using Parts = std::vector<project::PartInFile>;
  // `take`: what to do with the parts as read.
  using Take = std::function<void(const Parts&, bool ready)>;
  struct Read {
    Part repaired; // the only part; null: there are several
    Parts parts;   // several, as read
    std::optional<std::pair<std::size_t, std::size_t>> touching; // two of them
    Part asOne;                                                  // if two touch
  };
  static Read readSeveral(const QString& path, Parts parts, const geometry::Tessellation& facets,
                          std::size_t tools, const base::RunContext& ctx);
  void readPart(const QString& path, Take take);
  void endReading(const base::Outcome<Read>& outcome, const QString& path, const Take& take);
  void takeSeveral(const Read& read, const QString& path, const Take& take);
  bool isRepairedAsWanted() const;
  void readProject(const QString& file, const QString& projectFile, const QString& shownFile,
                   bool unsaved);
  void repair();
  void endRepair(const base::Outcome<std::shared_ptr<const project::LoadedPart>>& outcome,
                 const QString& path);
  void giveUpRepair();

  Document& document_;
  Planning& planning_;
  jobs::JobRunner runner_;
  AsOneQuestion asksAsOne_;
  std::shared_ptr<const project::LoadedPart> repairing_; // as it was before
  // Part whose repair was aborted or failed: not retried until the choice or the part changes.
  std::shared_ptr<const project::LoadedPart> refused_;
};

} // namespace voluta::document
