// The convex front: hull of the platform and a changing set of voxels (dissertation 3.4.1).
#pragma once

#include "curved/voxel_graph.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// Keeps the extremes of every row of voxels, so that a hull from scratch costs little: only the
// ends of rows that survive the planar hulls of their slices become candidates. Distances are in
// cells, measured between voxel centres and the hull of centres and platform.
class ConvexFront {
public:
  // The set is empty at first. Keeps a reference to the graph.
  explicit ConvexFront(const VoxelGraph& graph);

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

  // Present voxels v with wanted(v) no deeper than `depth`, each once, in a fixed order. Found from
  // the facets: all on the hull; of those below it some near the rim of a facet may be left out.
  template <typename Wanted>
  void nearSurface(double depth, Wanted&& wanted, std::vector<std::int32_t>& out) {
    out.clear();
    for (const std::int32_t v : belowSurface(depth))
      if (wanted(static_cast<std::size_t>(v)))
        out.push_back(v);
  }

  // Unit outward normal of a facet whose plane has v's centre on its outer side and all of the set
  // on its inner side; of several the one nearest to `wish`. Where v is inside: the facet it is
  // least deep below. +z where there is no hull.
  Eigen::Vector3d clearNormal(std::size_t v, const Eigen::Vector3d& wish) const;

  // Corners, in cells (a voxel's centre is at its whole index), of the facet v is least deep below.
  // Precondition: there is a hull.
  std::array<Eigen::Vector3d, 3> facetOver(std::size_t v) const;

  std::size_t facetCount() const { return facets_.size(); }

private:
  struct Row {
    std::int32_t low = 0, high = -1; // first and last i present; high < low: none
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
    int firstW = 0, lastW = -1;             // rows that may have ends
    std::vector<Ends> ends;
    const Ends& at(const std::array<std::int16_t, 3>& cell) const {
      return ends[static_cast<std::size_t>(cell[static_cast<std::size_t>(u)] +
                                           sizeU * cell[static_cast<std::size_t>(w)])];
    }
  };
  void touch(std::size_t v);
  void refreshRow(std::size_t row);
  void refreshSlice(std::size_t k);
  void gatherCandidates();
  const std::vector<std::int32_t>& belowSurface(double depth);
  void rasterise(std::size_t facet, int axis);
  LatticePoint inCells(const LatticePoint& p) const;
  // Distance of p below the plane of a facet times the length of its normal.
  double below(std::size_t facet, const LatticePoint& p) const;

  const VoxelGraph& graph_;
  std::vector<std::uint8_t> present_;
  std::size_t count_ = 0;
  std::vector<Row> rows_;
  std::vector<std::vector<std::array<std::int32_t, 2>>> slice_; // per k: hull of the rows' ends
  std::vector<std::uint8_t> sliceDirty_;
  std::vector<LatticePoint> candidates_;
  std::vector<HullFacet> facets_;
  // Planes in blocks, structure of arrays; padded with planes that everything is far below.
  std::vector<double> nx_, ny_, nz_, offset_, inverseLength_;
  std::vector<double> planeInCells_; // per facet: offset with a voxel's cell as its coordinates
  std::array<Surface, 3> surface_;
  std::vector<std::int32_t> below_;
  std::vector<std::uint32_t> stamp_;
  std::uint32_t round_ = 0;
};

} // namespace voluta::curved
