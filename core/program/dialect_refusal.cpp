// What a dialect cannot say of a cell or a motion.
#include "base/units.h"
#include "geometry/directions.h"
#include "program/dialect.h"
#include "program/own_lines.h"

#include <algorithm>

namespace voluta::program {

namespace {
// The ids of the formats that can say it, separated by commas.
template <typename CanSay> std::string formatsThat(const CanSay& canSay) {
  std::string ids;
  for (const Dialect& dialect : dialects())
    if (canSay(dialect))
      ids += joined({ids.empty() ? "" : ", ", dialect.id});
  return ids;
}

base::Message useFormats(const std::string& ids) {
  return ids.empty() ? base::Message() : base::message("use {formats}"_text, ids);
}
} // namespace

bool hasWordFor(const Dialect& dialect, plan::EventKind kind) {
  // Said by the extruder's outputs, if motions do not state amounts instead.
  if (kind == plan::EventKind::StartLag || kind == plan::EventKind::StopLag)
    return !dialect.extruders.empty();
  return std::ranges::find(dialect.events, kind) != dialect.events.end();
}

bool leavesOut(const Dialect& dialect, plan::EventKind kind) {
  return kind == plan::EventKind::Purge && !hasWordFor(dialect, kind);
}

base::Text nameOf(plan::EventKind kind) {
  switch (kind) {
  case plan::EventKind::ToolChange:
    return "a tool change"_text;
  case plan::EventKind::Cut:
    return "a cut of the tape"_text;
  case plan::EventKind::Pause:
    return "a pause for the operator"_text;
  case plan::EventKind::Wait:
    return "a wait"_text;
  case plan::EventKind::Release:
    return "releasing the tool"_text;
  case plan::EventKind::Lock:
    return "locking the tool"_text;
  case plan::EventKind::Mark:
    return "a mark for the other machine"_text;
  case plan::EventKind::Purge:
    return "a purge of the nozzle"_text;
  case plan::EventKind::Shot:
    return "a shot into a pocket"_text;
  case plan::EventKind::StartLag:
    return "a wait for the extruder's start lag"_text;
  case plan::EventKind::StopLag:
    return "stopping the extruder ahead of a bead's end"_text;
  case plan::EventKind::Output:
    return "setting an output"_text;
  case plan::EventKind::Statement:
    return "a statement of your own"_text;
  case plan::EventKind::Feed:
    break;
  }
  return "feeding in place"_text;
}

void requireRodTurns(const Dialect& dialect, const robot::Cell& cell) {
  const auto movesAxes = [&](const Dialect& d) {
    return d.supportsExternalAxes || cell.externalAxes().empty() ||
           (d.supportsAxesOf != nullptr && d.supportsAxesOf(cell));
  };
  if (movesAxes(dialect))
    return;
  throw base::Error(
      base::ErrorCode::Usage,
      base::message("format {format} does not support external axes: it cannot move the {axis} of "
                    "cell {cell}"_text,
                    dialect.id, cell.externalAxes().front().name, cell.id()),
      {}, useFormats(formatsThat([&](const Dialect& d) {
        return movesAxes(d) && !(d.needsJoints && isForeign(d, cell));
      })));
}

void requireOwnRobot(const Dialect& dialect, const robot::Cell& cell) {
  if (!dialect.needsJoints || !isForeign(dialect, cell))
    return;
  throw base::Error(base::ErrorCode::Usage,
                    base::message("format {format} states joint values for another "
                                  "maker's arm, not for the {robot} of cell {cell}"_text,
                                  dialect.id, cell.robot().id, cell.id()),
                    {}, base::message("use {formats}"_text, cell.robot().controller));
}

void requireUpright(const Dialect& dialect, std::span<const Eigen::Vector3d> directions) {
  if (dialect.tiltsNozzle)
    return;
  double maximum = 0.0;
  for (const Eigen::Vector3d& n : directions)
    maximum = std::max(maximum, geometry::angleBetween(n, Eigen::Vector3d::UnitZ()));
  if (maximum <= kUprightRad)
    return;
  throw base::Error(
      base::ErrorCode::Usage,
      base::message("format {format} cannot tilt the nozzle, but this job tilts it by "
                    "{angle}"_text,
                    dialect.id, base::degrees(base::radiansToDegrees(maximum))),
      {},
      base::message("use {formats}, or a mode with flat layers"_text,
                    formatsThat([](const Dialect& d) { return d.tiltsNozzle; })));
}

void requireEvents(const Dialect& dialect, const plan::Trajectory& trajectory) {
  const auto require = [&](plan::EventKind kind) {
    if (!hasWordFor(dialect, kind))
      throw base::Error(
          base::ErrorCode::Usage,
          base::message("format {format} has no command for {event}"_text, dialect.id,
                        nameOf(kind)),
          {}, useFormats(formatsThat([&](const Dialect& d) { return hasWordFor(d, kind); })));
  };
  if (trajectory.firstTool != 0)
    require(plan::EventKind::ToolChange);
  for (const plan::TrajectoryEvent& event : trajectory.events)
    if (!leavesOut(dialect, event.kind)) {
      require(event.kind);
      requireOwnLine(dialect.id, event, trajectory);
    }
}

std::optional<base::Error> refusal(const Dialect& dialect, const robot::Cell& cell,
                                   std::span<const Eigen::Vector3d> directions,
                                   const plan::Trajectory* trajectory) {
  try {
    requireOwnRobot(dialect, cell);
    requireRodTurns(dialect, cell);
    requireUpright(dialect, directions);
    if (trajectory)
      requireEvents(dialect, *trajectory);
  } catch (const base::Error& error) {
    return error;
  }
  return std::nullopt;
}

} // namespace voluta::program
