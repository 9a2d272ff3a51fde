#include "replay/event_sequence.h"

#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "program/own_lines.h"
#include "replay/wait_tolerance.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;
using plan::EventKind, plan::FactKind, plan::StatedFact, plan::TrajectoryEvent;

// A step of a stop. Shots are purges, and outputs are statements.
struct SequenceStep {
  EventKind kind = EventKind::Pause;
  int tool = 0;          // of a tool change
  std::string word = {}; // of a statement
  double seconds = 0.0;  // that pass before it
  TextPlace place = {};  // of a stated one

  bool stands(const SequenceStep& planned) const {
    return kind == planned.kind && tool == planned.tool && word == planned.word;
  }
};
struct Sequence {
  std::vector<SequenceStep> steps;
  double secondsBehind = 0.0; // behind the last step
};

std::optional<SequenceStep> stepOf(const StatedFact& fact) {
  SequenceStep step{.place = {fact.file + 1U, fact.line}};
  switch (fact.kind) {
  case FactKind::OperatorStop:
    return step;
  case FactKind::ToolSelected:
    step.kind = EventKind::ToolChange;
    step.tool = fact.tool;
    return step;
  case FactKind::TapeCut:
    step.kind = EventKind::Cut;
    return step;
  case FactKind::ToolLocked:
    step.kind = fact.number > 0.0 ? EventKind::Lock : EventKind::Release;
    return step;
  case FactKind::OwnStatement:
    step.kind = EventKind::Statement;
    step.word = fact.word;
    return step;
  default:
    return std::nullopt;
  }
}

class SequenceComparer {
public:
  SequenceComparer(const plan::ReadProgram& program, const plan::Trajectory& trajectory,
                   const Alignment& alignment)
      : program_(program), trajectory_(trajectory), alignment_(alignment) {
    for (const StatedFact& fact : program.facts)
      if (stepOf(fact))
        facts_.push_back(&fact);
    std::ranges::stable_sort(facts_, {}, &StatedFact::before);
  }

  std::vector<TextFinding> compare() {
    std::size_t last = kUnmatched;
    for (std::size_t m = program_.firstMotion + 1; m < program_.motions.size(); ++m) {
      const std::size_t point = alignment_.pointAhead(m);
      if (point != kUnmatched && point != last)
        if (const auto events = trajectory_.eventsBefore(point); events.size() > 1)
          compareAt(m, plannedBy(events), statedBefore(m));
      last = point;
    }
    return std::move(found_);
  }

private:
  Sequence plannedBy(std::span<const TrajectoryEvent> events) const {
    Sequence planned;
    double behind = 0.0; // Time of a lock
    for (const TrajectoryEvent& event : events) {
      SequenceStep step{.kind = event.kind};
      switch (event.kind) {
      case EventKind::Wait:
        planned.secondsBehind += event.seconds;
        continue;
      case EventKind::Feed:
      case EventKind::StartLag:
      case EventKind::StopLag:
      case EventKind::Mark:
        continue;
      case EventKind::Purge:
      case EventKind::Shot:
        if (program::leavesOut(program::findDialect(program_.format), event.kind))
          continue;
        step.kind = EventKind::Purge;
        break;
      case EventKind::ToolChange:
        step.tool = event.tool;
        break;
      case EventKind::Output:
      case EventKind::Statement:
        step.kind = EventKind::Statement;
        step.word = program::ownLine(program_.format, event);
        break;
      case EventKind::Release:
      case EventKind::Lock:
        behind = event.seconds;
        break;
      case EventKind::Pause:
      case EventKind::Cut:
        break;
      }
      step.seconds = std::exchange(planned.secondsBehind, std::exchange(behind, 0.0));
      planned.steps.push_back(std::move(step));
    }
    return planned;
  }

