#include "document/run_comparing.h"

#include "language/words.h"

namespace voluta::document {

RunComparing::RunComparing(QObject* parent) : QObject(parent) {
  connect(&runner_, &jobs::JobRunner::progressed, this,
          [this](const jobs::Progress& progress) { emit progressed(progress.fraction); });
}

void RunComparing::compare(const QString& record,
                           std::shared_ptr<const pipeline::PlanResult> plan) {
  runner_.run(
      [file = record.toStdString(), plan = std::move(plan)](const base::RunContext& ctx) {
        return pipeline::compareRun(plan->job, std::filesystem::path(file), {}, ctx);
      },
      [this](const base::Outcome<pipeline::ComparedRun>& outcome) {
        if (const auto* run = std::get_if<pipeline::ComparedRun>(&outcome))
          emit compared(*run);
        else if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
      });
}

} // namespace voluta::document
