#include "window/pages/event_marks.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <optional>

namespace voluta::window {

namespace {
using plan::EventKind;

QString words(const char* text) {
  return QCoreApplication::translate("EventMarks", text);
}

QString text(const std::string& own) {
  return QString::fromStdString(own);
}

// Returns the text of an event; empty: it is none that the user asked for.
QString textOf(const plan::TrajectoryEvent& event, const std::vector<double>& waits) {
  switch (event.kind) {
  case EventKind::Pause:
    return event.text.empty()
               ? words(QT_TRANSLATE_NOOP("EventMarks", "Pause"))
               : words(QT_TRANSLATE_NOOP("EventMarks", "Pause: %1")).arg(text(event.text));
  case EventKind::Wait:
    return std::ranges::find(waits, event.seconds) == waits.end()
               ? QString()
               : words(QT_TRANSLATE_NOOP("EventMarks", "Wait: %1 s"))
                     .arg(QLocale().toString(event.seconds));
  case EventKind::Output:
    return (event.on ? words(QT_TRANSLATE_NOOP("EventMarks", "Output %1 on"))
                     : words(QT_TRANSLATE_NOOP("EventMarks", "Output %1 off")))
        .arg(event.tool);
  case EventKind::ToolChange:
    return words(QT_TRANSLATE_NOOP("EventMarks", "Tool %1")).arg(event.tool + 1);
  case EventKind::Statement:
    return QStringLiteral("%1: %2").arg(text(event.format), text(event.text));
  default:
    return {};
  }
}

// Returns the layer, from 1, that is printed next; nullopt: none is.
std::optional<int> nextLayer(const timeline::Clock& clock, std::size_t point) {
  const plan::Trajectory& t = *clock.trajectory();
  while (point < t.pointCount() && t.waypoint[point] == plan::kNoWaypoint)
    ++point;
  if (point >= t.pointCount())
    return std::nullopt;
  const auto& paths = clock.toolPlan()->paths;
  const auto behind =
      std::ranges::upper_bound(paths, t.waypoint[point], {}, &plan::ToolPath::first);
  return behind == paths.begin() ? std::nullopt : std::optional(std::prev(behind)->layer + 1);
}
} // namespace

std::vector<timeline::EventMark> eventMarks(const timeline::Clock& clock,
                                            const std::vector<double>& asked) {
  std::vector<timeline::EventMark> marks;
  if (clock.empty())
    return marks;
  for (const plan::TrajectoryEvent& event : clock.trajectory()->events) {
    // At the ends the outputs are set off, whatever is asked for.
    const auto layer = nextLayer(clock, event.point);
    if (event.point < 2 || !layer)
      continue;
    if (const QString said = textOf(event, asked); !said.isEmpty())
      marks.push_back(
          {clock.timeOfPoint(event.point - 1),
           words(QT_TRANSLATE_NOOP("EventMarks", "Before layer %1: %2")).arg(*layer).arg(said)});
  }
  return marks;
}

} // namespace voluta::window