  // In the order of the text.
  Sequence statedBefore(std::size_t motion) const {
    Sequence stated;
    std::vector<const StatedFact*> facts;
    for (auto fact = std::ranges::lower_bound(facts_, motion, {}, &StatedFact::before);
         fact != facts_.end() && (*fact)->before == motion; ++fact)
      facts.push_back(*fact);
    const auto placeOfFact = [](const StatedFact* fact) {
      return std::tuple<std::size_t, std::size_t>(fact->file, fact->line);
    };
    std::ranges::stable_sort(facts, {}, placeOfFact);
    auto next = facts.begin();
    const auto take = [&] {
      SequenceStep step = *stepOf(**next++);
      step.seconds = std::exchange(stated.secondsBehind, 0.0);
      stated.steps.push_back(std::move(step));
    };
    const auto pauses =
        std::ranges::equal_range(program_.pauses, motion, {}, &plan::ProgramPause::before);
    for (const plan::ProgramPause& pause : pauses) {
      while (next != facts.end() && placeOfFact(*next) < std::tuple(pause.file, pause.line))
        take();
      if (pause.volumeMm3 > 0.0)
        stated.steps.push_back({.kind = EventKind::Purge,
                                .seconds = std::exchange(stated.secondsBehind, 0.0),
                                .place = {pause.file + 1U, pause.line}});
      else if (pause.drawnMm <= 0.0 && !pause.cuts)
        stated.secondsBehind += pause.durationS;
    }
    while (next != facts.end())
      take();
    return stated;
  }

  // The planned steps have to be among the stated ones in their order; there may be others between,
  // such as a prime.
  void compareAt(std::size_t motion, const Sequence& planned, const Sequence& stated) {
    const auto isStated = [&](const SequenceStep& step) {
      return std::ranges::any_of(stated.steps,
                                 [&](const SequenceStep& s) { return s.stands(step); });
    };
    if (!std::ranges::all_of(planned.steps, isStated))
      return; // told as missing or changed
    std::size_t at = 0;
    TextPlace place = placeOf(program_, motion);
    EventKind before = EventKind::Pause;
    for (std::size_t p = 0; p < planned.steps.size(); ++p) {
      const SequenceStep& step = planned.steps[p];
      double seconds = 0.0;
      while (at < stated.steps.size() && !stated.steps[at].stands(step))
        seconds += stated.steps[at++].seconds;
      if (at == stated.steps.size()) {
        tellEarly(step, stated, before);
        return;
      }
      compareTime(step.seconds, seconds + stated.steps[at].seconds, stated.steps[at].place);
      place = stated.steps[at++].place;
      before = step.kind;
    }
    double seconds = stated.secondsBehind;
    for (; at < stated.steps.size(); ++at)
      seconds += stated.steps[at].seconds;
    compareTime(planned.secondsBehind, seconds, place);
  }

  void tellEarly(const SequenceStep& step, const Sequence& stated, EventKind before) {
    const auto early =
        std::ranges::find_if(stated.steps, [&](const SequenceStep& s) { return s.stands(step); });
    found_.push_back(
        textFinding(program_, StatementChanged, early->place,
                    {{"statement", program::nameOf(step.kind)},
                     {"found", base::message("before {event}"_text, program::nameOf(before))},
                     {"planned", base::message("behind {event}"_text, program::nameOf(before))}}));
  }

  void compareTime(double planned, double stated, const TextPlace& place) {
    if (stated >= planned - waitTolerance(planned))
      return;
    found_.push_back(
        textFinding(program_, StatementChanged, place,
                    {{"statement", program::nameOf(EventKind::Wait)},
                     {"found", base::message("{time:.1f}"_text, base::seconds(stated))},
                     {"planned", base::message("{time:.1f}"_text, base::seconds(planned))}}));
  }

  const plan::ReadProgram& program_;
  const plan::Trajectory& trajectory_;
  const Alignment& alignment_;
  std::vector<const StatedFact*> facts_; // that are steps, ascending by the next motion
  std::vector<TextFinding> found_;
};

} // namespace

std::vector<TextFinding> compareSequences(const plan::ReadProgram& program,
                                          const plan::Trajectory& trajectory,
                                          const Alignment& alignment) {
  return SequenceComparer(program, trajectory, alignment).compare();
}

} // namespace voluta::replay
