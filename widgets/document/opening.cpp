#include "document/opening.h"

#include "base/staged_folder.h"
#include "document/document.h"
#include "document/planning.h"
#include "language/words.h"
#include "pipeline/resume.h"
#include "pipeline/stage_cache.h"
#include "pipeline/stage_options.h"
#include "process/process.h"
#include "project/cad_parts.h"
#include "project/job.h"

#include <QFileInfo>
#include <filesystem>
#include <utility>

namespace voluta::document {

namespace {
std::filesystem::path pathOf(const QString& file) {
  return file.toStdString();
}
} // namespace

Opening::Opening(Document& document, Planning& planning, QObject* parent)
    : QObject(parent), document_(document), planning_(planning) {
  connect(&runner_, &jobs::JobRunner::progressed, this, &Opening::progressed);
  connect(&runner_, &jobs::JobRunner::finished, this, &Opening::repair);
  connect(&document_, &Document::edited, this, &Opening::repair);
}

Opening::~Opening() = default;

void Opening::open(const QString& path) {
  if (path.endsWith(QStringLiteral(".voluta"), Qt::CaseInsensitive))
    openProject(path);
  else
    openPart(path);
}

void Opening::openPart(const QString& path) {
  readPart(path, [this, path](const Parts& parts, bool ready) {
    planning_.cancel();
    document_.openParts(parts, path, ready);
  });
}

void Opening::addPart(const QString& path) {
  readPart(path, [this, path](const Parts& parts, bool ready) {
    planning_.cancel();
    document_.addParts(parts, path, ready);
  });
}

Opening::Read Opening::readSeveral(const QString& path, Parts parts,
                                   const geometry::Tessellation& facets, std::size_t tools,
                                   const base::RunContext& ctx) {
  Read read;
  read.touching = project::touchingParts(parts);
  if (read.touching)
    read.asOne =
        project::withToolsOfJob(project::loadAsOne(path.toStdString(), false, facets, ctx), tools);
  read.parts = std::move(parts);
  return read;
}

void Opening::readPart(const QString& path, Take take) {
  giveUpRepair();
  runner_.run(
      [this, path, take, repair = document_.choices().item().repair,
       process = document_.jobChoices().tool().process,
       tools = document_.jobChoices().tools.size()](const base::RunContext& ctx,
                                                    const jobs::Post& post) {
        const geometry::Tessellation facets =
            geometry::tessellationFor(process::loadProcess(process).beadWidthMm);
        Parts parts = project::loadParts(path.toStdString(), false, facets, ctx.sub(0.0, 0.3));
        for (project::PartInFile& part : parts)
          part.part = project::withToolsOfJob(part.part, tools);
        if (parts.size() > 1)
          return readSeveral(path, std::move(parts), facets, tools, ctx.sub(0.3, 1.0));
        // `this` is used only in posted functions, which run on the thread of the window.
        const Part asRead = parts.front().part;
        post([this, path, take, parts, asRead, repair] {
          take(parts, !repair);
          repairing_ = asRead;
          emit opened(path, false);
        });
        return Read{project::withRepair(asRead, repair, ctx.sub(0.3, 1.0)), {}, {}, {}};
      },
      [this, path, take](const base::Outcome<Read>& outcome) { endReading(outcome, path, take); });
  emit started(path);
}

void Opening::endReading(const base::Outcome<Read>& outcome, const QString& path,
                         const Take& take) {
  if (const auto* read = std::get_if<Read>(&outcome)) {
    if (read->repaired)
      endRepair(read->repaired, path);
    else
      takeSeveral(*read, path, take);
  } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
    endRepair(*error, path);
  } else {
    endRepair(base::Cancelled{}, path);
  }
}

// repair() follows, since no run is left.
void Opening::takeSeveral(const Read& read, const QString& path, const Take& take) {
  const bool repair = document_.choices().item().repair;
  const auto nameOf = [&](std::size_t part) {
    return QString::fromStdString(read.parts[part].part->name);
  };
  if (read.touching && asksAsOne_ &&
      asksAsOne_(path, nameOf(read.touching->first), nameOf(read.touching->second)))
    take({{read.asOne}}, !repair);
  else
    take(read.parts, !repair);
  emit opened(path, false);
  if (isRepairedAsWanted())
    emit repaired();
}

bool Opening::isRepairedAsWanted() const {
  const std::vector<Part> parts = document_.sources();
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i]->repair != document_.jobChoices().item(i).repair && parts[i] != refused_)
      return false;
  return true;
}

