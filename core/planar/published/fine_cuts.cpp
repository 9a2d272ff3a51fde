#include "planar/published/fine_cuts.h"

#include "base/parallel.h"
#include "geometry/measures.h"
#include "planar/face_table.h"
#include "planar/published/piece_ways.h"
#include "planar/published/section_cut.h"
#include "planar/search/cut_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kTried = 60; // planes tried per piece and level
// Similar planes: cosine of normals, distance at the piece's middle
constexpr double kAlike = 0.95, kAlikeMm = 5.0;

// Planes for pieces for which the levels before found none.
struct Level {
  double stepShare; // of FineCutOptions::stepMm
  bool lessContact; // see withLessContact
};
constexpr std::array<Level, 4> kLevels{{{1.0, false}, {0.5, false}, {0.25, false}, {0.25, true}}};

struct Candidate {
  Plane plane;
  double gainMm2 = 0.0;
};

struct Queued {
  Piece piece;
  double riskyMm2 = 0.0;
  std::size_t pieceIndex = 0;        // its number in PieceWays
  std::size_t level = 0;             // the next to search
  std::vector<Candidate> candidates; // best last
};

// Returns the share of a triangle with sorted corner heights h that is above the plane at height d.
double shareAbove(const std::array<double, 3>& h, double d) {
  if (d <= h[0])
    return 1.0;
  if (d >= h[2])
    return 0.0;
  if (d >= h[1])
    return (h[2] - d) * (h[2] - d) / ((h[2] - h[0]) * (h[2] - h[1]));
  return 1.0 - (d - h[0]) * (d - h[0]) / ((h[2] - h[0]) * (h[1] - h[0]));
}

// Sums of amounts above each of many parallel planes.
class Above {
public:
  explicit Above(std::size_t planes) : partly_(planes, 0.0), wholly_(planes + 1, 0.0) {}

  // Adds an amount that is above all planes with an index below `end`.
  void addWhole(std::size_t end, double amount) { wholly_[end] += amount; }
  void addPart(std::size_t plane, double amount) { partly_[plane] += amount; }

  std::vector<double> sums() const {
    std::vector<double> out = partly_;
    double whole = 0.0;
    for (std::size_t k = out.size(); k-- > 0;) {
      whole += wholly_[k + 1];
      out[k] += whole;
    }
    return out;
  }

private:
  std::vector<double> partly_, wholly_;
};

struct PlaneLimits {
  double stepMm = 5.0;       // between offsets
  bool mayTouch = false;     // false: planes do not meet the sections of other cuts
  double minMm2 = 1.0;       // smaller gains do not count
  double minStandsMm2 = 0.0; // contact area of the piece that remains [mm2]
};

// Computes the risky area that each plane perpendicular to the normal removes, for planes that
// are within the limits.
void weigh(const Piece& piece, const FaceTable& faces, const Vector3d& normal, const RiskRule& rule,
           const PlaneLimits& limits, std::vector<Candidate>& out) {
  const geometry::TriangleMesh& mesh = piece.solid.mesh;
  std::vector<double> height(mesh.vertices.size());
  for (std::size_t v = 0; v < height.size(); ++v)
    height[v] = normal.dot(mesh.vertices[v]);
  if (height.empty())
    return;
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  const double lowest = *low;
  const auto count = static_cast<std::size_t>(std::max(0.0, (*high - lowest) / limits.stepMm));
  if (count == 0)
    return;
  const auto offsetOf = [&](std::size_t k) {
    return lowest + limits.stepMm * (static_cast<double>(k) + 1.0);
  };
  // Returns the index of the first plane above a height.
  const auto firstOver = [&](double h) {
    return std::min(count, static_cast<std::size_t>(
                               std::max(0.0, std::ceil((h - lowest) / limits.stepMm - 1.0))));
  };
  Above gain(count), stands(count);
  std::vector<std::uint8_t> forbidden(count, 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = mesh.triangles[t];
    std::array<double, 3> h{height[static_cast<std::size_t>(c[0])],
                            height[static_cast<std::size_t>(c[1])],
                            height[static_cast<std::size_t>(c[2])]};
    std::sort(h.begin(), h.end());
    const std::size_t begin = firstOver(h[0]), end = firstOver(h[2]);
    if (!limits.mayTouch && piece.solid.tag[t] != kSkin)
      std::fill(forbidden.begin() + static_cast<std::ptrdiff_t>(begin),
                forbidden.begin() + static_cast<std::ptrdiff_t>(end), 1);
    const double weight =
        (faces.risky[t] > 0.0 ? 1.0 : 0.0) -
        (!faces.onPrinted[t] && isRisky(faces.normal[t], normal, rule) ? 1.0 : 0.0);
    if (weight == 0.0 && !faces.stands[t])
      continue;
    const double contact = faces.stands[t] ? faces.area[t] : 0.0;
    gain.addWhole(begin, weight * faces.area[t]);
    stands.addWhole(begin, contact);
    for (std::size_t k = begin; k < end; ++k) {
      const double share = shareAbove(h, offsetOf(k));
      gain.addPart(k, share * weight * faces.area[t]);
      stands.addPart(k, share * contact);
    }
  }
  const std::vector<double> gains = gain.sums(), contactLoss = stands.sums();
  for (std::size_t k = count; k-- > 0;)
    if (!forbidden[k] && gains[k] >= limits.minMm2 &&
        faces.standsMm2 - contactLoss[k] >= limits.minStandsMm2)
      out.push_back({{normal, offsetOf(k)}, gains[k]});
}

