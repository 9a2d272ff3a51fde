// Programs into a folder.
#include "window/main_window.h"

#include "base/files.h"
#include "pipeline/outputs.h"
#include "window/status_line.h"

#include <algorithm>

namespace voluta::window {

using project::Stage;

void MainWindow::exportPrograms(const QString& folder, const QStringList& formats,
                                bool includeRefused) {
  const auto result = document_.result(Stage::Replay);
  const auto there = [&](const QString& id) {
    return result &&
           std::any_of(result->checked.begin(), result->checked.end(), [&](const auto& program) {
             return QString::fromStdString(program->program.format) == id;
           });
  };
  if (std::all_of(formats.begin(), formats.end(), there) && document_.upToDate(Stage::Replay)) {
    writePrograms(folder, formats, includeRefused);
    return;
  }
  pendingExport_ = PendingExport{folder, formats, includeRefused};
  planning_.plan(Stage::Replay);
}

void MainWindow::writePrograms(const QString& folder, const QStringList& formats,
                               bool includeRefused) {
  const auto result = document_.result(Stage::Replay);
  if (!result)
    return;
  std::vector<std::shared_ptr<const pipeline::CheckedProgram>> chosen;
  QStringList refused;
  for (const auto& program : result->checked)
    if (formats.contains(QString::fromStdString(program->program.format))) {
      if (program->passed || includeRefused)
        chosen.push_back(program);
      else
        refused << QString::fromStdString(program->program.format);
    }
  exporting_.run(
      [chosen, folder = folder.toStdString()](const base::RunContext& ctx) {
        base::StagedFolder staged(folder);
        int files = 0;
        for (const auto& program : chosen)
          for (const plan::ProgramFile& file : program->program.files) {
            ctx.checkpoint();
            base::writeFile(staged.path() / pipeline::writtenName(*program, file), file.text);
            ++files;
          }
        staged.commit();
        return files;
      },
      [this, folder, refused](base::Outcome<int> outcome) {
        if (const int* files = std::get_if<int>(&outcome)) {
          QString text = tr("Files written to %1: %2").arg(folder).arg(*files);
          if (!refused.isEmpty())
            text += tr("; refused and not written: %1").arg(refused.join(", "));
          status_->showIdle(text);
        } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
          tell(tr("Nothing is exported"), QString::fromStdString(error->what()));
        }
      },
      1);
}

} // namespace voluta::window
