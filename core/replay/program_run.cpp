#include "replay/program_run.h"

#include "base/memory.h"
#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "replay/alignment.h"
#include "replay/bead_coverage.h"
#include "replay/bridged_spans.h"
#include "replay/covered_beads.h"
#include "replay/item_finder.h"
#include "replay/replay_ground.h"
#include "replay/thin_cells.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace voluta::replay {

namespace {

using Eigen::Vector3d;
using enum plan::FindingKind;

constexpr std::size_t kMaxCells = 48'000'000;
// Material further than this from part and plan is not tracked; it counts as excess. For beads of
// up to 2 mm, and in maximum widths of larger ones.
constexpr double kStrayMm = 12.0, kStrayWidths = 6.0;

class RunJudge {
public:
  RunJudge(Run run, const ReplayInput& in, const ReplayThresholds& limits,
           const base::RunContext& ctx)
      : in_(in), limits_(limits), ctx_(ctx) {
    out_.run = std::move(run);
  }

  JudgedRun judge(KnownResults known) {
    if (known.deposited) {
      findInserted([&](std::size_t motion) { return known.firstPiece[motion]; });
      out_.deposited = std::move(known.deposited);
      out_.figures = std::move(known.figures);
      out_.beads = std::move(known.beads);
    } else {
      out_.deposited = layBeads();
      known.firstPiece = firstPieceOfMotions(out_.deposited->pieces, path().motionCount());
    }
    judgeLayerTimes(known.firstPiece);
    findClashes(known);
    gatherMet();
    base::freeStorage(out_.run.path.armJoints, out_.run.path.armMotion, out_.run.path.armFraction);
    return std::move(out_);
  }

private:
  const ExecutedPath& path() const { return out_.run.path; }

  // Finds what is put into the part: it is there when the first bead after it is approached.
  template <typename FirstPiece> void findInserted(const FirstPiece& firstPiece) {
    for (const plan::Insert& insert : in_.plan.inserts) {
      const std::size_t first = in_.plan.firstAfter(insert);
      const auto isAfter = [&](std::size_t point) {
        if (point == kUnmatched)
          return false;
        const std::size_t waypoint = plan::waypointAhead(in_.trajectory, point);
        return waypoint != plan::kNoWaypoint && waypoint >= first;
      };
      const auto motion = std::ranges::find_if(out_.run.pointOf, isAfter);
      if (motion != out_.run.pointOf.end())
        inserted_.push_back(
            {insert.body, firstPiece(static_cast<std::size_t>(motion - out_.run.pointOf.begin()))});
    }
  }

  std::shared_ptr<const DepositedBeads> layBeads() {
    std::vector<BeadPiece> pieces =
        beadPieces(out_.run.volumeMm3, path(), out_.run.knowledge, out_.run.shotMm3);
    dropFallen(pieces, GroundProbe(in_.platform));
    findInserted([&](std::size_t motion) {
      const auto first = std::ranges::lower_bound(pieces, motion, {}, &BeadPiece::motion);
      return static_cast<std::uint32_t>(first - pieces.begin());
    });
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
    const double margin = maxOf(&process::Process::beadWidthMaxMm);
    const double stray = std::max(kStrayMm, kStrayWidths * margin);
    const Vector3d minLow = low - Vector3d::Constant(stray);
    const Vector3d maxHigh = high + Vector3d::Constant(stray);
    for (const BeadPiece& piece : pieces)
      take(piece.to);
    low = (low - Vector3d::Constant(margin)).cwiseMax(minLow);
    high = (high + Vector3d::Constant(margin)).cwiseMin(maxHigh);
    // Support below a bead is searched for within a quarter of its height, which cells of more than
    // half a height would not resolve.
    const double ofWidth = 0.25 * minOf(&process::Process::beadWidthMm);
    const double ofHeight = 0.5 * thinHeight();
    const voxel::VoxelGrid grid = gridOver(low, high, std::min(ofWidth, ofHeight), kMaxCells);
    out_.figures.pitchMm = grid.pitch;
    DepositOptions options;
    options.widthMaxMm = 3.0 * maxOf(&process::Process::beadWidthMaxMm);
    const auto deposited = std::make_shared<DepositedBeads>();
    deposited->beads = depositBeads(grid, pieces, options, ctx_.sub(0.0, 0.64));
    deposited->printed.emplace(deposited->beads, pieces);
    deposited->underside.emplace(
        process::erodedHead(firstProcess().head, firstProcess().contactToleranceMm), pieces,
        options.widthMaxMm);
    judgeBeads(*deposited, pieces);
    deposited->below =
        piecesBelow(pieces, *deposited->printed, GroundProbe(in_.platform, inserted_), ctx_);
    deposited->pieces = depositedPieces(pieces, 2.0 * maxOf(&process::Process::beadWidthMaxMm));
    // Collision checks need only the filling pieces.
    deposited->beads.fill = {};
    deposited->beads.otherFill = {};
    deposited->beads.rectangle = {};
    base::freeStorage(deposited->beads.pieceExcessMm3);
    return deposited;
  }

