#include "motion/sequence.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "motion/change_place.h"
#include "motion/external_axes.h"
#include "motion/layer_events.h"
#include "motion/motion_options.h"
#include "motion/timed_points.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace voluta::motion {

using Eigen::Vector3d;

namespace {

// A travel lifts high at least once per this many waypoints, so that long programs can be cut into
// files where the nozzle is clear of the part.
constexpr std::size_t kHighEvery = 2000;
// Multiple of the usual search effort, used where a piece would be lost otherwise
constexpr int kThorough = 5;

class Connector {
public:
  Connector(const MotionScene& scene, PathPlanner& paths, KnownTransfers& known,
            const RobotState& home, const std::set<std::size_t>& highBefore,
            const base::RunContext& ctx)
      : scene_(scene), paths_(paths), known_(known), home_(home), highBefore_(highBefore),
        ctx_(ctx), usual_(scene), thorough_(scene, kThorough), bounds_(printedBoundsOf(scene.plan)),
        places_(eventPlaces(scene.plan, scene.options.layerEvents)) {}

  ConnectedRuns connect(std::vector<Run> runs) {
    std::vector<std::optional<Transfer>> ahead(runs.size());
    if (!runs.empty())
      base::parallelChunks(ctx_, runs.size() - 1, 1, [&](std::size_t b, std::size_t) {
        ahead[b + 1] = between(runs[b], runs[b + 1]);
      });
    ctx_.checkpoint();
    for (std::size_t r = 0; r < runs.size(); ++r) {
      ctx_.report(static_cast<double>(r) / static_cast<double>(runs.size()), "transfers"_text);
      // The remaining runs were planned from another state than the arm has now.
      if (otherBranch_) {
        const RobotState from = kept().empty() ? home_ : kept().back().points.back().at;
        for (Run& run : planned(runs[r], from))
          take(std::move(run), std::nullopt);
      } else {
        take(std::move(runs[r]), std::move(ahead[r]));
      }
    }
    while (!kept().empty() && !transferHome_ && !retreatHome(afterLast(), bounds_.back()))
      if (!retreat(afterLast(), bounds_.back()))
        dropLast();
    if (transferHome_)
      result_.sequence.ways.push_back(std::move(*transferHome_));
    return std::move(result_);
  }

private:
  using Purpose = KnownTransfers::Purpose;

  std::vector<Run>& kept() { return result_.sequence.runs; }

  std::size_t afterLast() { return kept().back().points.back().next + 1; }

  // Appends the run to the kept ones. `ahead`: the transfer found from the previous run of the
  // plan, which is valid only if that is the last kept run, uncut.
  void take(Run run, std::optional<Transfer> ahead) {
    const std::size_t before = run.points.front().next;
    const PrintedBounds& surround = bounds_[run.path];
    std::optional<Transfer> transfer;
    if (!kept().empty() && !transferHome_) {
      transfer = lastIsWhole_ ? std::move(ahead) : between(kept().back(), run);
      if (transfer)
        addBehindLift(*transfer, eventsBetween(&kept().back(), run));
      // Waypoints that were skipped may be treated as printed: `before` counts them.
      if (!transfer && !retreatHome(before, surround) && !retreat(before, surround) &&
          !retreatHome(afterLast(), surround)) {
        skipPath(run, 0, run.points.size(), true);
        lastIsWhole_ = false;
        return;
      }
    }
    if (!transfer && (transfer = approach(usual_, run, 0, surround)))
      setOut(*transfer, run);
    if (!transfer && inAnotherBranch(run, surround))
      return;
    if (!transfer)
      transfer = fromHome(run, surround);
    if (!transfer) {
      skipPath(run, 0, run.points.size(), false);
      lastIsWhole_ = false;
      return;
    }
    result_.sequence.ways.push_back(std::move(*transfer));
    kept().push_back(std::move(run));
    lastIsWhole_ = true;
  }

