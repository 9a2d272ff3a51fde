#include "program/common/walk.h"

#include "plan/marks.h"
#include "plan/output_states.h"
#include "process/cooling.h"
#include "program/bead_words.h"
#include "program/common/extruder_outputs.h"
#include "program/common/motion_targets.h"
#include "program/extruder.h"
#include "program/filament.h"
#include "program/gcode/extruder_axis.h"
#include "program/job_head.h"
#include "program/own_lines.h"
#include "robot/tool_changer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace voluta::program {

namespace {

// Returns whether the event stops the extruder if it happens at a bead.
bool isInsideBead(const plan::TrajectoryEvent& event) {
  return event.kind != plan::EventKind::StartLag && event.kind != plan::EventKind::StopLag;
}

class Walker {
public:
  Walker(const ProgramInput& input, const Walk& walk, ProgramEmitter& emitter,
         const base::RunContext& ctx)
      : in_(input), walk_(walk), emitter_(emitter), ctx_(ctx), paths_(input.toolPlan),
        extruder_(extruderOf(input)), locks_(walk.locksTool && locksTool(input)) {
    if (byAxis())
      zeros_ = axisCount(input).zeros;
    for (std::size_t i = 0; i < input.trajectory.pointCount(); ++i)
      lastPrint_ = isPrint(input.trajectory, i) ? i : lastPrint_;
    marks_ = plan::markStatements(input.trajectory);
  }

  void run() {
    for (std::size_t file = 0; file + 1 < walk_.cuts.size(); ++file) {
      const std::size_t end = walk_.cuts[file + 1];
      outputs_.off();
      said_.clear();
      emitter_.beginFile(file);
      if (file == 0)
        marks(0);
      else {
        lockAtFile(walk_.cuts[file]);
        ownOutputs(plan::outputStates(in_.trajectory, walk_.cuts[file] - 1));
      }
      for (std::size_t i = walk_.cuts[file]; i < end; ++i) {
        if (i % 4096 == 0)
          ctx_.report(static_cast<double>(i) / static_cast<double>(walk_.cuts.back()),
                      base::message("{format}"_text, std::string(walk_.format)));
        point(i, i + 1 == end);
      }
      if (end == in_.trajectory.pointCount()) {
        events(end);
        std::map<int, bool> off = plan::outputStates(in_.trajectory, 0);
        for (auto& [output, on] : off)
          on = false;
        ownOutputs(off);
      }
      emitter_.endFile(file);
    }
  }

private:
  // Of the selected tool.
  const process::Process& process() const { return in_.tooling.at(tool_).process; }
  bool byAxis() const { return walk_.outputs != nullptr && extruder_.byAxis; }
  bool zeroesAt(std::size_t i) const { return std::ranges::binary_search(zeros_, i); }

  void point(std::size_t i, bool last) {
    const plan::Trajectory& t = in_.trajectory;
    if (const std::string path = paths_.at(t.waypoint[i]); !path.empty())
      emitter_.remark(path);
    // Amid a bead too, the extruder is off while the arm waits.
    const bool insideBead = isPrint(t, i) && std::ranges::any_of(t.eventsBefore(i), isInsideBead);
    if (insideBead) {
      extruder(false);
      events(i);
    }
    if (isPrint(t, i) && !isPrint(t, i - 1))
      words(&process::BeadWords::start);
    if (isPrint(t, i) && drawn_)
      draw(false);
    if (isPrint(t, i))
      cool(t.waypoint[i]);
    if (walk_.outputs != nullptr && isPrint(t, i))
      flow(walk_.outputs->flowMm3PerS(i));
    extruder(isPrint(t, i));
    if (i > 0 && isPrint(t, i - 1) && !isPrint(t, i))
      words(&process::BeadWords::end);
    if (i > 0 && isPrint(t, i - 1) && !isPrint(t, i) && i < lastPrint_ && process().retractMm > 0.0)
      draw(true);
    if (i == 0) {
      emitter_.prompt();
      // The operator has fitted it by then. Dialects without outputs select it in their heads.
      if (walk_.outputs != nullptr && in_.selectsTool())
        selectTool();
      if (locks_) {
        emitter_.setOutput(kChangerOutput, true);
        if (!walk_.waitsByMotion)
          emitter_.wait(robot::kChangerS);
      }
      ownOutputs(plan::outputStates(t, 0));
    }
    if (!insideBead)
      events(i);
    if (zeroesAt(i))
      emitter_.zeroAxis();
    if (i == 0 || t.move[i] == plan::MoveKind::Joint)
      emitter_.jointMotion(i);
    else
      emitter_.straightMotion(i, last || zeroesAt(i + 1) || t.stopsBefore(i + 1));
    if (i == 0) {
      marks(1); // so that the nozzle does not wait primed
      prime();
    }
  }

