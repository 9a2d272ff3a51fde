#include "replay/alignment.h"

#include "base/error.h"
#include "base/run_context.h"
#include "geometry/directions.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

using geometry::angleBetween;

// Rounding error of a dialect's digits: a pair this close is accepted without comparing neighbours.
constexpr double kRoundingMm = 0.01;
constexpr std::size_t kRunOfAgreement = 3;

class Walk {
public:
  Walk(PoseSequence motions, PoseSequence points, const AlignmentOptions& options,
       const base::RunContext& ctx, const IsVia& isVia)
      : motions_(motions), points_(points), options_(options), ctx_(ctx), isVia_(isVia) {
    result_.pointOf.assign(motions.size(), kUnmatched);
    result_.leadsTo.assign(motions.size(), kUnmatched);
  }

  Alignment run() {
    std::size_t i = 0, j = 0;
    while (i < motions_.size() && j < points_.size()) {
      if (i % 4096 == 0)
        ctx_.checkpoint();
      if (agreesHere(i, j) && !isShortOf(i, j)) {
        result_.pointOf[i++] = j++;
        continue;
      }
      if (isVia_ && isVia_(i, j)) {
        result_.leadsTo[i++] = j;
        continue;
      }
      if (result_.deviations.size() >= options_.maxDeviations) {
        result_.gaveUp = true;
        return std::move(result_);
      }
      std::size_t skipMotions = 0, skipPoints = 0;
      if (!findResumption(i, j, skipMotions, skipPoints)) {
        result_.gaveUp = result_.gaveUp || motions_.size() - i > options_.window;
        skipMotions = motions_.size() - i;
        skipPoints = std::min(skipMotions, points_.size() - j);
      }
      explain(i, j, skipMotions, skipPoints);
      i += skipMotions;
      j += skipPoints;
    }
    if (i < motions_.size())
      add(DeviationKind::Extra, i, j, motions_.size() - i);
    if (j < points_.size()) {
      const std::size_t last = motions_.size() == 0 ? 0 : motions_.size() - 1;
      add(DeviationKind::CutShort, last, j, points_.size() - j);
    }
    return std::move(result_);
  }

private:
  double distance(std::size_t i, std::size_t j) const {
    return (motions_.tip[i] - points_.tip[j]).norm();
  }
  double angle(std::size_t i, std::size_t j) const {
    return angleBetween(motions_.direction[i], points_.direction[j]);
  }
  bool same(std::size_t i, std::size_t j) const {
    return distance(i, j) <= options_.sameMm && angle(i, j) <= options_.sameRad;
  }
  // Returns whether the pair agrees. Where points are closer together than `sameMm`, the next point
  // may fit better: this pair is then rejected, so that a gap is found at its true position.
  bool agreesHere(std::size_t i, std::size_t j) const {
    if (!same(i, j))
      return false;
    const double d = distance(i, j);
    return d <= kRoundingMm || j + 1 >= points_.size() || distance(i, j + 1) >= d;
  }
  // Returns whether motion i is an intermediate piece on the way to point j while motion i + 1 is
  // nearer to that point. Pieces may be closer together than `sameMm`.
  bool isShortOf(std::size_t i, std::size_t j) const {
    constexpr double kWrittenMm = 0.002; // a written target is closer to its point than this
    return isVia_ && distance(i, j) > kWrittenMm && i + 1 < motions_.size() &&
           distance(i + 1, j) < distance(i, j) && isVia_(i, j);
  }
  bool agreesOnwards(std::size_t i, std::size_t j) const {
    for (std::size_t k = 0; k < kRunOfAgreement; ++k) {
      const bool motionsEnd = i + k >= motions_.size(), pointsEnd = j + k >= points_.size();
      if (motionsEnd || pointsEnd)
        return k > 0 && motionsEnd && pointsEnd;
      if (!same(i + k, j + k))
        return false;
    }
    return true;
  }

  bool findResumption(std::size_t i, std::size_t j, std::size_t& skipMotions,
                      std::size_t& skipPoints) const {
    for (std::size_t total = 1; total <= 2 * options_.window; ++total) {
      // Equal skips first: a moved waypoint is likelier than a deleted one plus an inserted one.
      for (std::size_t off = total % 2; off <= total; off += 2)
        for (const bool pointsLonger : {true, false}) {
          const std::size_t less = (total - off) / 2, more = (total + off) / 2;
          const std::size_t a = pointsLonger ? less : more, b = pointsLonger ? more : less;
          if (i + a <= motions_.size() && j + b <= points_.size() && agreesOnwards(i + a, j + b)) {
            skipMotions = a;
            skipPoints = b;
            return true;
          }
        }
      if (total % 64 == 0)
        ctx_.checkpoint();
    }
    return false;
  }

  void explain(std::size_t i, std::size_t j, std::size_t motions, std::size_t points) {
    const std::size_t paired = std::min(motions, points);
    std::vector<bool> done(paired, false);
    for (std::size_t k = 0; k < paired; ++k) {
      if (done[k])
        continue;
      result_.pointOf[i + k] = j + k;
      if (same(i + k, j + k))
        continue;
      std::size_t other = paired;
      for (std::size_t l = k + 1; l < paired && other == paired; ++l)
        if (!done[l] && !same(i + l, j + l) && same(i + k, j + l) && same(i + l, j + k))
          other = l;
      Deviation d;
      d.motion = i + k;
      d.point = j + k;
      d.distanceMm = distance(i + k, j + k);
      d.angleRad = angle(i + k, j + k);
      if (other < paired) {
        done[other] = true;
        result_.pointOf[i + other] = j + other;
        d.kind = DeviationKind::Swapped;
        d.other = i + other;
        d.count = 2;
      } else {
        d.kind = DeviationKind::Moved;
      }
      result_.deviations.push_back(d);
    }
    if (motions > paired)
      add(DeviationKind::Extra, i + paired, j + paired, motions - paired);
    if (points > paired) {
      if (i + paired >= motions_.size())
        add(DeviationKind::CutShort, motions_.size() - 1, j + paired, points - paired);
      else
        add(DeviationKind::Missing, i + paired, j + paired, points - paired);
    }
  }

  void add(DeviationKind kind, std::size_t motion, std::size_t point, std::size_t count) {
    Deviation d;
    d.kind = kind;
    d.motion = d.other = motion;
    d.point = point;
    d.count = count;
    result_.deviations.push_back(d);
  }

  PoseSequence motions_, points_;
  const AlignmentOptions& options_;
  const base::RunContext& ctx_;
  const IsVia& isVia_;
  Alignment result_;
};

} // namespace

Alignment alignToPlan(PoseSequence motions, PoseSequence points, const AlignmentOptions& options,
                      const base::RunContext& ctx, const IsVia& isVia) {
  base::require(motions.tip.size() == motions.direction.size() &&
                    points.tip.size() == points.direction.size(),
                "alignToPlan: a direction per tip");
  return Walk(motions, points, options, ctx, isVia).run();
}

} // namespace voluta::replay
