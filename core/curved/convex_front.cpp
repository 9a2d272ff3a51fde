#include "curved/convex_front.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::curved {

namespace {

constexpr std::size_t kBlock = 8;
using Cell2 = std::array<std::int32_t, 2>;

// Corners of the hull of points sorted by (x, y), without those on its sides (Andrew's chain).
std::vector<Cell2> planarHull(const std::vector<Cell2>& sorted) {
  if (sorted.size() < 3)
    return sorted;
  const auto turn = [](const Cell2& o, const Cell2& a, const Cell2& b) {
    return static_cast<std::int64_t>(a[0] - o[0]) * (b[1] - o[1]) -
           static_cast<std::int64_t>(a[1] - o[1]) * (b[0] - o[0]);
  };
  std::vector<Cell2> hull;
  const auto chain = [&](auto first, auto last, std::size_t keep) {
    for (auto it = first; it != last; ++it) {
      while (hull.size() >= keep + 2 && turn(hull[hull.size() - 2], hull.back(), *it) <= 0)
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

ConvexFront::ConvexFront(const VoxelGraph& graph)
    : graph_(graph), present_(graph.size(), 0),
      rows_(static_cast<std::size_t>(graph.grid.size.y()) *
            static_cast<std::size_t>(graph.grid.size.z())),
      slice_(static_cast<std::size_t>(graph.grid.size.z())), sliceDirty_(slice_.size(), 0),
      stamp_(graph.size(), 0) {
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

void ConvexFront::touch(std::size_t v) {
  rows_[rowOf(v)].dirty = true;
  sliceDirty_[static_cast<std::size_t>(graph_.cell[v][2])] = 1;
}

void ConvexFront::insert(std::size_t v) {
  if (present_[v])
    return;
  present_[v] = 1;
  ++count_;
  touch(v);
}

void ConvexFront::remove(std::size_t v) {
  if (!present_[v])
    return;
  present_[v] = 0;
  --count_;
  touch(v);
}

void ConvexFront::refreshRow(std::size_t row) {
  const auto nx = static_cast<std::size_t>(graph_.grid.size.x());
  const std::int32_t* voxels = graph_.voxelAt.data() + row * nx;
  Row& r = rows_[row];
  r = {};
  const auto has = [&](std::size_t i) {
    return voxels[i] >= 0 && present_[static_cast<std::size_t>(voxels[i])];
  };
  std::size_t i = 0;
  while (i < nx && !has(i))
    ++i;
  if (i == nx)
    return;
  r.low = static_cast<std::int32_t>(i);
  for (i = nx - 1; !has(i);)
    --i;
  r.high = static_cast<std::int32_t>(i);
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
  // What survived in its z-slice must survive in its y-slice too.
  const auto ny = static_cast<std::size_t>(graph_.grid.size.y());
  std::vector<std::vector<Cell2>> ofRow(ny);
  for (std::size_t k = 0; k < slice_.size(); ++k)
    for (const Cell2& c : slice_[k])
      ofRow[static_cast<std::size_t>(c[1])].push_back({static_cast<std::int32_t>(k), c[0]});
  candidates_ = graph_.platform;
  for (std::size_t j = 0; j < ny; ++j) {
    std::sort(ofRow[j].begin(), ofRow[j].end());
    for (const Cell2& c : planarHull(ofRow[j]))
      candidates_.emplace_back(kLatticePerCell * c[1] + 8.0,
                               kLatticePerCell * static_cast<double>(j) + 8.0,
                               kLatticePerCell * (c[0] - graph_.plateLayer) + 8.0);
  }
}

void ConvexFront::rebuild() {
  for (std::size_t k = 0; k < slice_.size(); ++k)
    if (sliceDirty_[k])
      refreshSlice(k);
  gatherCandidates();
  facets_ = convexHull(candidates_);

  const std::size_t padded = (facets_.size() + kBlock - 1) / kBlock * kBlock;
  nx_.assign(padded, 0.0);
  ny_.assign(padded, 0.0);
  nz_.assign(padded, 0.0);
  offset_.assign(padded, std::numeric_limits<double>::max());
  inverseLength_.assign(padded, 1.0);
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    nx_[f] = facets_[f].normal.x();
    ny_[f] = facets_[f].normal.y();
    nz_[f] = facets_[f].normal.z();
    offset_[f] = facets_[f].offset;
    inverseLength_[f] = 1.0 / (kLatticePerCell * facets_[f].normal.norm());
  }

  planeInCells_.resize(facets_.size());
  for (Surface& surface : surface_) {
    std::fill(surface.ends.begin(), surface.ends.end(), Ends{});
    surface.firstW = surface.sizeW;
    surface.lastW = -1;
  }
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    planeInCells_[f] =
        facets_[f].normal.dot(inCells(candidates_[static_cast<std::size_t>(facets_[f].corner[0])]));
    for (int axis = 0; axis < 3; ++axis)
      if (facets_[f].normal[axis] != 0.0)
        rasterise(f, axis);
  }
}

double ConvexFront::below(std::size_t f, const LatticePoint& p) const {
  return offset_[f] - (nx_[f] * p.x() + ny_[f] * p.y() + nz_[f] * p.z());
}

bool ConvexFront::deeperThan(std::size_t v, double depth, std::size_t& hint) const {
  if (facets_.empty())
    return false;
  const LatticePoint p = graph_.lattice(v);
  // A point of a convex body lies on a facet exactly when it is an end of the line through it along
  // an axis that the facet faces: strictly between the ends of all three lines is strictly inside.
  // The ends span an octahedron, which lies inside and answers for most of what is deeper.
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
  if (spanned * depth * depth < kSure)
    return true;

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
  if (facets_.empty())
    return 0.0;
  const LatticePoint p = graph_.lattice(v);
  double least = std::numeric_limits<double>::max();
  for (std::size_t f = 0; f < nx_.size(); ++f)
    least = std::min(least, below(f, p) * inverseLength_[f]);
  return least;
}

// Column by column along each axis that a facet faces enough: what lies within `depth` below its
// plane there. Near the rim of a facet columns may pass it by; its neighbour sees to those.
const std::vector<std::int32_t>& ConvexFront::belowSurface(double depth) {
  below_.clear();
  ++round_;
  constexpr double kFacing = 0.5;
  const Eigen::Vector3i& size = graph_.grid.size;
  const std::array<std::size_t, 3> stride{1, static_cast<std::size_t>(size.x()),
                                          static_cast<std::size_t>(size.x()) *
                                              static_cast<std::size_t>(size.y())};
  for (int axis = 0; axis < 3; ++axis) {
    const Surface& surface = surface_[static_cast<std::size_t>(axis)];
    const int u = surface.u, w = surface.w;
    for (int cw = surface.firstW; cw <= surface.lastW; ++cw)
      for (int cu = 0; cu < surface.sizeU; ++cu) {
        const Ends& ends = surface.ends[static_cast<std::size_t>(cu + surface.sizeU * cw)];
        for (const std::int32_t end : {ends.low, ends.high}) {
          if (end < 0)
            continue;
          const auto f = static_cast<std::size_t>(end);
          const Eigen::Vector3d& n = facets_[f].normal;
          const double facing = kLatticePerCell * inverseLength_[f] * std::abs(n[axis]);
          if (facing < kFacing)
            continue;
          const double reach = (depth + 1e-9) / facing;
          const double at = (planeInCells_[f] - n[u] * cu - n[w] * cw) / n[axis];
          const bool upper = n[axis] > 0.0;
          const int from = std::max(0, static_cast<int>(std::ceil(upper ? at - reach : at - 1e-9)));
          const int to = std::min(size[axis] - 1,
                                  static_cast<int>(std::floor(upper ? at + 1e-9 : at + reach)));
          std::size_t cell =
              static_cast<std::size_t>(cu) * stride[static_cast<std::size_t>(u)] +
              static_cast<std::size_t>(cw) * stride[static_cast<std::size_t>(w)] +
              static_cast<std::size_t>(from) * stride[static_cast<std::size_t>(axis)];
          for (int ca = from; ca <= to; ++ca, cell += stride[static_cast<std::size_t>(axis)]) {
            const std::int32_t v = graph_.voxelAt[cell];
            if (v < 0 || !present_[static_cast<std::size_t>(v)] ||
                stamp_[static_cast<std::size_t>(v)] == round_)
              continue;
            stamp_[static_cast<std::size_t>(v)] = round_;
            below_.push_back(v);
          }
        }
      }
  }
  return below_;
}

// Marks the columns along `axis` that meet the facet, its rim included.
void ConvexFront::rasterise(std::size_t f, int axis) {
  Surface& surface = surface_[static_cast<std::size_t>(axis)];
  const int u = surface.u, w = surface.w;
  // Corners in cells: a voxel's centre is at its whole index.
  std::array<std::array<double, 2>, 3> corner;
  for (std::size_t c = 0; c < 3; ++c) {
    const LatticePoint p = inCells(candidates_[static_cast<std::size_t>(facets_[f].corner[c])]);
    corner[c] = {p[u], p[w]};
  }
  const auto [lowW, highW] = std::minmax({corner[0][1], corner[1][1], corner[2][1]});
  constexpr double kSlack = 1e-9;
  const bool upper = facets_[f].normal[axis] > 0.0;
  const int firstW = std::max(0, static_cast<int>(std::ceil(lowW - kSlack)));
  const int lastW = std::min(surface.sizeW - 1, static_cast<int>(std::floor(highW + kSlack)));
  surface.firstW = std::min(surface.firstW, firstW);
  surface.lastW = std::max(surface.lastW, lastW);
  for (int cw = firstW; cw <= lastW; ++cw) {
    double lowU = std::numeric_limits<double>::max(), highU = -lowU;
    for (std::size_t c = 0; c < 3; ++c) {
      const auto &p = corner[c], &q = corner[(c + 1) % 3];
      if (std::min(p[1], q[1]) > cw + kSlack || std::max(p[1], q[1]) < cw - kSlack)
        continue;
      const double rise = q[1] - p[1];
      if (std::abs(rise) <= kSlack) {
        lowU = std::min({lowU, p[0], q[0]});
        highU = std::max({highU, p[0], q[0]});
      } else {
        const double t = std::clamp((cw - p[1]) / rise, 0.0, 1.0);
        const double at = p[0] + t * (q[0] - p[0]);
        lowU = std::min(lowU, at);
        highU = std::max(highU, at);
      }
    }
    const int firstU = std::max(0, static_cast<int>(std::ceil(lowU - kSlack)));
    const int lastU = std::min(surface.sizeU - 1, static_cast<int>(std::floor(highU + kSlack)));
    Ends* row = surface.ends.data() + static_cast<std::ptrdiff_t>(surface.sizeU) * cw;
    for (int cu = firstU; cu <= lastU; ++cu)
      (upper ? row[cu].high : row[cu].low) = static_cast<std::int32_t>(f);
  }
}

LatticePoint ConvexFront::inCells(const LatticePoint& p) const {
  return (p.array() - 0.5 * kLatticePerCell) / kLatticePerCell +
         Eigen::Array3d(0.0, 0.0, graph_.plateLayer);
}

std::array<Eigen::Vector3d, 3> ConvexFront::facetOver(std::size_t v) const {
  base::require(!facets_.empty(), "facetOver: there is a hull");
  const LatticePoint p = graph_.lattice(v);
  std::size_t nearest = 0;
  for (std::size_t f = 1; f < facets_.size(); ++f)
    if (below(f, p) * inverseLength_[f] < below(nearest, p) * inverseLength_[nearest])
      nearest = f;
  std::array<Eigen::Vector3d, 3> corners;
  for (std::size_t c = 0; c < 3; ++c)
    corners[c] = inCells(candidates_[static_cast<std::size_t>(facets_[nearest].corner[c])]);
  return corners;
}

Eigen::Vector3d ConvexFront::clearNormal(std::size_t v, const Eigen::Vector3d& wish) const {
  const LatticePoint p = graph_.lattice(v);
  double least = std::numeric_limits<double>::max(), bestTurn = -2.0;
  std::size_t shallowest = facets_.size(), nearest = facets_.size();
  for (std::size_t f = 0; f < facets_.size(); ++f) {
    const double below = offset_[f] - (nx_[f] * p.x() + ny_[f] * p.y() + nz_[f] * p.z());
    if (below * inverseLength_[f] < least) {
      least = below * inverseLength_[f];
      shallowest = f;
    }
    if (below > 0.0)
      continue;
    const double turn = kLatticePerCell * inverseLength_[f] * facets_[f].normal.dot(wish);
    if (turn > bestTurn) {
      bestTurn = turn;
      nearest = f;
    }
  }
  const std::size_t chosen = nearest < facets_.size() ? nearest : shallowest;
  return chosen < facets_.size() ? facets_[chosen].normal.normalized()
                                 : Eigen::Vector3d(Eigen::Vector3d::UnitZ());
}

} // namespace voluta::curved
