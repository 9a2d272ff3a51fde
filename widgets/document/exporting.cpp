#include "document/exporting.h"

#include "base/staged_folder.h"
#include "language/words.h"
#include "pipeline/checked_program.h"
#include "plan/program.h"

#include <QDir>
#include <QFileInfo>

namespace voluta::document {

Exporting::Exporting(QObject* parent) : QObject(parent) {}

QStringList Exporting::conflictingFiles(const QString& folder, const pipeline::PlanResult& plan,
                                        const pipeline::Programs& programs) {
  QStringList ofPrograms, others;
  for (const auto& checked : programs)
    for (const plan::ProgramFile& file : checked->program.files)
      ofPrograms << QString::fromStdString(pipeline::writtenName(*checked, file));
  for (const std::string& name : pipeline::handoverNames(plan, programs))
    if (const QString file = QString::fromStdString(name); !ofPrograms.contains(file))
      others << file;
  QStringList there = ofPrograms + others;
  there.removeIf(
      [&](const QString& file) { return !QFileInfo::exists(QDir(folder).filePath(file)); });
  return there;
}

void Exporting::write(const QString& folder, std::shared_ptr<const pipeline::PlanResult> plan,
                      pipeline::Programs programs, pipeline::ProofStyle proofStyle) {
  runner_.run(
      [folder = folder.toStdString(), plan = std::move(plan), programs = std::move(programs),
       proofStyle = std::move(proofStyle)](const base::RunContext& ctx) {
        base::StagedFolder staged(folder);
        pipeline::writeHandover(*plan, programs, staged.path(), ctx, proofStyle);
        staged.commit();
        return static_cast<int>(pipeline::handoverNames(*plan, programs).size());
      },
      [this, folder](const base::Outcome<int>& outcome) {
        if (const int* files = std::get_if<int>(&outcome))
          emit written(folder, *files);
        else if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
      },
      1);
}

void Exporting::finish(const QString& folder) {
  if (folder.isEmpty())
    return;
  finisher_.run([folder = folder.toStdString()](
                    const base::RunContext&) { return base::finishStaged(folder); },
                [this](const base::Outcome<bool>& outcome) {
                  if (const auto* error = std::get_if<base::Error>(&outcome))
                    emit failed(language::words(error->whole()));
                },
                1);
}

} // namespace voluta::document
