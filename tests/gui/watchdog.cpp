#include "gui/watchdog.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QMetaEnum>
#include <QThread>
#include <algorithm>
#include <ctime>

namespace voluta::test {

namespace {
// Processor time of the window's thread: on a loaded machine wall time includes other programs.
double threadMs() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}
} // namespace

bool WatchedApplication::deliver(QObject* receiver, QEvent* event) {
  if (!event->isInputEvent() && event->type() != QEvent::Shortcut)
    return QApplication::notify(receiver, event);
  inputReceivers_.push_back(receiver);
  const bool taken = QApplication::notify(receiver, event);
  inputReceivers_.pop_back();
  return taken;
}

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
  const int loop = QThread::currentThread()->loopLevel();
  if (!under_.empty() && under_.back().loop == loop) { // part of the one being timed
    under_.back().paints = under_.back().paints || event->type() == QEvent::Paint;
    return deliver(receiver, event);
  }
  for (Delivery& outer : under_)
    outer.opensLoop = true;
  // The receiver may be deleted afterwards.
  const QString what =
      QString("%1 to %2 %3 of %4")
          .arg(QMetaEnum::fromType<QEvent::Type>().valueToKey(event->type()),
               receiver->metaObject()->className(), receiver->objectName(),
               receiver->parent() ? receiver->parent()->metaObject()->className() : "nothing");
  under_.push_back({loop});
  const bool frame = event->type() == QEvent::UpdateRequest && receiver->isWidgetType();
  const double framesBefore = framesMs_;
  QElapsedTimer timer;
  timer.start();
  const double workedBefore = threadMs();
  const bool taken = deliver(receiver, event);
  const double ms = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
  const double worked = threadMs() - workedBefore;
  const double beside = ms - (framesMs_ - framesBefore);
  // For one that paints, without the time spent waiting for the picture.
  const double apart = under_.back().paints ? std::min(beside, worked) : beside;
  if (frame) {
    longestFrameMs_ = std::max(longestFrameMs_, ms);
  } else if (!under_.back().opensLoop && apart > longestMs_) {
    longestMs_ = apart;
    longestWhat_ = what;
  }
  if (framesMs_ == framesBefore && !under_.back().opensLoop && !frame && worked > longestWorkMs_) {
    longestWorkMs_ = worked;
    longestWork_ = what;
  }
  under_.pop_back();
  return taken;
}

} // namespace voluta::test
