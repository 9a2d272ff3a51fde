#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/mesh_query.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "replay/alignment.h"
#include "replay/beads.h"
#include "replay/clashes.h"
#include "replay/comparison.h"
#include "replay/coverage.h"
#include "replay/depositor.h"
#include "replay/executed_path.h"
#include "replay/ground.h"
#include "replay/verification.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;
using enum plan::FindingKind;

constexpr std::size_t kMaxCells = 48'000'000;
constexpr std::size_t kMaxListed = 100; // of one kind; the rest is counted
// Material further than this from part and plan is not followed: it counts as excess.
constexpr double kStrayMm = 12.0;

class Judge {
public:
  Judge(const ReplayInput& in, const ReplayThresholds& limits, const base::RunContext& ctx)
      : in_(in), limits_(limits), ctx_(ctx) {}

  Verification run() {
    check();
    ctx_.report(0.0, "running the program"_text);
    path_ = executeProgram(in_.program, in_.cell, ctx_);
    out_.armChecked = path_.arm;
    out_.durationS = path_.totalS();
    compare();
    layBeads();
    judgeBeads();
    findClashes();
    tellLimits();
    conclude();
    ctx_.report(1.0, "replayed"_text);
    return std::move(out_);
  }

private:
  void check() const {
    const plan::Trajectory& t = in_.trajectory;
    const std::size_t n = t.pointCount();
    base::require(t.dof == in_.cell.dof(), "replay: the trajectory is the cell's");
    base::require(t.joints.size() == n * static_cast<std::size_t>(t.dof) && t.move.size() == n &&
                      t.waypoint.size() == n && t.extrudedMm3.size() == n,
                  "replay: the trajectory's arrays have one length");
    base::require(!in_.part.empty(), "replay: the part has triangles");
    base::require(in_.platform.known(), "replay: the platform is known");
  }

  void add(plan::FindingKind kind, std::vector<plan::NamedValue> values,
           std::optional<Vector3d> where = std::nullopt, TextPlace place = {},
           std::size_t count = 1) {
    out_.findings.push_back(plan::makeFinding(kind, std::move(values), where, count));
    out_.places.push_back(place);
  }
  // The finding begins with the line of that motion.
  void atMotion(plan::FindingKind kind, std::size_t motion, std::vector<plan::NamedValue> values,
                const Vector3d& where, double whenS, std::size_t count = 1) {
    add(kind, std::move(values), where, place(motion), count);
    out_.findings.back().whenS = whenS;
    out_.findings.back().program = programLine(in_.program, place(motion));
  }
  TextPlace place(std::size_t motion) const { return placeOf(in_.program, motion); }

  void compare() {
    ctx_.report(0.06, "comparing with the plan"_text);
    const PlannedNozzle planned = plannedNozzle(in_.trajectory, in_.cell, ctx_);
    Alignment alignment = alignToPlan({path_.targetTip, path_.targetDirection},
                                      {planned.tip, planned.direction}, AlignmentOptions{}, ctx_);
    for (TextFinding& f : compareWithPlan(in_.program, path_, planned, in_.trajectory, alignment,
                                          ComparisonOptions{})) {
      ++out_.deviations;
      out_.findings.push_back(std::move(f.finding));
      out_.places.push_back(f.place);
    }
    const struct PathDeviation deviation =
        pathDeviation(path_, planned, in_.trajectory, in_.program, alignment, ctx_);
    out_.maxDeviationMm = deviation.mm;
    out_.maxDeviationRad = deviation.rad;
    deviationMotion_ = deviation.motion;
    knowledge_ =
        beadKnowledge(alignment.pointOf, in_.trajectory, in_.plan, in_.process.layerHeightMm);
    pointOf_ = std::move(alignment.pointOf);
  }