// Returns the planes best first, all dissimilar ones before those that are similar to a better one.
std::vector<Candidate> dissimilarFirst(std::vector<Candidate> found, const Vector3d& middle) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gainMm2 > b.gainMm2; });
  std::vector<Candidate> out, similar;
  for (const Candidate& c : found) {
    const bool isNew = std::none_of(out.begin(), out.end(), [&](const Candidate& o) {
      return o.plane.normal.dot(c.plane.normal) > kAlike &&
             std::abs(o.plane.heightOf(middle) - c.plane.heightOf(middle)) < kAlikeMm;
    });
    (isNew ? out : similar).push_back(c);
    if (out.size() == kTried)
      return out;
  }
  similar.resize(std::min(similar.size(), kTried - out.size()));
  out.insert(out.end(), similar.begin(), similar.end());
  return out;
}

double riskyOf(const std::vector<Queued>& pieces) {
  double sum = 0.0;
  for (const Queued& q : pieces)
    sum += q.riskyMm2;
  return sum;
}

class FineCutting {
public:
  FineCutting(std::vector<Piece> pieces, const PlanarOptions& options, const FineCutOptions& fine,
              std::int32_t& firstTag, const base::RunContext& ctx)
      : levelOptions_{options, withLessContact(options)}, fine_(fine), tag_(firstTag), ctx_(ctx),
        sections_(options.head.sections.empty() ? SectionContact::Apart : SectionContact::MayTouch),
        normals_(evenDirections(fine.normals, options.lowestZ)), ways_(options, fine.spacingMm) {
    for (Piece& piece : pieces)
      queue_.push_back(queued(std::move(piece)));
    blocked_ = blockedWith({}, queue_.size());
  }

  // Returns whether any piece could be cut.
  bool cutOnce() {
    std::stable_sort(queue_.begin(), queue_.end(),
                     [](const Queued& a, const Queued& b) { return a.riskyMm2 > b.riskyMm2; });
    for (std::size_t best = next(); best < queue_.size(); best = next()) {
      ctx_.checkpoint();
      const Plane plane = queue_[best].candidates.back().plane;
      queue_[best].candidates.pop_back();
      if (cutBy(best, plane))
        return true;
    }
    return false;
  }

  double riskyMm2() const { return riskyOf(queue_); }

  std::vector<Piece> pieces() && {
    std::vector<Piece> out;
    for (Queued& q : queue_)
      out.push_back(std::move(q.piece));
    return out;
  }

private:
  Queued queued(Piece piece) {
    Queued q;
    q.riskyMm2 = riskyArea(piece, rule());
    q.piece = std::move(piece);
    q.pieceIndex = ways_.add(q.piece);
    return q;
  }

  const RiskRule& rule() const { return levelOptions_[0].rule; }
  // The options of the level that the piece's candidates are from.
  const PlanarOptions& optionsFor(const Queued& q) const {
    return levelOptions_[q.level > 0 && kLevels[q.level - 1].lessContact ? 1 : 0];
  }

  // Replaces a piece by the two sides of its cut. Returns false if that would increase the number
  // of pieces that the head does not reach.
  bool replaced(std::size_t at, PieceCut cut) {
    std::vector<Queued> made;
    made.push_back(queued(std::move(cut.below)));
    for (Piece& piece : cut.above)
      made.push_back(queued(std::move(piece)));
    const std::size_t blocked = blockedWith(made, at);
    if (blocked > blocked_) {
      for (const Queued& q : made)
        ways_.remove(q.pieceIndex);
      return false;
    }
    blocked_ = blocked;
    tag_ += static_cast<std::int32_t>(made.size()) - 1;
    ways_.remove(queue_[at].pieceIndex);
    queue_.erase(queue_.begin() + static_cast<std::ptrdiff_t>(at));
    queue_.insert(queue_.end(), std::make_move_iterator(made.begin()),
                  std::make_move_iterator(made.end()));
    return true;
  }

  // Returns the index of the piece, among the first of the queue that can be cut, with the largest
  // gain; the number of pieces if none can be cut.
  std::size_t next() {
    std::size_t looked = 0, best = queue_.size();
    for (std::size_t i = 0; i < queue_.size() && looked < fine_.pieces; ++i) {
      Queued& q = queue_[i];
      if (q.riskyMm2 < fine_.minMm2)
        break;
      while (q.candidates.empty() && q.level < kLevels.size())
        search(q);
      if (q.candidates.empty())
        continue;
      ++looked;
      if (best == queue_.size() ||
          q.candidates.back().gainMm2 > queue_[best].candidates.back().gainMm2)
        best = i;
    }
    return best;
  }