  std::optional<Transfer> between(const Run& a, const Run& b) const {
    const RunPoint &last = a.points.back(), &first = b.points.front();
    const plan::ToolPath &pathA = scene_.plan.paths[a.path], &pathB = scene_.plan.paths[b.path];
    if (pathA.tool != pathB.tool || waitsBetween(a, b)) // The arm rests in between
      return std::nullopt;
    const bool hop = pathA.layer == pathB.layer && pathA.patch == pathB.patch &&
                     (last.at.tip - first.at.tip).norm() <= scene_.options.hopMm;
    const bool high = a.points.front().next / kHighEvery != first.next / kHighEvery ||
                      highBefore_.contains(first.next);
    const Lift lift = high ? Lift::High : hop ? Lift::Hop : Lift::Usual;
    const auto from = [&](const RobotState& state) {
      return known_.of(high ? Purpose::BetweenHigh : Purpose::Between, state, first.at, last.next,
                       first.next, bounds_[b.path], [&] {
                         return usual_.plan(state, first.at, lift, first.next, bounds_[b.path],
                                            scene_.options.seed + first.next, ctx_);
                       });
    };
    const std::vector<TransferPoint> wipe = usual_.wipe(a, scene_.options.wipeMm, first.next);
    if (!wipe.empty())
      if (std::optional<Transfer> transfer = from(wipe.back().at)) {
        transfer->points.insert(transfer->points.begin(), wipe.begin(), wipe.end());
        return transfer;
      }
    return from(last.at);
  }

  RobotState rest() {
    return kept().empty()
               ? home_
               : stateAt(scene_.cell, homeAfter(scene_.cell, kept().back().points.back().at.q));
  }

  // Plans the way home from the end of the last kept run; returns whether there is one.
  bool retreatHome(std::size_t before, const PrintedBounds& surround) {
    const RunPoint& end = kept().back().points.back();
    for (const TransferPlanner* planner : {&usual_, &thorough_})
      if ((transferHome_ = leave(*planner, end, rest(), before, surround)))
        return true;
    return false;
  }

  std::optional<Transfer> leave(const TransferPlanner& planner, const RunPoint& end,
                                const RobotState& rest, std::size_t before,
                                const PrintedBounds& surround) {
    return known_.of(&planner == &usual_ ? Purpose::Leave : Purpose::LeaveThoroughly, end.at, rest,
                     end.next, before, surround, [&] {
                       return planner.leave(end.at, rest, before, surround,
                                            scene_.options.seed + end.next, ctx_);
                     });
  }

  // If there is no way home: shortens the last kept run, or drops it and some before it. Returns
  // false if this does not help; nothing is changed then.
  bool retreat(std::size_t before, const PrintedBounds& surround) {
    constexpr std::size_t kMaxRuns = 3;
    for (std::size_t runs = 0; runs < std::min(kMaxRuns, kept().size()); ++runs) {
      const Run& run = kept()[kept().size() - 1 - runs];
      const std::size_t n = run.points.size();
      for (std::size_t back = runs == 0 ? 1 : 0; back + 1 < n;
           back = std::max<std::size_t>(1, 2 * back)) {
        std::size_t count = n - back;
        while (count > 1 && run.points[count - 1].waypoint == plan::kNoWaypoint)
          --count;
        if (count < 2)
          break;
        const RunPoint& end = run.points[count - 1];
        const RobotState home = stateAt(scene_.cell, homeAfter(scene_.cell, end.at.q));
        auto transfer = leave(usual_, end, home, before, surround);
        if (!transfer)
          continue;
        for (std::size_t k = 0; k < runs; ++k)
          dropLast();
        cutLast(count);
        transferHome_ = std::move(transfer);
        lastIsWhole_ = false;
        return true;
      }
    }
    return false;
  }

  void dropLast() {
    skipPath(kept().back(), 0, kept().back().points.size(), true);
    kept().pop_back();
    result_.sequence.ways.pop_back();
    lastIsWhole_ = false;
  }

