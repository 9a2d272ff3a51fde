#include "document/planning.h"

#include "base/memory.h"
#include "curved/decomposition.h"
#include "document/document.h"
#include "language/words.h"
#include "pipeline/resume.h"
#include "pipeline/search_texts.h"
#include "pipeline/stage_cache.h"

#include <QTimer>

namespace voluta::document {

using project::Stage;

namespace {
constexpr int kStartOverMs = 300;
// By then the views have dropped what they showed.
constexpr int kReturnMemoryMs = 1000;
using Result = std::shared_ptr<const pipeline::PlanResult>;
} // namespace

jobs::Progress progressOfStrategy(jobs::Progress progress,
                                  const pipeline::StrategyProgress& strategy) {
  progress.stage =
      base::message("{trying}: {stage}"_text, pipeline::tryingText(strategy), progress.stage);
  if (!strategy.isLast())
    progress.secondsLeft.reset();
  return progress;
}

Planning::Planning(Document& document, QObject* parent)
    : QObject(parent), document_(document), cache_(std::make_shared<pipeline::StageCache>()),
      startOver_(new QTimer(this)), returnMemory_(new QTimer(this)) {
  returnMemory_->setSingleShot(true);
  returnMemory_->setInterval(kReturnMemoryMs);
  connect(returnMemory_, &QTimer::timeout, this, [this] {
    memory_.run(
        [](const base::RunContext&) {
          base::returnFreedMemory();
          return true;
        },
        [](const base::Outcome<bool>&) {}, 1);
  });
  startOver_->setSingleShot(true);
  startOver_->setInterval(kStartOverMs);
  connect(startOver_, &QTimer::timeout, this, [this] {
    if (runner_.running())
      start();
  });
  connect(&document_, &Document::edited, this, &Planning::noteEdit);
  connect(&document_, &Document::sourceChanged, this, &Planning::noteSource);
  connect(&runner_, &jobs::JobRunner::progressed, this, &Planning::noteProgress);
}

Planning::~Planning() = default;

void Planning::startAfresh(std::shared_ptr<pipeline::StageCache> cache) {
  cancel();
  cache_ = cache ? std::move(cache) : std::make_shared<pipeline::StageCache>();
  returnMemory_->start();
}

bool Planning::running() const {
  return runner_.running() || waiting_.has_value();
}

void Planning::plan(Stage until) {
  if (!document_.source())
    return;
  until_ = until;
  if (!document_.sourceReady()) {
    waiting_ = until;
    return;
  }
  start();
}

// Plans the programs only: the choices alone would give the whole print, not its rest.
void Planning::startRest() {
  project::Job rest = document_.result(Stage::Motion)->job;
  rest.choices = document_.jobChoices();
  runner_.run(
      [this, rest = std::move(rest)](const base::RunContext& ctx, const jobs::Post& post) {
        const auto result =
            std::make_shared<const pipeline::PlanResult>(pipeline::writeRest(rest, ctx));
        post([this, result] {
          document_.stageDone(Stage::Replay, result);
          emit stageDone(Stage::Replay);
        });
        return result;
      },
      [this](const base::Outcome<Result>& outcome) { end(outcome); });
  emit started(until_);
}

void Planning::start() {
  waiting_.reset();
  startOver_->stop();
  strategy_.reset();
  const bool rest = document_.isRest() && until_ == Stage::Replay;
  document_.planStarted(until_);
  if (rest) {
    startRest();
    return;
  }
  runner_.run(
      [this, request = document_.request(until_), cache = cache_](const base::RunContext& ctx,
                                                                  const jobs::Post& post) {
        // `this` is used only in posted functions, which run on the thread of the window.
        const auto reportStage = [&](Stage stage, const pipeline::PlanResult& soFar) {
          post([this, stage, given = request.items,
                snapshot = std::make_shared<const pipeline::PlanResult>(soFar)] {
            // The plan repairs a part, or takes it as read, if it was not loaded that way.
            for (std::size_t i = 0; i < given.size(); ++i)
              if (snapshot->job.item(i).loaded != given[i].loaded)
                document_.replaceSource(given[i].loaded, snapshot->job.item(i).loaded);
            document_.stageDone(stage, snapshot);
            emit stageDone(stage);
          });
        };
        const auto preview = [&](std::shared_ptr<const curved::Decomposition> voxels,
                                 const pipeline::PlanResult& soFar) {
          post([this, shown = previewOf(std::move(voxels), soFar)] {
            document_.showPreview(shown);
          });
        };
        const auto reportStrategy = [&](const pipeline::StrategyProgress& strategy) {
          post([this, strategy] { strategy_ = strategy; });
        };
        return std::make_shared<const pipeline::PlanResult>(
            pipeline::planPart(request, ctx, cache.get(), {reportStage, preview, reportStrategy}));
      },
      [this](const base::Outcome<Result>& outcome) { end(outcome); });
  emit started(until_);
}

void Planning::noteProgress(const jobs::Progress& progress) {
  emit progressed(strategy_ ? progressOfStrategy(progress, *strategy_) : progress);
}

void Planning::end(const base::Outcome<Result>& outcome) {
  // An edit arrived when the plan was about to end: its result does not belong to that edit.
  const bool edited = startOver_->isActive() && !std::holds_alternative<base::Cancelled>(outcome);
  startOver_->stop();
  if (edited) {
    if (const auto* result = std::get_if<Result>(&outcome))
      document_.planEnded(*result);
    start();
    return;
  }
  if (const auto* result = std::get_if<Result>(&outcome)) {
    document_.planEnded(*result);
    emit finished();
  } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
    const Stage where = document_.planFailed(*error);
    emit failed(where, language::words(error->whole()));
  } else {
    document_.planCancelled();
    emit cancelled();
  }
}

void Planning::cancel() {
  if (waiting_ && !runner_.running()) {
    waiting_.reset();
    emit cancelled();
    return;
  }
  waiting_.reset();
  runner_.cancel();
}

void Planning::noteEdit() {
  if (!document_.source())
    cancel();
  else if (startsOver_ && runner_.running())
    startOver_->start();
}

void Planning::noteSource() {
  if (waiting_ && document_.sourceReady())
    start();
  else if (waiting_ && !document_.source())
    cancel();
}

} // namespace voluta::document
