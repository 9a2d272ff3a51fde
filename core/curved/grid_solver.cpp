#include "curved/grid_solver.h"

#include "base/error.h"
#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voluta::curved {

namespace {

constexpr std::size_t kGrain = 16384;
constexpr std::size_t kCoarsest = 64;
constexpr int kCoarsestSweeps = 20;

double dot(const std::vector<float>& a, const std::vector<float>& b, const base::RunContext& ctx) {
  return base::parallelSum<double>(ctx, a.size(), kGrain, 0.0, [&](std::size_t i, std::size_t end) {
    double sum = 0.0;
    for (; i < end; ++i)
      sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum;
  });
}

using Cell = std::array<std::int32_t, 3>;

// Numbers of cells, even i + j + k first, otherwise in the given order.
std::vector<std::int32_t> redFirstOrder(const std::vector<Cell>& cells, std::size_t& reds) {
  std::vector<std::int32_t> place(cells.size());
  const auto red = [](const Cell& c) { return (c[0] + c[1] + c[2]) % 2 == 0; };
  reds = static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), red));
  std::int32_t nextRed = 0, nextBlack = static_cast<std::int32_t>(reds);
  for (std::size_t c = 0; c < cells.size(); ++c)
    place[c] = red(cells[c]) ? nextRed++ : nextBlack++;
  return place;
}

} // namespace

GridSolver::Level GridSolver::finestLevel(const VoxelGraph& graph, std::vector<Cell>& placed) {
  const std::size_t n = graph.size();
  std::vector<Cell> cells(n);
  for (std::size_t v = 0; v < n; ++v)
    cells[v] = {graph.cell[v][0], graph.cell[v][1], graph.cell[v][2] - graph.plateLayer};
  Level finest;
  place_ = redFirstOrder(cells, finest.reds);
  finest.neighbour.resize(n);
  finest.weight.resize(n);
  finest.tie.resize(n);
  placed.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    const auto at = static_cast<std::size_t>(place_[v]);
    placed[at] = cells[v];
    finest.tie[at] = graph.onPlatform[v] ? 2.0f : 0.0f;
    for (std::size_t s = 0; s < 6; ++s) {
      const std::int32_t w = graph.neighbour[v][s];
      finest.neighbour[at][s] = w < 0 ? -1 : place_[static_cast<std::size_t>(w)];
      finest.weight[at][s] = w < 0 ? 0.0f : 1.0f;
    }
  }
  return finest;
}

// Which cell of two each way a cell is in, and what that takes from it. `placed`: of the cells of
// the fine level, then of the coarse one's. `size` as they.
GridSolver::Level GridSolver::coarserLevel(Level& fine, std::vector<Cell>& placed,
                                           Eigen::Vector3i& size) {
  const voxel::VoxelGrid half{.size = (size + Eigen::Vector3i::Ones()) / 2};
  const auto indexOf = [&](const Cell& c) { return half.index(c[0] / 2, c[1] / 2, c[2] / 2); };
  std::vector<std::int32_t> number(half.cellCount(), -1);
  std::vector<Cell> cells;
  for (const Cell& c : placed)
    if (std::int32_t& at = number[indexOf(c)]; at < 0) {
      at = 0;
      cells.push_back({c[0] / 2, c[1] / 2, c[2] / 2});
    }
  std::sort(cells.begin(), cells.end(), [](const Cell& a, const Cell& b) {
    return std::tie(a[2], a[1], a[0]) < std::tie(b[2], b[1], b[0]);
  });
  Level coarse;
  const std::vector<std::int32_t> place = redFirstOrder(cells, coarse.reds);
  std::vector<Cell> coarsePlaced(cells.size());
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const Cell doubled{2 * cells[c][0], 2 * cells[c][1], 2 * cells[c][2]};
    number[indexOf(doubled)] = place[c];
    coarsePlaced[static_cast<std::size_t>(place[c])] = cells[c];
  }
  fine.coarse.resize(fine.size());
  for (std::size_t c = 0; c < fine.size(); ++c)
    fine.coarse[c] = number[indexOf(placed[c])];
  sumUp(fine, cells.size(), coarse);
  placed = std::move(coarsePlaced);
  size = half.size;
  return coarse;
}