  void events(std::size_t i) {
    marks(i);
    for (const plan::TrajectoryEvent& event : in_.trajectory.eventsBefore(i))
      switch (event.kind) {
      case plan::EventKind::ToolChange:
        returnDrawn();
        tool_ = event.tool;
        selectTool();
        emitter_.awaitHeat(tool_);
        break;
      case plan::EventKind::Cut:
        emitter_.cut();
        break;
      case plan::EventKind::Pause:
        pause(event);
        break;
      case plan::EventKind::Feed:
        emitter_.extrudeInPlace(event.feedMm, std::abs(event.feedMm) / kDrawBackMmPerS);
        break;
      case plan::EventKind::Wait:
        emitter_.wait(event.seconds);
        break;
      case plan::EventKind::Purge:
        returnDrawn();
        flowOut("purge", event);
        break;
      case plan::EventKind::Shot:
        shot(event);
        break;
      case plan::EventKind::Release:
        returnDrawn();
        [[fallthrough]];
      case plan::EventKind::Lock:
        emitter_.setOutput(kChangerOutput, event.kind == plan::EventKind::Lock);
        emitter_.wait(event.seconds);
        break;
      case plan::EventKind::Mark: // said by marks()
        break;
      case plan::EventKind::StartLag:
        startLag(i, event.seconds);
        break;
      case plan::EventKind::StopLag: // said by the flow (TcpMotions)
        break;
      case plan::EventKind::Output:
      case plan::EventKind::Statement:
        if (event.point > 0) // else said before the first motion
          emitter_.ownLine(program::ownLine(walk_.format, event));
        break;
      }
  }

  // Whatever ran before may have left the user's outputs in any state.
  void ownOutputs(const std::map<int, bool>& states) {
    for (const auto& [output, on] : states)
      emitter_.ownLine(program::ownLine(
          walk_.format, {.kind = plan::EventKind::Output, .tool = output, .on = on}));
  }

  // A file may be started alone, after a stop; a change locks its tool itself.
  void lockAtFile(std::size_t point) {
    const auto events = in_.trajectory.eventsBefore(point);
    if (!locks_ || std::ranges::find(events, plan::EventKind::Lock, &plan::TrajectoryEvent::kind) !=
                       events.end())
      return;
    emitter_.setOutput(kChangerOutput, true);
    if (walk_.filesRunAlone)
      emitter_.wait(robot::kChangerS);
  }

  // Each tool has its own filament, which the operator or a tool changer takes away.
  void returnDrawn() {
    if (drawn_)
      draw(false);
  }

  void pause(const plan::TrajectoryEvent& event) {
    const plan::TrajectoryEvent* const change = in_.trajectory.changeAfter(event);
    if (change) {
      returnDrawn();
      emitter_.coolTool(tool_);
    }
    emitter_.pause(change ? changeText(in_.tooling, change->tool) : pauseText(event));
  }

  void selectTool() {
    if (walk_.outputs == nullptr)
      return emitter_.selectTool(tool_);
    for (int k = 1; k < static_cast<int>(in_.tooling.tools().size()); ++k)
      emitter_.setOutput(k, k == tool_);
  }

  // Says those before the motion to a point that are not said yet.
  void marks(std::size_t point) {
    for (; mark_ < marks_.size() && marks_[mark_].point <= point; ++mark_) {
      const plan::MarkStatement& said = marks_[mark_];
      if (mark_ == 0 || said.event != marks_[mark_ - 1].event)
        emitter_.remark(markRemark(said));
      if (said.sets)
        emitter_.setOutput(kMarkOutput + said.signal, said.on);
      else
        emitter_.awaitInput(kMarkOutput + said.signal, said.on);
    }
  }