void Opening::openProject(const QString& file) {
  readProject(file, file, file, false);
}

void Opening::openRecovered(const Recovered& recovered) {
  readProject(recovered.file, recovered.originalPath,
              recovered.originalPath.isEmpty() ? recovered.name : recovered.originalPath, true);
}

void Opening::readProject(const QString& file, const QString& projectFile, const QString& shownFile,
                          bool unsaved) {
  giveUpRepair();
  using Opened = std::shared_ptr<const pipeline::PlanResult>;
  const auto cache = std::make_shared<pipeline::StageCache>();
  runner_.run(
      [file, cache](const base::RunContext& ctx) -> Opened {
        ctx.report(0.0, "open"_text);
        base::finishStaged(std::filesystem::absolute(pathOf(file)).parent_path());
        project::Job job = project::readJob(pathOf(file), pipeline::allParameters());
        ctx.report(0.8, "open"_text);
        pipeline::seedCache(*cache, job);
        return std::make_shared<const pipeline::PlanResult>(pipeline::resultOf(std::move(job)));
      },
      [this, projectFile, shownFile, unsaved, cache](const base::Outcome<Opened>& outcome) {
        if (const auto* result = std::get_if<Opened>(&outcome)) {
          planning_.startAfresh(cache);
          document_.openJob(**result, projectFile, unsaved);
          emit opened(projectFile, true);
        } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
          emit failed(shownFile, language::words(error->whole()));
        } else {
          emit cancelled();
        }
      },
      1);
  emit started(shownFile);
}

void Opening::resume(std::size_t point) {
  giveUpRepair();
  base::require(document_.upToDate(project::Stage::Motion), "Opening: a motion to take up");
  project::Job job = document_.result(project::Stage::Motion)->job;
  job.choices = document_.jobChoices();
  const QString name = tr("the rest of %1").arg(document_.name());
  using Resumed = std::shared_ptr<const pipeline::ResumeResult>;
  runner_.run(
      [job = std::move(job), point](const base::RunContext& ctx) -> Resumed {
        return std::make_shared<const pipeline::ResumeResult>(
            pipeline::resumeJob(job, point, {}, ctx));
      },
      [this, name](const base::Outcome<Resumed>& outcome) {
        if (const auto* resumed = std::get_if<Resumed>(&outcome)) {
          const pipeline::PlanResult& plan = (*resumed)->plan;
          if (plan.job.resumedAt == 0) { // no path leads there
            const plan::Findings& findings = plan.job.report.findings;
            emit failed(name, findings.empty() ? QString()
                                               : language::words(plan::reasonOf(findings.back())));
            return;
          }
          planning_.cancel();
          document_.openJob(plan, {}, true);
          emit opened({}, true);
        } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
          emit failed(name, language::words(error->whole()));
        } else {
          emit cancelled();
        }
      });
  emit started(name);
}

// Adapts each part to the choice whether to repair it.
void Opening::repair() {
  if (runner_.running())
    return;
  const std::vector<Part> parts = document_.sources();
  bool allAsWanted = true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    const bool wanted = document_.jobChoices().item(i).repair;
    if (part->repair == wanted)
      continue;
    allAsWanted = false;
    if (part == refused_)
      continue;
    repairing_ = part;
    runner_.run(
        [part, wanted](const base::RunContext& ctx) {
          return project::withRepair(part, wanted, ctx);
        },
        [this](const base::Outcome<Part>& outcome) { endRepair(outcome, document_.sourcePath()); });
    emit started(document_.sourcePath());
    return;
  }
  if (allAsWanted && !parts.empty())
    refused_.reset();
}

void Opening::endRepair(const base::Outcome<Part>& outcome, const QString& path) {
  if (const auto* part = std::get_if<Part>(&outcome)) {
    document_.replaceSource(std::exchange(repairing_, nullptr), *part);
    if (isRepairedAsWanted())
      emit repaired();
    return;
  }
  giveUpRepair();
  if (const auto* error = std::get_if<base::Error>(&outcome))
    emit failed(path, language::words(error->whole()));
  else
    emit cancelled();
}

// Leaves the part as it is; planning repairs it.
void Opening::giveUpRepair() {
  if (!repairing_)
    return;
  refused_ = std::exchange(repairing_, nullptr);
  document_.replaceSource(refused_, refused_);
}

void Opening::cancel() {
  runner_.cancel();
}

} // namespace voluta::document
