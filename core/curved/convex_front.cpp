#include "curved/convex_front.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::curved {

namespace {

constexpr std::size_t kBlock = 8;
// If a facet faces an axis less than this, columns along the axis are not meaningful for the voxels
// near it.
constexpr double kFacing = 0.5;
using Cell2 = std::array<std::int32_t, 2>;

// Like std::floor and std::ceil, which are function calls on some processors.
int floored(double x) {
  const int whole = static_cast<int>(x);
  return whole - (x < whole);
}
int ceiled(double x) {
  const int whole = static_cast<int>(x);
  return whole + (x > whole);
}

// Returns the corners of the hull of points sorted by (x, y), without points on its sides (Andrew's
// monotone chain).
std::vector<Cell2> planarHull(const std::vector<Cell2>& sorted) {
  if (sorted.size() < 3)
    return sorted;
  const auto orientation = [](const Cell2& o, const Cell2& a, const Cell2& b) {
    return static_cast<std::int64_t>(a[0] - o[0]) * (b[1] - o[1]) -
           static_cast<std::int64_t>(a[1] - o[1]) * (b[0] - o[0]);
  };
  std::vector<Cell2> hull;
  const auto chain = [&](auto first, auto last, std::size_t keep) {
    for (auto it = first; it != last; ++it) {
      while (hull.size() >= keep + 2 && orientation(hull[hull.size() - 2], hull.back(), *it) <= 0)
        hull.pop_back();
      hull.push_back(*it);
    }
    hull.pop_back();
  };
  chain(sorted.begin(), sorted.end(), 0);
  chain(sorted.rbegin(), sorted.rend(), hull.size());
  return hull;
}

} // namespace

ConvexFront::ConvexFront(const VoxelGraph& graph, Columns columns)
    : graph_(graph), columns_(columns), present_(graph.size(), 0),
      rows_(static_cast<std::size_t>(graph.grid.size.y()) *
            static_cast<std::size_t>(graph.grid.size.z())),
      slice_(static_cast<std::size_t>(graph.grid.size.z())), sliceDirty_(slice_.size(), 0),
      ofRow_(static_cast<std::size_t>(graph.grid.size.y())),
      cornerStamp_(graph.size() + graph.platform.size(), 0), stamp_(graph.size(), 0) {
  for (int axis = 0; axis < 3; ++axis) {
    Surface& surface = surface_[static_cast<std::size_t>(axis)];
    surface.u = (axis + 1) % 3;
    surface.w = (axis + 2) % 3;
    surface.sizeU = graph.grid.size[surface.u];
    surface.sizeW = graph.grid.size[surface.w];
    surface.ends.resize(static_cast<std::size_t>(surface.sizeU) *
                        static_cast<std::size_t>(surface.sizeW));
  }
}

void ConvexFront::insert(std::size_t v) {
  if (present_[v])
    return;
  present_[v] = 1;
  ++count_;
  Row& row = rows_[rowOf(v)];
  const std::int32_t i = graph_.cell[v][0];
  if (row.high >= row.low && i > row.low && i < row.high)
    return;
  if (row.high < row.low) {
    row.low = row.high = i;
  } else {
    row.low = std::min(row.low, i);
    row.high = std::max(row.high, i);
  }
  sliceDirty_[static_cast<std::size_t>(graph_.cell[v][2])] = 1;
}

void ConvexFront::remove(std::size_t v) {
  if (!present_[v])
    return;
  present_[v] = 0;
  --count_;
  Row& row = rows_[rowOf(v)];
  const std::int32_t i = graph_.cell[v][0];
  if (i > row.low && i < row.high)
    return;
  row.dirty = true;
  sliceDirty_[static_cast<std::size_t>(graph_.cell[v][2])] = 1;
}