  void layBeads() {
    pieces_ = beadPieces(in_.program, path_, knowledge_);
    // The grid spans the part and what lies near it; a waypoint far astray must not blow it up.
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
    for (const BeadPiece& piece : pieces_)
      take(piece.to);
    low = (low - Vector3d::Constant(margin)).cwiseMax(mostLow);
    high = (high + Vector3d::Constant(margin)).cwiseMin(mostHigh);
    // What lies beneath a bead is looked for in a quarter of its height: cells of more than half a
    // height would hide it.
    const double ofWidth = 0.25 * in_.process.beadWidthMm;
    const double ofHeight = 0.5 * thinHeight();
    const voxel::VoxelGrid grid = gridOver(low, high, std::min(ofWidth, ofHeight), kMaxCells);
    out_.pitchMm = grid.pitch;
    DepositOptions depositOptions;
    depositOptions.widthMaxMm = 3.0 * in_.process.beadWidthMaxMm;
    // Sections of thin beads have more cells, and may have fewer samples in each.
    if (ofHeight < 0.99 * ofWidth)
      depositOptions.samplesPerCell = 3;
    beads_ = depositBeads(grid, pieces_, depositOptions, ctx_.sub(0.1, 0.68));
    for (const BeadPiece& piece : pieces_)
      (piece.ofPart ? out_.depositedMm3 : out_.supportMm3) += static_cast<double>(piece.volumeMm3);
  }

