#include "document/live_preview.h"

#include "curved/decomposition.h"
#include "document/document.h"
#include "document/planning.h"
#include "language/words.h"
#include "pipeline/stage_cache.h"

#include <QTimer>

namespace voluta::document {

using project::Stage;

namespace {
constexpr int kPauseMs = 300;
using Result = std::shared_ptr<const pipeline::PlanResult>;
} // namespace

LivePreview::LivePreview(Document& document, Planning& planning, QObject* parent)
    : QObject(parent), document_(document), planning_(planning), pause_(new QTimer(this)) {
  pause_->setSingleShot(true);
  pause_->setTimerType(Qt::PreciseTimer);
  connect(pause_, &QTimer::timeout, this, &LivePreview::start);
  connect(&document_, &Document::edited, this, &LivePreview::noteEdit);
  connect(&runner_, &jobs::JobRunner::progressed, this, &LivePreview::progressed);
  connect(&planning_, &Planning::started, this, [this](Stage until) {
    if (until > Stage::Load)
      stop();
  });
  // The first stage was still being planned at the end of the pause.
  const auto startIfDue = [this] {
    if (due_)
      start();
  };
  connect(&planning_, &Planning::finished, this, startIfDue);
  connect(&planning_, &Planning::cancelled, this, startIfDue);
  connect(&planning_, &Planning::failed, this, startIfDue);
}

LivePreview::~LivePreview() = default;

bool LivePreview::wanted() const {
  const bool planned = document_.result(Stage::Decompose) || document_.preview();
  return enabled_ && document_.source() && document_.sourceReady() && planned &&
         !document_.key(Stage::Decompose).empty() && !document_.upToDate(Stage::Decompose) &&
         !(planning_.running() && planning_.until() > Stage::Load);
}

void LivePreview::setEnabled(bool on) {
  enabled_ = on;
  if (on)
    noteEdit();
  else
    cancel();
}

void LivePreview::noteEdit() {
  const bool planning = planning_.running() && planning_.until() > Stage::Load;
  if (running() && runKey_ == document_.key(Stage::Decompose))
    return;
  const bool first = !pause_->isActive() && !running();
  runner_.cancel();
  due_ = false;
  if (wanted()) {
    // Via the timer, so that other listeners learn of the edit first: if the part has to be
    // rotated, the first stage is then planned once for both.
    pause_->start(first ? 0 : kPauseMs);
  } else {
    pause_->stop();
    if (!planning)
      document_.dropPreview();
  }
}

void LivePreview::refresh() {
  pause_->stop();
  if (!running() || runKey_ != document_.key(Stage::Decompose))
    start();
}

void LivePreview::stop() {
  pause_->stop();
  due_ = false;
  runner_.cancel();
}

void LivePreview::cancel() {
  const bool was = running();
  stop();
  if (!was)
    return;
  document_.dropPreview();
  emit cancelled();
}

void LivePreview::start() {
  due_ = false;
  if (!wanted() || (running() && runKey_ == document_.key(Stage::Decompose)))
    return;
  if (planning_.running()) {
    due_ = true;
    return;
  }
  runKey_ = document_.key(Stage::Decompose);
  runner_.run(
      [this, request = document_.request(Stage::Decompose),
       cache = planning_.cache()](const base::RunContext& ctx, const jobs::Post& post) {
        // `this` is used only in posted functions, which run on the thread of the window.
        const auto preview = [&](std::shared_ptr<const curved::Decomposition> voxels,
                                 const pipeline::PlanResult& soFar) {
          post([this, shown = previewOf(std::move(voxels), soFar)] {
            document_.showPreview(shown);
          });
        };
        return std::make_shared<const pipeline::PlanResult>(
            pipeline::planPart(request, ctx, cache.get(), {.onPreview = preview}));
      },
      [this](const base::Outcome<Result>& outcome) {
        if (const auto* result = std::get_if<Result>(&outcome)) {
          document_.previewDone(*result);
          emit finished();
        } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
          document_.previewFailed(*error);
          emit failed(language::words(error->whole()));
        }
      });
  emit started();
}

} // namespace voluta::document