void ConvexFront::refreshRow(std::size_t row) {
  const std::int32_t* voxels =
      graph_.voxelAt.data() + row * static_cast<std::size_t>(graph_.grid.size.x());
  Row& r = rows_[row];
  const auto has = [&](std::int32_t i) {
    return voxels[i] >= 0 && present_[static_cast<std::size_t>(voxels[i])];
  };
  r.dirty = false;
  while (r.low <= r.high && !has(r.low))
    ++r.low;
  while (r.high > r.low && !has(r.high))
    --r.high;
}

void ConvexFront::refreshSlice(std::size_t k) {
  const auto ny = static_cast<std::size_t>(graph_.grid.size.y());
  std::vector<Cell2> ends; // (j, i), sorted
  for (std::size_t j = 0; j < ny; ++j) {
    Row& row = rows_[k * ny + j];
    if (row.dirty)
      refreshRow(k * ny + j);
    if (row.high < row.low)
      continue;
    ends.push_back({static_cast<std::int32_t>(j), row.low});
    if (row.high > row.low)
      ends.push_back({static_cast<std::int32_t>(j), row.high});
  }
  slice_[k] = planarHull(ends);
  for (Cell2& c : slice_[k])
    std::swap(c[0], c[1]);
  sliceDirty_[k] = 0;
}

void ConvexFront::gatherCandidates() {
  // A candidate must survive the hull of its z-slice and that of its y-slice.
  for (auto& row : ofRow_)
    row.clear();
  for (std::size_t k = 0; k < slice_.size(); ++k)
    for (const Cell2& c : slice_[k])
      ofRow_[static_cast<std::size_t>(c[1])].push_back({static_cast<std::int32_t>(k), c[0]});
  candidates_ = graph_.platform;
  candidateId_.clear();
  for (std::size_t c = 0; c < graph_.platform.size(); ++c)
    candidateId_.push_back(static_cast<std::int32_t>(graph_.size() + c));
  for (std::size_t j = 0; j < ofRow_.size(); ++j) {
    std::sort(ofRow_[j].begin(), ofRow_[j].end());
    for (const Cell2& c : planarHull(ofRow_[j])) {
      candidateId_.push_back(
          graph_.voxelAt[graph_.grid.index(c[1], static_cast<std::int32_t>(j), c[0])]);
      candidates_.push_back(pointOf(candidateId_.back()));
    }
  }
}

void ConvexFront::rebuild() {
  bool changed = !built_;
  for (std::size_t k = 0; k < slice_.size(); ++k)
    if (sliceDirty_[k]) {
      changed = true;
      refreshSlice(k);
    }
  if (!changed)
    return;
  built_ = true;
  gatherCandidates();
  replaceFacets(convexHull(candidates_));
}

void ConvexFront::replaceFacets(const std::vector<HullFacet>& hull) {
  std::vector<std::pair<Corners, const HullFacet*>> wanted;
  wanted.reserve(hull.size());
  for (const HullFacet& h : hull) {
    Corners c;
    for (std::size_t s = 0; s < 3; ++s)
      c[s] = candidateId_[static_cast<std::size_t>(h.corner[s])];
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    wanted.emplace_back(c, &h);
  }
  std::sort(wanted.begin(), wanted.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });

  std::vector<std::int32_t> had = std::move(byCorners_), kept, removed;
  std::vector<std::pair<Corners, const HullFacet*>> added;
  byCorners_.clear();
  ++rebuilt_;
  auto old = had.begin();
  const auto cornersOf = [&](std::int32_t slot) -> const Corners& {
    return facets_[static_cast<std::size_t>(slot)].corner;
  };
  for (const auto& entry : wanted) {
    for (; old != had.end() && cornersOf(*old) < entry.first; ++old)
      removed.push_back(*old);
    if (old != had.end() && cornersOf(*old) == entry.first)
      kept.push_back(*old++);
    else
      added.push_back(entry);
  }
  removed.insert(removed.end(), old, had.end());
  const bool anew = removed.size() > kept.size();
  if (anew && columns_ == Columns::Drawn)
    for (Surface& surface : surface_)
      std::fill(surface.ends.begin(), surface.ends.end(), Ends{});
  for (const std::int32_t slot : removed) {
    if (!anew)
      mark(static_cast<std::size_t>(slot), Stroke::Erase);
    dropFacet(slot);
  }
  std::vector<std::int32_t> made;
  for (const auto& [corners, h] : added)
    made.push_back(addFacet(corners, *h));
  // A column that meets the rim of a removed facet may also meet a facet that remains.
  for (const std::int32_t slot : kept) {
    const Corners& corners = cornersOf(slot);
    if (anew || std::any_of(corners.begin(), corners.end(), [&](std::int32_t c) {
          return cornerStamp_[static_cast<std::size_t>(c)] == rebuilt_;
        }))
      mark(static_cast<std::size_t>(slot), Stroke::Fill);
  }
  byCorners_.resize(kept.size() + made.size());
  std::merge(kept.begin(), kept.end(), made.begin(), made.end(), byCorners_.begin(),
             [&](std::int32_t a, std::int32_t b) { return cornersOf(a) < cornersOf(b); });
}

