#include "replay/planned_events.h"

#include "plan/finding_kinds.h"
#include "plan/marks.h"
#include "plan/output_states.h"
#include "program/dialect.h"
#include "program/job_head.h"
#include "program/own_lines.h"
#include "program/stop_text.h"
#include "replay/change_order.h"
#include "replay/event_sequence.h"
#include "replay/start_lock.h"
#include "replay/wait_tolerance.h"
#include "robot/tool_changer.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;
using plan::EventKind, plan::FactKind, plan::StatedFact, plan::TrajectoryEvent;

// Returns the event that a statement stands for; nullopt for statements that are no events.
std::optional<EventKind> eventOf(const StatedFact& fact) {
  switch (fact.kind) {
  case FactKind::OperatorStop:
    return EventKind::Pause;
  case FactKind::ToolSelected:
    return EventKind::ToolChange;
  case FactKind::TapeCut:
    return EventKind::Cut;
  case FactKind::ToolLocked:
    return fact.number > 0.0 ? EventKind::Lock : EventKind::Release;
  case FactKind::OwnStatement:
    return EventKind::Statement;
  default:
    return std::nullopt;
  }
}

constexpr double kPurgeShare = 0.02; // Tolerance of the volume of purges

class EventComparer {
public:
  EventComparer(const plan::ReadProgram& program, const plan::Trajectory& trajectory,
                const Alignment& alignment, const process::Tooling& tooling, bool hasChanger,
                std::size_t firstPoint)
      : program_(program), trajectory_(trajectory), alignment_(alignment), tooling_(tooling),
        hasLock_(hasChanger || !tooling.isOne()), firstPoint_(firstPoint),
        found_(trajectory.events.size(), false) {}

  std::vector<TextFinding> compare() {
    const StatedFact* begin = nullptr; // selects the tool of the first motion
    int selected = trajectory_.toolAt(firstPoint_);
    for (const StatedFact& fact : program_.facts) {
      const auto kind = eventOf(fact);
      const bool selects = kind == EventKind::ToolChange;
      if (fact.kind == FactKind::OperatorStop && fact.number <= 0.0 && isBetweenMotions(fact))
        endsByItself(fact);
      if (kind == EventKind::Statement && isOfStates(fact))
        continue;
      if (kind && isBetweenMotions(fact) && !(selects && fact.tool == selected))
        stated(fact, *kind);
      if (kind == EventKind::Release && hasLock_ && !isBetweenMotions(fact))
        unplanned(fact, EventKind::Release);
      if (!selects)
        continue;
      selected = fact.tool;
      if (fact.before <= program_.firstMotion)
        begin = &fact;
    }
    compareBegin(begin);
    compareStates();
    const PlannedStops planned = plannedStops(program_, trajectory_, alignment_);
    compareWaits(planned.seconds);
    comparePurges(planned);
    compareMarks();
    for (std::size_t e = 0; e < found_.size(); ++e)
      if (!found_[e])
        missing(trajectory_.events[e]);
    return std::move(findings_);
  }

private:
  // The arm would go on while the operator's hands are at the nozzle.
  void endsByItself(const StatedFact& stop) {
    findings_.push_back(
        textFinding(program_, StatementChanged, {stop.file + 1U, stop.line},
                    {{"statement", program::nameOf(EventKind::Pause)},
                     {"found", base::Message("a stop that ends by itself or is skipped"_text)},
                     {"planned", base::Message("a stop that the operator ends"_text)}}));
  }

  // Returns whether it is one of the lines that set all outputs of the user's own: before the first
  // motion, at the beginning of a further file, and behind the last motion.
  bool isOfStates(const StatedFact& fact) {
    const std::size_t last = program_.motions.size(), m = fact.before;
    const bool isInside = isBetweenMotions(fact);
    if (isInside && program_.motions[m].file == program_.motions[m - 1].file)
      return false;
    std::vector<const StatedFact*>& of = states_[isInside ? m : m < last ? 0 : last];
    if (isInside && of.size() == plan::outputStates(trajectory_, 0).size())
      return false;
    of.push_back(&fact);
    return true;
  }
  void compareStates() {
    const std::size_t last = program_.motions.size();
    compareStates(program_.firstMotion, 0, plan::outputStates(trajectory_, firstPoint_));
    for (std::size_t m = program_.firstMotion + 1; m < last; ++m)
      if (const std::size_t point = alignment_.pointAhead(m);
          program_.motions[m].file != program_.motions[m - 1].file && point != kUnmatched)
        compareStates(m, m, plan::outputStates(trajectory_, point - 1));
    std::map<int, bool> off = plan::outputStates(trajectory_, 0);
    for (auto& [output, on] : off)
      on = false;
    compareStates(last, last, off);
  }
  void compareStates(std::size_t motion, std::size_t key, const std::map<int, bool>& planned) {
    const std::vector<const StatedFact*>& stated = states_[key];
    std::size_t k = 0;
    for (const auto& [output, on] : planned) {
      TrajectoryEvent event;
      event.kind = EventKind::Output;
      event.tool = output;
      event.on = on;
      if (k == stated.size()) {
        missingAt(motion, EventKind::Output);
        return;
      }
      compareText(*stated[k++], event);
    }
    for (; k < stated.size(); ++k)
      unplanned(*stated[k], EventKind::Statement);
  }

