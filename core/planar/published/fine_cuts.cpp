#include "planar/published/fine_cuts.h"

#include "base/parallel.h"
#include "geometry/measures.h"
#include "planar/face_table.h"
#include "planar/published/section_cut.h"
#include "planar/search/cut_candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kTried = 40; // planes tried per piece

struct Candidate {
  Plane plane;
  double gainMm2 = 0.0;
};

struct Queued {
  Piece piece;
  double riskyMm2 = 0.0;
  bool searched = false;
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

// Computes the risky area that each plane perpendicular to the normal removes, for planes that
// fulfil the constraints and leave `leastStands` of the piece's contact area.
void weigh(const Piece& piece, const FaceTable& faces, const Vector3d& normal, const RiskRule& rule,
           const FineCutOptions& fine, double leastStands, std::vector<Candidate>& out) {
  const geometry::TriangleMesh& mesh = piece.solid.mesh;
  std::vector<double> height(mesh.vertices.size());
  for (std::size_t v = 0; v < height.size(); ++v)
    height[v] = normal.dot(mesh.vertices[v]);
  if (height.empty())
    return;
  const auto [low, high] = std::minmax_element(height.begin(), height.end());
  const double lowest = *low;
  const auto count = static_cast<std::size_t>(std::max(0.0, (*high - lowest) / fine.stepMm));
  if (count == 0)
    return;
  const auto offsetOf = [&](std::size_t k) {
    return lowest + fine.stepMm * (static_cast<double>(k) + 1.0);
  };
  // Returns the index of the first plane above a height.
  const auto firstOver = [&](double h) {
    return std::min(count, static_cast<std::size_t>(
                               std::max(0.0, std::ceil((h - lowest) / fine.stepMm - 1.0))));
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
    if (piece.solid.tag[t] != kSkin)
      std::fill(forbidden.begin() + static_cast<std::ptrdiff_t>(begin),
                forbidden.begin() + static_cast<std::ptrdiff_t>(end), 1);
    const double weight = (faces.risky[t] > 0.0 ? 1.0 : 0.0) -
                          (!faces.laid[t] && isRisky(faces.normal[t], normal, rule) ? 1.0 : 0.0);
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
    if (!forbidden[k] && gains[k] >= fine.leastMm2 &&
        faces.standsMm2 - contactLoss[k] >= leastStands)
      out.push_back({{normal, offsetOf(k)}, gains[k]});
}

void search(Queued& q, const std::vector<Vector3d>& normals, const PlanarOptions& options,
            const FineCutOptions& fine, const base::RunContext& ctx) {
  const RiskRule& rule = options.rule;
  if (q.searched)
    return;
  q.searched = true;
  const FaceTable faces = faceTable(q.piece, rule);
  const double leastStands =
      options.keptContact * (q.piece.baseTag == kPlate ? fine.footing.contactMm2 : faces.standsMm2);
  std::vector<std::vector<Candidate>> found(normals.size());
  base::parallelChunks(ctx, normals.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      // otherwise the section itself needs support
      if (!isRisky(normals[i], q.piece.base.normal, rule))
        weigh(q.piece, faces, normals[i], rule, fine, leastStands, found[i]);
  });
  for (const auto& of : found)
    q.candidates.insert(q.candidates.end(), of.begin(), of.end());
  std::stable_sort(q.candidates.begin(), q.candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.gainMm2 > b.gainMm2; });
  if (q.candidates.size() > kTried)
    q.candidates.resize(kTried);
  std::reverse(q.candidates.begin(), q.candidates.end());
}

Queued queued(Piece piece, const RiskRule& rule) {
  Queued q;
  q.riskyMm2 = riskyArea(piece, rule);
  q.piece = std::move(piece);
  return q;
}