void ConvexFront::dropFacet(std::int32_t slot) {
  const auto f = static_cast<std::size_t>(slot);
  for (const std::int32_t c : facets_[f].corner)
    cornerStamp_[static_cast<std::size_t>(c)] = rebuilt_;
  facets_[f] = {};
  nx_[f] = ny_[f] = nz_[f] = 0.0;
  offset_[f] = std::numeric_limits<double>::max();
  inverseLength_[f] = 1.0;
  free_.push_back(slot);
}

std::int32_t ConvexFront::addFacet(const Corners& corners, const HullFacet& hullFacet) {
  if (free_.empty()) {
    for (std::size_t i = 0; i < kBlock; ++i)
      free_.push_back(static_cast<std::int32_t>(facets_.size() + kBlock - 1 - i));
    const std::size_t size = facets_.size() + kBlock;
    facets_.resize(size);
    for (std::vector<double>* a : {&nx_, &ny_, &nz_})
      a->resize(size, 0.0);
    offset_.resize(size, std::numeric_limits<double>::max());
    inverseLength_.resize(size, 1.0);
  }
  const std::int32_t slot = free_.back();
  free_.pop_back();
  const auto f = static_cast<std::size_t>(slot);
  const Eigen::Vector3d& n = hullFacet.normal;
  std::array<Eigen::Vector3d, 3> at;
  for (std::size_t c = 0; c < 3; ++c)
    at[c] = inCells(pointOf(corners[c]));
  facets_[f] = {corners, n, at, n.dot(at[0]), 0, 0, true};
  new_.push_back(slot);
  nx_[f] = n.x();
  ny_[f] = n.y();
  nz_[f] = n.z();
  offset_[f] = hullFacet.offset;
  inverseLength_[f] = 1.0 / (kLatticePerCell * n.norm());
  mark(f, Stroke::Draw);
  return slot;
}

double ConvexFront::below(std::size_t f, const LatticePoint& p) const {
  return offset_[f] - (nx_[f] * p.x() + ny_[f] * p.y() + nz_[f] * p.z());
}

// A point of a convex body is on a facet exactly if it is an end of the line through it along an
// axis that the facet faces: strictly between the ends of all three lines means strictly inside.
// The six ends span an octahedron inside the body, which decides most deeper points.
std::optional<bool> ConvexFront::deeperByColumns(std::size_t v, const LatticePoint& p,
                                                 double depth) const {
  double spanned = 0.0;
  for (const int axis : {2, 1, 0}) {
    const Ends& ends = surface_[static_cast<std::size_t>(axis)].at(graph_.cell[v]);
    if (ends.low < 0 || ends.high < 0)
      return false;
    double nearest = std::numeric_limits<double>::max();
    for (const std::int32_t end : {ends.low, ends.high}) {
      const auto f = static_cast<std::size_t>(end);
      const double under = below(f, p);
      if (under * inverseLength_[f] <= depth)
        return false;
      nearest = std::min(nearest, under / std::abs(facets_[f].normal[axis]));
    }
    spanned += kLatticePerCell * kLatticePerCell / (nearest * nearest);
  }
  constexpr double kSure = 1.0 - 1e-9;
  return spanned * depth * depth < kSure ? std::optional(true) : std::nullopt;
}

