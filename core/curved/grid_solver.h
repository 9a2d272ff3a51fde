// Screened Poisson equations on the part's voxels, by conjugate gradients with multigrid.
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
// Preconditioner: one V-cycle; cells of a coarser grid hold 2 x 2 x 2 of the finer one, values are
// constant on them, and weights are halved, as the distance between centres doubles (Trottenberg
// et al., Multigrid, 2.8). Red-black Gauss-Seidel before, black-red after, so it is symmetric. The
// same result for any number of threads.
class GridSolver {
public:
  explicit GridSolver(const VoxelGraph& graph);

  // Takes the diagonal, >= 0, one a voxel.
  void setScreen(const std::vector<float>& screen);

  // Improves x until the residual has fallen to `relative` of |b| or after `iterations`; returns
  // the iterations it took. Throws Cancelled.
  int solve(const std::vector<float>& b, std::vector<float>& x, double relative, int iterations,
            const base::RunContext& ctx);

private:
  struct Level {
    std::vector<std::array<std::int32_t, 6>> neighbour; // -1: none
    std::vector<std::array<float, 6>> weight;
    std::vector<float> tie; // to the platform
    std::vector<float> screen, inverseDiagonal;
    std::vector<std::int32_t> coarse; // cell of the coarser level
    std::size_t reds = 0;             // cells [0, reds) have an even i + j + k
    std::vector<float> x, b, r;
    std::size_t size() const { return tie.size(); }
  };

  using Cell = std::array<std::int32_t, 3>;
  Level finestLevel(const VoxelGraph& graph, std::vector<Cell>& placed);
  static Level coarserLevel(Level& fine, std::vector<Cell>& placed, Eigen::Vector3i& size);
  static void sumUp(const Level& fine, std::size_t cells, Level& coarse);
  void smooth(Level& level, bool redFirst, const base::RunContext& ctx) const;
  void sweep(Level& level, std::size_t begin, std::size_t end, const base::RunContext& ctx) const;
  void residual(Level& level, const base::RunContext& ctx) const;
  void cycle(std::size_t depth, const base::RunContext& ctx);
  void multiply(const std::vector<float>& x, std::vector<float>& out,
                const base::RunContext& ctx) const;

  std::vector<Level> levels_;
  std::vector<std::int32_t> place_; // of a voxel in level 0
  std::vector<float> rhs_, value_, residual_, direction_, product_;
};

} // namespace voluta::curved