// Returns the two sides of the cut, if it is worthwhile.
std::optional<std::vector<Queued>> halves(const Queued& q, const Plane& plane, std::int32_t tag,
                                          const Wanted& wanted, const PlanarOptions& options,
                                          const FineCutOptions& fine) {
  auto cut = constrainedCut(q.piece, plane, tag, wanted, options, fine.footing);
  if (!cut || geometry::volume(cut->below.solid.mesh) < options.leastVolumeMm3)
    return std::nullopt;
  std::vector<Queued> out{queued(std::move(cut->below), options.rule)};
  double risky = out.front().riskyMm2;
  for (Piece& piece : cut->above) {
    out.push_back(queued(std::move(piece), options.rule));
    risky += out.back().riskyMm2;
  }
  if (q.riskyMm2 - risky < fine.leastMm2)
    return std::nullopt;
  return out;
}

double riskyOf(const std::vector<Queued>& pieces) {
  double sum = 0.0;
  for (const Queued& q : pieces)
    sum += q.riskyMm2;
  return sum;
}

// Cuts off everything above the plane. If that would leave a solid without a base, or is not
// worthwhile, cuts off the one solid above the plane with the largest gain.
std::optional<std::vector<Queued>> bestCut(const Queued& q, const Plane& plane, std::int32_t tag,
                                           const PlanarOptions& options,
                                           const FineCutOptions& fine) {
  std::size_t solids = 0;
  const auto large = [&](const TaggedMesh& solid) {
    return geometry::volume(solid.mesh) >= options.leastVolumeMm3;
  };
  auto best = halves(
      q, plane, tag,
      [&](const TaggedMesh& solid) {
        ++solids;
        return large(solid);
      },
      options, fine);
  if (best || solids < 2)
    return best;
  for (std::size_t only = 0; only < solids; ++only) {
    std::size_t place = 0;
    auto one = halves(
        q, plane, tag, [&](const TaggedMesh& solid) { return place++ == only && large(solid); },
        options, fine);
    if (one && (!best || riskyOf(*one) < riskyOf(*best)))
      best = std::move(one);
  }
  return best;
}

} // namespace

std::vector<Piece> fineCuts(std::vector<Piece> pieces, const PlanarOptions& options,
                            const FineCutOptions& fine, std::int32_t& firstTag,
                            const base::RunContext& ctx) {
  const std::vector<Vector3d> normals = evenDirections(fine.normals, kFacesUp);
  std::vector<Queued> queue;
  for (Piece& piece : pieces)
    queue.push_back(queued(std::move(piece), options.rule));
  for (int cuts = 0; cuts < options.mostCuts;) {
    ctx.report(static_cast<double>(cuts) / options.mostCuts, "pieces"_text);
    std::stable_sort(queue.begin(), queue.end(),
                     [](const Queued& a, const Queued& b) { return a.riskyMm2 > b.riskyMm2; });
    double risky = 0.0;
    for (const Queued& q : queue)
      risky += q.riskyMm2;
    if (risky <= fine.targetMm2)
      break;
    const std::size_t looked = std::min(fine.pieces, queue.size());
    std::size_t best = looked;
    for (std::size_t i = 0; i < looked; ++i) {
      search(queue[i], normals, options, fine, ctx.quiet());
      if (!queue[i].candidates.empty() &&
          (best == looked ||
           queue[i].candidates.back().gainMm2 > queue[best].candidates.back().gainMm2))
        best = i;
    }
    if (best == looked)
      break;
    const Plane plane = queue[best].candidates.back().plane;
    queue[best].candidates.pop_back();
    auto made = bestCut(queue[best], plane, firstTag, options, fine);
    if (!made)
      continue;
    firstTag += static_cast<std::int32_t>(made->size()) - 1;
    queue.erase(queue.begin() + static_cast<std::ptrdiff_t>(best));
    queue.insert(queue.end(), std::make_move_iterator(made->begin()),
                 std::make_move_iterator(made->end()));
    ++cuts;
  }
  std::vector<Piece> out;
  for (Queued& q : queue)
    out.push_back(std::move(q.piece));
  return out;
}

} // namespace voluta::planar
