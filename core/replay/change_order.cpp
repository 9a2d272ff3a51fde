#include "replay/change_order.h"

#include "base/lower_case.h"
#include "plan/finding_kinds.h"
#include "plan/fitted_tools.h"
#include "program/dialect.h"
#include "program/job_head.h"
#include "replay/planned_events.h"
#include "replay/wait_tolerance.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace voluta::replay {

namespace {

using enum plan::FindingKind;
using plan::EventKind, plan::FactKind, plan::StatedFact, plan::TrajectoryEvent;

constexpr int kNoTool = -1;

// The steps of a change in their order.
enum class Step { Release, Stop, Select, Lock, Heat, Purge };

struct Stated {
  Step step = Step::Stop;
  TextPlace place;
  const StatedFact* fact = nullptr; // nullptr: a purge
  std::size_t pause = 0;            // of a purge: its index
};

std::optional<Step> stepOf(const StatedFact& fact) {
  switch (fact.kind) {
  case FactKind::OperatorStop:
    return Step::Stop;
  case FactKind::ToolSelected:
    return Step::Select;
  case FactKind::NozzleHeatWait:
    return Step::Heat;
  case FactKind::ToolLocked:
    return fact.number > 0.0 ? Step::Lock : Step::Release;
  default:
    return std::nullopt;
  }
}

base::Message nameOf(Step step) {
  switch (step) {
  case Step::Release:
    return program::nameOf(EventKind::Release);
  case Step::Stop:
    return program::nameOf(EventKind::Pause);
  case Step::Select:
    return program::nameOf(EventKind::ToolChange);
  case Step::Lock:
    return program::nameOf(EventKind::Lock);
  case Step::Heat:
    return "a wait until the nozzle is hot"_text;
  case Step::Purge:
    break;
  }
  return program::nameOf(EventKind::Purge);
}

class OrderComparer {
public:
  OrderComparer(const plan::ReadProgram& program, const plan::Trajectory& trajectory,
                const Alignment& alignment, const process::Tooling& tooling, std::size_t firstPoint)
      : program_(program), trajectory_(trajectory), alignment_(alignment), tooling_(tooling),
        firstPoint_(firstPoint) {
    for (const StatedFact& fact : program.facts)
      if (stepOf(fact))
        facts_.push_back(&fact);
  }

  std::vector<TextFinding> compare() {
    const bool changes = !tooling_.isOne() && program::hasWordFor(dialect(), EventKind::ToolChange);
    if (changes)
      compareBegin();
    std::size_t last = kUnmatched;
    for (std::size_t m = program_.firstMotion + 1; m < program_.motions.size(); ++m) {
      const std::size_t point = alignment_.pointAhead(m);
      if (point != kUnmatched && point != last)
        compareAt(m, trajectory_.eventsBefore(point));
      last = point;
    }
    if (changes)
      compareFitted();
    return std::move(found_);
  }

private:
  // Returns the statements before a motion, in the order of the text.
  std::vector<Stated> statedBefore(std::size_t motion) const {
    std::vector<Stated> stated;
    auto next = std::ranges::lower_bound(facts_, motion, {}, &StatedFact::before);
    const auto takeFacts = [&](std::size_t beforePause) {
      for (;
           next != facts_.end() && (*next)->before == motion && (*next)->beforePause <= beforePause;
           ++next)
        stated.push_back({*stepOf(**next), {(*next)->file + 1U, (*next)->line}, *next});
    };
    const auto pauses =
        std::ranges::equal_range(program_.pauses, motion, {}, &plan::ProgramPause::before);
    for (auto pause = pauses.begin(); pause != pauses.end(); ++pause) {
      takeFacts(static_cast<std::size_t>(pause - program_.pauses.begin()));
      if (pause->volumeMm3 > 0.0)
        stated.push_back({Step::Purge,
                          {pause->file + 1U, pause->line},
                          nullptr,
                          static_cast<std::size_t>(pause - program_.pauses.begin())});
    }
    takeFacts(program_.pauses.size());
    return stated;
  }

