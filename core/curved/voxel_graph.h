// The part's voxels as a graph: indices, AM-stable neighbours and the platform.
#pragma once

#include "curved/convex_hull.h"
#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// Steps to the 18 AM-stable neighbours (definition 1: L1 distance 1 or 2 within one cell per axis,
// i.e. faces and edges but not corners). The first six are faces: -x +x -y +y -z +z.
inline constexpr int kNeighbours = 18;
extern const std::array<Eigen::Vector3i, kNeighbours> kNeighbourStep;
extern const std::array<float, kNeighbours> kNeighbourDistance; // in cells

// Lattice of the convex front: 16 units per cell, x and y from the grid's corner, z from the plate.
inline constexpr double kLatticePerCell = 16.0;

struct VoxelGraph {
  voxel::VoxelGrid grid;
  int plateLayer = 0;                            // k of the cells on the plate
  std::vector<std::int32_t> voxelAt;             // per cell of the grid, -1: no voxel
  std::vector<std::array<std::int16_t, 3>> cell; // per voxel, in grid order
  std::vector<std::array<std::int32_t, kNeighbours>> neighbour; // per voxel, -1: none
  std::vector<std::uint8_t> onPlatform;                         // per voxel: is on the platform
  std::vector<LatticePoint> platform;                           // corners on the lattice, z = 0

  std::size_t size() const { return cell.size(); }
  // Index in the grid.
  std::size_t cellOf(std::size_t v) const { return grid.index(cell[v][0], cell[v][1], cell[v][2]); }
  // Centre of a voxel on the front's lattice.
  LatticePoint lattice(std::size_t v) const {
    return {kLatticePerCell * cell[v][0] + 8.0, kLatticePerCell * cell[v][1] + 8.0,
            kLatticePerCell * (cell[v][2] - plateLayer) + 8.0};
  }
};

// A flat part, one cell deep in y, grows with the planar hull of its cells and the platform. Its
// front is the hull with a platform that extends this far to both sides, whose section with the
// plane of the cells is that planar hull.
inline constexpr double kFlatPlatformCells = 1000.0;

// Returns the graph of the cells with use[cell] != 0 above the plate. `platform` is a convex
// polygon on z = 0, mm, counter-clockwise; a voxel is on it if it belongs to the plate's layer and
// its centre is over the polygon or within 1e-6 cells of it. Preconditions (Error{Internal}): use
// has one entry per cell; the platform has at least 3 corners.
VoxelGraph voxelGraph(const voxel::VoxelGrid& grid, const std::vector<std::uint8_t>& use,
                      int plateLayer, const std::vector<Eigen::Vector2d>& platform);

} // namespace voluta::curved