  // The smallest and the largest value among the processes of the tools that print beads.
  double minOf(double process::Process::*value) const {
    double smallest = in_.tooling.first().process.*value;
    for (const process::Tool& tool : in_.tooling.tools())
      if (!tool.process.tape)
        smallest = std::min(smallest, tool.process.*value);
    return smallest;
  }
  double maxOf(double process::Process::*value) const {
    double largest = in_.tooling.first().process.*value;
    for (const process::Tool& tool : in_.tooling.tools())
      if (!tool.process.tape)
        largest = std::max(largest, tool.process.*value);
    return largest;
  }
  const process::Process& processOf(const BeadPiece& piece) const {
    return in_.tooling.at(out_.run.tool[piece.motion]).process;
  }
  // Returns the longest span that is held at its ends.
  double bridgedMm(const BeadPiece& piece) const {
    const process::Process& process = processOf(piece);
    return limits_.bridgesMaySag
               ? process::saggingBridgeMm(process, sectionOf(piece, widestOf(piece)).widthMm)
               : process.bridgeMm;
  }
  // Of the first tool. All heads have the shape of its head.
  const process::Process& firstProcess() const { return in_.tooling.first().process; }

  // Returns the thickness that nine tenths of the waypoints exceed, or the processes' layer height
  // if that is less.
  double thinHeight() const {
    const double usual = minOf(&process::Process::layerHeightMm);
    std::vector<float> heights = in_.plan.heightMm;
    if (heights.empty())
      return usual;
    const auto tenth = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 10);
    std::nth_element(heights.begin(), tenth, heights.end());
    return std::clamp(static_cast<double>(*tenth), minOf(&process::Process::layerHeightMinMm),
                      usual);
  }

  // Returns the exact volume of these triangles if they are closed, else the volume on the grid.
  double partVolume(std::size_t firstTriangle, std::size_t endTriangle, double onGrid) const {
    double sum = 0.0;
    for (std::size_t t = firstTriangle; t < endTriangle; ++t)
      sum += in_.part.corner(t, 0).dot(in_.part.corner(t, 1).cross(in_.part.corner(t, 2))) / 6.0;
    return std::abs(sum - onGrid) < 0.02 * onGrid ? sum : onGrid;
  }

  void add(plan::FindingKind kind, std::vector<plan::NamedValue> values,
           std::optional<Vector3d> where = std::nullopt,
           std::optional<std::size_t> motion = std::nullopt, std::size_t count = 1, int item = -1) {
    out_.beads.push_back({kind, std::move(values), where, motion, count, item});
  }