bool ConvexFront::deeperThan(std::size_t v, double depth, std::size_t& hint) const {
  if (byCorners_.empty())
    return false;
  const LatticePoint p = graph_.lattice(v);
  if (columns_ == Columns::Drawn)
    if (const std::optional<bool> known = deeperByColumns(v, p, depth))
      return *known;
  const std::size_t blocks = nx_.size() / kBlock;
  const auto allDeeper = [&](std::size_t block) {
    int shallow = 0;
    for (std::size_t f = block * kBlock; f < (block + 1) * kBlock; ++f)
      shallow += below(f, p) * inverseLength_[f] <= depth;
    return shallow == 0;
  };
  if (hint < blocks && !allDeeper(hint))
    return false;
  for (std::size_t b = 0; b < blocks; ++b)
    if (!allDeeper(b)) {
      hint = b;
      return false;
    }
  return true;
}

double ConvexFront::depth(std::size_t v) const {
  if (byCorners_.empty())
    return 0.0;
  const LatticePoint p = graph_.lattice(v);
  double minimum = std::numeric_limits<double>::max();
  for (std::size_t f = 0; f < nx_.size(); ++f)
    minimum = std::min(minimum, below(f, p) * inverseLength_[f]);
  return minimum;
}

double ConvexFront::facing(std::size_t slot, int axis) const {
  return kLatticePerCell * inverseLength_[slot] * std::abs(facets_[slot].normal[axis]);
}

inline std::array<int, 2> ConvexFront::cellsBelow(const Facet& facet, int axis, double facing,
                                                  double depth, int cu, int cw) const {
  const Surface& surface = surface_[static_cast<std::size_t>(axis)];
  const Eigen::Vector3d& n = facet.normal;
  const double reach = (depth + 1e-9) / facing;
  const double at = (facet.planeInCells - n[surface.u] * cu - n[surface.w] * cw) / n[axis];
  const bool upper = n[axis] > 0.0;
  return {std::max(0, ceiled(upper ? at - reach : at - 1e-9)),
          std::min(graph_.grid.size[axis] - 1, floored(upper ? at + 1e-9 : at + reach))};
}

// Collects the voxels within `depth` below the facet's plane in this column. Columns can miss
// voxels near the rim; those belong to the neighbouring facet.
inline void ConvexFront::gatherColumn(std::size_t slot, int axis, double facing, double depth,
                                      int cu, int cw, std::vector<std::int32_t>& out) {
  const Surface& surface = surface_[static_cast<std::size_t>(axis)];
  const Eigen::Vector3i& size = graph_.grid.size;
  const auto [from, to] = cellsBelow(facets_[slot], axis, facing, depth, cu, cw);
  if (from > to)
    return;
  std::array<int, 3> cell{};
  cell[static_cast<std::size_t>(surface.u)] = cu;
  cell[static_cast<std::size_t>(surface.w)] = cw;
  cell[static_cast<std::size_t>(axis)] = from;
  const std::array<std::size_t, 3> strides{1, static_cast<std::size_t>(size.x()),
                                           static_cast<std::size_t>(size.x()) *
                                               static_cast<std::size_t>(size.y())};
  std::size_t index = graph_.grid.index(cell[0], cell[1], cell[2]);
  for (int ca = from; ca <= to; ++ca, index += strides[static_cast<std::size_t>(axis)]) {
    const std::int32_t v = graph_.voxelAt[index];
    if (v < 0 || !present_[static_cast<std::size_t>(v)] ||
        stamp_[static_cast<std::size_t>(v)] == round_)
      continue;
    stamp_[static_cast<std::size_t>(v)] = round_;
    out.push_back(v);
  }
}