  // What nine tenths of the waypoints are as thick as, or the process's height where that is less.
  double thinHeight() const {
    std::vector<float> heights = in_.plan.heightMm;
    if (heights.empty())
      return in_.process.layerHeightMm;
    const auto tenth = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 10);
    std::nth_element(heights.begin(), tenth, heights.end());
    return std::clamp(static_cast<double>(*tenth), in_.process.layerHeightMinMm,
                      in_.process.layerHeightMm);
  }

  // Of the mesh where it is closed (its own volume is exact); else of the grid.
  double partVolume(double onGrid) const {
    double sum = 0.0;
    for (std::size_t t = 0; t < in_.part.triangles.size(); ++t)
      sum += in_.part.corner(t, 0).dot(in_.part.corner(t, 1).cross(in_.part.corner(t, 2))) / 6.0;
    return std::abs(sum - onGrid) < 0.02 * onGrid ? sum : onGrid;
  }

  void judgeBeads() {
    ctx_.report(0.68, "measuring the beads"_text);
    const geometry::MeshQuery query(in_.part);
    const PartCells cells = partCells(in_.part, query, beads_.grid, ctx_);
    const Coverage coverage =
        measureCoverage(beads_, cells, query, 0.25 * in_.process.beadWidthMm, ctx_);
    out_.partVolumeMm3 = partVolume(cells.volumeMm3);
    const double volume = std::max(out_.partVolumeMm3, 1e-9);
    out_.coveredFraction = coverage.coveredFraction;
    double excess = 0.0;
    std::size_t worstPiece = 0;
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      if (pieces_[p].ofPart) {
        excess += static_cast<double>(beads_.pieceExcessMm3[p]);
        if (beads_.pieceExcessMm3[p] > beads_.pieceExcessMm3[worstPiece])
          worstPiece = p;
      }
    out_.excessFraction = std::max(0.0, excess / volume);
    out_.overfillFraction = std::max(0.0, (coverage.outsideMm3 + excess) / volume);
    out_.massRatio = out_.depositedMm3 / volume;
    if (out_.coveredFraction < limits_.coveredMin)
      add(Uncovered, {{"share", base::percent(100.0 * (1.0 - out_.coveredFraction))}},
          coverage.worstGap);
    if (out_.overfillFraction > limits_.overfillMax)
      add(Overfill,
          {{"outside", base::percent(100.0 * coverage.outsideMm3 / volume)},
           {"noRoom", base::percent(100.0 * out_.excessFraction)}},
          pieces_.empty() ? std::nullopt : std::optional(pieces_[worstPiece].to),
          pieces_.empty() ? TextPlace{} : place(pieces_[worstPiece].motion));
    if (std::abs(out_.massRatio - 1.0) > limits_.massTolerance)
      add(Mass, {{"share", base::percent(100.0 * out_.massRatio)}});

    ctx_.report(0.73, "looking beneath the beads"_text);
    printed_.emplace(beads_, pieces_);
    const SupportedBeads support = findSupport(pieces_, *printed_, GroundProbe(in_.platform), ctx_);
    out_.beadLengthMm = support.lengthMm;
    out_.unsupportedFraction =
        support.lengthMm > 0.0 ? support.unsupportedMm / support.lengthMm : 0.0;
    if (out_.unsupportedFraction > limits_.unsupportedMax && !support.unsupported.empty()) {
      const BeadPiece& first = pieces_[support.unsupported.front()];
      atMotion(Unsupported, first.motion, {{"length", base::mm(support.unsupportedMm)}}, first.to,
               path_.startS[first.motion], support.unsupported.size());
    }
  }

  void findClashes() {
    ctx_.report(0.75, "looking for collisions"_text);
    const GroundSolids ground(in_.platform, in_.cell, 0.25 * in_.process.beadWidthMm, ctx_);
    std::vector<Clash> clashes = headClashes(path_, pieces_, *printed_, in_.process, ground, ctx_);
    ctx_.report(0.97, "looking for collisions"_text);
    for (Clash& c : armClashes(path_, pieces_, *printed_, ground, in_.cell, ctx_))
      clashes.push_back(std::move(c));
    std::stable_sort(clashes.begin(), clashes.end(),
                     [](const Clash& a, const Clash& b) { return a.motion < b.motion; });
    out_.collisions = clashes.size();
    std::set<std::size_t> waypoints;
    for (const Clash& c : clashes)
      for (std::size_t m = c.motion; m <= c.lastMotion; ++m)
        if (const std::size_t w = waypointAhead(m); w != plan::kNoWaypoint)
          waypoints.insert(w);
    out_.metAt.assign(waypoints.begin(), waypoints.end());
    for (std::size_t k = 0; k < clashes.size() && k < kMaxListed; ++k) {
      const Clash& c = clashes[k];
      atMotion(ReplayedCollision, c.motion, {{"first", c.first}, {"second", c.second}}, c.where,
               c.whenS, c.samples);
    }
    if (clashes.size() > kMaxListed)
      add(MoreReplayedCollisions, {{"collisions", clashes.size() - kMaxListed}}, std::nullopt, {},
          clashes.size() - kMaxListed);
  }

  // The waypoint that a motion leads to, by itself or by those that follow it.
  std::size_t waypointAhead(std::size_t motion) const {
    return motion < pointOf_.size() && pointOf_[motion] != kUnmatched
               ? plan::waypointAhead(in_.trajectory, pointOf_[motion])
               : plan::kNoWaypoint;
  }

  void tellLimits() {
    std::vector<LimitViolation> all = path_.violations;
    for (std::size_t m = 0; m < path_.motionCount(); ++m) {
      const plan::ProgramMotion& motion = in_.program.motions[m];
      const double volume = motionVolume(in_.program, path_, m);
      const double flow = motion.volumeMm3 >= 0.0 && path_.durationS[m] > 0.0
                              ? volume / path_.durationS[m]
                              : (motion.extruding ? motion.flowMm3PerS : 0.0);
      if (flow > 1.05 * in_.process.maxFlowMm3PerS)
        all.push_back({LimitKind::Flow, m, -1, flow, in_.process.maxFlowMm3PerS});
    }
    std::stable_sort(all.begin(), all.end(), [](const LimitViolation& a, const LimitViolation& b) {
      return a.motion < b.motion;
    });
    std::size_t listed = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const LimitViolation& v = all[k];
      // One that goes on over the motions that follow is one.
      const bool goesOn = k > 0 && all[k - 1].kind == v.kind && all[k - 1].joint == v.joint &&
                          all[k - 1].motion + 1 >= v.motion;
      if (goesOn)
        continue;
      ++out_.limitViolations;
      if (++listed > kMaxListed)
        continue;
      const plan::Finding f = findingOf(v);
      atMotion(f.kind, v.motion, f.values, path_.targetTip[v.motion], path_.startS[v.motion]);
    }
    if (listed > kMaxListed)
      add(MoreLimits, {{"violations", listed - kMaxListed}}, std::nullopt, {}, listed - kMaxListed);
  }

  plan::Finding findingOf(const LimitViolation& v) const {
    const auto degrees = [](double rad) { return base::degrees(base::radiansToDegrees(rad)); };
    const auto degreesPerS = [](double radPerS) {
      return base::Quantity{base::radiansToDegrees(radPerS), base::Unit::DegreePerS};
    };
    const int external = v.joint - in_.cell.armDof();
    const base::Value joint =
        external < 0
            ? base::Value(base::message("joint {number}"_text, v.joint + 1))
            : base::Value(in_.cell.externalAxes()[static_cast<std::size_t>(external)].name);
    switch (v.kind) {
    case LimitKind::OutOfReach:
      break;
    case LimitKind::JointRange:
      return plan::makeFinding(
          JointRange, {{"joint", joint}, {"angle", degrees(v.value)}, {"limit", degrees(v.limit)}});
    case LimitKind::JointSpeed:
      return plan::makeFinding(
          JointSpeed,
          {{"joint", joint}, {"speed", degreesPerS(v.value)}, {"limit", degreesPerS(v.limit)}});
    case LimitKind::BranchJump:
      return plan::makeFinding(BranchJump, {{"joint", joint}, {"angle", degrees(v.value)}});
    case LimitKind::BlendOverlap:
      return plan::makeFinding(BlendOverlap,
                               {{"blend", base::mm(v.value)}, {"way", base::mm(v.limit)}});
    case LimitKind::Flow:
      return plan::makeFinding(plan::FindingKind::Flow,
                               {{"flow", base::Quantity{v.value, base::Unit::Mm3PerS}},
                                {"limit", base::Quantity{v.limit, base::Unit::Mm3PerS}}});
    }
    return plan::makeFinding(OutOfReach);
  }

  void conclude() {
    if (out_.maxDeviationMm > limits_.deviationMaxMm && path_.motionCount() > 0)
      atMotion(plan::FindingKind::PathDeviation, deviationMotion_,
               {{"distance", base::mm(out_.maxDeviationMm)}}, path_.targetTip[deviationMotion_],
               path_.startS[deviationMotion_]);
    const auto atLeast = [&](const char* name, double value, double limit) {
      out_.results.push_back({name, value, limit, value >= limit});
    };
    const auto atMost = [&](const char* name, double value, double limit) {
      out_.results.push_back({name, value, limit, value <= limit});
    };
    atLeast("coveredFraction", out_.coveredFraction, limits_.coveredMin);
    atMost("unsupportedFraction", out_.unsupportedFraction, limits_.unsupportedMax);
    atMost("overfillFraction", out_.overfillFraction, limits_.overfillMax);
    atMost("massRatio", std::abs(out_.massRatio - 1.0), limits_.massTolerance);
    out_.results.back().value = out_.massRatio;
    atMost("collisions", static_cast<double>(out_.collisions),
           static_cast<double>(limits_.collisionsMax));
    atMost("limitViolations", static_cast<double>(out_.limitViolations),
           static_cast<double>(limits_.limitViolationsMax));
    atMost("maxDeviationMm", out_.maxDeviationMm, limits_.deviationMaxMm);
    out_.passed =
        out_.deviations == 0 && std::all_of(out_.results.begin(), out_.results.end(),
                                            [](const ThresholdResult& r) { return r.passed; });
  }

  const ReplayInput& in_;
  const ReplayThresholds& limits_;
  const base::RunContext& ctx_;
  Verification out_;
  ExecutedPath path_;
  std::vector<std::size_t> pointOf_; // the trajectory's point that a motion is, or kUnmatched
  std::vector<BeadKnowledge> knowledge_;
  std::vector<BeadPiece> pieces_;
  BeadGrid beads_;
  std::optional<PrintedPart> printed_;
  std::size_t deviationMotion_ = 0;
};

} // namespace

Verification replayProgram(const ReplayInput& input, const ReplayThresholds& thresholds,
                           const base::RunContext& ctx) {
  return Judge(input, thresholds, ctx).run();
}

} // namespace voluta::replay
