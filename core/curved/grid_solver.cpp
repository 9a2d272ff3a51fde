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
constexpr int kRun = 64;
constexpr std::size_t kRunGrain = 1024;

double dot(const std::vector<float>& a, const std::vector<float>& b, const base::RunContext& ctx) {
  return base::parallelSum<double>(ctx, a.size(), kGrain, 0.0, [&](std::size_t i, std::size_t end) {
    double sum = 0.0;
    for (; i < end; ++i)
      sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return sum;
  });
}

using Cell = std::array<std::int32_t, 3>;

// Returns the cells' new numbers: even i + j + k first, otherwise in the given order.
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

GridSolver::Level GridSolver::finestLevel(const VoxelGraph& graph, Cells& cells) {
  const std::size_t n = graph.size();
  std::vector<Cell> at(n);
  for (std::size_t v = 0; v < n; ++v)
    at[v] = {graph.cell[v][0], graph.cell[v][1], graph.cell[v][2] - graph.plateLayer};
  Level finest;
  place_ = redFirstOrder(at, cells.reds);
  finest.tie.resize(n);
  cells.at.resize(n);
  cells.neighbour.resize(n);
  for (std::size_t v = 0; v < n; ++v) {
    const auto p = static_cast<std::size_t>(place_[v]);
    cells.at[p] = at[v];
    finest.tie[p] = graph.onPlatform[v] ? 2.0f : 0.0f;
    for (std::size_t s = 0; s < 6; ++s) {
      const std::int32_t w = graph.neighbour[v][s];
      cells.neighbour[p][s] = w < 0 ? -1 : place_[static_cast<std::size_t>(w)];
    }
  }
  findRuns(cells, finest);
  return finest;
}

// Builds the coarser level, which merges 2 x 2 x 2 cells, and links the fine level to it. `cells`
// and `size` are those of the fine level on entry and of the coarser one on return.
GridSolver::Level GridSolver::coarserLevel(Level& fine, Cells& cells, Eigen::Vector3i& size) {
  const voxel::VoxelGrid half{.size = (size + Eigen::Vector3i::Ones()) / 2};
  const auto indexOf = [&](const Cell& c) { return half.index(c[0] / 2, c[1] / 2, c[2] / 2); };
  std::vector<std::int32_t> number(half.cellCount(), -1);
  std::vector<Cell> at;
  for (const Cell& c : cells.at)
    if (std::int32_t& n = number[indexOf(c)]; n < 0) {
      n = 0;
      at.push_back({c[0] / 2, c[1] / 2, c[2] / 2});
    }
  std::sort(at.begin(), at.end(), [](const Cell& a, const Cell& b) {
    return std::tie(a[2], a[1], a[0]) < std::tie(b[2], b[1], b[0]);
  });
  Level coarse;
  Cells coarser;
  const std::vector<std::int32_t> place = redFirstOrder(at, coarser.reds);
  coarser.at.resize(at.size());
  for (std::size_t c = 0; c < at.size(); ++c) {
    const Cell doubled{2 * at[c][0], 2 * at[c][1], 2 * at[c][2]};
    number[indexOf(doubled)] = place[c];
    coarser.at[static_cast<std::size_t>(place[c])] = at[c];
  }
  fine.coarse.resize(fine.size());
  fine.firstOf.assign(at.size() + 1, 0);
  for (std::size_t c = 0; c < fine.size(); ++c) {
    fine.coarse[c] = number[indexOf(cells.at[c])];
    ++fine.firstOf[static_cast<std::size_t>(fine.coarse[c]) + 1];
  }
  std::partial_sum(fine.firstOf.begin(), fine.firstOf.end(), fine.firstOf.begin());
  fine.finer.resize(fine.size());
  std::vector<std::int32_t> next = fine.firstOf;
  for (std::size_t c = 0; c < fine.size(); ++c) {
    std::int32_t& to = next[static_cast<std::size_t>(fine.coarse[c])];
    fine.finer[static_cast<std::size_t>(to++)] = static_cast<std::int32_t>(c);
  }
  sumUp(fine, cells.neighbour, coarse, coarser.neighbour);
  findRuns(coarser, coarse);
  cells = std::move(coarser);
  size = half.size;
  return coarse;
}

void GridSolver::sumUp(const Level& fine, const Neighbours& fineNeighbour, Level& coarse,
                       Neighbours& neighbour) {
  const std::size_t cells = fine.firstOf.size() - 1;
  neighbour.assign(cells, {-1, -1, -1, -1, -1, -1});
  for (std::vector<float>& weight : coarse.weight)
    weight.assign(cells, 0.0f);
  coarse.tie.assign(cells, 0.0f);
  for (std::size_t c = 0; c < fine.size(); ++c) {
    const auto parent = static_cast<std::size_t>(fine.coarse[c]);
    coarse.tie[parent] += 0.5f * fine.tie[c];
    for (std::size_t s = 0; s < 6; ++s) {
      const std::int32_t w = fineNeighbour[c][s];
      if (w < 0 || fine.coarse[static_cast<std::size_t>(w)] == fine.coarse[c])
        continue;
      neighbour[parent][s] = fine.coarse[static_cast<std::size_t>(w)];
      coarse.weight[s][parent] += fine.weight[s].empty() ? 0.5f : 0.5f * fine.weight[s][c];
    }
  }
}

