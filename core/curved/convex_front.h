// The convex front: convex hull of the platform and a changing set of voxels (dissertation 3.4.1).
#pragma once

#include "curved/voxel_graph.h"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::curved {

// Keeps the extremes of every row of voxels, so that recomputing the hull is cheap: only ends of
// rows that survive the planar hulls of their slices become candidates. A facet whose corners
// remain is also a facet of the next hull, so the data stored per facet changes only where the hull
// changes. Distances are in cells, between voxel centres and the hull of centres and platform.
class ConvexFront {
public:
  // Whether the facets that each column of voxels meets are stored. This requires rasterizing every
  // facet, and answers queries about voxels without testing all facets. nearSurface() and
  // isNearSurface() require Drawn.
  enum class Columns { Drawn, None };

  // The set is initially empty. Keeps a reference to the graph.
  explicit ConvexFront(const VoxelGraph& graph, Columns columns = Columns::Drawn);

  bool present(std::size_t v) const { return present_[v] != 0; }
  std::size_t count() const { return count_; }
  // Call rebuild() after insert() or remove() before querying the hull.
  void insert(std::size_t v);
  void remove(std::size_t v);

  // Recomputes the hull of the present voxels and the platform.
  void rebuild();

  // Returns whether the centre of v is deeper than `depth` >= 0 inside the hull. Exact for depth 0:
  // strictly inside. False if there is no hull (no voxel present). `hint` stores the facets that
  // decided the last query: start with 0, use one per thread; it never changes the result.
  bool deeperThan(std::size_t v, double depth, std::size_t& hint) const;

  // Returns the minimum distance of v's centre below the planes of the facets: its depth inside the
  // hull, negative outside. 0 if there is no hull.
  double depth(std::size_t v) const;

  // Returns in `out` the present voxels no deeper than `depth`, each once, in a fixed order.
  // Complete for voxels on the hull; deeper voxels near the rim of a facet may be missing.
  void nearSurface(double depth, std::vector<std::int32_t>& out);
  // Returns whether v, which is present, is one of those.
  bool isNearSurface(std::size_t v, double depth) const;
  // Returns only those below facets with a corner for which goes(voxel) is true. Voxels below the
  // other facets, but not on them, stay inside the next hull as long as only voxels are removed. A
  // facet that repeatedly satisfies goes() but remains is skipped more and more often.
  template <typename IsRemovable>
  void nearRemovable(double depth, IsRemovable&& isRemovable, std::vector<std::int32_t>& out) {
    gatherWhere([&](const Facet& facet) { return anyVoxel(facet, isRemovable); },
                [](Facet& facet) { return rarer(++facet.asked); }, depth, out);
  }
  // Returns the voxels that the last nearRemovable() omitted below facets that have lost a corner
  // since rebuild().
  void nearRemoved(double depth, std::vector<std::int32_t>& out) {
    const std::uint32_t going = round_;
    gatherWhere(
        [&](const Facet& facet) {
          return anyVoxel(facet, [&](std::size_t v) { return !present_[v]; });
        },
        [&](const Facet& facet) { return facet.gathered != going; }, depth, out);
  }
  // Returns the present voxels on facets that are new since the last call.
  void onNewFacets(std::vector<std::int32_t>& out);

  // Returns the unit outward normal of a facet whose plane has v's centre on its outer side and the
  // whole set on its inner side; of several, the one nearest to `wish`. If v is inside: of the
  // facet below which v is least deep. +z if there is no hull.
  Eigen::Vector3d clearNormal(std::size_t v, const Eigen::Vector3d& wish) const;

  // Returns the corners, in cells (a voxel's centre has integer coordinates), of the facet below
  // which v is least deep. Precondition: there is a hull.
  std::array<Eigen::Vector3d, 3> facetOver(std::size_t v) const;

