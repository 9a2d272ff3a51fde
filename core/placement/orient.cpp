#include "placement/orient.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/units.h"
#include "geometry/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>

namespace voluta::placement {

namespace {

constexpr std::size_t kFlatPlaces = 8, kRefined = 3, kChecked = 4;
constexpr double kSmallRotation = 12.0; // degrees
constexpr double kStays = 1.25;         // of the best's risky area
constexpr double kPieceCost = 0.002;    // of the present risky area
constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

struct Candidate {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  OrientationScore score;
  std::size_t missed = kUnknown; // at the coarse width

  auto keyWith(std::size_t misses) const {
    return std::tuple(!score.stands, misses, score.riskyMm2, score.heightMm);
  }
  auto key() const { return keyWith(missed); }
};

Orientation minResidualArea(const geometry::TriangleMesh& mesh, const OrientOptions& options) {
  const OrientationMeasure measure(mesh, options.voxelMm, options.overhangRad);
  const ResidualRotation found =
      minResidualRotation(mesh, options.quarterTurns, [&](const Eigen::Matrix3d& rotation) {
        return measure.of(rotation).stands;
      });
  Orientation out;
  out.rotation = found.rotation;
  out.score = measure.of(found.rotation.toRotationMatrix());
  out.before = measure.of(Eigen::Matrix3d::Identity());
  out.tried = found.tried;
  out.residual = found.after;
  out.residualBefore = found.before;
  return out;
}

class OrientSearch {
public:
  OrientSearch(const geometry::TriangleMesh& mesh, const OrientOptions& options,
               const base::RunContext& ctx)
      : mesh_(mesh), options_(options), ctx_(ctx),
        measure_(mesh, options.voxelMm, options.overhangRad) {
    add(Eigen::Quaterniond::Identity());
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3d down(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      if (!down.isZero() && (!options.quarterTurns || down.cwiseAbs().sum() == 1.0))
        add(geometry::rotationLayingFlat(down));
    }
    if (!options.quarterTurns)
      for (const Eigen::Vector3d& down : measure_.flatPlaces(kFlatPlaces))
        add(geometry::rotationLayingFlat(down));
  }

  Orientation minRiskyArea() {
    for (Candidate& c : found_)
      c.missed = 0;
    for (double step = 0.5 * kSmallRotation; step > 1.0 && !options_.quarterTurns; step *= 0.5)
      for (const Eigen::Quaterniond& rotation : nearTheBest(step))
        if (add(rotation))
          found_.back().missed = 0;
    return chosen(best());
  }

  Orientation fewestMissed() {
    coarseMm_ =
        coarseWidth(mesh_, found_[0].rotation, options_.voxelMm, options_.searchVoxels, ctx_);
    growCoarse(0, 0.0, 0.6);
    if (!options_.quarterTurns) {
      const std::size_t first = found_.size();
      const Candidate winner = found_[best()];
      for (const Eigen::Quaterniond& rotation : nearTheBest(kSmallRotation))
        // Skip candidates that could not win even without a missed voxel.
        if (add(rotation) && found_.back().keyWith(0) >= winner.key())
          found_.pop_back();
      growCoarse(first, 0.6, 0.8);
    }
    std::vector<std::size_t> order = sorted();
    order.resize(std::min(order.size(), kChecked));
    std::size_t winner = order[0], fewest = kUnknown;
    for (std::size_t n = 0; n < order.size() && fewest > 0; ++n) {
      const double at = 0.8 + 0.2 * static_cast<double>(n) / kChecked;
      const std::size_t missed = coarseGrowths(mesh_, {found_[order[n]].rotation},
                                               grid(options_.voxelMm), ctx_.sub(at, at))
                                     .front()
                                     .missed;
      if (missed < fewest) {
        fewest = missed;
        winner = order[n];
      }
    }
    Orientation out = chosen(winner);
    out.searchMm = coarseMm_;
    out.missed = found_[winner].missed;
    out.missedBefore = found_[0].missed;
    out.missedAtVoxelMm = fewest;
    return out;
  }

  Orientation minAfterCuts() {
    CutsOfTurns cuts{cutAll(), std::vector<char>(found_.size())};
    const std::size_t winner = options_.checkedCuts ? bestChecked(cuts) : bestByCuts(cuts);
    Orientation out = chosen(winner);
    out.cuts = cuts.outcomes[winner];
    out.cutsBefore = cuts.outcomes[0];
    out.areCutsChecked = cuts.isChecked[winner] != 0;
    return out;
  }

