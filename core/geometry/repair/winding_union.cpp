#include "geometry/repair/winding_union.h"

#include "geometry/edges.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/repair/arrangement.h"
#include "geometry/repair/diagnosis.h"
#include "geometry/repair/repair_steps.h"
#include "geometry/repair/self_intersections.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <utility>

namespace voluta::geometry {

using Eigen::Vector3d;

namespace {

// Facets connected across edges with exactly two facets bound the same two regions.
std::vector<int> patchesOf(const Arrangement& arrangement) {
  const std::vector<std::array<int, 3>>& facets = arrangement.facets.triangles;
  UnionFind sets(facets.size());
  const std::vector<HalfEdge> edges = sortedHalfEdges(arrangement.facets);
  forEachEdge(edges, [&](std::size_t begin, std::size_t end) {
    if (end - begin != 2 || edges[begin].forward == edges[begin + 1].forward)
      return;
    const int a = edges[begin].triangle, b = edges[begin + 1].triangle;
    if (arrangement.layers[static_cast<std::size_t>(a)] ==
        arrangement.layers[static_cast<std::size_t>(b)])
      sets.join(a, b);
  });
  std::vector<int> patch(facets.size());
  for (std::size_t f = 0; f < facets.size(); ++f)
    patch[f] = sets.find(static_cast<int>(f));
  return patch;
}

// Determines the winding number in front of a patch from its largest facets.
class PatchSides {
public:
  PatchSides(const Arrangement& arrangement, const TriangleMesh& mesh)
      : arrangement_(arrangement), query_(mesh), reach_(1e-6 * bounds(mesh).diagonal().norm()) {}

  struct Front {
    int winding = 0;
    bool isCertain = false; // false: other surfaces are too close to be certain
  };
  // `facets`: sorted by decreasing area.
  Front front(const std::vector<int>& facets) const {
    Front first;
    for (std::size_t i = 0; i < std::min<std::size_t>(facets.size(), kTries); ++i) {
      const auto f = static_cast<std::size_t>(facets[i]);
      const TriangleMesh& mesh = arrangement_.facets;
      const Vector3d centre = (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3.0;
      const Vector3d out =
          std::min(reach_, 1e-3 * std::sqrt(triangleArea(mesh, f))) * triangleNormal(mesh, f);
      const int front = winding(centre + out), back = winding(centre - out);
      if (back == front + arrangement_.layers[f])
        return {front, true};
      if (i == 0)
        first.winding = front;
    }
    return first;
  }

  static constexpr std::size_t kTries = 5; // facets of a patch

private:
  int winding(const Vector3d& p) const {
    return static_cast<int>(std::lround(query_.windingNumber(p)));
  }

  const Arrangement& arrangement_;
  MeshQuery query_;
  double reach_;
};

enum class Choice : signed char { Open, Drop, Keep };

// Decides uncertain patches so that each edge has as many kept facets forward as backward: if a
// single patch at an edge is undecided, the others determine it.
class NeighbourChoice {
public:
  NeighbourChoice(const Arrangement& arrangement, const std::vector<int>& patch,
                  std::vector<Choice>& choices)
      : edges_(sortedHalfEdges(arrangement.facets)), patch_(patch), choices_(choices),
        spansOf_(patch.size()) {
    forEachEdge(edges_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (const std::size_t at = patchAt(i); choices_[at] == Choice::Open) {
          std::vector<Span>& spans = spansOf_[at];
          if (spans.empty() || spans.back().begin != begin)
            spans.push_back({begin, end});
        }
      waiting_.push_back({begin, end});
    });
  }

  void decide() {
    while (!waiting_.empty()) {
      const Span span = waiting_.front();
      waiting_.pop_front();
      const std::optional<std::size_t> decided = decideAt(span);
      if (decided) // its other edges may have a single undecided patch now
        waiting_.insert(waiting_.end(), spansOf_[*decided].begin(), spansOf_[*decided].end());
    }
  }

private:
  struct Span { // half-edges of an edge
    std::size_t begin, end;
  };
  std::size_t patchAt(std::size_t halfEdge) const {
    return static_cast<std::size_t>(patch_[static_cast<std::size_t>(edges_[halfEdge].triangle)]);
  }
  // Returns the patch that the edge decides.
  std::optional<std::size_t> decideAt(const Span& span) {
    std::optional<std::size_t> open;
    int openBalance = 0, keptBalance = 0;
    for (std::size_t i = span.begin; i < span.end; ++i) {
      const std::size_t at = patchAt(i);
      const int sign = edges_[i].forward ? 1 : -1;
      if (choices_[at] == Choice::Keep)
        keptBalance += sign;
      if (choices_[at] != Choice::Open)
        continue;
      if (open && *open != at)
        return std::nullopt;
      open = at;
      openBalance += sign;
    }
    if (!open || openBalance == 0)
      return std::nullopt;
    choices_[*open] = keptBalance == -openBalance ? Choice::Keep : Choice::Drop;
    return open;
  }

