#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "geometry/mesh_query.h"
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
#include <cstdio>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kMaxCells = 48'000'000;
constexpr std::size_t kMaxListed = 100; // of one kind; the rest is counted
// Material further than this from part and plan is not followed: it counts as excess.
constexpr double kStrayMm = 12.0;

std::string text(double value, int decimals) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
  return buffer;
}

class Judge {
public:
  Judge(const ReplayInput& in, const ReplayThresholds& limits, const base::RunContext& ctx)
      : in_(in), limits_(limits), ctx_(ctx) {}

  Verification run() {
    check();
    ctx_.report(0.0, "running the program");
    path_ = executeProgram(in_.program, in_.cell, ctx_);
    out_.armChecked = path_.arm;
    out_.durationS = path_.totalS();
    compare();
    layBeads();
    judgeBeads();
    findClashes();
    tellLimits();
    conclude();
    ctx_.report(1.0, "replayed");
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

  void add(const char* kind, TextPlace place, std::string reason, std::string remedy,
           std::optional<Vector3d> where = std::nullopt, std::optional<double> when = std::nullopt,
           std::size_t count = 1) {
    plan::Finding f;
    f.stage = "replay";
    f.kind = kind;
    f.where = where;
    f.whenS = when;
    f.count = count;
    f.reason = std::move(reason);
    f.remedy = std::move(remedy);
    out_.findings.push_back(std::move(f));
    out_.places.push_back(place);
  }
  TextPlace place(std::size_t motion) const { return placeOf(in_.program, motion); }
  std::string line(std::size_t motion) const { return placeName(in_.program, place(motion)); }

  void compare() {
    ctx_.report(0.1, "comparing with the plan");
    const PlannedNozzle planned = plannedNozzle(in_.trajectory, in_.cell, ctx_);
    const Alignment alignment =
        alignToPlan({path_.targetTip, path_.targetDirection}, {planned.tip, planned.direction},
                    AlignmentOptions{}, ctx_);
    for (TextFinding& f : compareWithPlan(in_.program, path_, planned, in_.trajectory, alignment,
                                          ComparisonOptions{})) {
      ++out_.deviations;
      out_.findings.push_back(std::move(f.finding));
      out_.places.push_back(f.place);
    }
    const PathDeviation deviation =
        pathDeviation(path_, planned, in_.trajectory, in_.program, alignment, ctx_);
    out_.maxDeviationMm = deviation.mm;
    out_.maxDeviationRad = deviation.rad;
    deviationMotion_ = deviation.motion;
    knowledge_ =
        beadKnowledge(alignment.pointOf, in_.trajectory, in_.plan, in_.process.layerHeightMm);
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
    beads_ = depositBeads(grid, pieces_, depositOptions, ctx_.sub(0.2, 0.5));
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
    ctx_.report(0.5, "measuring the beads");
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
      add("uncovered", {},
          text(100.0 * (1.0 - out_.coveredFraction), 2) +
              " % of the part is in no bead; most of it round the place given",
          "use lower layers or a finer nozzle, or print the part larger", coverage.worstGap);
    if (out_.overfillFraction > limits_.overfillMax)
      add("overfill", pieces_.empty() ? TextPlace{} : place(pieces_[worstPiece].motion),
          text(100.0 * coverage.outsideMm3 / volume, 2) +
              " % of the part's volume is laid outside it, " +
              text(100.0 * out_.excessFraction, 2) + " % finds no room",
          "less flow, or beads further apart",
          pieces_.empty() ? std::nullopt : std::optional(pieces_[worstPiece].to));
    if (std::abs(out_.massRatio - 1.0) > limits_.massTolerance)
      add("mass", {}, "the material laid is " + text(100.0 * out_.massRatio, 2) + " % of the part",
          "check the flow and the infill's density");

    ctx_.report(0.65, "looking beneath the beads");
    printed_.emplace(beads_, pieces_);
    const SupportedBeads support = findSupport(pieces_, *printed_, GroundProbe(in_.platform), ctx_);
    out_.beadLengthMm = support.lengthMm;
    out_.unsupportedFraction =
        support.lengthMm > 0.0 ? support.unsupportedMm / support.lengthMm : 0.0;
    if (out_.unsupportedFraction > limits_.unsupportedMax && !support.unsupported.empty()) {
      const BeadPiece& first = pieces_[support.unsupported.front()];
      add("unsupported", place(first.motion),
          line(first.motion) + ": " + text(support.unsupportedMm, 1) +
              " mm of bead have nothing beneath them, the first of them here",
          "turn the part, or allow supports", first.to, path_.startS[first.motion],
          support.unsupported.size());
    }
  }

  void findClashes() {
    ctx_.report(0.75, "looking for collisions");
    const GroundSolids ground(in_.platform, in_.cell, 0.25 * in_.process.beadWidthMm, ctx_);
    std::vector<Clash> clashes = headClashes(path_, pieces_, *printed_, in_.process, ground, ctx_);
    ctx_.report(0.85, "looking for collisions");
    for (Clash& c : armClashes(path_, pieces_, *printed_, ground, in_.cell, ctx_))
      clashes.push_back(std::move(c));
    std::stable_sort(clashes.begin(), clashes.end(),
                     [](const Clash& a, const Clash& b) { return a.motion < b.motion; });
    out_.collisions = clashes.size();
    for (std::size_t k = 0; k < clashes.size() && k < kMaxListed; ++k) {
      const Clash& c = clashes[k];
      add("collision", place(c.motion),
          line(c.motion) + ": " + c.first + " and " + c.second + " collide",
          "plan anew with more clearance, or another place for the part", c.where, c.whenS,
          c.samples);
    }
    if (clashes.size() > kMaxListed)
      add("collision", {},
          "and " + std::to_string(clashes.size() - kMaxListed) + " collisions more",
          "plan anew with more clearance", std::nullopt, std::nullopt, clashes.size() - kMaxListed);
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
      add("limit", place(v.motion), line(v.motion) + ": " + reasonOf(v),
          "slower there, or another place in the cell", path_.targetTip[v.motion],
          path_.startS[v.motion]);
    }
    if (listed > kMaxListed)
      add("limit", {}, "and " + std::to_string(listed - kMaxListed) + " violations more",
          "slower there, or another place in the cell", std::nullopt, std::nullopt,
          listed - kMaxListed);
  }

