#include "replay/run.h"

#include "base/memory.h"
#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "replay/alignment.h"
#include "replay/coverage.h"
#include "replay/ground.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;
using enum plan::FindingKind;

constexpr std::size_t kMaxCells = 48'000'000;
// Material further than this from part and plan is not tracked; it counts as excess.
constexpr double kStrayMm = 12.0;
constexpr double kSameOfCell = 0.5, kSameInTheMean = 0.1; // in cells of the bead grid
// share of a motion's volume; below kLeastMm3 there is no material
constexpr double kSameVolume = 1e-3, kLeastMm3 = 1e-6;

class RunJudge {
public:
  RunJudge(Run run, const ReplayInput& in, const ReplayThresholds& limits,
           const base::RunContext& ctx)
      : in_(in), limits_(limits), ctx_(ctx) {
    out_.run = std::move(run);
  }

  JudgedRun judge(const JudgedRuns& judged) {
    const JudgedRun* known = nullptr;
    for (const auto& other : judged)
      if (!known && laysTheSame(*other))
        known = other.get();
    if (known) {
      numberMine(known->run.path.motionCount());
      out_.laid = known->laid;
      out_.figures = known->figures;
      out_.beads = known->beads;
      for (BeadFinding& f : out_.beads)
        if (f.motion)
          f.motion = mineOf_[*f.motion];
    } else {
      same_.assign(out_.run.path.motionCount(), 0);
      out_.laid = layBeads();
    }
    findClashes(known);
    gatherMet();
    base::freeStorage(out_.run.path.armJoints, out_.run.path.armMotion, out_.run.path.armFraction);
    return std::move(out_);
  }

private:
  const ExecutedPath& path() const { return out_.run.path; }

  // Returns whether both runs print the same beads; fills in same_ and otherOf_.
  bool laysTheSame(const JudgedRun& other) {
    const Ball head = HeadSolid(in_.process.head).ball();
    const std::vector<Apart> off =
        apart(other.run, out_.run, head.centre.norm() + head.radius, ctx_);
    const double cell = other.figures.pitchMm;
    same_.assign(off.size(), 0);
    otherOf_.assign(off.size(), kUnmatched);
    double moved = 0.0, volume = 0.0;
    std::size_t beads = 0; // motions of the other run that deposit material and exist here too
    for (std::size_t m = 0; m < off.size(); ++m) {
      const std::size_t o = otherOf_[m] = off[m].motion;
      const double mine = out_.run.volumeMm3[m];
      const double its = o == kUnmatched ? 0.0 : other.run.volumeMm3[o];
      same_[m] = o != kUnmatched && std::max(off[m].tipMm, off[m].headMm) <= kSameOfCell * cell;
      beads += its > 0.0;
      if (mine <= 0.0 && its <= 0.0)
        continue;
      if (off[m].tipMm > kSameOfCell * cell ||
          std::abs(mine - its) > kLeastMm3 + kSameVolume * std::min(mine, its))
        return false;
      moved += mine * off[m].tipMm;
      volume += mine;
    }
    const auto laid = std::ranges::count_if(other.run.volumeMm3, [](double v) { return v > 0.0; });
    return beads == static_cast<std::size_t>(laid) && moved <= kSameInTheMean * cell * volume;
  }

