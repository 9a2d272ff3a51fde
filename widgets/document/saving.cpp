#include "document/saving.h"

#include "base/error.h"
#include "document/document.h"
#include "language/words.h"
#include "project/job.h"

#include <QFileInfo>
#include <filesystem>
#include <memory>
#include <utility>

namespace voluta::document {

Saving::Saving(Document& document, QObject* parent) : QObject(parent), document_(document) {}

void Saving::save() {
  base::require(!document_.projectFile().isEmpty(), "Saving: a project with a file");
  saveAs(document_.projectFile());
}

void Saving::saveAs(const QString& file) {
  const QString whole =
      QFileInfo(file).suffix().isEmpty() ? file + QStringLiteral(".voluta") : file;
  if (!document_.source())
    emit failed(whole, tr("There is nothing to save yet. Open a part first."));
  else if (runner_.running())
    next_ = whole;
  else
    write(whole);
}

void Saving::write(const QString& file) {
  const auto job = std::make_shared<const project::Job>(document_.snapshot());
  runner_.run(
      [file, job](const base::RunContext&) {
        project::writeJob(std::filesystem::path(file.toStdString()), *job);
        return true;
      },
      [this, file, job, revision = document_.revision()](const base::Outcome<bool>& outcome) {
        if (const auto* error = std::get_if<base::Error>(&outcome)) {
          emit failed(file, language::words(error->whole()));
        } else {
          document_.saved(file, revision, *job);
          emit saved(file);
        }
        if (next_)
          write(*std::exchange(next_, std::nullopt));
      },
      1);
}

} // namespace voluta::document