  // The tool of the first motion.
  void compareBegin(const StatedFact* begin) {
    const int planned = trajectory_.toolAt(firstPoint_);
    const auto number = [](int tool) { return static_cast<std::size_t>(tool) + 1; };
    if (begin && begin->tool != planned)
      findings_.push_back(
          textFinding(program_, StatementChanged, {begin->file + 1U, begin->line},
                      {{"statement", base::Message("the tool that the program begins with"_text)},
                       {"found", number(begin->tool)},
                       {"planned", number(planned)}}));
    const bool selects = !tooling_.isOne() && program::hasWordFor(dialect(), EventKind::ToolChange);
    if (!begin && selects && program_.firstMotion < program_.motions.size())
      findings_.push_back(
          textFinding(program_, StatementMissing, placeOf(program_, program_.firstMotion),
                      {{"statement", base::Message("the selection of the first tool"_text)}}));
  }

  void compareWaits(const std::vector<double>& planned) {
    std::vector<double> stated(planned.size(), 0.0);
    std::vector<const plan::ProgramPause*> pauseAt(planned.size(), nullptr);
    for (const plan::ProgramPause& pause : program_.pauses)
      if (pause.before < planned.size() && pause.drawnMm <= 0.0 && !pause.cuts) {
        stated[pause.before] += pause.durationS;
        pauseAt[pause.before] = &pause;
      }
    for (std::size_t m = program_.firstMotion; m < planned.size(); ++m) {
      if (planned[m] <= 0.0)
        continue;
      const double tolerance = waitTolerance(planned[m]);
      if (stated[m] <= tolerance && planned[m] > tolerance)
        continue; // missing
      for (const EventKind kind : {EventKind::Wait, EventKind::StartLag})
        mark(kind, alignment_.pointAhead(m));
      if (std::abs(stated[m] - planned[m]) > tolerance && pauseAt[m])
        findings_.push_back(textFinding(
            program_, StatementChanged, {pauseAt[m]->file + 1U, pauseAt[m]->line},
            {{"statement", program::nameOf(EventKind::Wait)},
             {"found", base::message("{time:.1f}"_text, base::seconds(stated[m]))},
             {"planned", base::message("{time:.1f}"_text, base::seconds(planned[m]))}}));
    }
  }
  void comparePurges(const PlannedStops& stops) {
    const std::vector<double>& planned = stops.purgeMm3;
    for (std::size_t m = program_.firstMotion; m < planned.size(); ++m) {
      if (planned[m] <= 0.0)
        continue;
      double stated = 0.0;
      const plan::ProgramPause* at = nullptr;
      for (const plan::ProgramPause& pause : program_.pauses)
        if (pause.before == m && pause.volumeMm3 > 0.0) {
          stated += pause.volumeMm3;
          at = &pause;
        }
      if (!at)
        continue; // missing
      const EventKind kind = stops.shotAt(m) ? EventKind::Shot : EventKind::Purge;
      mark(kind, alignment_.pointAhead(m));
      if (std::abs(stated - planned[m]) > kPurgeShare * planned[m])
        findings_.push_back(textFinding(program_, StatementChanged, {at->file + 1U, at->line},
                                        {{"statement", program::nameOf(kind)},
                                         {"found", base::mm3(stated)},
                                         {"planned", base::mm3(planned[m])}}));
    }
  }
  // All statements of marks in their order, from the withdrawal at the start to that at the end.
  void compareMarks() {
    const std::vector<plan::MarkStatement> wanted = plan::markStatements(trajectory_);
    for (const plan::MarkStatement& w : wanted)
      if (w.event != plan::kNoEvent)
        found_[w.event] = true;
    std::size_t next = 0;
    for (const StatedFact& fact : program_.facts) {
      const bool sets = fact.kind == FactKind::MarkSet;
      if (!sets && fact.kind != FactKind::MarkAwaited)
        continue;
      const std::size_t point = pointOfMark(fact);
      const auto isIt = [&](const plan::MarkStatement& w) {
        return w.point == point && w.sets == sets &&
               plan::markCode(w.signal, w.on) == static_cast<int>(fact.number);
      };
      constexpr std::size_t kAhead = 12; // so that one lost mark is one finding
      const auto from = wanted.begin() + static_cast<std::ptrdiff_t>(next),
                 to = wanted.begin() +
                      static_cast<std::ptrdiff_t>(std::min(wanted.size(), next + kAhead));
      const auto at = std::find_if(from, to, isIt);
      if (at == to) {
        unplanned(fact, EventKind::Mark);
        continue;
      }
      for (auto lost = from; lost != at; ++lost)
        lose(*lost);
      next = static_cast<std::size_t>(at - wanted.begin()) + 1;
    }
    for (; next < wanted.size(); ++next)
      lose(wanted[next]);
  }
  std::size_t pointOfMark(const StatedFact& fact) const {
    if (fact.before <= program_.firstMotion)
      return 0;
    return fact.before < program_.motions.size() ? alignment_.pointAhead(fact.before)
                                                 : trajectory_.pointCount();
  }
  void lose(const plan::MarkStatement& statement) {
    if (statement.event != plan::kNoEvent) {
      found_[statement.event] = false;
      return;
    }
    bool& isReported = statement.point == 0 ? lostAtStart_ : lostAtEnd_;
    if (!std::exchange(isReported, true))
      missingAt(statement.point == 0 ? program_.firstMotion : program_.motions.size(),
                EventKind::Mark);
  }
  void mark(EventKind kind, std::size_t point) {
    for (const TrajectoryEvent& event : trajectory_.eventsBefore(point))
      if (event.kind == kind)
        found_[static_cast<std::size_t>(&event - trajectory_.events.data())] = true;
  }
  bool isBetweenMotions(const StatedFact& fact) const {
    return fact.before > program_.firstMotion && fact.before < program_.motions.size();
  }
  // Of the motions that lead to a point, the first one follows its events.
  bool beginsWay(std::size_t motion) const {
    const std::size_t point = alignment_.pointAhead(motion);
    return point != kUnmatched && alignment_.pointAhead(motion - 1) != point;
  }
  // Returns whether a statement of that kind may stand for the event.
  bool isOf(const TrajectoryEvent& event, EventKind kind, const StatedFact& fact) const {
    if (kind == EventKind::Statement)
      return event.kind == EventKind::Output || event.kind == EventKind::Statement;
    return event.kind == kind && (kind != EventKind::ToolChange || event.tool == fact.tool);
  }
  void stated(const StatedFact& fact, EventKind kind) {
    if (beginsWay(fact.before))
      for (const TrajectoryEvent& event :
           trajectory_.eventsBefore(alignment_.pointAhead(fact.before))) {
        const auto e = static_cast<std::size_t>(&event - trajectory_.events.data());
        if (!isOf(event, kind, fact) || found_[e])
          continue;
        found_[e] = true;
        if (kind == EventKind::Pause || kind == EventKind::Statement)
          compareText(fact, event);
        return;
      }
    if (!locksAtFile(program_, fact))
      unplanned(fact, kind);
  }