  Orientation leastTension() {
    constexpr double kSame = 1.05;
    std::vector<double> tension;
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate& c : found_) {
      tension.push_back(options_.tension(c.rotation.toRotationMatrix().row(2).transpose()));
      if (c.score.stands)
        least = std::min(least, tension.back());
    }
    const auto isAmong = [&](std::size_t n) {
      return found_[n].score.stands && tension[n] <= kSame * least;
    };
    std::optional<std::size_t> winner;
    for (std::size_t n = 0; n < found_.size(); ++n)
      if (isAmong(n) && (!winner || found_[n].key() < found_[*winner].key()))
        winner = n;
    if (!winner ||
        (isAmong(0) && found_[0].score.riskyMm2 <= kStays * found_[*winner].score.riskyMm2))
      winner = 0;
    Orientation out = chosen(*winner);
    out.tensionMPa = tension[*winner];
    out.tensionBeforeMPa = tension[0];
    return out;
  }

private:
  // Returns false if the part would not stand or has that orientation already.
  bool add(const Eigen::Quaterniond& rotation) {
    constexpr double kSame = 0.02;
    Candidate c;
    c.rotation = rotation;
    const Eigen::Vector3d up = rotation.toRotationMatrix().row(2).transpose();
    for (const Candidate& other : found_)
      if ((other.rotation.toRotationMatrix().row(2).transpose() - up).norm() < kSame)
        return false;
    c.score = measure_.of(rotation.toRotationMatrix());
    if (!found_.empty() && !c.score.stands)
      return false;
    found_.push_back(c);
    return true;
  }

  std::vector<std::size_t> sorted() const {
    std::vector<std::size_t> order(found_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return found_[a].key() < found_[b].key();
    });
    // Prefer the present orientation if it is hardly worse.
    const Candidate &first = found_[order[0]], &asLoaded = found_[0];
    if (asLoaded.score.stands && asLoaded.missed == first.missed &&
        asLoaded.score.riskyMm2 <= kStays * first.score.riskyMm2) {
      order.erase(std::find(order.begin(), order.end(), 0));
      order.insert(order.begin(), 0);
    }
    return order;
  }
  std::size_t best() const { return sorted()[0]; }

  // Returns the best few, tilted slightly.
  std::vector<Eigen::Quaterniond> nearTheBest(double degrees) const {
    std::vector<Eigen::Quaterniond> near;
    std::vector<std::size_t> order = sorted();
    order.resize(std::min(order.size(), kRefined));
    for (const std::size_t n : order)
      for (const double sign : {-1.0, 1.0})
        for (const int axis : {0, 1})
          near.push_back(Eigen::AngleAxisd(sign * base::degreesToRadians(degrees),
                                           Eigen::Vector3d::Unit(axis)) *
                         found_[n].rotation);
    return near;
  }

  Orientation chosen(std::size_t n) const {
    Orientation out;
    out.rotation = found_[n].rotation;
    out.score = found_[n].score;
    out.before = found_[0].score;
    out.tried = found_.size();
    return out;
  }

  CoarseGrid grid(double pitchMm) const { return {pitchMm, options_.centreMm, options_.platform}; }

  struct CutsOfTurns { // by candidate
    std::vector<CutOutcome> outcomes;
    std::vector<char> isChecked;
  };
  double costOf(const CutsOfTurns& cuts, std::size_t n) const {
    return cuts.outcomes[n].riskyMm2 +
           kPieceCost * found_[0].score.riskyMm2 * static_cast<double>(cuts.outcomes[n].pieces);
  }
  auto keyOf(const CutsOfTurns& cuts, std::size_t n) const {
    return std::tuple(!found_[n].score.stands, costOf(cuts, n), found_[n].score.heightMm);
  }
  bool presentIsAsGood(const CutsOfTurns& cuts, std::size_t winner) const {
    return found_[0].score.stands && costOf(cuts, 0) <= kStays * costOf(cuts, winner);
  }

  std::size_t bestByCuts(const CutsOfTurns& cuts) const {
    std::size_t winner = 0;
    for (std::size_t n = 1; n < found_.size(); ++n)
      if (keyOf(cuts, n) < keyOf(cuts, winner))
        winner = n;
    return presentIsAsGood(cuts, winner) ? 0 : winner;
  }

