#include "document/saving.h"

#include "base/error.h"
#include "document/document.h"
#include "language/words.h"
#include "project/job.h"

#include <QFileInfo>
#include <filesystem>

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
  runner_.run(
      [file, job = document_.snapshot()](const base::RunContext&) {
        project::writeJob(std::filesystem::path(file.toStdString()), job);
        return true;
      },
      [this, file, revision = document_.revision()](const base::Outcome<bool>& outcome) {
        if (const auto* error = std::get_if<base::Error>(&outcome)) {
          emit failed(file, language::words(error->whole()));
        } else {
          document_.saved(file, revision);
          emit saved(file);
        }
        if (next_)
          write(*std::exchange(next_, std::nullopt));
      },
      1);
}

} // namespace voluta::document
