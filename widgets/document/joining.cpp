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
  using Read = std::shared_ptr<const project::Station>;
  reader_.run(
      [file = file.toStdString()](const base::RunContext&) -> Read {
        return std::make_shared<const project::Station>(pipeline::plannedStation(file));
      },
      [this, file](const base::Outcome<Read>& outcome) {
        if (const auto* station = std::get_if<Read>(&outcome))
          emit stationRead(file, *station);
        else if (const auto* error = std::get_if<base::Error>(&outcome))
          emit failed(language::words(error->whole()));
      },
      1);
}

void Joining::plan(project::Station station) {
  planner_.run(
      [this, station = std::move(station)](const base::RunContext& ctx) mutable -> JoinedResult {
        return std::make_shared<const pipeline::StationResult>(
            pipeline::planStation(std::move(station), ctx, &cache_));
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
        pipeline::StationResult written = *result; // large data are shared
        base::StagedFolder staged(folder);
        pipeline::writeStationOutputs(written, staged.path(), ctx);
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
