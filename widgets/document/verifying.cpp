#include "document/verifying.h"

#include "language/words.h"

namespace voluta::document {

Verifying::Verifying(QObject* parent) : QObject(parent) {
  connect(&runner_, &jobs::JobRunner::progressed, this,
          [this](const jobs::Progress& progress) { emit progressed(progress.fraction); });
}

void Verifying::verify(const QString& program, std::shared_ptr<const pipeline::PlanResult> plan) {
  runner_.run(
      [file = program.toStdString(), plan = std::move(plan)](const base::RunContext& ctx) {
        return pipeline::verifyProgram(std::filesystem::path(file), plan->job, ctx);
      },
      [this](const base::Outcome<pipeline::VerifyResult>& outcome) {
        if (const auto* result = std::get_if<pipeline::VerifyResult>(&outcome))
          emit verified(*result);
        else if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
      });
}

} // namespace voluta::document