  void cutLast(std::size_t count) {
    Run& run = kept().back();
    if (count == run.points.size())
      return;
    skipPath(run, count, run.points.size(), true);
    run.points.resize(count);
    run.ladder = jointsOf(run.points);
  }

  // Returns the transfer from the rest pose to a point of the run.
  std::optional<Transfer> approach(const TransferPlanner& planner, const Run& run, std::size_t at,
                                   const PrintedBounds& surround) {
    const RunPoint& start = run.points[at];
    const RobotState from = rest();
    return known_.of(&planner == &usual_ ? Purpose::Approach : Purpose::ApproachThoroughly, from,
                     start.at, start.next, start.next, surround, [&] {
                       return planner.approach(from, start.at, start.next, surround,
                                               scene_.options.seed + start.next, ctx_);
                     });
  }

  // Prepends the way home after the last kept run, if there is one, the events of layers, and the
  // change to the run's tool, if another one is mounted.
  void setOut(Transfer& transfer, const Run& run) {
    const std::size_t before = run.points.front().next;
    const Run* const last = kept().empty() ? nullptr : &kept().back();
    Transfer atRest = happen(eventsBetween(last, run), last && toolOf(*last) != toolOf(run),
                             last == nullptr, before);
    if (last && toolOf(*last) != toolOf(run))
      join(atRest, toolChange(toolOf(*last), toolOf(run), before));
    prepend(atRest, transfer);
    if (transferHome_)
      prepend(*transferHome_, transfer);
    transferHome_.reset();
  }

  int toolOf(const Run& run) const { return scene_.plan.paths[run.path].tool; }
  const plan::LayerEvent& eventAt(std::size_t place) const {
    return scene_.options.layerEvents[places_[place].event];
  }

  // Returns whether it is so for each event that happens at a place.
  template <typename Is> bool isEach(std::size_t place, const Is& is) const {
    return is(eventAt(place)) && std::ranges::all_of(places_[place].also, [&](std::size_t event) {
             return is(scene_.options.layerEvents[event]);
           });
  }

  // Returns the events between two runs, as indices of their places; `a`: nullptr before the first
  // run. Where the operator changes the tool the arm stops anyway.
  std::vector<std::size_t> eventsBetween(const Run* a, const Run& b) const {
    const bool stopsAnyway =
        a && toolOf(*a) != toolOf(b) && scene_.cell.toolChange().by == robot::ToolChange::By::Hand;
    std::vector<std::size_t> between;
    for (std::size_t k = 0; k < places_.size() && places_[k].path <= b.path; ++k) {
      const plan::LayerEvent& event = eventAt(k);
      const bool isUsualPause =
          event.kind == plan::LayerEventKind::Pause && isEach(k, [](const plan::LayerEvent& one) {
            return one.text.empty() && !one.changesFilament;
          });
      if ((!a || places_[k].path > a->path) && event.kind != plan::LayerEventKind::Tool &&
          !(stopsAnyway && isUsualPause))
        between.push_back(k);
    }
    return between;
  }
  bool waitsBetween(const Run& a, const Run& b) const {
    return std::ranges::any_of(eventsBetween(&a, b),
                               [&](std::size_t k) { return waitsAside(eventAt(k).kind); });
  }

  // Adds events that need no place of their own where the nozzle has left the bead.
  static void addBehindLift(Transfer& transfer, const std::vector<std::size_t>& places) {
    const std::size_t last = transfer.points.size() - 1;
    std::size_t lift = 0;
    while (lift < last && transfer.points[lift].move == plan::MoveKind::Wipe)
      ++lift;
    const std::size_t point = std::min(lift + 1, last);
    for (const std::size_t place : places)
      transfer.toolSteps.push_back({point, ToolStep::Kind::Event, place});
  }