  // The text that the operator reads at a stop, or a line that the user asked for.
  void compareText(const StatedFact& fact, const TrajectoryEvent& event) {
    const bool isPause = event.kind == EventKind::Pause;
    if (isPause && !dialect().showsTexts)
      return;
    const TrajectoryEvent* const change = isPause ? trajectory_.changeAfter(event) : nullptr;
    const std::string planned = change    ? program::changeText(tooling_, change->tool)
                                : isPause ? program::pauseText(event)
                                          : program::ownLine(program_.format, event);
    if (fact.word == (isPause ? program::shownText(program_.format, planned) : planned))
      return;
    findings_.push_back(
        textFinding(program_, StatementChanged, {fact.file + 1U, fact.line},
                    {{"statement", isPause ? base::Message("the text of the stop"_text)
                                           : base::Message(program::nameOf(event.kind))},
                     {"found", fact.word},
                     {"planned", planned}}));
  }

  void unplanned(const StatedFact& fact, EventKind kind) {
    findings_.push_back(textFinding(program_, StatementChanged, {fact.file + 1U, fact.line},
                                    {{"statement", program::nameOf(kind)},
                                     {"found", base::Message("one"_text)},
                                     {"planned", base::Message("none"_text)}}));
  }
  void missing(const TrajectoryEvent& event) {
    if (event.kind == EventKind::Feed || event.kind == EventKind::StopLag) // compared as material
      return;
    if (event.point <= firstPoint_ || program::leavesOut(dialect(), event.kind))
      return;
    const auto at = std::ranges::find(alignment_.pointOf, event.point);
    const auto motion = static_cast<std::size_t>(at - alignment_.pointOf.begin());
    if (motion < program_.firstMotion)
      return;
    missingAt(motion, event.kind);
  }
  void missingAt(std::size_t motion, EventKind kind) {
    findings_.push_back(
        textFinding(program_, StatementMissing,
                    placeOf(program_, std::min(motion, program_.motions.size() - 1)),
                    {{"statement", program::nameOf(kind)}}));
  }