  std::vector<HalfEdge> edges_;
  const std::vector<int>& patch_;
  std::vector<Choice>& choices_;
  std::vector<std::vector<Span>> spansOf_; // of open patches
  std::deque<Span> waiting_;
};

// Volume of the tetrahedra between the facets and a point.
double volumeBelow(const TriangleMesh& mesh, const std::vector<int>& facets, const Vector3d& from) {
  double sum = 0.0;
  for (const int f : facets) {
    const auto t = static_cast<std::size_t>(f);
    const Vector3d a = mesh.corner(t, 0) - from, b = mesh.corner(t, 1) - from,
                   c = mesh.corner(t, 2) - from;
    sum += a.dot(b.cross(c)) / 6.0;
  }
  return sum;
}

// Uncertain patches are decided by measurement; if that leaves gaps, by their neighbours.
WindingUnion boundaryOfInside(const Arrangement& arrangement, const TriangleMesh& mesh,
                              const base::RunContext& ctx) {
  const TriangleMesh& all = arrangement.facets;
  const std::vector<int> patch = patchesOf(arrangement);
  std::map<int, std::vector<int>> facetsOf;
  for (std::size_t f = 0; f < patch.size(); ++f)
    facetsOf[patch[f]].push_back(static_cast<int>(f));
  const PatchSides sides(arrangement, mesh);
  const Vector3d middle = bounds(mesh).center();
  // by the divergence theorem, over the boundary of the points with negative winding number
  double insideOut = 0.0;
  std::vector<Choice> choices(patch.size(), Choice::Open), certain = choices; // indexed by patch
  for (auto& [id, facets] : facetsOf) {
    ctx.checkpoint();
    const auto areaOf = [&](int f) { return triangleArea(all, static_cast<std::size_t>(f)); };
    const auto few = std::min<std::ptrdiff_t>(PatchSides::kTries, std::ssize(facets));
    std::partial_sort(facets.begin(), facets.begin() + few, facets.end(), [&](int a, int b) {
      return std::pair(-areaOf(a), a) < std::pair(-areaOf(b), b);
    });
    const auto at = static_cast<std::size_t>(id);
    const PatchSides::Front front = sides.front(facets);
    choices[at] = front.winding < 1 && front.winding + arrangement.layers[at] >= 1 ? Choice::Keep
                                                                                   : Choice::Drop;
    if (front.isCertain)
      certain[at] = choices[at];
    const int back = front.winding + arrangement.layers[at];
    if ((front.winding < 0) != (back < 0))
      insideOut += (back < 0 ? 1.0 : -1.0) * volumeBelow(all, facets, middle);
  }
  const auto kept = [&](const std::vector<Choice>& chosen) {
    std::vector<bool> keep(patch.size());
    for (std::size_t f = 0; f < patch.size(); ++f)
      keep[f] = chosen[static_cast<std::size_t>(patch[f])] == Choice::Keep;
    return subMesh(all, keep);
  };
  TriangleMesh measured = kept(choices);
  if (isWatertight(measured))
    return {std::move(measured), insideOut};
  NeighbourChoice(arrangement, patch, certain).decide();
  return {kept(certain), insideOut};
}

} // namespace

double WindingUnion::lostShare() const {
  const double all = insideOutMm3 + volume(mesh);
  return all > 0.0 ? insideOutMm3 / all : 0.0;
}

std::optional<WindingUnion> windingUnion(const TriangleMesh& mesh,
                                         const std::vector<std::pair<int, int>>& pairs,
                                         const base::RunContext& ctx) {
  const Arrangement arrangement = arrange(mesh, pairs, ctx);
  WindingUnion united = boundaryOfInside(arrangement, mesh, ctx);
  if (!isWatertight(united.mesh))
    return std::nullopt;
  return united;
}

TriangleMesh overlapsUnited(TriangleMesh mesh, const base::RunContext& ctx) {
  const auto pairs = selfIntersections(mesh, ctx);
  if (pairs.empty())
    return mesh;
  std::optional<WindingUnion> united = windingUnion(mesh, pairs, ctx);
  return united && !united->losesTooMuch() ? std::move(united->mesh) : std::move(mesh);
}

} // namespace voluta::geometry