  // Returns the events as a trip from rest and back. The nozzle has dripped while the arm waited:
  // it is primed where that hurts nothing, unless a change of the tool follows, which purges it.
  Transfer happen(const std::vector<std::size_t>& places, bool isBeforeChange, bool isFirst,
                  std::size_t before) {
    using Kind = ToolStep::Kind;
    if (places.empty())
      return isFirst ? prime(before) : Transfer();
    const auto waits = [&](std::size_t k) { return waitsAside(eventAt(k).kind); };
    std::vector<ToolStep> steps;
    for (const std::size_t place : places)
      steps.push_back({0, Kind::Event, place});
    Transfer all;
    if (std::ranges::none_of(places, waits)) {
      all.toolSteps = std::move(steps);
      if (isFirst)
        join(all, prime(before));
      return all;
    }
    const bool changesFilament = std::ranges::any_of(places, [&](std::size_t k) {
      return !isEach(k, [](const plan::LayerEvent& one) { return !one.changesFilament; });
    });
    if (!isBeforeChange && !(isFirst && scene_.plan.primes()))
      steps.push_back({0, changesFilament ? Kind::Purge : Kind::Prime});
    doBeside(all, std::move(steps), before);
    return all;
  }

  static void prepend(const Transfer& first, Transfer& transfer) {
    for (ToolStep& step : transfer.toolSteps)
      step.point += first.points.size();
    transfer.toolSteps.insert(transfer.toolSteps.begin(), first.toolSteps.begin(),
                              first.toolSteps.end());
    transfer.points.insert(transfer.points.begin(), first.points.begin(), first.points.end());
  }

  // Returns the change from tool to tool, which begins and ends at rest. Throws
  // Error{UnusableInput} if the arm does not reach a dock.
  Transfer toolChange(int mounted, int wanted, std::size_t before) {
    using Kind = ToolStep::Kind;
    const bool isChanger = scene_.cell.toolChange().by == robot::ToolChange::By::Changer;
    Transfer all;
    if (isChanger) {
      putTool(all, mounted, before, Kind::Release);
      putTool(all, wanted, before, Kind::Take);
    }
    if (isChanger)
      goTo(all, rest(), wanted, before);
    std::vector<ToolStep> steps = {{0, Kind::Purge}};
    if (!isChanger)
      steps.insert(steps.begin(), ToolStep{0, Kind::Take});
    doBeside(all, std::move(steps), before);
    return all;
  }

  // Returns the trip on which the first tool is primed; empty if a path primes it, or the program
  // may prime it at rest.
  Transfer prime(std::size_t before) {
    Transfer all;
    if (scene_.options.purge.primesBeside && !scene_.plan.primes() && dropsOnPart(scene_, rest().q))
      doBeside(all, {{0, ToolStep::Kind::Prime}}, before);
    return all;
  }

  // Appends a trip from rest to the place beside the part, the steps there, a wipe, and the way
  // back. If there is no such place, the steps are done at rest.
  void doBeside(Transfer& all, std::vector<ToolStep> steps, std::size_t before) {
    const auto trip = purgeTrip(scene_, rest(), placesBeside(rest().q),
                                [&](const RobotState& from, const RobotState& to, bool isStraight) {
                                  return go(from, to, isStraight, before);
                                });
    if (trip)
      append(all, trip->there);
    else if (dropsOnPart(scene_, rest().q))
      keepFromPart(steps);
    for (ToolStep& step : steps) {
      step.point = all.points.size();
      all.toolSteps.push_back(step);
    }
    if (trip) {
      append(all, trip->wipe);
      append(all, trip->back);
    }
  }
  // At rest above the part: what primes the nozzle after a pause would fall on it.
  void keepFromPart(std::vector<ToolStep>& steps) {
    const auto waits = [&](const ToolStep& step) {
      return step.kind == ToolStep::Kind::Event && waitsAside(eventAt(step.event).kind);
    };
    const auto count = static_cast<std::size_t>(std::ranges::count_if(steps, waits));
    if (count == 0)
      return;
    result_.waitsAbovePart += count;
    std::erase_if(steps, [](const ToolStep& step) { return step.kind != ToolStep::Kind::Event; });
  }
  // Appends a trip from rest and back to another one.
  static void join(Transfer& all, const Transfer& next) {
    for (ToolStep step : next.toolSteps) {
      step.point += all.points.size();
      all.toolSteps.push_back(step);
    }
    append(all, next.points);
  }
  static void append(Transfer& to, const std::vector<TransferPoint>& points) {
    to.points.insert(to.points.end(), points.begin(), points.end());
  }