void GridSolver::findRuns(const Cells& cells, Level& level) {
  const auto continues = [&](const Run& run, std::size_t c) {
    if (run.count == kRun || c == cells.reds)
      return false;
    for (std::size_t s = 0; s < 6; ++s) {
      const std::int32_t w = cells.neighbour[c][s];
      if (run.neighbour[s] < 0 ? w >= 0 : w != run.neighbour[s] + run.count)
        return false;
    }
    return true;
  };
  level.reds = cells.reds;
  for (std::size_t c = 0; c < cells.at.size(); ++c) {
    if (level.runs.empty() || !continues(level.runs.back(), c)) {
      if (c == cells.reds)
        level.redRuns = level.runs.size();
      level.runs.push_back({static_cast<std::int32_t>(c), 0, cells.neighbour[c]});
    }
    ++level.runs.back().count;
  }
  if (cells.reds == cells.at.size())
    level.redRuns = level.runs.size();
}

GridSolver::GridSolver(const VoxelGraph& graph) {
  Cells cells;
  levels_.push_back(finestLevel(graph, cells));
  Eigen::Vector3i size = graph.grid.size;
  while (levels_.back().size() > kCoarsest && levels_.size() < 12) {
    Level coarse = coarserLevel(levels_.back(), cells, size);
    levels_.push_back(std::move(coarse));
  }
  for (Level& level : levels_) {
    level.x.resize(level.size());
    level.b.resize(level.size());
    level.r.resize(level.size());
  }
  for (std::vector<float>* v : {&rhs_, &value_, &direction_, &product_})
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
    level.held.resize(level.size());
    level.diagonal.resize(level.size());
    level.inverseDiagonal.resize(level.size());
    for (std::size_t c = 0; c < level.size(); ++c)
      level.held[c] = level.diagonal[c] = level.tie[c] + level.screen[c];
    for (const Run& run : level.runs)
      for (std::size_t s = 0; s < 6; ++s)
        if (run.neighbour[s] >= 0)
          for (auto c = static_cast<std::size_t>(run.begin), i = std::size_t{0};
               i < static_cast<std::size_t>(run.count); ++i)
            level.diagonal[c + i] += level.weight[s].empty() ? 1.0f : level.weight[s][c + i];
    for (std::size_t c = 0; c < level.size(); ++c)
      level.inverseDiagonal[c] = level.diagonal[c] > 0.0f ? 1.0f / level.diagonal[c] : 0.0f;
  }
}

namespace {

constexpr std::array<float, kRun> kNothing{};

// Returns pointers to the rows of neighbours of a run's cells; `none` replaces missing rows.
template <typename Run>
std::array<const float*, 6> rowsBeside(const Run& run, const float* x, const float* none) {
  std::array<const float*, 6> row{};
  for (std::size_t s = 0; s < 6; ++s)
    row[s] = run.neighbour[s] < 0 ? none : x + run.neighbour[s];
  return row;
}

// out = b + sum of weight x over the faces, for the cells of a run.
template <typename Level, typename Run>
void sumRun(const Level& level, const Run& run, std::array<float, kRun>& out) {
  const auto row = rowsBeside(run, level.x.data(), kNothing.data());
  const float* b = level.b.data() + run.begin;
  if (level.weight[0].empty()) {
    for (int i = 0; i < run.count; ++i)
      out[static_cast<std::size_t>(i)] =
          b[i] + row[0][i] + row[1][i] + row[2][i] + row[3][i] + row[4][i] + row[5][i];
    return;
  }
  std::array<const float*, 6> w{};
  for (std::size_t s = 0; s < 6; ++s)
    w[s] = level.weight[s].data() + run.begin;
  for (int i = 0; i < run.count; ++i)
    out[static_cast<std::size_t>(i)] = b[i] + w[0][i] * row[0][i] + w[1][i] * row[1][i] +
                                       w[2][i] * row[2][i] + w[3][i] * row[3][i] +
                                       w[4][i] * row[4][i] + w[5][i] * row[5][i];
}

} // namespace

void GridSolver::sweep(Level& level, std::size_t begin, std::size_t end,
                       const base::RunContext& ctx) const {
  base::parallelChunks(ctx, end - begin, kRunGrain, [&](std::size_t from, std::size_t to) {
    std::array<float, kRun> sum;
    for (std::size_t n = begin + from; n < begin + to; ++n) {
      const Run& run = level.runs[n];
      sumRun(level, run, sum);
      float* x = level.x.data() + run.begin;
      const float* inverse = level.inverseDiagonal.data() + run.begin;
      for (int i = 0; i < run.count; ++i)
        x[i] = sum[static_cast<std::size_t>(i)] * inverse[i];
    }
  });
}