  void compareAt(std::size_t motion, std::span<const TrajectoryEvent> planned) {
    const auto has = [&](EventKind kind) {
      return std::ranges::find(planned, kind, &TrajectoryEvent::kind) != planned.end();
    };
    const auto change = std::ranges::find(planned, EventKind::ToolChange, &TrajectoryEvent::kind);
    if (change == planned.end()) {
      // The nozzle drips while the operator is awaited, and is primed behind it.
      if (has(EventKind::Pause) && has(EventKind::Purge))
        compareOrder(statedBefore(motion), kNoTool);
      return;
    }
    const std::vector<Stated> stated = statedBefore(motion);
    compareOrder(stated, change->tool);
    compareTimes(motion, stated, planned);
    compareHeat(motion, stated, change->tool);
  }

  // Each step has to come behind those that the sequence has before it.
  void compareOrder(std::span<const Stated> stated, int tool) {
    // Heat of other tools may be stated anywhere.
    const auto isOfChange = [&](const Stated& s) {
      return s.step != Step::Heat || s.fact->tool == tool;
    };
    for (std::size_t i = 0; i < stated.size(); ++i)
      for (std::size_t j = i + 1; j < stated.size(); ++j)
        if (stated[i].step > stated[j].step && isOfChange(stated[i]) && isOfChange(stated[j])) {
          reportBefore(stated[i], stated[j].step);
          break;
        }
  }
  void reportBefore(const Stated& early, Step late) {
    found_.push_back(
        textFinding(program_, StatementChanged, early.place,
                    {{"statement", nameOf(early.step)},
                     {"found", base::message("before {event}"_text, nameOf(late))},
                     {"planned", base::message("behind {event}"_text, nameOf(late))}}));
  }

  // The changer's time passes before the next step, not anywhere in the change.
  void compareTimes(std::size_t motion, std::span<const Stated> stated,
                    std::span<const TrajectoryEvent> planned) {
    for (const TrajectoryEvent& event : planned) {
      if (event.kind != EventKind::Release && event.kind != EventKind::Lock)
        continue;
      const Step step = event.kind == EventKind::Release ? Step::Release : Step::Lock;
      const auto at = std::ranges::find(stated, step, &Stated::step);
      if (at == stated.end())
        continue; // told as missing
      const auto next = at + 1;
      std::size_t end = program_.pauses.size();
      if (next != stated.end())
        end = next->fact ? next->fact->beforePause : next->pause;
      double seconds = 0.0;
      for (std::size_t p = at->fact->beforePause; p < end; ++p)
        if (const plan::ProgramPause& pause = program_.pauses[p];
            pause.before == motion && pause.volumeMm3 <= 0.0)
          seconds += pause.durationS;
      if (seconds < event.seconds - waitTolerance(event.seconds))
        found_.push_back(textFinding(
            program_, StatementChanged, at->place,
            {{"statement", base::message("the time for {event}"_text, nameOf(step))},
             {"found", base::message("{time:.1f}"_text, base::seconds(seconds))},
             {"planned", base::message("{time:.1f}"_text, base::seconds(event.seconds))}}));
    }
  }

  void compareText(const StatedFact& stop, int tool) {
    if (!dialect().showsTexts)
      return;
    const std::string planned = program::toolName(tooling_, tool);
    if (base::lowerCase(stop.word).find(base::lowerCase(planned)) != std::string::npos)
      return;
    found_.push_back(textFinding(program_, StatementChanged, {stop.file + 1U, stop.line},
                                 {{"statement", base::Message("the text of the stop"_text)},
                                  {"found", stop.word},
                                  {"planned", planned}}));
  }

  void compareHeat(std::size_t motion, std::span<const Stated> stated, int tool) {
    const bool heats = std::ranges::find(program_.neededFacts, FactKind::NozzleHeatWait) !=
                           program_.neededFacts.end() &&
                       tooling_.at(tool).process.material.nozzleC;
    const bool waits = std::ranges::any_of(
        stated, [&](const Stated& s) { return s.step == Step::Heat && s.fact->tool == tool; });
    if (heats && !waits)
      found_.push_back(textFinding(program_, StatementMissing, placeOf(program_, motion),
                                   {{"statement", nameOf(Step::Heat)}}));
  }

