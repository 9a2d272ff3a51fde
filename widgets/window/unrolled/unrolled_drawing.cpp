#include "window/unrolled/unrolled_drawing.h"

#include "window/background.h"

namespace voluta::window {

void UnrolledDrawing::draw(const Subject& subject) {
  wanted_ = subject;
  if (!runner_.running())
    start();
}

void UnrolledDrawing::start() {
  if (drawn_ && *drawn_ == wanted_)
    return;
  inBackground(
      runner_,
      [now = wanted_](const base::RunContext& ctx) {
        return unrolledPicture(now.content, now.frame, now.look, ctx);
      },
      [this, now = wanted_](QImage&& made) {
        picture_ = std::move(made);
        drawn_ = now;
        emit changed();
        // Queued: the run is still emitting its end.
        QMetaObject::invokeMethod(
            this, [this] { draw(wanted_); }, Qt::QueuedConnection);
      });
}

} // namespace voluta::window