void GridSolver::sumUp(const Level& fine, std::size_t cells, Level& coarse) {
  coarse.neighbour.assign(cells, {-1, -1, -1, -1, -1, -1});
  coarse.weight.assign(cells, {});
  coarse.tie.assign(cells, 0.0f);
  for (std::size_t c = 0; c < fine.size(); ++c) {
    const auto parent = static_cast<std::size_t>(fine.coarse[c]);
    coarse.tie[parent] += 0.5f * fine.tie[c];
    for (std::size_t s = 0; s < 6; ++s) {
      const std::int32_t w = fine.neighbour[c][s];
      if (w < 0 || fine.coarse[static_cast<std::size_t>(w)] == fine.coarse[c])
        continue;
      coarse.neighbour[parent][s] = fine.coarse[static_cast<std::size_t>(w)];
      coarse.weight[parent][s] += 0.5f * fine.weight[c][s];
    }
  }
}

GridSolver::GridSolver(const VoxelGraph& graph) {
  std::vector<Cell> placed;
  levels_.push_back(finestLevel(graph, placed));
  Eigen::Vector3i size = graph.grid.size;
  while (levels_.back().size() > kCoarsest && levels_.size() < 12) {
    Level coarse = coarserLevel(levels_.back(), placed, size);
    levels_.push_back(std::move(coarse));
  }
  for (Level& level : levels_) {
    level.x.resize(level.size());
    level.b.resize(level.size());
    level.r.resize(level.size());
  }
  for (std::vector<float>* v : {&rhs_, &value_, &residual_, &direction_, &product_})
    v->resize(graph.size());
  setScreen(std::vector<float>(graph.size(), 0.0f));
}

void GridSolver::setScreen(const std::vector<float>& screen) {
  base::require(screen.size() == place_.size(), "GridSolver: one screen value a voxel");
  levels_[0].screen.resize(screen.size());
  for (std::size_t v = 0; v < screen.size(); ++v)
    levels_[0].screen[static_cast<std::size_t>(place_[v])] = screen[v];
  for (std::size_t l = 0; l < levels_.size(); ++l) {
    Level& level = levels_[l];
    if (l > 0) {
      const Level& fine = levels_[l - 1];
      level.screen.assign(level.size(), 0.0f);
      for (std::size_t c = 0; c < fine.size(); ++c)
        level.screen[static_cast<std::size_t>(fine.coarse[c])] += fine.screen[c];
    }
    level.inverseDiagonal.resize(level.size());
    for (std::size_t c = 0; c < level.size(); ++c) {
      float diagonal = level.tie[c] + level.screen[c];
      for (const float w : level.weight[c])
        diagonal += w;
      level.inverseDiagonal[c] = diagonal > 0.0f ? 1.0f / diagonal : 0.0f;
    }
  }
}

void GridSolver::sweep(Level& level, std::size_t begin, std::size_t end,
                       const base::RunContext& ctx) const {
  base::parallelChunks(ctx, end - begin, kGrain, [&](std::size_t from, std::size_t to) {
    for (std::size_t c = begin + from; c < begin + to; ++c) {
      float sum = level.b[c];
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = level.neighbour[c][s]; w >= 0)
          sum += level.weight[c][s] * level.x[static_cast<std::size_t>(w)];
      level.x[c] = sum * level.inverseDiagonal[c];
    }
  });
}

void GridSolver::smooth(Level& level, bool redFirst, const base::RunContext& ctx) const {
  if (redFirst)
    sweep(level, 0, level.reds, ctx);
  sweep(level, level.reds, level.size(), ctx);
  if (!redFirst)
    sweep(level, 0, level.reds, ctx);
}

