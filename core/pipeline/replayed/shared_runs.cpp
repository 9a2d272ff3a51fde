#include "pipeline/replayed/shared_runs.h"

#include "base/memory.h"
#include "base/run_context.h"
#include "pipeline/replayed/apart.h"
#include "replay/alignment.h"
#include "replay/distances.h"
#include "replay/replay_steps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace voluta::pipeline {

namespace {

using replay::kUnmatched;

constexpr double kSameOfCell = 0.5, kSameInTheMean = 0.1; // in cells of the bead grid
// share of a motion's volume; below kMinMm3 there is no material
constexpr double kSameVolume = 1e-3, kMinMm3 = 1e-6;

// Returns the volume that flows into a pocket where the motion ends.
double shotMm3(const replay::Run& run, std::size_t motion) {
  return motion < run.shotMm3.size() ? run.shotMm3[motion] : 0.0;
}

// A run and a judged one of the same plan, motion by motion.
class RunPair {
public:
  RunPair(const replay::Run& mine, const replay::JudgedRun& other) : mine_(mine), other_(other) {}

  // Returns whether both runs print the same beads. `reachMm`: of the head along its axis.
  bool printTheSame(double reachMm, const base::RunContext& ctx) {
    const std::vector<Apart> off = apart(other_.run, mine_, reachMm, ctx);
    const double cell = other_.figures.pitchMm;
    same_.assign(off.size(), 0);
    otherOf_.assign(off.size(), kUnmatched);
    double moved = 0.0, volume = 0.0;
    std::size_t beads = 0; // motions of the other run that deposit material and exist here too
    for (std::size_t m = 0; m < off.size(); ++m) {
      const std::size_t o = otherOf_[m] = off[m].motion;
      const double mine = mine_.volumeMm3[m];
      const double its = o == kUnmatched ? 0.0 : other_.run.volumeMm3[o];
      if (std::abs(shotMm3(mine_, m) - shotMm3(other_.run, o)) > kMinMm3)
        return false;
      same_[m] = o != kUnmatched && std::max(off[m].tipMm, off[m].headMm) <= kSameOfCell * cell;
      beads += its > 0.0;
      if (mine <= 0.0 && its <= 0.0)
        continue;
      if (off[m].tipMm > kSameOfCell * cell ||
          (o != kUnmatched && mine_.tool[m] != other_.run.tool[o]) ||
          std::abs(mine - its) > kMinMm3 + kSameVolume * std::min(mine, its))
        return false;
      moved += mine * off[m].tipMm;
      volume += mine;
    }
    const auto deposited =
        std::ranges::count_if(other_.run.volumeMm3, [](double v) { return v > 0.0; });
    return beads == static_cast<std::size_t>(deposited) && moved <= kSameInTheMean * cell * volume;
  }

  // Precondition: printTheSame() returned true.
  replay::KnownResults results() {
    numberMine();
    replay::KnownResults known;
    known.deposited = other_.deposited;
    known.figures = other_.figures;
    known.beads = other_.beads;
    for (replay::BeadFinding& f : known.beads)
      if (f.motion)
        f.motion = mineOf_[*f.motion];
    known.firstPiece = firstPieces();
    for (const auto* clashes : {&other_.head, &other_.arm})
      for (const replay::Clash& c : *clashes)
        excludeUnlessWhole(c);
    known.headKnown = same_;
    known.armKnown = sameArm();
    takeOver(other_.head, known.headKnown, known.head);
    takeOver(other_.arm, known.armKnown, known.arm);
    return known;
  }

private:
  void numberMine() {
    mineOf_.assign(other_.run.path.motionCount(), kUnmatched);
    for (std::size_t m = 0; m < otherOf_.size(); ++m)
      if (otherOf_[m] != kUnmatched)
        mineOf_[otherOf_[m]] = m;
  }