void ConvexFront::gatherBelow(std::size_t slot, int axis, double depth,
                              std::vector<std::int32_t>& out) {
  const double towards = facing(slot, axis);
  eachRow(facets_[slot], axis, [&](int cw, int firstU, int lastU) {
    for (int cu = firstU; cu <= lastU; ++cu)
      gatherColumn(slot, axis, towards, depth, cu, cw, out);
  });
}

void ConvexFront::gatherBelow(std::size_t slot, double depth, std::vector<std::int32_t>& out) {
  for (int axis = 0; axis < 3; ++axis)
    if (facing(slot, axis) >= kFacing)
      gatherBelow(slot, axis, depth, out);
}

void ConvexFront::nearSurface(double depth, std::vector<std::int32_t>& out) {
  out.clear();
  ++round_;
  for (int axis = 0; axis < 3; ++axis) {
    const Surface& surface = surface_[static_cast<std::size_t>(axis)];
    for (int cw = 0; cw < surface.sizeW; ++cw)
      for (int cu = 0; cu < surface.sizeU; ++cu) {
        const Ends& ends = surface.ends[static_cast<std::size_t>(cu + surface.sizeU * cw)];
        for (const std::int32_t end : {ends.low, ends.high}) {
          if (end < 0)
            continue;
          const auto slot = static_cast<std::size_t>(end);
          if (const double towards = facing(slot, axis); towards >= kFacing)
            gatherColumn(slot, axis, towards, depth, cu, cw, out);
        }
      }
  }
}

bool ConvexFront::isNearSurface(std::size_t v, double depth) const {
  const std::array<std::int16_t, 3>& cell = graph_.cell[v];
  for (int axis = 0; axis < 3; ++axis) {
    const Surface& surface = surface_[static_cast<std::size_t>(axis)];
    const Ends& ends = surface.at(cell);
    for (const std::int32_t end : {ends.low, ends.high}) {
      if (end < 0)
        continue;
      const auto slot = static_cast<std::size_t>(end);
      const double towards = facing(slot, axis);
      if (towards < kFacing)
        continue;
      const int at = cell[static_cast<std::size_t>(axis)];
      const auto [from, to] =
          cellsBelow(facets_[slot], axis, towards, depth, cell[static_cast<std::size_t>(surface.u)],
                     cell[static_cast<std::size_t>(surface.w)]);
      if (from <= at && at <= to)
        return true;
    }
  }
  return false;
}

void ConvexFront::onNewFacets(std::vector<std::int32_t>& out) {
  out.clear();
  ++round_;
  for (const std::int32_t slot : new_) {
    Facet& facet = facets_[static_cast<std::size_t>(slot)];
    if (!facet.isNew)
      continue;
    facet.isNew = false;
    int axis = 0;
    facet.normal.cwiseAbs().maxCoeff(&axis);
    gatherBelow(static_cast<std::size_t>(slot), axis, 0.0, out);
  }
  new_.clear();
}