  std::string reasonOf(const LimitViolation& v) const {
    const auto degrees = [](double rad) { return text(rad * 180.0 / M_PI, 1); };
    const int external = v.joint - in_.cell.armDof();
    const std::string joint =
        external < 0 ? "joint " + std::to_string(v.joint + 1)
                     : in_.cell.externalAxes()[static_cast<std::size_t>(external)].name;
    switch (v.kind) {
    case LimitKind::OutOfReach:
      return "the arm cannot reach this target";
    case LimitKind::JointRange:
      return joint + " at " + degrees(v.value) + " degrees, its limit is " + degrees(v.limit);
    case LimitKind::JointSpeed:
      return joint + " at " + degrees(v.value) + " degrees/s, its limit is " + degrees(v.limit);
    case LimitKind::BranchJump:
      return "the arm would have to change its configuration, " + joint + " by " +
             degrees(v.value) + " degrees at once";
    case LimitKind::BlendOverlap:
      return "its blend overlaps the one before (" + text(v.value, 3) + " mm on " +
             text(v.limit, 3) + " mm): the controller skips the waypoint";
    case LimitKind::Flow:
      return "a flow of " + text(v.value, 1) + " mm3/s, the extruder gives " + text(v.limit, 1);
    }
    return {};
  }

  void conclude() {
    if (out_.maxDeviationMm > limits_.deviationMaxMm && path_.motionCount() > 0)
      add("deviation", place(deviationMotion_),
          line(deviationMotion_) + ": the nozzle's path is " + text(out_.maxDeviationMm, 3) +
              " mm off the planned one",
          "shorter motions or smaller blends", path_.targetTip[deviationMotion_],
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