  const program::Dialect& dialect() const { return program::findDialect(program_.format); }

  const plan::ReadProgram& program_;
  const plan::Trajectory& trajectory_;
  const Alignment& alignment_;
  const process::Tooling& tooling_;
  const bool hasLock_; // there is a tool changer's output
  const std::size_t firstPoint_;
  std::vector<bool> found_; // per event of the trajectory
  // Lines that set the states of outputs, by the next motion; 0: before the first one.
  std::map<std::size_t, std::vector<const StatedFact*>> states_;
  bool lostAtStart_ = false, lostAtEnd_ = false; // statements that withdraw signals of marks
  std::vector<TextFinding> findings_;
};

} // namespace

PlannedStops plannedStops(const plan::ReadProgram& program, const plan::Trajectory& trajectory,
                          const Alignment& alignment) {
  PlannedStops stops{std::vector<double>(program.motions.size(), 0.0),
                     std::vector<double>(program.motions.size(), 0.0),
                     std::vector<char>(program.motions.size(), 0)};
  std::size_t last = kUnmatched;
  for (std::size_t m = 0; m < program.motions.size(); ++m) {
    const std::size_t point = alignment.pointAhead(m);
    // Of the motions that lead to a point, the first one follows its events.
    if (point != kUnmatched && point != last) {
      stops.seconds[m] = trajectory.waitBefore(point);
      stops.purgeMm3[m] = trajectory.purgeBefore(point);
      stops.shot[m] = trajectory.shotBefore(point);
    }
    last = point;
  }
  return stops;
}

std::vector<TextFinding> ownStatements(const plan::ReadProgram& program,
                                       const plan::Trajectory& trajectory,
                                       const Alignment& alignment, std::size_t firstPoint) {
  std::vector<TextFinding> found;
  for (const TrajectoryEvent& event : trajectory.events)
    if (event.kind == EventKind::Statement && event.point <= firstPoint &&
        program.firstMotion < program.motions.size())
      found.push_back({plan::makeFinding(StatementBeforeRest, {{"statement", event.text}}), {}});
  for (const StatedFact& fact : program.facts) {
    if (fact.kind != FactKind::OwnStatement || fact.before >= program.motions.size())
      continue;
    for (const TrajectoryEvent& event : trajectory.eventsBefore(alignment.pointAhead(fact.before)))
      if (event.kind == EventKind::Statement && event.text == fact.word)
        found.push_back(textFinding(program, OwnStatement, {fact.file + 1U, fact.line},
                                    {{"statement", fact.word}}));
  }
  return found;
}

std::vector<TextFinding> compareEvents(const plan::ReadProgram& program,
                                       const plan::Trajectory& trajectory,
                                       const Alignment& alignment, const process::Tooling& tooling,
                                       const robot::Cell& cell, std::size_t firstPoint) {
  if (program.motions.empty())
    return {};
  std::vector<TextFinding> found =
      EventComparer(program, trajectory, alignment, tooling, robot::hasChanger(cell), firstPoint)
          .compare();
  std::ranges::move(compareChangeOrder(program, trajectory, alignment, tooling, firstPoint),
                    std::back_inserter(found));
  // Each line is reported once.
  for (TextFinding& other : compareSequences(program, trajectory, alignment))
    if (std::ranges::none_of(found, [&](const TextFinding& told) {
          return std::pair(told.place.file, told.place.line) ==
                 std::pair(other.place.file, other.place.line);
        }))
      found.push_back(std::move(other));
  return found;
}

} // namespace voluta::replay