  std::size_t facetCount() const { return byCorners_.size(); }

private:
  // Corners of a facet: a voxel, or size() + n for the n-th corner of the platform.
  using Corners = std::array<std::int32_t, 3>;
  struct Facet {
    Corners corner{-1, -1, -1};                       // Counter-clockwise, smallest index first
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // Outward, not normalized
    std::array<Eigen::Vector3d, 3> corners;           // In cells
    double planeInCells = 0.0;                        // Plane offset for points in cell coordinates
    std::uint32_t asked = 0;    // Number of times nearRemovable() considered it
    std::uint32_t gathered = 0; // round_ of the last time
    bool isNew = false;         // Not yet returned by onNewFacets()
  };
  struct Row {
    // First and last i present; high < low: none. While dirty, a superset of the range.
    std::int32_t low = 0, high = -1;
    bool dirty = false;
  };
  std::size_t rowOf(std::size_t v) const {
    return static_cast<std::size_t>(graph_.cell[v][1]) +
           static_cast<std::size_t>(graph_.grid.size.y()) *
               static_cast<std::size_t>(graph_.cell[v][2]);
  }
  // Facets in which a line along an axis meets the hull; -1: none.
  struct Ends {
    std::int32_t low = -1, high = -1;
  };
  // The hull seen along one axis: the end facets of each column of voxels.
  struct Surface {
    // The other axes and their cell counts; u varies fastest
    int u = 0, w = 0, sizeU = 0, sizeW = 0;
    std::vector<Ends> ends;
    const Ends& at(const std::array<std::int16_t, 3>& cell) const {
      return ends[static_cast<std::size_t>(cell[static_cast<std::size_t>(u)] +
                                           sizeU * cell[static_cast<std::size_t>(w)])];
    }
  };
  // Returns deeperThan() as far as the columns decide it; nullopt if they do not.
  std::optional<bool> deeperByColumns(std::size_t v, const LatticePoint& p, double depth) const;
  enum class Stroke { Draw, Erase, Fill };
  void refreshRow(std::size_t row);
  void refreshSlice(std::size_t k);
  void gatherCandidates();
  void replaceFacets(const std::vector<HullFacet>& hull);
  void dropFacet(std::int32_t slot);
  std::int32_t addFacet(const Corners& corners, const HullFacet& hullFacet);
  // Calls visit(cw, first cu, last cu) for the rows of columns along `axis` that meet the facet,
  // including its rim. The facet must face the axis.
  template <typename Visit> void eachRow(const Facet& facet, int axis, Visit&& visit) const;
  void mark(std::size_t slot, Stroke stroke);
  // Returns the first and last cell of the column (cu, cw) along `axis` that are within `depth`
  // below the plane of a facet, whose normal's component along the axis is `facing` > 0.
  std::array<int, 2> cellsBelow(const Facet& facet, int axis, double facing, double depth, int cu,
                                int cw) const;
  void gatherColumn(std::size_t slot, int axis, double facing, double depth, int cu, int cw,
                    std::vector<std::int32_t>& out);
  double facing(std::size_t slot, int axis) const;
  void gatherBelow(std::size_t slot, int axis, double depth, std::vector<std::int32_t>& out);
  void gatherBelow(std::size_t slot, double depth, std::vector<std::int32_t>& out);
  // Returns whether n is due: every number up to 8, then four per doubling.
  static bool rarer(std::uint32_t n) { return n < 8 || n % (std::bit_floor(n) / 4) == 0; }
  template <typename Is> bool anyVoxel(const Facet& facet, Is&& is) const {
    for (const std::int32_t c : facet.corner)
      if (static_cast<std::size_t>(c) < graph_.size() && is(static_cast<std::size_t>(c)))
        return true;
    return false;
  }
  template <typename Where, typename Also>
  void gatherWhere(Where&& where, Also&& also, double depth, std::vector<std::int32_t>& out) {
    out.clear();
    ++round_;
    for (const std::int32_t slot : byCorners_) {
      Facet& facet = facets_[static_cast<std::size_t>(slot)];
      if (!where(facet) || !also(facet))
        continue;
      facet.gathered = round_;
      gatherBelow(static_cast<std::size_t>(slot), depth, out);
    }
  }
  LatticePoint pointOf(std::int32_t corner) const;
  LatticePoint inCells(const LatticePoint& p) const;
  // Returns the distance of p below the plane of a facet times the length of its normal.
  double below(std::size_t facet, const LatticePoint& p) const;

  const VoxelGraph& graph_;
  Columns columns_;
  std::vector<std::uint8_t> present_;
  std::size_t count_ = 0;
  std::vector<Row> rows_;
  std::vector<std::vector<std::array<std::int32_t, 2>>> slice_; // Per k: hull of the rows' ends
  std::vector<std::uint8_t> sliceDirty_;
  bool built_ = false;
  std::vector<std::vector<std::array<std::int32_t, 2>>> ofRow_; // Per j: candidates (k, i)
  std::vector<LatticePoint> candidates_;
  std::vector<std::int32_t> candidateId_;      // Indices as in Corners
  std::vector<Facet> facets_;                  // By slot; free slots have no corners
  std::vector<std::int32_t> byCorners_, free_; // Used slots, sorted by corners; free slots
  // Planes in blocks, as a structure of arrays. The planes of free slots are far above everything.
  std::vector<double> nx_, ny_, nz_, offset_, inverseLength_;
  std::array<Surface, 3> surface_;
  std::vector<std::int32_t> new_;          // Slots of new facets
  std::vector<std::uint32_t> cornerStamp_; // Per corner: rebuilt_ when it lost a facet
  std::uint32_t rebuilt_ = 0;
  std::vector<std::uint32_t> stamp_; // Per voxel: round_ when it was gathered
  std::uint32_t round_ = 0;          // Counts gatherings
};

} // namespace voluta::curved