  void judgeBeads(const DepositedBeads& deposited, const std::vector<BeadPiece>& pieces) {
    judgeVolume(deposited.beads, pieces);
    judgeSupport(*deposited.printed, pieces);
  }

  void judgeVolume(const BeadGrid& beads, const std::vector<BeadPiece>& pieces) {
    ctx_.report(0.65, "measuring the beads"_text);
    RunFigures& figures = out_.figures;
    const geometry::MeshQuery query(in_.part);
    const PartCells cells = partCells(in_.part, query, beads.grid, ctx_);
    const double outsideMm = 0.25 * minOf(&process::Process::beadWidthMm);
    const ItemFinder items(in_.part, query, in_.firstTriangle, 4.0 * outsideMm);
    SurfaceBands bands{.outsideMm = outsideMm,
                       .notchMm = 0.5 * minOf(&process::Process::layerHeightMm)};
    for (const plan::FillIntent& fill : in_.plan.fill)
      bands.shellMm.push_back(fill.shellMm);
    const double narrowest = minOf(&process::Process::beadWidthMinMm);
    const ThinCells thin = hasLevelLayers(in_.plan)
                               ? thinCells(in_.part, cells, beads.grid, narrowest, ctx_)
                               : ThinCells{};
    const Coverage coverage = measureCoverage(beads, cells, query, bands, ctx_, items, thin);
    figures.partVolumeMm3 = partVolume(0, in_.part.triangles.size(), cells.volumeMm3);
    judgeCoverage(coverage);
    judgeExcess(coverage.outsideMm3, beads.pieceExcessMm3, pieces);
  }

  // Returns the intended volume of an item, or of a job of one item. The plan can leave open no
  // more than there is inside the shell.
  double intendedMm3(std::size_t item, const ItemCoverage& coverage, double volumeMm3) const {
    return volumeMm3 - std::min(in_.plan.fillOf(item).openMm3, coverage.interiorMm3);
  }
  // Returns the covered share of the intended volume that is not both thin and open.
  double coveredFraction(std::size_t item, const ItemCoverage& coverage, double intended) const {
    if (in_.plan.fillOf(item).isSolid())
      return coverage.coveredFraction;
    const double thin = coverage.thinMm3;
    return 1.0 - (1.0 - coverage.coveredFraction) * (coverage.shellMm3 - thin) /
                     std::max(intended - thin, 1e-9);
  }

  void judgeCoverage(const Coverage& coverage) {
    RunFigures& figures = out_.figures;
    if (coverage.worstGapMm3 > 0.0)
      figures.worst.gap = coverage.worstGap;
    figures.thinMm3 = coverage.thinMm3;
    if (coverage.thinMm3 > 0.0)
      figures.worst.thin = coverage.worstThin;
    if (coverage.items.size() == 1) {
      figures.intendedMm3 = intendedMm3(0, coverage, figures.partVolumeMm3);
      figures.coveredFraction = coveredFraction(0, coverage, figures.intendedMm3);
      figures.thinFraction = coverage.thinMm3 / std::max(figures.intendedMm3, 1e-9);
      addUncovered(figures.coveredFraction, coverage, -1);
      addThin(figures.thinFraction, coverage.items.front(), -1);
      return;
    }
    double covered = 0.0;
    for (std::size_t i = 0; i < coverage.items.size(); ++i) {
      const ItemCoverage& own = coverage.items[i];
      const std::size_t end =
          i + 1 < in_.firstTriangle.size() ? in_.firstTriangle[i + 1] : in_.part.triangles.size();
      ItemFigures item;
      item.intendedMm3 = intendedMm3(
          i, own, partVolume(in_.firstTriangle[i], end, own.shellMm3 + own.interiorMm3));
      item.coveredFraction = coveredFraction(i, own, item.intendedMm3);
      item.thinMm3 = own.thinMm3;
      item.thinFraction = own.thinMm3 / std::max(item.intendedMm3, 1e-9);
      figures.intendedMm3 += item.intendedMm3;
      covered += item.coveredFraction * (item.intendedMm3 - own.thinMm3);
      addUncovered(item.coveredFraction, own, static_cast<int>(i));
      addThin(item.thinFraction, own, static_cast<int>(i));
      figures.items.push_back(item);
    }
    figures.coveredFraction = covered / std::max(figures.intendedMm3 - figures.thinMm3, 1e-9);
    figures.thinFraction = figures.thinMm3 / std::max(figures.intendedMm3, 1e-9);
  }