  std::string markRemark(const plan::MarkStatement& said) {
    if (said.event == plan::kNoEvent)
      return "signals for other machines off";
    const int channel = said.signal / 2;
    const std::size_t number = reached_.at(static_cast<std::size_t>(channel))++;
    std::string name = number == 0 ? std::string("start mark") : "mark " + std::to_string(number);
    if (channel > 0)
      name += " of channel " + std::to_string(channel + 1);
    return name;
  }

  // The filament is drawn back before and after it, if it was before.
  void shot(const plan::TrajectoryEvent& event) {
    const bool wasDrawn = drawn_;
    if (wasDrawn)
      draw(false);
    flowOut("shot", event);
    if (wasDrawn)
      draw(true);
  }

  void flowOut(std::string_view remark, const plan::TrajectoryEvent& event) {
    emitter_.remark(remark);
    if (walk_.outputs == nullptr) {
      emitter_.purge(event.volumeMm3 / filamentArea(), event.seconds);
      return;
    }
    if (extruder_.byAxis)
      return emitter_.extrudeInPlace(event.volumeMm3 / filamentArea(), event.seconds);
    flow(event.volumeMm3 / event.seconds);
    extruder(true);
    emitter_.wait(event.seconds);
    extruder(false);
  }

  // The extruder runs meanwhile. Before a bead shorter than the stop lag it is switched off as much
  // earlier.
  void startLag(std::size_t first, double seconds) {
    const plan::Trajectory& t = in_.trajectory;
    if (walk_.outputs == nullptr || walk_.outputs->flowMm3PerS(first) > 0.0)
      return emitter_.wait(seconds);
    std::size_t last = first;
    while (last + 1 < t.pointCount() && isPrint(t, last + 1))
      ++last;
    const double beadS = t.timeS[last] - t.timeS[first - 1],
                 volume = t.extrudedMm3[last] - t.extrudedMm3[first - 1],
                 early = std::clamp(process().lag.stopS - beadS, 0.0, seconds);
    if (beadS > 0.0 && early < seconds) {
      flow(std::min(volume / beadS, process().maxFlowMm3PerS));
      extruder(true);
      emitter_.wait(seconds - early);
      flow(0.0);
      extruder(true);
    }
    if (early > 0.0)
      emitter_.wait(early);
  }

  // Marks the places of the process's statements (bead_words.h).
  void words(std::vector<std::string> process::BeadWords::*part) {
    if (const process::BeadWords* words = process().wordsFor(walk_.format))
      for (const std::string& statement : words->*part)
        emitter_.remark(beadWordRemark(statement));
  }

  // Runs the fan as the path of that waypoint needs it.
  void cool(std::size_t waypoint) {
    const auto& paths = in_.toolPlan.paths;
    if (waypoint == plan::kNoWaypoint)
      return;
    while (path_ + 1 < paths.size() && paths[path_ + 1].first <= waypoint)
      ++path_;
    const double share = process::fanShare(process().material, paths[path_]);
    if (std::abs(share - fan_) < process::kSameFan)
      return;
    fan_ = share;
    if (walk_.outputs != nullptr && extruder_.fan)
      emitter_.send(extruder_.fan(share));
    else
      emitter_.fan(share);
  }

  void flow(double mm3PerS) {
    flow_ = mm3PerS;
    if (extruder_.text || extruder_.streams || extruder_.byAxis)
      return;
    if (const auto share = outputs_.flow(mm3PerS))
      emitter_.flow(*share);
  }
  void extruder(bool on) {
    if (walk_.outputs == nullptr || extruder_.byAxis)
      return;
    const bool turns = outputs_.setExtruder(on);
    if (extruder_.text)
      say(extruder_.text(on ? flow_ : 0.0));
    else if (turns)
      emitter_.extruder(on);
  }
  // After beginFile the extruder is stopped.
  void say(const std::string& text) {
    if (text == (said_.empty() ? extruder_.text(0.0) : said_))
      return;
    said_ = text;
    emitter_.send(text);
  }

  void draw(bool back) {
    drawn_ = back;
    const double mm = process().retractMm, seconds = mm / kDrawBackMmPerS;
    if (walk_.outputs == nullptr) {
      emitter_.retract(back ? -mm : mm);
    } else if (extruder_.byAxis) {
      emitter_.extrudeInPlace(back ? -mm : mm, seconds);
    } else if (extruder_.text) {
      const double mm3PerS = filamentArea(extruder_.filamentMm) * kDrawBackMmPerS;
      say(extruder_.text(back ? -mm3PerS : mm3PerS));
      emitter_.wait(seconds);
      say(extruder_.text(0.0));
    } else if (extruder_.streams) {
      extruder(true);
      emitter_.wait(seconds);
      extruder(false);
    }
  }