  // Returns purgePlaces(), which looks at all waypoints, once for each rest pose.
  const std::vector<PurgePlace>& placesBeside(const robot::JointVector& home) {
    if (!beside_ || beside_->first != home)
      beside_.emplace(home, purgePlaces(scene_, home));
    return beside_->second;
  }

  // Goes into the tool's dock, releases or takes it there, and comes out again.
  void putTool(Transfer& all, int tool, std::size_t before, ToolStep::Kind kind) {
    const auto& docks = scene_.cell.toolChange().docks;
    base::require(static_cast<std::size_t>(tool) < docks.size(), "a dock for each tool");
    const robot::ToolDock& dock = docks[static_cast<std::size_t>(tool)];
    const RobotState outside = dockState(dock.before), inside = dockState(dock.in);
    goTo(all, outside, tool, before);
    goTo(all, inside, tool, before, true);
    all.toolSteps.push_back({all.points.size(), kind});
    goTo(all, outside, tool, before, true);
  }

  RobotState dockState(const robot::JointVector& arm) {
    robot::JointVector q = rest().q;
    q.head(arm.size()) = arm;
    return stateAt(scene_.cell, q);
  }

  // Returns the motion between two states away from the part.
  std::optional<Transfer> go(const RobotState& from, const RobotState& to, bool isStraight,
                             std::size_t before) {
    const auto kind =
        isStraight ? KnownTransfers::Purpose::DockStraight : KnownTransfers::Purpose::Dock;
    return known_.of(kind, from, to, before, before, {}, [&] {
      return isStraight ? usual_.straight(from, to, before)
                        : usual_.between(from, to, before, scene_.options.seed + before, ctx_);
    });
  }

  // Appends the motion to or from the dock of a tool; throws if there is none.
  void goTo(Transfer& all, const RobotState& to, int tool, std::size_t before,
            bool isStraight = false) {
    const auto transfer =
        go(all.points.empty() ? rest() : all.points.back().at, to, isStraight, before);
    if (transfer)
      append(all, transfer->points);
    else
      throw base::Error(base::ErrorCode::UnusableInput,
                        base::message("the arm does not get to the dock of tool {number} without "
                                      "a collision"_text,
                                      tool + 1),
                        {}, "move the dock or the part"_text);
  }

  // Plans the run's waypoints again, starting from `from`.
  std::vector<Run> planned(const Run& run, const RobotState& from) {
    std::vector<Run> runs;
    const std::size_t first = run.points.front().next, last = run.points.back().next;
    paths_.plan(run.path, first, last - first + 1, from, ctx_.quiet(), runs, result_.refused);
    return runs;
  }

  // Prints the run from the rest pose in another branch of the arm or with other rotations. Returns
  // false if this does not help.
  bool inAnotherBranch(const Run& run, const PrintedBounds& surround) {
    const std::size_t refusedBefore = result_.refused.size();
    std::vector<Run> runs = planned(run, rest());
    if (!runs.empty())
      if (auto transfer = approach(usual_, runs.front(), 0, surround)) {
        setOut(*transfer, runs.front());
        result_.sequence.ways.push_back(std::move(*transfer));
        kept().push_back(std::move(runs.front()));
        otherBranch_ = true;
        lastIsWhole_ = false;
        for (std::size_t i = 1; i < runs.size(); ++i)
          take(std::move(runs[i]), std::nullopt);
        return true;
      }
    result_.refused.resize(refusedBefore);
    return false;
  }

