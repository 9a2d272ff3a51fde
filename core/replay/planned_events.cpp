#include "replay/planned_events.h"

#include "plan/finding_kinds.h"

#include <algorithm>
#include <optional>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;
using plan::EventKind, plan::FactKind, plan::StatedFact, plan::TrajectoryEvent;

// Returns the event that a statement stands for; nullopt for statements that are no events.
std::optional<EventKind> eventOf(FactKind kind) {
  switch (kind) {
  case FactKind::OperatorStop:
    return EventKind::Pause;
  case FactKind::ToolSelected:
    return EventKind::ToolChange;
  case FactKind::TapeCut:
    return EventKind::Cut;
  default:
    return std::nullopt;
  }
}

base::Message nameOf(EventKind kind) {
  switch (kind) {
  case EventKind::ToolChange:
    return "the change to another tool"_text;
  case EventKind::Cut:
    return "the cut of the tape"_text;
  case EventKind::Pause:
    return "a pause for the operator"_text;
  case EventKind::Feed:
    break;
  }
  return "feeding in place"_text;
}

class EventComparer {
public:
  EventComparer(const plan::ReadProgram& program, const plan::Trajectory& trajectory,
                const Alignment& alignment)
      : program_(program), trajectory_(trajectory), alignment_(alignment),
        found_(trajectory.events.size(), false) {}

  std::vector<TextFinding> compare() {
    for (const StatedFact& fact : program_.facts)
      if (const auto kind = eventOf(fact.kind); kind && isBetweenMotions(fact))
        stated(fact, *kind);
    for (std::size_t e = 0; e < found_.size(); ++e)
      if (!found_[e] && isToBeStated(trajectory_.events[e]))
        missing(trajectory_.events[e]);
    return std::move(findings_);
  }

private:
  bool isBetweenMotions(const StatedFact& fact) const {
    return fact.before > program_.firstMotion && fact.before < program_.motions.size();
  }
  // Filament that is fed in place is compared as material.
  bool isToBeStated(const TrajectoryEvent& event) const {
    return event.kind != EventKind::Feed && motionTo(event.point) >= program_.firstMotion;
  }
  std::size_t pointOf(std::size_t motion) const {
    const std::size_t point = alignment_.pointOf[motion];
    return point == kUnmatched && motion < alignment_.leadsTo.size() ? alignment_.leadsTo[motion]
                                                                     : point;
  }
  std::size_t motionTo(std::size_t point) const {
    const auto at = std::ranges::find(alignment_.pointOf, point);
    return static_cast<std::size_t>(at - alignment_.pointOf.begin());
  }

  void stated(const StatedFact& fact, EventKind kind) {
    const std::size_t point = pointOf(fact.before);
    for (std::size_t e = 0; e < found_.size(); ++e) {
      const TrajectoryEvent& event = trajectory_.events[e];
      const bool isSame = event.point == point && event.kind == kind &&
                          (kind != EventKind::ToolChange || event.tool == fact.number);
      if (isSame && !found_[e]) {
        found_[e] = true;
        return;
      }
    }
    findings_.push_back(textFinding(program_, StatementChanged, {fact.file + 1U, fact.line},
                                    {{"statement", nameOf(kind)},
                                     {"found", base::Message("stated here"_text)},
                                     {"planned", base::Message("not planned here"_text)}}));
  }
  void missing(const TrajectoryEvent& event) {
    const std::size_t last = program_.motions.empty() ? 0 : program_.motions.size() - 1;
    findings_.push_back(textFinding(program_, StatementMissing,
                                    placeOf(program_, std::min(motionTo(event.point), last)),
                                    {{"statement", nameOf(event.kind)}}));
  }

  const plan::ReadProgram& program_;
  const plan::Trajectory& trajectory_;
  const Alignment& alignment_;
  std::vector<bool> found_; // per event of the trajectory
  std::vector<TextFinding> findings_;
};

} // namespace

std::vector<TextFinding> compareEvents(const plan::ReadProgram& program,
                                       const plan::Trajectory& trajectory,
                                       const Alignment& alignment) {
  if (program.motions.empty())
    return {};
  return EventComparer(program, trajectory, alignment).compare();
}

} // namespace voluta::replay