  void prime() {
    if (walk_.outputs == nullptr || !primesStanding(in_))
      return;
    emitter_.remark("prime");
    const double seconds = in_.process().primeS;
    if (extruder_.byAxis) {
      emitter_.extrudeInPlace(process::primeFlow(in_.process()) * seconds / filamentArea(),
                              seconds);
    } else {
      flow(process::primeFlow(in_.process()));
      extruder(true);
      emitter_.wait(seconds);
      extruder(false);
    }
    emitter_.remark("print");
  }

  const ProgramInput& in_;
  const Walk& walk_;
  ProgramEmitter& emitter_;
  const base::RunContext& ctx_;
  PathNames paths_;
  WrittenOutputs outputs_{in_.tooling.fullFlowMm3PerS()};
  const Extruder& extruder_;
  const bool locks_;  // before anything moves: an earlier run may have left the tool unlocked
  double flow_ = 0.0; // wanted flow
  bool drawn_ = false;
  int tool_ = in_.trajectory.firstTool; // selected
  std::vector<plan::MarkStatement> marks_;
  std::size_t mark_ = 0;                                   // said next
  std::array<std::size_t, plan::kMarkChannels> reached_{}; // marks, by channel
  std::size_t path_ = 0;                                   // printed last
  double fan_ = 0.0;
  std::size_t lastPrint_ = 0;      // point
  std::string said_;               // last text sent
  std::vector<std::size_t> zeros_; // points, of an extruder that is an axis
};

} // namespace

void ProgramEmitter::ownLine(std::string_view line) {
  remark(kOwnLineMark);
  remark(ownLineRemark(line));
}

void walkTrajectory(const ProgramInput& input, const Walk& walk, ProgramEmitter& emitter,
                    const base::RunContext& ctx) {
  Walker(input, walk, emitter, ctx).run();
}

namespace {
MotionTarget targetAt(const ProgramInput& input, std::size_t point) {
  return targetOf(input.cell,
                  Eigen::Map<const Eigen::VectorXd>(input.trajectory.at(point), input.cell.dof()));
}

// Returns the height of the nozzle at a point of a travel above the last bead before it.
double liftAt(const ProgramInput& input, std::size_t point) {
  std::size_t bead = point;
  while (bead > 0 && !isPrint(input.trajectory, bead))
    --bead;
  const MotionTarget end = targetAt(input, bead);
  return (targetAt(input, point).tipMm - end.tipMm).dot(end.direction);
}

// Returns where the file that begins at `begin` ends; nullopt if there is no suitable travel up to
// `last`.
std::optional<std::size_t> cutBehindLift(const ProgramInput& input, std::size_t begin,
                                         std::size_t limit, std::size_t last) {
  constexpr double kSlackMm = 0.01;
  std::optional<std::size_t> cut;
  double highest = 0.0;
  for (std::size_t i = begin + std::max<std::size_t>(1, limit / 2); i <= last; ++i) {
    if (!standsClear(input.trajectory, i))
      continue;
    const double lift = std::min(liftAt(input, i - 1), kClearMm - kSlackMm);
    if (!cut || (i - begin > limit ? lift > highest : lift >= highest)) {
      cut = i;
      highest = lift;
    }
  }
  return cut;
}
} // namespace

std::vector<std::size_t> cutsOf(const ProgramInput& input, std::size_t limit) {
  const std::size_t n = input.trajectory.pointCount();
  const std::size_t hard = limit + std::max<std::size_t>(limit / 10, 100);
  std::vector<std::size_t> cuts = {0};
  while (limit > 0 && n - cuts.back() > limit) {
    const std::size_t begin = cuts.back(), last = std::min(begin + hard, n - 1);
    const auto cut = cutBehindLift(input, begin, limit, last);
    if (!cut && n - begin <= hard)
      break;
    cuts.push_back(cut.value_or(last));
  }
  cuts.push_back(n);
  return cuts;
}

} // namespace voluta::program