  // A tool that the operator fits has no heat before the stop for it, and none from the stop on at
  // which he takes it off.
  void compareFitted() {
    int fitted = trajectory_.toolAt(firstPoint_);
    std::map<int, double> heat; // commanded last, of each tool
    std::set<int> removed;
    std::size_t next = program_.firstMotion + 1;
    for (const StatedFact& fact : program_.facts) {
      for (; next < fact.before && next < program_.motions.size(); ++next)
        fitted = fittedBefore(next).value_or(fitted);
      if (fact.kind == FactKind::OperatorStop && fact.before > program_.firstMotion &&
          fact.before < program_.motions.size() && isLastStop(fact))
        if (const std::optional<int> tool = fittedBefore(fact.before); tool && *tool != fitted) {
          removed.insert(fitted);
          if (heat[fitted] > 0.0)
            tellHot(fact, fitted, heat[fitted]);
          fitted = *tool;
        }
      if (fact.kind != FactKind::NozzleHeat)
        continue;
      heat[fact.tool] = fact.number;
      if (fact.number <= 0.0 || fact.tool == fitted)
        continue;
      if (removed.contains(fact.tool)) {
        tellHot(fact, fact.tool, fact.number);
        continue;
      }
      if (!plan::isFittedByHand(trajectory_, fact.tool))
        continue;
      found_.push_back(
          textFinding(program_, StatementChanged, {fact.file + 1U, fact.line},
                      {{"statement", base::message("the heat of {tool}"_text,
                                                   program::toolName(tooling_, fact.tool))},
                       {"found", base::message("before {event}"_text, nameOf(Step::Stop))},
                       {"planned", base::message("behind {event}"_text, nameOf(Step::Stop))}}));
    }
  }
  // Pauses before a layer come before the stop in which the tool is changed.
  bool isLastStop(const StatedFact& stop) const {
    return std::ranges::none_of(program_.facts, [&](const StatedFact& other) {
      return &other > &stop && other.kind == FactKind::OperatorStop && other.before == stop.before;
    });
  }
  void tellHot(const StatedFact& at, int tool, double celsius) {
    found_.push_back(textFinding(
        program_, StatementChanged, {at.file + 1U, at.line},
        {{"statement", base::message("the heat of {tool}"_text, program::toolName(tooling_, tool))},
         {"found", base::number(celsius)},
         {"planned", base::number(0.0)}}));
  }
  // Returns the tool that the operator fits before that motion.
  std::optional<int> fittedBefore(std::size_t motion) const {
    const std::size_t point = alignment_.pointAhead(motion);
    if (point == kUnmatched)
      return std::nullopt;
    for (const TrajectoryEvent& event : trajectory_.eventsBefore(point))
      if (event.kind == EventKind::Pause)
        if (const TrajectoryEvent* change = trajectory_.changeAfter(event))
          return change->tool;
    return std::nullopt;
  }

  // The operator fits the tool of the first motion before an output selects it.
  void compareBegin() {
    const StatedFact* stop = nullptr;
    const StatedFact* selected = nullptr;
    for (const StatedFact* fact : facts_) {
      if (fact->before > program_.firstMotion)
        break;
      if (fact->kind == FactKind::OperatorStop && fact->number > 0.0)
        stop = fact;
      if (fact->kind == FactKind::ToolSelected && !selected)
        selected = fact;
    }
    if (stop)
      compareText(*stop, trajectory_.toolAt(firstPoint_));
    if (stop && selected && selected < stop)
      reportBefore({Step::Select, {selected->file + 1U, selected->line}, selected}, Step::Stop);
  }

  const program::Dialect& dialect() const { return program::findDialect(program_.format); }

  const plan::ReadProgram& program_;
  const plan::Trajectory& trajectory_;
  const Alignment& alignment_;
  const process::Tooling& tooling_;
  const std::size_t firstPoint_;
  std::vector<const StatedFact*> facts_; // that are steps, in the order of the text
  std::vector<TextFinding> found_;
};

} // namespace

std::vector<TextFinding> compareChangeOrder(const plan::ReadProgram& program,
                                            const plan::Trajectory& trajectory,
                                            const Alignment& alignment,
                                            const process::Tooling& tooling,
                                            std::size_t firstPoint) {
  if (program.motions.empty())
    return {};
  return OrderComparer(program, trajectory, alignment, tooling, firstPoint).compare();
}

} // namespace voluta::replay