  // Returns the first piece of each motion among the other run's pieces.
  std::vector<std::uint32_t> firstPieces() const {
    const std::size_t motions = mine_.path.motionCount();
    const std::vector<std::uint32_t> its =
        replay::firstPieceOfMotions(other_.deposited->pieces, other_.run.path.motionCount());
    std::vector<std::uint32_t> mine(motions + 1, its.back());
    for (std::size_t m = motions; m-- > 0;)
      mine[m] = otherOf_[m] != kUnmatched ? its[otherOf_[m]] : mine[m + 1];
    return mine;
  }

  // A contact that continues into a motion that differs is checked again as a whole.
  void excludeUnlessWhole(const replay::Clash& c) {
    bool whole = true;
    for (std::size_t o = c.motion; o <= c.lastMotion; ++o)
      whole = whole && mineOf_[o] != kUnmatched && same_[mineOf_[o]];
    if (whole)
      return;
    for (std::size_t o = c.motion; o <= c.lastMotion; ++o)
      if (mineOf_[o] != kUnmatched)
        same_[mineOf_[o]] = 0;
  }

  std::vector<char> sameArm() const {
    std::vector<char> same(same_.size(), 0);
    if (other_.run.path.arm && mine_.path.arm)
      for (std::size_t m = 0; m < same.size(); ++m)
        same[m] = same_[m] && sameJoints(m);
    return same;
  }

  bool sameJoints(std::size_t motion) const {
    constexpr double kSameRad = 2e-4; // a tenth of a millimetre at half a metre
    const replay::ExecutedPath &path = mine_.path, &other = other_.run.path;
    if (other.dof != path.dof || otherOf_[motion] == kUnmatched)
      return false;
    for (int k = 0; k < path.dof; ++k)
      if (std::abs(path.angleOf(k, other.jointsAt(otherOf_[motion])[k] -
                                       path.jointsAt(motion)[k])) > kSameRad)
        return false;
    return true;
  }

  // Appends the clashes that begin in known motions, with this run's motions and times.
  void takeOver(const std::vector<replay::Clash>& clashes, const std::vector<char>& known,
                std::vector<replay::Clash>& out) const {
    for (replay::Clash c : clashes) {
      const std::size_t first = mineOf_[c.motion], last = mineOf_[c.lastMotion];
      if (first == kUnmatched || last == kUnmatched || !known[first])
        continue;
      c.whenS = mine_.path.startS[first] + (c.whenS - other_.run.path.startS[c.motion]);
      c.motion = first;
      c.lastMotion = last;
      out.push_back(std::move(c));
    }
  }

  const replay::Run& mine_;
  const replay::JudgedRun& other_;
  std::vector<char> same_; // per motion of mine: unchanged, but for the arm
  // Motions to the same point of the plan: of the other run, per motion of mine, and vice versa.
  std::vector<std::size_t> otherOf_, mineOf_;
};

} // namespace

replay::KnownResults SharedRuns::knownOf(const replay::Run& run, const process::Process& process,
                                         const base::RunContext& ctx) const {
  const replay::Ball head = replay::HeadSolid(process.head).ball();
  for (const replay::JudgedRun& other : runs_)
    if (RunPair pair(run, other); pair.printTheSame(head.centre.norm() + head.radius, ctx))
      return pair.results();
  return {};
}

void SharedRuns::add(replay::JudgedRun run) {
  replay::ExecutedPath& path = run.run.path;
  base::freeStorage(path.targetTip, path.targetDirection, path.commandedMm, path.angleRad,
                    path.cornerRad, path.durationS, path.violations, run.run.pointOf,
                    run.run.knowledge);
  runs_.push_back(std::move(run));
}

replay::Verification replayShared(replay::ReplayInput input,
                                  const replay::ReplayThresholds& thresholds, SharedRuns& shared,
                                  const base::RunContext& ctx) {
  replay::ComparedProgram compared = replay::compareProgram(input, thresholds, ctx);
  replay::KnownResults known =
      shared.knownOf(compared.run, input.tooling.first().process, ctx.sub(0.1, 1.0));
  replay::JudgedProgram judged =
      replay::judgeProgram(std::move(compared), input, thresholds, std::move(known), ctx);
  shared.add(std::move(judged.run));
  base::returnFreedMemory();
  return std::move(judged.verdict);
}

} // namespace voluta::pipeline
