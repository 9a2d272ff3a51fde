// The convex front: hull of the platform and a changing set of voxels (dissertation 3.4.1).
#pragma once

#include "curved/voxel_graph.h"

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace voluta::curved {

// Keeps the extremes of every row of voxels, so that a hull from scratch costs little: only the
// ends of rows that survive the planar hulls of their slices become candidates. A facet whose
// corners stay is a facet of the next hull too, so what is kept beside the hull changes with it
// only where it changes. Distances are in cells, measured between voxel centres and the hull of
// centres and platform.
class ConvexFront {
public:
  // Whether the facets that each column of voxels meets are kept: it takes drawing every facet, and
  // answers for voxels without asking all facets. nearSurface() and isNearSurface() need them.
  enum class Columns { Drawn, None };

  // The set is empty at first. Keeps a reference to the graph.
  explicit ConvexFront(const VoxelGraph& graph, Columns columns = Columns::Drawn);

  bool present(std::size_t v) const { return present_[v] != 0; }
  std::size_t count() const { return count_; }
  // Both need rebuild() before the hull is asked again.
  void insert(std::size_t v);
  void remove(std::size_t v);

  // The hull of the present voxels and the platform.
  void rebuild();

  // Whether the centre of v lies deeper than `depth` >= 0 inside the hull. Exact for depth 0:
  // strictly inside. False where there is no hull (no voxel present). `hint` remembers the facets
  // that answered last: start with 0, keep one a thread; it never changes the answer.
  bool deeperThan(std::size_t v, double depth, std::size_t& hint) const;

  // Least distance of v's centre below the planes of the facets: its depth inside the hull,
  // negative outside. 0 where there is no hull.
  double depth(std::size_t v) const;

  // Present voxels no deeper than `depth`, each once, in a fixed order. Found from the facets: all
  // on the hull; of those below it some near the rim of a facet may be left out.
  void nearSurface(double depth, std::vector<std::int32_t>& out);
  // Whether v, present, is one of those.
  bool isNearSurface(std::size_t v, double depth) const;
  // Of them those below facets of which a corner goes(voxel). What lies below the others, and not
  // on them, is inside the next hull too as long as nothing but voxels goes. A facet of which that
  // is said again and again, and it stays, is left out more and more often.
  template <typename Goes>
  void nearRemovable(double depth, Goes&& goes, std::vector<std::int32_t>& out) {
    gatherWhere([&](const Facet& facet) { return anyVoxel(facet, goes); },
                [](Facet& facet) { return rarer(++facet.asked); }, depth, out);
  }
  // What the last nearRemovable() left out below facets that lost a corner since rebuild().
  void nearRemoved(double depth, std::vector<std::int32_t>& out) {
    const std::uint32_t going = round_;
    gatherWhere(
        [&](const Facet& facet) {
          return anyVoxel(facet, [&](std::size_t v) { return !present_[v]; });
        },
        [&](const Facet& facet) { return facet.gathered != going; }, depth, out);
  }
  // Present voxels on those facets that are new since the last call.
  void onNewFacets(std::vector<std::int32_t>& out);

  // Unit outward normal of a facet whose plane has v's centre on its outer side and all of the set
  // on its inner side; of several the one nearest to `wish`. Where v is inside: the facet it is
  // least deep below. +z where there is no hull.
  Eigen::Vector3d clearNormal(std::size_t v, const Eigen::Vector3d& wish) const;

  // Corners, in cells (a voxel's centre is at its whole index), of the facet v is least deep below.
  // Precondition: there is a hull.
  std::array<Eigen::Vector3d, 3> facetOver(std::size_t v) const;

  std::size_t facetCount() const { return byCorners_.size(); }

private:
  // Which point of a hull: a voxel, or size() + n for the n-th corner of the platform.
  using Corners = std::array<std::int32_t, 3>;
  struct Facet {
    Corners corner{-1, -1, -1};                       // counter-clockwise from the least
    Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // outward, not unit
    std::array<Eigen::Vector3d, 3> corners;           // in cells
    double planeInCells = 0.0;  // offset of its plane with a voxel's cell as its coordinates
    std::uint32_t asked = 0;    // by nearRemovable(), so often
    std::uint32_t gathered = 0; // round_ of the last time
    bool isNew = false;         // not told by onNewFacets() yet
  };
  struct Row {
    // First and last i present; high < low: none. While dirty nothing lies outside them.
    std::int32_t low = 0, high = -1;
    bool dirty = false;
  };
  std::size_t rowOf(std::size_t v) const {
    return static_cast<std::size_t>(graph_.cell[v][1]) +
           static_cast<std::size_t>(graph_.grid.size.y()) *
               static_cast<std::size_t>(graph_.cell[v][2]);
  }
  // Facets in which a line along an axis meets the hull, -1: it does not.
  struct Ends {
    std::int32_t low = -1, high = -1;
  };
  // The hull seen along one axis: its ends for each line through a column of voxels.
  struct Surface {
    int u = 0, w = 0, sizeU = 0, sizeW = 0; // axes across and their cells; u runs fastest
    std::vector<Ends> ends;
    const Ends& at(const std::array<std::int16_t, 3>& cell) const {
      return ends[static_cast<std::size_t>(cell[static_cast<std::size_t>(u)] +
                                           sizeU * cell[static_cast<std::size_t>(w)])];
    }
  };
  // What the columns tell of deeperThan(); none: nothing for sure.
  std::optional<bool> deeperByColumns(std::size_t v, const LatticePoint& p, double depth) const;
  enum class Stroke { Draw, Erase, Fill };
  void refreshRow(std::size_t row);
  void refreshSlice(std::size_t k);
  void gatherCandidates();
  void replaceFacets(const std::vector<HullFacet>& hull);
  void dropFacet(std::int32_t slot);
  std::int32_t addFacet(const Corners& corners, const HullFacet& hullFacet);
  // Visits rows (cw, first cu, last cu) of the columns along `axis`, which the facet faces, that
  // meet it, its rim included.
  template <typename Visit> void eachRow(const Facet& facet, int axis, Visit&& visit) const;
  void mark(std::size_t slot, Stroke stroke);
  // First and last cell of the column (cu, cw) along `axis` that lie within `depth` below the plane
  // of a facet, which faces the axis by `facing` > 0.
  std::array<int, 2> cellsBelow(const Facet& facet, int axis, double facing, double depth, int cu,
                                int cw) const;
  void gatherColumn(std::size_t slot, int axis, double facing, double depth, int cu, int cw,
                    std::vector<std::int32_t>& out);
  double facing(std::size_t slot, int axis) const;
  void gatherBelow(std::size_t slot, int axis, double depth, std::vector<std::int32_t>& out);
  void gatherBelow(std::size_t slot, double depth, std::vector<std::int32_t>& out);
  // Every number up to 8, then four of each doubling.
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
  // Distance of p below the plane of a facet times the length of its normal.
  double below(std::size_t facet, const LatticePoint& p) const;

  const VoxelGraph& graph_;
  Columns columns_;
  std::vector<std::uint8_t> present_;
  std::size_t count_ = 0;
  std::vector<Row> rows_;
  std::vector<std::vector<std::array<std::int32_t, 2>>> slice_; // per k: hull of the rows' ends
  std::vector<std::uint8_t> sliceDirty_;
  bool built_ = false;
  std::vector<std::vector<std::array<std::int32_t, 2>>> ofRow_; // per j: candidates (k, i)
  std::vector<LatticePoint> candidates_;
  std::vector<std::int32_t> candidateId_;      // as Corners
  std::vector<Facet> facets_;                  // by slot; a free one has no corners
  std::vector<std::int32_t> byCorners_, free_; // slots in use, sorted by corners; free slots
  // Planes in blocks, structure of arrays; free slots have planes that everything is far below.
  std::vector<double> nx_, ny_, nz_, offset_, inverseLength_;
  std::array<Surface, 3> surface_;
  std::vector<std::int32_t> new_;          // slots that were new
  std::vector<std::uint32_t> cornerStamp_; // per corner: rebuilt_ when it lost a facet
  std::uint32_t rebuilt_ = 0;
  std::vector<std::uint32_t> stamp_; // per voxel: round_ when it was gathered
  std::uint32_t round_ = 0;          // of gathering
};

} // namespace voluta::curved