  // Replaces the outcomes of the best by what the cuts really leave.
  std::size_t bestChecked(CutsOfTurns& cuts) const {
    std::vector<std::size_t> order(found_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return keyOf(cuts, a) < keyOf(cuts, b); });
    const std::size_t byEstimate = bestByCuts(cuts);
    std::optional<std::size_t> winner;
    const auto check = [&](std::size_t n) {
      const std::optional<CutOutcome> left = options_.checkedCuts(found_[n].rotation);
      if (!left)
        return;
      cuts.outcomes[n] = *left;
      cuts.isChecked[n] = 1;
      if (!winner || keyOf(cuts, n) < keyOf(cuts, *winner))
        winner = n;
    };
    std::size_t checked = 0;
    for (const std::size_t n : order) {
      if (checked == kChecked || (winner && keyOf(cuts, *winner) <= keyOf(cuts, n)))
        break;
      check(n);
      ctx_.report(0.5 + 0.5 * static_cast<double>(++checked) / (kChecked + 1), "orientation"_text);
    }
    if (!winner)
      return byEstimate;
    if (!cuts.isChecked[0] && presentIsAsGood(cuts, *winner))
      check(0);
    return cuts.isChecked[0] && presentIsAsGood(cuts, *winner) ? 0 : *winner;
  }

  // Cuts the part in each orientation.
  std::vector<CutOutcome> cutAll() const {
    std::vector<CutOutcome> out(found_.size());
    base::parallelWithProgress(
        ctx_, out.size(), options_.checkedCuts ? 0.5 : 1.0, "orientation"_text,
        [&](std::size_t n) { out[n] = options_.cutOutcome(found_[n].rotation); });
    return out;
  }

  // Computes the missed voxels of the candidates from `first` on.
  void growCoarse(std::size_t first, double from, double to) {
    std::vector<Eigen::Quaterniond> turns;
    for (std::size_t n = first; n < found_.size(); ++n)
      turns.push_back(found_[n].rotation);
    const std::vector<CoarseGrowth> growths =
        coarseGrowths(mesh_, turns, grid(coarseMm_), ctx_.sub(from, to));
    for (std::size_t n = 0; n < growths.size(); ++n)
      found_[first + n].missed = growths[n].missed;
  }

  const geometry::TriangleMesh& mesh_;
  const OrientOptions& options_;
  const base::RunContext& ctx_;
  OrientationMeasure measure_;
  std::vector<Candidate> found_; // the first is the present orientation
  double coarseMm_ = 0.0;
};

} // namespace

base::ParameterTable orientParameters() {
  return base::ParameterTable({
      base::choiceParameter("orient", "none",
                            {{"none", "none"_text},
                             {"leastRisky", "minimum overhang"_text},
                             {"fewestMissed", "fewest missed voxels"_text},
                             {"leastResidual", "least residual area"_text},
                             {"leastAfterCuts", "least overhang of pieces"_text},
                             {"leastTension", "least tension across layers"_text}},
                            "Placement"_text, "Turn the part"_text,
                            "Searches for a better orientation of the part: with the smallest "
                            "overhanging area, with the fewest voxels missed by growth, along "
                            "the axes, so that the projections on XY and XZ leave the least area "
                            "of their bounding rectangles empty (blanks for milling), with the "
                            "smallest overhanging area after the part is cut into pieces (mode "
                            "planar), or with the least tension across the layers under the load "
                            "of its regions."_text,
                            true),
  });
}

Orientation bestOrientation(const geometry::TriangleMesh& mesh, Objective objective,
                            const OrientOptions& options, const base::RunContext& ctx) {
  base::require(!mesh.empty() && options.voxelMm > 0.0, "bestOrientation: facets, voxelMm > 0");
  base::require(objective != Objective::MinAfterCuts || options.cutOutcome,
                "bestOrientation: cutOutcome");
  base::require(objective != Objective::LeastTension || options.tension,
                "bestOrientation: tension");
  const auto found = [&] {
    if (objective == Objective::MinResidualArea)
      return minResidualArea(mesh, options);
    OrientSearch search(mesh, options, ctx);
    return objective == Objective::MinRiskyArea   ? search.minRiskyArea()
           : objective == Objective::FewestMissed ? search.fewestMissed()
           : objective == Objective::MinAfterCuts ? search.minAfterCuts()
                                                  : search.leastTension();
  };
  Orientation out = found();
  ctx.report(1.0, "orientation"_text);
  return out;
}

} // namespace voluta::placement
