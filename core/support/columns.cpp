#include "support/columns.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <queue>
#include <unordered_map>

namespace voluta::support {

namespace {

// Costs count halves of a cell, so that sums are exact.
constexpr int kCell = 2, kAside = 4, kSideFace = 12, kNear = 1, kOnPart = 16;

// From a cell to the next of a column: down first, so that straight columns win among equals.
const std::array<Eigen::Vector3i, 5> kStep{
    {{0, 0, -1}, {-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}}};
const std::array<Eigen::Vector3i, 6> kFace{
    {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};

bool isPart(Cell c) {
  return c == Cell::Part || c == Cell::Footing;
}
bool isFree(Cell c) {
  return c == Cell::Empty || c == Cell::Plate;
}

class Search {
public:
  Search(const voxel::VoxelGrid& grid, const std::vector<Cell>& cells, const base::RunContext& ctx)
      : grid_(grid), cells_(cells), ctx_(ctx) {}

  std::optional<Column> run(const std::vector<std::size_t>& carried) {
    for (const std::size_t c : carried) {
      const Eigen::Vector3i below = grid_.cell(c) - Eigen::Vector3i::UnitZ();
      if (isFree(at(below)))
        offer(index(below), kNone, kCell + touching(below, Eigen::Vector3i::UnitZ()));
    }
    for (std::size_t steps = 0; !open_.empty(); ++steps) {
      if (steps % 4096 == 0)
        ctx_.checkpoint();
      const auto [cost, cell, ends] = open_.top();
      open_.pop();
      if (ends)
        return column(cell);
      if (cost > known_.at(cell).cost)
        continue;
      spread(cell, cost);
    }
    return std::nullopt;
  }

private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Known {
    int cost;
    std::size_t before;
  };
  struct Open {
    int cost;
    std::size_t cell;
    bool ends;
    bool operator<(const Open& other) const { // least cost on top, then least cell
      if (cost != other.cost)
        return cost > other.cost;
      return cell != other.cell ? cell > other.cell : ends < other.ends;
    }
  };

  std::size_t index(const Eigen::Vector3i& c) const { return grid_.index(c.x(), c.y(), c.z()); }
  Cell at(const Eigen::Vector3i& c) const {
    return grid_.contains(c.x(), c.y(), c.z()) ? cells_[index(c)] : Cell::Closed;
  }

  // Price of the part around a cell of a column; `but`: the face that is meant to touch.
  int touching(const Eigen::Vector3i& c, const Eigen::Vector3i& but) const {
    int cost = 0;
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      if (step.isZero() || !isPart(at(c + step)))
        continue;
      // What lies beside the meant face cannot be kept off.
      if (step == but || (!but.isZero() && step.dot(but) > 0))
        continue;
      cost += step.cwiseAbs().sum() == 1 ? kSideFace : kNear;
    }
    return cost;
  }

  void offer(std::size_t cell, std::size_t before, int cost) {
    const auto [entry, isNew] = known_.try_emplace(cell, Known{cost, before});
    if (!isNew) {
      if (entry->second.cost <= cost)
        return;
      entry->second = {cost, before};
    }
    open_.push({cost, cell, false});
    if (cells_[cell] == Cell::Plate)
      open_.push({cost, cell, true});
    const Cell below = at(grid_.cell(cell) - Eigen::Vector3i::UnitZ());
    if (below == Cell::Support)
      open_.push({cost, cell, true});
    if (below == Cell::Footing) // its face was priced as a side's
      open_.push({cost - kSideFace + kOnPart, cell, true});
  }

  void spread(std::size_t cell, int cost) {
    const Eigen::Vector3i c = grid_.cell(cell);
    for (const Eigen::Vector3i& step : kStep) {
      const Eigen::Vector3i to = c + step;
      if (isFree(at(to)))
        offer(index(to), cell,
              cost + kCell + (step.z() == 0 ? kAside : 0) + touching(to, Eigen::Vector3i::Zero()));
    }
  }

  Column column(std::size_t foot) const {
    Column out;
    for (std::size_t c = foot; c != kNone; c = known_.at(c).before)
      out.cells.push_back(c);
    std::reverse(out.cells.begin(), out.cells.end());
    out.foot = grid_.cell(foot);
    out.top = grid_.cell(out.cells.front());
    const Cell below = at(out.foot - Eigen::Vector3i::UnitZ());
    out.standsOn = cells_[foot] == Cell::Plate ? Column::Foot::Platform
                   : below == Cell::Support    ? Column::Foot::Support
                                               : Column::Foot::Part;
    for (const std::size_t c : out.cells)
      for (const Eigen::Vector3i& face : kFace) {
        const bool carries = c == out.cells.front() && face.z() > 0;
        const bool stands = c == foot && face.z() < 0;
        if (!carries && !stands && isPart(at(grid_.cell(c) + face)))
          ++out.sideFaces;
      }
    return out;
  }

  const voxel::VoxelGrid& grid_;
  const std::vector<Cell>& cells_;
  const base::RunContext& ctx_;
  std::unordered_map<std::size_t, Known> known_;
  std::priority_queue<Open> open_;
};

} // namespace

std::optional<Column> cheapestColumn(const voxel::VoxelGrid& grid, const std::vector<Cell>& cells,
                                     const std::vector<std::size_t>& carried,
                                     const base::RunContext& ctx) {
  base::require(cells.size() == grid.cellCount(), "cheapestColumn: one entry a cell");
  return Search(grid, cells, ctx).run(carried);
}

} // namespace voluta::support