void GridSolver::residual(Level& level, const base::RunContext& ctx) const {
  base::parallelChunks(ctx, level.size(), kGrain, [&](std::size_t from, std::size_t to) {
    for (std::size_t c = from; c < to; ++c) {
      float diagonal = level.tie[c] + level.screen[c], sum = level.b[c];
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = level.neighbour[c][s]; w >= 0) {
          sum += level.weight[c][s] * level.x[static_cast<std::size_t>(w)];
          diagonal += level.weight[c][s];
        }
      level.r[c] = sum - diagonal * level.x[c];
    }
  });
}

void GridSolver::cycle(std::size_t depth, const base::RunContext& ctx) {
  Level& level = levels_[depth];
  std::fill(level.x.begin(), level.x.end(), 0.0f);
  if (depth + 1 == levels_.size()) {
    for (int i = 0; i < kCoarsestSweeps; ++i)
      smooth(level, true, ctx);
    for (int i = 0; i < kCoarsestSweeps; ++i)
      smooth(level, false, ctx);
    return;
  }
  smooth(level, true, ctx);
  residual(level, ctx);
  Level& coarse = levels_[depth + 1];
  std::fill(coarse.b.begin(), coarse.b.end(), 0.0f);
  for (std::size_t c = 0; c < level.size(); ++c)
    coarse.b[static_cast<std::size_t>(level.coarse[c])] += level.r[c];
  cycle(depth + 1, ctx);
  for (std::size_t c = 0; c < level.size(); ++c)
    level.x[c] += coarse.x[static_cast<std::size_t>(level.coarse[c])];
  smooth(level, false, ctx);
}

void GridSolver::multiply(const std::vector<float>& x, std::vector<float>& out,
                          const base::RunContext& ctx) const {
  const Level& level = levels_[0];
  base::parallelChunks(ctx, level.size(), kGrain, [&](std::size_t from, std::size_t to) {
    for (std::size_t c = from; c < to; ++c) {
      float sum = (level.tie[c] + level.screen[c]) * x[c];
      for (std::size_t s = 0; s < 6; ++s)
        if (const std::int32_t w = level.neighbour[c][s]; w >= 0)
          sum += level.weight[c][s] * (x[c] - x[static_cast<std::size_t>(w)]);
      out[c] = sum;
    }
  });
}

int GridSolver::solve(const std::vector<float>& b, std::vector<float>& x, double relative,
                      int iterations, const base::RunContext& ctx) {
  const std::size_t n = place_.size();
  base::require(b.size() == n && x.size() == n, "GridSolver: one value a voxel");
  for (std::size_t v = 0; v < n; ++v) {
    rhs_[static_cast<std::size_t>(place_[v])] = b[v];
    value_[static_cast<std::size_t>(place_[v])] = x[v];
  }
  multiply(value_, product_, ctx);
  for (std::size_t i = 0; i < n; ++i)
    residual_[i] = rhs_[i] - product_[i];
  const double stop = relative * std::sqrt(dot(rhs_, rhs_, ctx));
  double previous = 0.0;
  int done = 0;
  while (done < iterations && std::sqrt(dot(residual_, residual_, ctx)) > stop) {
    levels_[0].b = residual_;
    cycle(0, ctx);
    const std::vector<float>& z = levels_[0].x;
    const double rz = dot(residual_, z, ctx);
    const auto beta = static_cast<float>(done == 0 ? 0.0 : rz / previous);
    for (std::size_t i = 0; i < n; ++i)
      direction_[i] = z[i] + beta * direction_[i];
    multiply(direction_, product_, ctx);
    const double curvature = dot(direction_, product_, ctx);
    if (!(curvature > 0.0))
      break;
    const auto step = static_cast<float>(rz / curvature);
    for (std::size_t i = 0; i < n; ++i) {
      value_[i] += step * direction_[i];
      residual_[i] -= step * product_[i];
    }
    previous = rz;
    ++done;
  }
  for (std::size_t v = 0; v < n; ++v)
    x[v] = value_[static_cast<std::size_t>(place_[v])];
  return done;
}

} // namespace voluta::curved
