// Screened Poisson equations on the part's voxels, solved by conjugate gradients with multigrid.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"

#include <array>
#include <cstdint>
#include <vector>

namespace voluta::curved {

// Solves (L + P + diag(screen)) x = b, where L is the graph Laplacian over the faces of voxels and
// P ties voxels on the platform to 0 half a cell below them (weight 2). Symmetric and positive
// definite as long as each component is tied or screened.
//
// Preconditioner: one V-cycle. Cells of a coarser grid contain 2 x 2 x 2 of the finer one, values
// are constant on them, and weights are halved, as the distance between centres doubles
// (Trottenberg et al., Multigrid, 2.8). Red-black Gauss-Seidel before, black-red after, so it is
// symmetric. The result does not depend on the number of threads.
class GridSolver {
public:
  explicit GridSolver(const VoxelGraph& graph);

  // Sets the diagonal, >= 0, one value per voxel.
  void setScreen(const std::vector<float>& screen);

  // Improves x until the residual has fallen to `relative` of |b| or after `iterations`. Returns
  // the number of iterations. Throws Cancelled.
  int solve(const std::vector<float>& b, std::vector<float>& x, double relative, int iterations,
            const base::RunContext& ctx);

private:
  // Every other cell of a row of the grid whose neighbours are consecutive too: in each direction
  // they start at `neighbour`; negative: none. Sums over the faces then read whole rows, without an
  // index per face.
  struct Run {
    std::int32_t begin = 0, count = 0;
    std::array<std::int32_t, 6> neighbour{};
  };
  struct Level {
    std::vector<Run> runs;
    std::size_t reds = 0, redRuns = 0; // Cells and runs [0, this number) have an even i + j + k
    std::array<std::vector<float>, 6> weight; // 0 where there is no neighbour; empty: 1 each
    std::vector<float> tie;                   // To the platform
    std::vector<float> screen, held;          // held: tie and screen
    std::vector<float> diagonal, inverseDiagonal;
    // Cells of this level in each cell c of the coarser one: [firstOf[c], firstOf[c + 1]) of
    // `finer`, ascending. coarse: for each cell, its cell in the coarser level.
    std::vector<std::int32_t> firstOf, finer, coarse;
    std::vector<float> x, b, r;
    std::size_t size() const { return tie.size(); }
  };

  using Cell = std::array<std::int32_t, 3>;
  using Neighbours = std::vector<std::array<std::int32_t, 6>>;
  struct Cells {
    std::vector<Cell> at;
    Neighbours neighbour; // -1: none
    std::size_t reds = 0;
  };
  Level finestLevel(const VoxelGraph& graph, Cells& cells);
  static Level coarserLevel(Level& fine, Cells& cells, Eigen::Vector3i& size);
  static void sumUp(const Level& fine, const Neighbours& fineNeighbour, Level& coarse,
                    Neighbours& neighbour);
  static void findRuns(const Cells& cells, Level& level);
  void smooth(Level& level, bool redFirst, const base::RunContext& ctx) const;
  void sweep(Level& level, std::size_t begin, std::size_t end, const base::RunContext& ctx) const;
  void residual(Level& level, const base::RunContext& ctx) const;
  void cycle(std::size_t depth, const base::RunContext& ctx);
  void multiply(const std::vector<float>& x, std::vector<float>& out,
                const base::RunContext& ctx) const;

  std::vector<Level> levels_;
  std::vector<std::int32_t> place_; // Index of a voxel in level 0
  std::vector<float> rhs_, value_, direction_, product_;
};

} // namespace voluta::curved