  // Plans the transfer from the rest pose to the run's start with more effort, or to the nearest
  // point of the run that can be reached; earlier points are lost.
  std::optional<Transfer> fromHome(Run& run, const PrintedBounds& surround) {
    const std::size_t n = run.points.size();
    std::optional<Transfer> transfer = approach(thorough_, run, 0, surround);
    std::size_t first = 0;
    for (std::size_t on = 1; !transfer && on + 1 < n; on *= 2) {
      first = on;
      while (first < n && run.points[first].waypoint == plan::kNoWaypoint)
        ++first;
      if (first + 1 < n)
        transfer = approach(usual_, run, first, surround);
    }
    if (!transfer)
      return std::nullopt;
    if (first > 0) {
      skipPath(run, 0, first, false);
      run.points.erase(run.points.begin(), run.points.begin() + static_cast<std::ptrdiff_t>(first));
      run.ladder = jointsOf(run.points);
    }
    setOut(*transfer, run);
    return transfer;
  }

  void skipPath(const Run& run, std::size_t from, std::size_t to, bool caught) {
    SkippedPiece piece;
    piece.caught = caught;
    for (std::size_t i = from; i < to; ++i)
      if (run.points[i].waypoint != plan::kNoWaypoint)
        piece.waypoints.push_back(run.points[i].waypoint);
    if (!piece.waypoints.empty())
      result_.skipped.push_back(std::move(piece));
  }

  const MotionScene& scene_;
  PathPlanner& paths_;
  KnownTransfers& known_;
  const RobotState& home_;
  const std::set<std::size_t>& highBefore_;
  const base::RunContext& ctx_;
  TransferPlanner usual_, thorough_;
  std::vector<PrintedBounds> bounds_;
  std::vector<EventPlace> places_; // of events of layers
  std::optional<std::pair<robot::JointVector, std::vector<PurgePlace>>> beside_; // placesBeside()
  ConnectedRuns result_;
  std::optional<Transfer> transferHome_; // The way home from the last kept run, once needed
  bool lastIsWhole_ = false;             // The last kept run is the last one taken, uncut
  // A run was planned again: later runs no longer continue from its state
  bool otherBranch_ = false;
};

} // namespace

std::vector<PrintedBounds> printedBoundsOf(const plan::ToolPlan& plan) {
  std::vector<PrintedBounds> balls;
  Vector3d low = Vector3d::Zero(), high = Vector3d::Zero(); // The platform's middle
  std::multimap<std::size_t, const plan::Insert*> inserts;  // by the first waypoint after
  for (const plan::Insert& insert : plan.inserts)
    inserts.emplace(plan.firstAfter(insert), &insert);
  for (const plan::ToolPath& path : plan.paths) {
    for (auto [own, end] = inserts.equal_range(path.first); own != end; ++own)
      for (const Vector3d& vertex : own->second->body->vertices) {
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
      }
    balls.push_back({0.5 * (low + high), 0.5 * (high - low).norm()});
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      low = low.cwiseMin(plan.position[i]);
      high = high.cwiseMax(plan.position[i]);
    }
  }
  balls.push_back({0.5 * (low + high), 0.5 * (high - low).norm()});
  return balls;
}

RobotState stateAt(const robot::Cell& cell, const robot::JointVector& q) {
  const Eigen::Isometry3d pose = cell.work_T_tool(q);
  return {pose.translation(), Eigen::Quaterniond(pose.linear()), q, axesOf(cell, q)};
}

ConnectedRuns connectRuns(const MotionScene& scene, std::vector<Run> runs, const RobotState& home,
                          PathPlanner& paths, KnownTransfers& known, const base::RunContext& ctx,
                          const std::set<std::size_t>& highBefore) {
  return Connector(scene, paths, known, home, highBefore, ctx).connect(std::move(runs));
}

} // namespace voluta::motion