void GridSolver::smooth(Level& level, bool redFirst, const base::RunContext& ctx) const {
  if (redFirst)
    sweep(level, 0, level.redRuns, ctx);
  sweep(level, level.redRuns, level.runs.size(), ctx);
  if (!redFirst)
    sweep(level, 0, level.redRuns, ctx);
}

void GridSolver::residual(Level& level, const base::RunContext& ctx) const {
  base::parallelChunks(ctx, level.runs.size(), kRunGrain, [&](std::size_t from, std::size_t to) {
    std::array<float, kRun> sum;
    for (std::size_t n = from; n < to; ++n) {
      const Run& run = level.runs[n];
      sumRun(level, run, sum);
      const float *x = level.x.data() + run.begin, *diagonal = level.diagonal.data() + run.begin;
      float* r = level.r.data() + run.begin;
      for (int i = 0; i < run.count; ++i)
        r[i] = sum[static_cast<std::size_t>(i)] - diagonal[i] * x[i];
    }
  });
}

void GridSolver::cycle(std::size_t depth, const base::RunContext& ctx) {
  Level& level = levels_[depth];
  if (depth + 1 == levels_.size()) {
    std::fill(level.x.begin(), level.x.end(), 0.0f);
    for (int i = 0; i < kCoarsestSweeps; ++i)
      smooth(level, true, ctx);
    for (int i = 0; i < kCoarsestSweeps; ++i)
      smooth(level, false, ctx);
    return;
  }
  // The sweep starts from zero, so all neighbours of a red cell are zero.
  base::parallelChunks(ctx, level.reds, kGrain, [&](std::size_t from, std::size_t to) {
    for (std::size_t c = from; c < to; ++c)
      level.x[c] = level.b[c] * level.inverseDiagonal[c];
  });
  sweep(level, level.redRuns, level.runs.size(), ctx);
  residual(level, ctx);
  Level& coarse = levels_[depth + 1];
  base::parallelChunks(ctx, coarse.size(), kGrain / 8, [&](std::size_t from, std::size_t to) {
    for (std::size_t c = from; c < to; ++c) {
      float sum = 0.0f;
      for (std::int32_t f = level.firstOf[c]; f < level.firstOf[c + 1]; ++f)
        sum += level.r[static_cast<std::size_t>(level.finer[static_cast<std::size_t>(f)])];
      coarse.b[c] = sum;
    }
  });
  cycle(depth + 1, ctx);
  base::parallelChunks(ctx, level.size(), kGrain, [&](std::size_t from, std::size_t to) {
    for (std::size_t c = from; c < to; ++c)
      level.x[c] += coarse.x[static_cast<std::size_t>(level.coarse[c])];
  });
  smooth(level, false, ctx);
}

void GridSolver::multiply(const std::vector<float>& x, std::vector<float>& out,
                          const base::RunContext& ctx) const {
  const Level& level = levels_[0];
  base::parallelChunks(ctx, level.runs.size(), kRunGrain, [&](std::size_t from, std::size_t to) {
    for (std::size_t n = from; n < to; ++n) {
      const Run& run = level.runs[n];
      const float *own = x.data() + run.begin, *held = level.held.data() + run.begin;
      const auto row = rowsBeside(run, x.data(), own);
      float* sum = out.data() + run.begin;
      for (int i = 0; i < run.count; ++i)
        sum[i] = held[i] * own[i] + (own[i] - row[0][i]) + (own[i] - row[1][i]) +
                 (own[i] - row[2][i]) + (own[i] - row[3][i]) + (own[i] - row[4][i]) +
                 (own[i] - row[5][i]);
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
  std::vector<float>& residual = levels_[0].b;
  multiply(value_, product_, ctx);
  for (std::size_t i = 0; i < n; ++i)
    residual[i] = rhs_[i] - product_[i];
  const double stop = relative * std::sqrt(dot(rhs_, rhs_, ctx));
  double previous = 0.0;
  int done = 0;
  while (done < iterations && std::sqrt(dot(residual, residual, ctx)) > stop) {
    cycle(0, ctx);
    const std::vector<float>& z = levels_[0].x;
    const double rz = dot(residual, z, ctx);
    const auto beta = static_cast<float>(done == 0 ? 0.0 : rz / previous);
    base::parallelChunks(ctx, n, kGrain, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i)
        direction_[i] = z[i] + beta * direction_[i];
    });
    multiply(direction_, product_, ctx);
    const double curvature = dot(direction_, product_, ctx);
    if (!(curvature > 0.0))
      break;
    const auto step = static_cast<float>(rz / curvature);
    base::parallelChunks(ctx, n, kGrain, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) {
        value_[i] += step * direction_[i];
        residual[i] -= step * product_[i];
      }
    });
    previous = rz;
    ++done;
  }
  for (std::size_t v = 0; v < n; ++v)
    x[v] = value_[static_cast<std::size_t>(place_[v])];
  return done;
}

} // namespace voluta::curved