template <typename Visit>
void ConvexFront::eachRow(const Facet& facet, int axis, Visit&& visit) const {
  const Surface& surface = surface_[static_cast<std::size_t>(axis)];
  // Corners in cells: a voxel's centre has integer coordinates. Corners are on the lattice, so that
  // rows compare exactly.
  struct Corner {
    double u, w;
  };
  std::array<Corner, 3> corner;
  for (std::size_t c = 0; c < 3; ++c)
    corner[c] = {facet.corners[c][surface.u], facet.corners[c][surface.w]};
  if (corner[1].w < corner[0].w)
    std::swap(corner[0], corner[1]);
  if (corner[2].w < corner[1].w)
    std::swap(corner[1], corner[2]);
  if (corner[1].w < corner[0].w)
    std::swap(corner[0], corner[1]);
  const auto& [first, middle, last] = corner;
  const auto slope = [](const Corner& from, const Corner& to) {
    return to.w > from.w ? (to.u - from.u) / (to.w - from.w) : 0.0;
  };
  const double across = slope(first, last), before = slope(first, middle),
               after = slope(middle, last);
  constexpr double kSlack = 1e-9;
  const int firstW = std::max(0, ceiled(first.w)),
            lastW = std::min(surface.sizeW - 1, floored(last.w));
  for (int cw = firstW; cw <= lastW; ++cw) {
    const double one = first.u + across * (cw - first.w);
    const double other =
        cw < middle.w ? first.u + before * (cw - first.w) : middle.u + after * (cw - middle.w);
    visit(cw, std::max(0, ceiled(std::min(one, other) - kSlack)),
          std::min(surface.sizeU - 1, floored(std::max(one, other) + kSlack)));
  }
}

void ConvexFront::mark(std::size_t slot, Stroke stroke) {
  if (columns_ == Columns::None)
    return;
  const Facet& facet = facets_[slot];
  const auto id = static_cast<std::int32_t>(slot);
  for (int axis = 0; axis < 3; ++axis) {
    if (facet.normal[axis] == 0.0)
      continue;
    Surface& surface = surface_[static_cast<std::size_t>(axis)];
    const auto end = facet.normal[axis] > 0.0 ? &Ends::high : &Ends::low;
    eachRow(facet, axis, [&](int cw, int firstU, int lastU) {
      Ends* row = surface.ends.data() + static_cast<std::ptrdiff_t>(surface.sizeU) * cw;
      for (int cu = firstU; cu <= lastU; ++cu) {
        std::int32_t& at = row[cu].*end;
        if (stroke == Stroke::Draw)
          at = id;
        else if (stroke == Stroke::Erase)
          at = at == id ? -1 : at;
        else if (at < 0)
          at = id;
      }
    });
  }
}

LatticePoint ConvexFront::pointOf(std::int32_t corner) const {
  const auto c = static_cast<std::size_t>(corner);
  return c < graph_.size() ? graph_.lattice(c) : graph_.platform[c - graph_.size()];
}

LatticePoint ConvexFront::inCells(const LatticePoint& p) const {
  return (p.array() - 0.5 * kLatticePerCell) / kLatticePerCell +
         Eigen::Array3d(0.0, 0.0, graph_.plateLayer);
}

std::array<Eigen::Vector3d, 3> ConvexFront::facetOver(std::size_t v) const {
  base::require(!byCorners_.empty(), "facetOver: there is a hull");
  const LatticePoint p = graph_.lattice(v);
  std::size_t nearest = 0;
  for (std::size_t f = 1; f < facets_.size(); ++f)
    if (below(f, p) * inverseLength_[f] < below(nearest, p) * inverseLength_[nearest])
      nearest = f;
  return facets_[nearest].corners;
}

Eigen::Vector3d ConvexFront::clearNormal(std::size_t v, const Eigen::Vector3d& wish) const {
  const LatticePoint p = graph_.lattice(v);
  double minimum = std::numeric_limits<double>::max(), bestAlignment = -2.0;
  std::size_t shallowest = facets_.size(), nearest = facets_.size();
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const double below = offset_[f] - (nx_[f] * p.x() + ny_[f] * p.y() + nz_[f] * p.z());
    if (below * inverseLength_[f] < minimum) {
      minimum = below * inverseLength_[f];
      shallowest = f;
    }
    if (below > 0.0)
      continue;
    const double alignment = kLatticePerCell * inverseLength_[f] * facets_[f].normal.dot(wish);
    if (alignment > bestAlignment) {
      bestAlignment = alignment;
      nearest = f;
    }
  }
  const std::size_t chosen = nearest < facets_.size() ? nearest : shallowest;
  return chosen < facets_.size() ? facets_[chosen].normal.normalized()
                                 : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

} // namespace voluta::curved