  std::shared_ptr<const LaidBeads> layBeads() {
    std::vector<BeadPiece> pieces = beadPieces(out_.run.volumeMm3, path(), out_.run.knowledge);
    dropFallen(pieces, GroundProbe(in_.platform));
    // The grid spans the part and its surroundings; one far-off waypoint must not enlarge it
    // without bound.
    Vector3d low = in_.part.vertices.front(), high = low;
    const auto take = [&](const Vector3d& p) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    };
    for (const Vector3d& v : in_.part.vertices)
      take(v);
    for (const Vector3d& p : in_.plan.position)
      take(p);
    const Vector3d mostLow = low - Vector3d::Constant(kStrayMm);
    const Vector3d mostHigh = high + Vector3d::Constant(kStrayMm);
    const double margin = in_.process.beadWidthMaxMm;
    for (const BeadPiece& piece : pieces)
      take(piece.to);
    low = (low - Vector3d::Constant(margin)).cwiseMax(mostLow);
    high = (high + Vector3d::Constant(margin)).cwiseMin(mostHigh);
    // Support below a bead is searched for within a quarter of its height, which cells of more than
    // half a height would not resolve.
    const double ofWidth = 0.25 * in_.process.beadWidthMm;
    const double ofHeight = 0.5 * thinHeight();
    const voxel::VoxelGrid grid = gridOver(low, high, std::min(ofWidth, ofHeight), kMaxCells);
    out_.figures.pitchMm = grid.pitch;
    DepositOptions options;
    options.widthMaxMm = 3.0 * in_.process.beadWidthMaxMm;
    const auto laid = std::make_shared<LaidBeads>();
    laid->beads = depositBeads(grid, pieces, options, ctx_.sub(0.0, 0.64));
    laid->printed.emplace(laid->beads, pieces);
    laid->underside.emplace(process::erodedHead(in_.process.head, in_.process.contactToleranceMm),
                            pieces, options.widthMaxMm);
    judgeBeads(*laid, pieces);
    laid->pieces = laidPieces(pieces, 2.0 * in_.process.beadWidthMaxMm);
    // Collision checks need only the filling pieces.
    laid->beads.fill = {};
    laid->beads.otherFill = {};
    base::freeStorage(laid->beads.pieceExcessMm3);
    return laid;
  }

  // Returns the thickness that nine tenths of the waypoints exceed, or the process's layer height
  // if that is less.
  double thinHeight() const {
    std::vector<float> heights = in_.plan.heightMm;
    if (heights.empty())
      return in_.process.layerHeightMm;
    const auto tenth = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 10);
    std::nth_element(heights.begin(), tenth, heights.end());
    return std::clamp(static_cast<double>(*tenth), in_.process.layerHeightMinMm,
                      in_.process.layerHeightMm);
  }

  // Returns the mesh's exact volume if the mesh is closed, else the volume on the grid.
  double partVolume(double onGrid) const {
    double sum = 0.0;
    for (std::size_t t = 0; t < in_.part.triangles.size(); ++t)
      sum += in_.part.corner(t, 0).dot(in_.part.corner(t, 1).cross(in_.part.corner(t, 2))) / 6.0;
    return std::abs(sum - onGrid) < 0.02 * onGrid ? sum : onGrid;
  }

  void add(plan::FindingKind kind, std::vector<plan::NamedValue> values,
           std::optional<Vector3d> where = std::nullopt,
           std::optional<std::size_t> motion = std::nullopt, std::size_t count = 1) {
    out_.beads.push_back({kind, std::move(values), where, motion, count});
  }

  void judgeBeads(const LaidBeads& laid, const std::vector<BeadPiece>& pieces) {
    ctx_.report(0.65, "measuring the beads"_text);
    const BeadGrid& beads = laid.beads;
    RunFigures& figures = out_.figures;
    const geometry::MeshQuery query(in_.part);
    const PartCells cells = partCells(in_.part, query, beads.grid, ctx_);
    const Coverage coverage =
        measureCoverage(beads, cells, query, 0.25 * in_.process.beadWidthMm, ctx_);
    figures.partVolumeMm3 = partVolume(cells.volumeMm3);
    const double volume = std::max(figures.partVolumeMm3, 1e-9);
    figures.coveredFraction = coverage.coveredFraction;
    if (coverage.worstGapMm3 > 0.0)
      figures.worst.gap = coverage.worstGap;
    double excess = 0.0;
    std::size_t worst = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p)
      if (pieces[p].ofPart) {
        excess += static_cast<double>(beads.pieceExcessMm3[p]);
        if (beads.pieceExcessMm3[p] > beads.pieceExcessMm3[worst])
          worst = p;
      }
    figures.excessFraction = std::max(0.0, excess / volume);
    if (excess > 0.0)
      figures.worst.overfill = pieces[worst].to;
    figures.overfillFraction = std::max(0.0, (coverage.outsideMm3 + excess) / volume);
    if (figures.coveredFraction < limits_.coveredMin)
      add(Uncovered, {{"share", base::percent(100.0 * (1.0 - figures.coveredFraction))}},
          coverage.worstGap);
    if (figures.overfillFraction > limits_.overfillMax) {
      std::optional<Vector3d> where;
      std::optional<std::size_t> motion;
      if (!pieces.empty())
        where = pieces[worst].to, motion = pieces[worst].motion;
      add(Overfill,
          {{"outside", base::percent(100.0 * coverage.outsideMm3 / volume)},
           {"noRoom", base::percent(100.0 * figures.excessFraction)}},
          where, motion);
    }
    ctx_.report(0.7, "checking support below the beads"_text);
    const SupportedBeads support =
        findSupport(pieces, *laid.printed, GroundProbe(in_.platform), ctx_);
    figures.beadLengthMm = support.lengthMm;
    const double length = std::max(support.lengthMm, 1e-9);
    figures.unsupportedFraction = support.unsupportedMm / length;
    figures.halfCarriedFraction = support.halfCarriedMm / length;
    figures.longestUnsupportedMm = support.longestUnsupportedMm;
    if (support.unsupportedFrom)
      figures.worst.unsupported = pieces[*support.unsupportedFrom].to;
    if (support.halfCarriedFrom)
      figures.worst.halfCarried = pieces[*support.halfCarriedFrom].to;
    if (support.longestUnsupportedMm > 0.0)
      figures.worst.longestUnsupported = pieces[support.longestFrom].to;
    if (figures.unsupportedFraction > limits_.unsupportedMax && !support.unsupported.empty()) {
      const BeadPiece& first = pieces[support.unsupported.front()];
      add(Unsupported, {{"length", base::mm(support.unsupportedMm)}}, first.to, first.motion,
          support.unsupported.size());
    }
    if (support.longestUnsupportedMm > in_.process.bridgeMm) {
      const BeadPiece& first = pieces[support.longestFrom];
      add(LongBridge,
          {{"length", base::mm(support.longestUnsupportedMm)},
           {"bridge", base::mm(in_.process.bridgeMm)}},
          first.to, first.motion);
    }
  }

  void findClashes(const JudgedRun* known) {
    ctx_.report(0.72, "checking for collisions"_text);
    const GroundSolids ground(in_.platform, in_.cell, 0.25 * in_.process.beadWidthMm, ctx_);
    const bool armToo = known && known->run.path.arm && path().arm;
    if (known)
      for (const auto* clashes : {&known->head, &known->arm})
        for (const Clash& c : *clashes)
          lend(c);
    std::vector<char> armSame = armToo ? same_ : std::vector<char>(same_.size(), 0);
    if (armToo)
      for (std::size_t m = 0; m < armSame.size(); ++m)
        armSame[m] = armSame[m] && sameJoints(known->run.path, m);
    const std::vector<std::uint32_t> firstPiece = firstPieces(known);
    out_.head = headClashes(path(), out_.laid->pieces, firstPiece, *out_.laid->printed,
                            *out_.laid->underside, in_.process, ground, same_, ctx_);
    ctx_.report(0.97, "checking for collisions"_text);
    out_.arm = armClashes(path(), firstPiece, *out_.laid->printed, ground, in_.cell, armSame, ctx_);
    if (known) {
      takeOver(known->head, same_, known->run.path, out_.head);
      takeOver(known->arm, armSame, known->run.path, out_.arm);
    }
  }

  // Returns the first piece of each motion. The pieces may be shared by a known run and then be
  // numbered by its motions.
  std::vector<std::uint32_t> firstPieces(const JudgedRun* known) const {
    const std::size_t motions = path().motionCount();
    if (!known)
      return firstPieceOfMotions(out_.laid->pieces, motions);
    const std::vector<std::uint32_t> its =
        firstPieceOfMotions(out_.laid->pieces, known->run.path.motionCount());
    std::vector<std::uint32_t> mine(motions + 1, its.back());
    for (std::size_t m = motions; m-- > 0;)
      mine[m] = otherOf_[m] != kUnmatched ? its[otherOf_[m]] : mine[m + 1];
    return mine;
  }

  void numberMine(std::size_t count) {
    mineOf_.assign(count, kUnmatched);
    for (std::size_t m = 0; m < otherOf_.size(); ++m)
      if (otherOf_[m] != kUnmatched)
        mineOf_[otherOf_[m]] = m;
  }

  // A contact that continues into a motion that differs is checked again as a whole.
  void lend(const Clash& c) {
    bool whole = true;
    for (std::size_t o = c.motion; o <= c.lastMotion; ++o)
      whole = whole && mineOf_[o] != kUnmatched && same_[mineOf_[o]];
    if (whole)
      return;
    for (std::size_t o = c.motion; o <= c.lastMotion; ++o)
      if (mineOf_[o] != kUnmatched)
        same_[mineOf_[o]] = 0;
  }

  bool sameJoints(const ExecutedPath& other, std::size_t motion) const {
    constexpr double kSameRad = 2e-4; // a tenth of a millimetre at half a metre
    if (other.dof != path().dof || otherOf_[motion] == kUnmatched)
      return false;
    for (int k = 0; k < path().dof; ++k)
      if (std::abs(path().turnOf(k, other.jointsAt(otherOf_[motion])[k] -
                                        path().jointsAt(motion)[k])) > kSameRad)
        return false;
    return true;
  }

  void takeOver(const std::vector<Clash>& clashes, const std::vector<char>& same,
                const ExecutedPath& other, std::vector<Clash>& out) const {
    for (Clash c : clashes) {
      const std::size_t first = mineOf_[c.motion], last = mineOf_[c.lastMotion];
      if (first == kUnmatched || last == kUnmatched || !same[first])
        continue;
      c.whenS = path().startS[first] + (c.whenS - other.startS[c.motion]);
      c.motion = first;
      c.lastMotion = last;
      out.push_back(std::move(c));
    }
  }

  void gatherMet() {
    out_.figures.collisions = out_.head.size() + out_.arm.size();
    std::set<std::size_t> waypoints;
    for (const auto* clashes : {&out_.head, &out_.arm})
      for (const Clash& c : *clashes)
        for (std::size_t m = c.motion; m <= c.lastMotion; ++m)
          if (out_.run.pointOf[m] != kUnmatched)
            if (const std::size_t w = plan::waypointAhead(in_.trajectory, out_.run.pointOf[m]);
                w != plan::kNoWaypoint)
              waypoints.insert(w);
    out_.figures.collidingWaypoints.assign(waypoints.begin(), waypoints.end());
  }

  const ReplayInput& in_;
  const ReplayThresholds& limits_;
  const base::RunContext& ctx_;
  JudgedRun out_;
  std::vector<char> same_; // per motion: as in the known run
  // Motions to the same point of the plan: the known run's per motion of this run, and the inverse.
  std::vector<std::size_t> otherOf_, mineOf_;
};

} // namespace

JudgedRun judgeRun(Run run, const ReplayInput& input, const ReplayThresholds& thresholds,
                   const JudgedRuns& judged, const base::RunContext& ctx) {
  return RunJudge(std::move(run), input, thresholds, ctx).judge(judged);
}

JudgedRun strippedForReuse(JudgedRun run) {
  ExecutedPath& path = run.run.path;
  base::freeStorage(path.targetTip, path.targetDirection, path.commandedMm, path.turnRad,
                    path.cornerRad, path.durationS, path.violations, run.run.pointOf,
                    run.run.knowledge);
  return run;
}

} // namespace voluta::replay
