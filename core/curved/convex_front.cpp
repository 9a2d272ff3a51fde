#include "curved/convex_front.h"

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
      stamp_(graph.size(), 0) {}

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
}

bool ConvexFront::deeperThan(std::size_t v, double depth, std::size_t& hint) const {
  const std::size_t blocks = nx_.size() / kBlock;
  if (blocks == 0)
    return false;
  const LatticePoint p = graph_.lattice(v);
  const double x = p.x(), y = p.y(), z = p.z();
  const auto allDeeper = [&](std::size_t block) {
    int shallow = 0;
    for (std::size_t f = block * kBlock; f < (block + 1) * kBlock; ++f) {
      const double below = offset_[f] - (nx_[f] * x + ny_[f] * y + nz_[f] * z);
      shallow += below * inverseLength_[f] <= depth;
    }
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
  for (std::size_t f = 0; f < nx_.size(); ++f) {
    const double below = offset_[f] - (nx_[f] * p.x() + ny_[f] * p.y() + nz_[f] * p.z());
    least = std::min(least, below * inverseLength_[f]);
  }
  return least;
}

// A voxel within `depth` of the hull lies that close below the plane of some facet, whose normal
// has a component of at least 1/sqrt(3) along one axis; from the voxel along that axis the hull
// therefore ends within sqrt(3) depth. So it is enough to look below the ends of all columns
// along the three axes.
const std::vector<std::int32_t>& ConvexFront::belowSurface(double depth) {
  below_.clear();
  ++round_;
  const double reach = std::sqrt(3.0) * depth + 1e-6;
  for (const HullFacet& facet : facets_)
    for (int axis = 0; axis < 3; ++axis)
      if (facet.normal[axis] != 0.0)
        rasterise(facet, axis, reach);
  return below_;
}

void ConvexFront::rasterise(const HullFacet& facet, int axis, double reach) {
  const int u = (axis + 1) % 3, w = (axis + 2) % 3;
  // Corners in cells: a voxel's centre is at its whole index.
  Eigen::Vector3d corner[3];
  for (std::size_t c = 0; c < 3; ++c) {
    corner[c] =
        (candidates_[static_cast<std::size_t>(facet.corner[c])].array() - 8.0) / kLatticePerCell;
    corner[c].z() += graph_.plateLayer;
  }
  const auto [lowW, highW] = std::minmax({corner[0][w], corner[1][w], corner[2][w]});
  const auto [lowA, highA] = std::minmax({corner[0][axis], corner[1][axis], corner[2][axis]});
  const Eigen::Vector3d n = facet.normal;
  const double planeOffset = n.dot(corner[0]);
  const bool upper = n[axis] > 0.0;
  const Eigen::Vector3i size = graph_.grid.size;
  constexpr double kSlack = 1e-9;

  const int firstW = std::max(0, static_cast<int>(std::ceil(lowW - kSlack)));
  const int lastW = std::min(size[w] - 1, static_cast<int>(std::floor(highW + kSlack)));
  for (int cw = firstW; cw <= lastW; ++cw) {
    double lowU = std::numeric_limits<double>::max(), highU = -lowU;
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d &p = corner[c], &q = corner[(c + 1) % 3];
      if (std::min(p[w], q[w]) > cw + kSlack || std::max(p[w], q[w]) < cw - kSlack)
        continue;
      const double rise = q[w] - p[w];
      if (std::abs(rise) <= kSlack) {
        lowU = std::min({lowU, p[u], q[u]});
        highU = std::max({highU, p[u], q[u]});
      } else {
        const double t = std::clamp((cw - p[w]) / rise, 0.0, 1.0);
        const double at = p[u] + t * (q[u] - p[u]);
        lowU = std::min(lowU, at);
        highU = std::max(highU, at);
      }
    }
    const int firstU = std::max(0, static_cast<int>(std::ceil(lowU - kSlack)));
    const int lastU = std::min(size[u] - 1, static_cast<int>(std::floor(highU + kSlack)));
    for (int cu = firstU; cu <= lastU; ++cu) {
      const double end = std::clamp((planeOffset - n[u] * cu - n[w] * cw) / n[axis], lowA, highA);
      const int from = static_cast<int>(std::ceil(upper ? end - reach : end - kSlack));
      const int to = static_cast<int>(std::floor(upper ? end + kSlack : end + reach));
      Eigen::Vector3i cell;
      cell[u] = cu;
      cell[w] = cw;
      for (int ca = std::max(0, from); ca <= std::min(size[axis] - 1, to); ++ca) {
        cell[axis] = ca;
        const std::int32_t v = graph_.voxelAt[graph_.grid.index(cell.x(), cell.y(), cell.z())];
        if (v < 0 || !present_[static_cast<std::size_t>(v)] ||
            stamp_[static_cast<std::size_t>(v)] == round_)
          continue;
        stamp_[static_cast<std::size_t>(v)] = round_;
        below_.push_back(v);
      }
    }
  }
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