  void addUncovered(double coveredFraction, const ItemCoverage& coverage, int item) {
    if (coveredFraction < limits_.coveredMin)
      add(Uncovered, {{"share", base::percent(100.0 * (1.0 - coveredFraction))}}, coverage.worstGap,
          std::nullopt, 1, item);
  }

  void addThin(double share, const ItemCoverage& coverage, int item) {
    if (share > limits_.thinMax)
      add(Thin,
          {{"share", base::percent(100.0 * share)},
           {"volume", base::mm3(coverage.thinMm3)},
           {"bead", base::mm(minOf(&process::Process::beadWidthMinMm))},
           {"places", coverage.thinPlaces}},
          coverage.worstThin, std::nullopt, 1, item);
  }

  void judgeExcess(double outsideMm3, const std::vector<float>& excessMm3,
                   const std::vector<BeadPiece>& pieces) {
    RunFigures& figures = out_.figures;
    const double volume = std::max(figures.partVolumeMm3, 1e-9);
    double excess = 0.0;
    std::size_t worst = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p)
      if (pieces[p].ofPart) {
        excess += static_cast<double>(excessMm3[p]);
        if (excessMm3[p] > excessMm3[worst])
          worst = p;
      }
    figures.excessFraction = std::max(0.0, excess / volume);
    if (excess > 0.0)
      figures.worst.overfill = pieces[worst].to;
    figures.overfillFraction = std::max(0.0, (outsideMm3 + excess) / volume);
    if (figures.overfillFraction > limits_.overfillMax) {
      std::optional<Vector3d> where;
      std::optional<std::size_t> motion;
      if (!pieces.empty())
        where = pieces[worst].to, motion = pieces[worst].motion;
      add(Overfill,
          {{"outside", base::percent(100.0 * outsideMm3 / volume)},
           {"noRoom", base::percent(100.0 * figures.excessFraction)}},
          where, motion);
    }
  }

  void judgeSupport(const PrintedPart& printed, const std::vector<BeadPiece>& pieces) {
    RunFigures& figures = out_.figures;
    ctx_.report(0.7, "checking support below the beads"_text);
    Bridging bridging{[this](const BeadPiece& piece) { return bridgedMm(piece); }};
    if (!in_.plan.isSolid())
      bridging.sparsePart.emplace(in_.part);
    const SupportedBeads support =
        findSupport(pieces, printed, GroundProbe(in_.platform, inserted_), ctx_, &bridging);
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
    const double bridged = pieces.empty() ? 0.0 : bridgedMm(pieces[support.longestFrom]);
    const bool isTooMuch =
        figures.items.empty() && figures.unsupportedFraction > limits_.unsupportedMax;
    if (!support.unsupported.empty() && (isTooMuch || hangs(support.longestUnsupportedMm, bridged)))
      addUnsupported(support.unsupportedMm, figures.unsupportedFraction, support.unsupported,
                     pieces, -1);
    judgeSupportOfItems(support, pieces);
    if (pieces.empty())
      return;
    const BeadPiece& first = pieces[support.longestFrom];
    if (support.longestUnsupportedMm > bridged)
      add(LongBridge,
          {{"length", base::mm(support.longestUnsupportedMm)}, {"bridge", base::mm(bridged)}},
          first.to, first.motion);
  }

  // Returns whether a bead hangs free so far that its share of a large part says nothing.
  bool hangs(double longestMm, double bridged) const {
    constexpr double kFarthest = 5.0;    // of what the material bridges
    constexpr double kUsualShare = 0.02; // a larger share was allowed on purpose
    return limits_.unsupportedMax <= kUsualShare && longestMm > kFarthest * bridged;
  }

  void judgeSupportOfItems(const SupportedBeads& support, const std::vector<BeadPiece>& pieces) {
    const std::size_t count = std::min(out_.figures.items.size(), support.lengthOfItemMm.size());
    for (std::size_t i = 0; i < count; ++i) {
      ItemFigures& item = out_.figures.items[i];
      item.unsupportedFraction =
          support.unsupportedOfItemMm[i] / std::max(support.lengthOfItemMm[i], 1e-9);
      if (item.unsupportedFraction <= limits_.unsupportedMax)
        continue;
      std::vector<std::uint32_t> own;
      for (const std::uint32_t p : support.unsupported)
        if (pieces[p].item == i)
          own.push_back(p);
      addUnsupported(support.unsupportedOfItemMm[i], item.unsupportedFraction, own, pieces,
                     static_cast<int>(i));
    }
  }

  // Precondition: there are unsupported pieces.
  void addUnsupported(double lengthMm, double share, const std::vector<std::uint32_t>& unsupported,
                      const std::vector<BeadPiece>& pieces, int item) {
    const BeadPiece& first = pieces[unsupported.front()];
    add(Unsupported, {{"length", base::mm(lengthMm)}, {"share", base::percent(100.0 * share)}},
        first.to, first.motion, unsupported.size(), item);
  }

  void judgeLayerTimes(const std::vector<std::uint32_t>& firstPiece) {
    const CoveredBeads covered = coveredBeads(out_.deposited->pieces, out_.deposited->below,
                                              firstPiece, out_.run, in_.layerTimes);
    out_.figures.layerTimes = covered.figures;
    if (covered.shortest)
      out_.figures.worst.layerTime = covered.shortest->where;
    const auto report = [&](plan::FindingKind kind, const std::optional<CoveredPlace>& place,
                            double lengthMm, double limitS) {
      if (lengthMm > 0.0)
        out_.layerTimes.push_back({kind,
                                   {{"time", base::seconds(place->timeS)},
                                    {"limit", base::seconds(limitS)},
                                    {"length", base::mm(lengthMm)}},
                                   place->where,
                                   place->motion});
    };
    report(CoolingTime, covered.shortest, covered.youngMm, in_.layerTimes.minS);
    report(BondTime, covered.longest, covered.oldMm, in_.layerTimes.maxS);
  }

  void findClashes(const KnownResults& known) {
    ctx_.report(0.72, "checking for collisions"_text);
    const GroundSolids ground(in_.platform, in_.cell, 0.25 * minOf(&process::Process::beadWidthMm),
                              ctx_, inserted_);
    out_.head =
        headClashes(path(), out_.deposited->pieces, known.firstPiece, *out_.deposited->printed,
                    *out_.deposited->underside, firstProcess(), ground, known.headKnown, ctx_);
    ctx_.report(0.97, "checking for collisions"_text);
    out_.arm = armClashes(path(), known.firstPiece, *out_.deposited->printed, ground, in_.cell,
                          known.armKnown, ctx_);
    out_.head.insert(out_.head.end(), known.head.begin(), known.head.end());
    out_.arm.insert(out_.arm.end(), known.arm.begin(), known.arm.end());
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
  std::vector<InsertedBody> inserted_; // with the pieces of out_.deposited
  JudgedRun out_;
};

} // namespace

JudgedRun judgeRun(Run run, const ReplayInput& input, const ReplayThresholds& thresholds,
                   KnownResults known, const base::RunContext& ctx) {
  return RunJudge(std::move(run), input, thresholds, ctx).judge(std::move(known));
}

} // namespace voluta::replay
