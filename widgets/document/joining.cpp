#include "document/joining.h"

#include "base/staged_folder.h"
#include "language/words.h"

namespace voluta::document {

Joining::Joining(QObject* parent) : QObject(parent) {
  connect(&planner_, &jobs::JobRunner::progressed, this, [this](const jobs::Progress& progress) {
    emit progressed(progress.fraction, language::words(progress.stage));
  });
}

void Joining::read(const QString& file) {
  using Read = std::shared_ptr<const project::Job>;
  reader_.run(
      [file = file.toStdString()](const base::RunContext&) -> Read {
        return std::make_shared<const project::Job>(pipeline::jobToJoin(file));
      },
      [this, file](const base::Outcome<Read>& outcome) {
        if (const auto* job = std::get_if<Read>(&outcome))
          emit jobRead(file, *job);
        else if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
      },
      1);
}

void Joining::plan(pipeline::TogetherRequest request) {
  planner_.run(
      [request = std::move(request)](const base::RunContext& ctx) mutable -> JoinedResult {
        return std::make_shared<const pipeline::TogetherResult>(
            pipeline::planTogether(std::move(request), ctx));
      },
      [this](const base::Outcome<JoinedResult>& outcome) {
        if (const auto* result = std::get_if<JoinedResult>(&outcome))
          emit planned(*result);
        else if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
        else
          emit cancelled();
      });
}

void Joining::cancel() {
  planner_.cancel();
}

void Joining::write(const QString& folder, JoinedResult result) {
  writer_.run(
      [folder = folder.toStdString(), result = std::move(result)](const base::RunContext& ctx) {
        pipeline::TogetherResult written = *result; // large data are shared
        base::StagedFolder staged(folder);
        pipeline::writeTogether(written, staged.path(), ctx);
        staged.commit();
        return true;
      },
      [this, folder](const base::Outcome<bool>& outcome) {
        if (std::get_if<bool>(&outcome))
          emit written(folder);
        else if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
      },
      1);
}

} // namespace voluta::document