  // Fills the candidates from the piece's next level.
  void search(Queued& q) {
    const Level& level = kLevels[q.level++];
    const FaceTable faces = faceTable(q.piece, rule());
    PlaneLimits limits;
    limits.stepMm = level.stepShare * fine_.stepMm;
    limits.mayTouch = sections_ == SectionContact::MayTouch;
    limits.minMm2 = fine_.minMm2;
    limits.minStandsMm2 = optionsFor(q).keptContact *
                          (q.piece.baseTag == kPlate ? fine_.footing.contactMm2 : faces.standsMm2);
    std::vector<std::vector<Candidate>> found(normals_.size());
    base::parallelChunks(ctx_.quiet(), normals_.size(), 4, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        // otherwise the section itself needs support
        if (!isRisky(normals_[i], q.piece.base.normal, rule()))
          weigh(q.piece, faces, normals_[i], rule(), limits, found[i]);
    });
    std::vector<Candidate> all;
    for (const auto& of : found)
      all.insert(all.end(), of.begin(), of.end());
    q.candidates = dissimilarFirst(std::move(all), geometry::bounds(q.piece.solid.mesh).center());
    std::reverse(q.candidates.begin(), q.candidates.end());
  }

  struct Halves {
    PieceCut cut;
    double riskyMm2 = 0.0;
  };

  // Returns the two sides of the cut, if it is worthwhile.
  std::optional<Halves> halves(const Queued& q, const Plane& plane, const Wanted& wanted) const {
    const PlanarOptions& options = optionsFor(q);
    auto cut = constrainedCut(q.piece, plane, tag_, wanted, options, fine_.footing, sections_);
    if (!cut || geometry::volume(cut->below.solid.mesh) < options.minVolumeMm3)
      return std::nullopt;
    double risky = riskyArea(cut->below, rule());
    for (const Piece& piece : cut->above)
      risky += riskyArea(piece, rule());
    if (q.riskyMm2 - risky < fine_.minMm2)
      return std::nullopt;
    return Halves{std::move(*cut), risky};
  }

  // Cuts off everything above the plane, each solid as a piece or, if the head does not reach them
  // so, all as one. If that is not possible or not worthwhile, cuts off the one solid above the
  // plane with the largest gain. Returns false if no cut is possible.
  bool cutBy(std::size_t at, const Plane& plane) {
    std::size_t solids = 0;
    const auto large = [&](const TaggedMesh& solid) {
      return geometry::volume(solid.mesh) >= levelOptions_[0].minVolumeMm3;
    };
    const auto all = halves(queue_[at], plane, [&](const TaggedMesh& solid) {
      ++solids;
      return large(solid);
    });
    if (all &&
        (replaced(at, all->cut) || (all->cut.above.size() > 1 && replaced(at, joined(all->cut)))))
      return true;
    std::optional<Halves> best;
    for (std::size_t only = 0; only < solids && solids > 1; ++only) {
      std::size_t place = 0;
      auto one = halves(queue_[at], plane,
                        [&](const TaggedMesh& solid) { return place++ == only && large(solid); });
      if (one && (!best || one->riskyMm2 < best->riskyMm2))
        best = std::move(one);
    }
    return best && replaced(at, best->cut);
  }

  // Returns the number of pieces that the head does not reach if `made` replaces a piece.
  std::size_t blockedWith(const std::vector<Queued>& made, std::size_t replaced) {
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < queue_.size(); ++i)
      if (i != replaced)
        numbers.push_back(queue_[i].pieceIndex);
    for (const Queued& q : made)
      numbers.push_back(q.pieceIndex);
    return ways_.blocked(numbers);
  }

  std::array<PlanarOptions, 2> levelOptions_; // as given, with less contact
  const FineCutOptions& fine_;
  std::int32_t& tag_;
  const base::RunContext& ctx_;
  SectionContact sections_;
  std::vector<Vector3d> normals_;
  PieceWays ways_;
  std::vector<Queued> queue_;
  std::size_t blocked_ = 0;
};

} // namespace

std::vector<Piece> fineCuts(std::vector<Piece> pieces, const PlanarOptions& options,
                            const FineCutOptions& fine, std::int32_t& firstTag,
                            const base::RunContext& ctx) {
  FineCutting cutting(std::move(pieces), options, fine, firstTag, ctx);
  for (int cuts = 0; cuts < options.maxCuts && cutting.riskyMm2() > fine.targetMm2; ++cuts) {
    ctx.report(static_cast<double>(cuts) / options.maxCuts, "pieces"_text);
    if (!cutting.cutOnce())
      break;
  }
  return std::move(cutting).pieces();
}

} // namespace voluta::planar
