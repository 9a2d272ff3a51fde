#include "support/columns.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <queue>
#include <unordered_map>

namespace voluta::support {

namespace {

// Costs are in halves of a cell, so that sums are exact.
constexpr int kCell = 2, kLateral = 4, kSideFace = 12, kNear = 1, kOnPart = 16;

// From a cell to the next of a column: down first, so that straight columns win ties.
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
  Search(const voxel::VoxelGrid& grid, const std::vector<Cell>& cells, int maxLateralSteps,
         const base::RunContext& ctx)
      : grid_(grid), cells_(cells), maxLateralSteps_(maxLateralSteps), ctx_(ctx) {}

  std::optional<Column> run(const std::vector<std::size_t>& carried) {
    for (const std::size_t c : carried) {
      const Eigen::Vector3i below = grid_.cell(c) - Eigen::Vector3i::UnitZ();
      if (isFree(at(below)))
        offer(placeOf(index(below), 0), kNone, kCell + touching(below, Eigen::Vector3i::UnitZ()));
    }
    for (std::size_t steps = 0; !open_.empty(); ++steps) {
      if (steps % 4096 == 0)
        ctx_.checkpoint();
      const auto [cost, place, ends] = open_.top();
      open_.pop();
      if (ends)
        return column(place);
      if (cost > known_.at(place).cost)
        continue;
      spread(place, cost);
    }
    return std::nullopt;
  }

private:
  // A cell and the number of sideways steps since the last step down.
  using Place = std::size_t;
  static constexpr Place kNone = static_cast<Place>(-1);
  Place placeOf(std::size_t cell, int lateralSteps) const {
    return cell * (static_cast<std::size_t>(maxLateralSteps_) + 1) +
           static_cast<std::size_t>(lateralSteps);
  }
  std::size_t cellOf(Place place) const {
    return place / (static_cast<std::size_t>(maxLateralSteps_) + 1);
  }
  int lateralStepsOf(Place place) const {
    return static_cast<int>(place % (static_cast<std::size_t>(maxLateralSteps_) + 1));
  }
  struct Known {
    int cost;
    Place before;
  };
  struct Open {
    int cost;
    Place place;
    bool ends;
    bool operator<(const Open& other) const { // minimum cost on top, then smallest place
      if (cost != other.cost)
        return cost > other.cost;
      return place != other.place ? place > other.place : ends < other.ends;
    }
  };

  std::size_t index(const Eigen::Vector3i& c) const { return grid_.index(c.x(), c.y(), c.z()); }
  Cell at(const Eigen::Vector3i& c) const {
    return grid_.contains(c.x(), c.y(), c.z()) ? cells_[index(c)] : Cell::Closed;
  }

  // Returns the cost of the part around a cell of a column; `but`: the face that may touch.
  int touching(const Eigen::Vector3i& c, const Eigen::Vector3i& but) const {
    int cost = 0;
    for (int n = 0; n < 27; ++n) {
      const Eigen::Vector3i step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      if (step.isZero() || !isPart(at(c + step)))
        continue;
      // Neighbours beside the permitted face cannot be avoided.
      if (step == but || (!but.isZero() && step.dot(but) > 0))
        continue;
      cost += step.cwiseAbs().sum() == 1 ? kSideFace : kNear;
    }
    return cost;
  }

  void offer(Place place, Place before, int cost) {
    const std::size_t cell = cellOf(place);
    const auto [entry, isNew] = known_.try_emplace(place, Known{cost, before});
    if (!isNew) {
      if (entry->second.cost <= cost)
        return;
      entry->second = {cost, before};
    }
    open_.push({cost, place, false});
    if (cells_[cell] == Cell::Plate)
      open_.push({cost, place, true});
    const Cell below = at(grid_.cell(cell) - Eigen::Vector3i::UnitZ());
    if (below == Cell::Support)
      open_.push({cost, place, true});
    if (below == Cell::Footing) // its face was priced as a side's
      open_.push({cost - kSideFace + kOnPart, place, true});
  }

  void spread(Place place, int cost) {
    const Eigen::Vector3i c = grid_.cell(cellOf(place));
    for (const Eigen::Vector3i& step : kStep) {
      const Eigen::Vector3i to = c + step;
      // Without a limit, states differ by their cells alone.
      const int lateralSteps =
          step.z() != 0 || maxLateralSteps_ == 0 ? 0 : lateralStepsOf(place) + 1;
      if (lateralSteps <= maxLateralSteps_ && isFree(at(to)))
        offer(placeOf(index(to), lateralSteps), place,
              cost + kCell + (step.z() == 0 ? kLateral : 0) +
                  touching(to, Eigen::Vector3i::Zero()));
    }
  }

  Column column(Place last) const {
    Column out;
    const std::size_t foot = cellOf(last);
    for (Place place = last; place != kNone; place = known_.at(place).before)
      out.cells.push_back(cellOf(place));
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
  const int maxLateralSteps_; // 0: no limit
  const base::RunContext& ctx_;
  std::unordered_map<Place, Known> known_;
  std::priority_queue<Open> open_;
};

} // namespace

std::optional<Column> cheapestColumn(const voxel::VoxelGrid& grid, const std::vector<Cell>& cells,
                                     const std::vector<std::size_t>& carried, int maxLateralSteps,
                                     const base::RunContext& ctx) {
  base::require(cells.size() == grid.cellCount() && maxLateralSteps > 0,
                "cheapestColumn: one entry a cell, steps aside");
  std::optional<Column> column = Search(grid, cells, maxLateralSteps, ctx).run(carried);
  return column ? column : Search(grid, cells, 0, ctx).run(carried);
}

} // namespace voluta::support
