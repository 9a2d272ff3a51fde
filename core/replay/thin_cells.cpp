#include "replay/thin_cells.h"

#include "base/parallel.h"
#include "geometry/polygon_paths.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace voluta::replay {

namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

// A wall exactly as wide as the narrowest bead is not thin.
constexpr double kSlack = 0.99;
// Chord error of round corners, as a share of their radius; what an opening may lose along straight
// walls by rounding [mm].
constexpr double kArc = 0.005, kRoundingMm = 5e-4;
constexpr int kRows = 8; // scan lines per cell
// A low part has few rows of cells: its rows are cut more often.
constexpr int kEnoughCuts = 24, kMostCuts = 6;

// The triangles that cross each row of cells.
class Slices {
public:
  Slices(const geometry::TriangleMesh& part, const voxel::VoxelGrid& grid)
      : part_(part), crossing_(static_cast<std::size_t>(grid.size.z())) {
    const auto rowOf = [&](double z) {
      return std::clamp(static_cast<int>(std::floor((z - grid.origin.z()) / grid.pitch)), 0,
                        grid.size.z() - 1);
    };
    for (std::size_t t = 0; t < part.triangles.size(); ++t) {
      double low = part.corner(t, 0).z(), high = low;
      for (int c = 1; c < 3; ++c) {
        low = std::min(low, part.corner(t, c).z());
        high = std::max(high, part.corner(t, c).z());
      }
      for (int k = rowOf(low); k <= rowOf(high) && low < high; ++k)
        crossing_[static_cast<std::size_t>(k)].push_back(static_cast<std::uint32_t>(t));
    }
  }

  bool isEmpty(std::size_t row) const { return crossing_[row].empty(); }
  std::size_t rows() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        crossing_, [](const std::vector<std::uint32_t>& row) { return !row.empty(); }));
  }

  // Returns the contours at a height within a row; nullopt if they are open.
  std::optional<Paths> contoursAt(std::size_t row, double z) const {
    struct Segment {
      std::uint64_t to;
      ClipperLib::IntPoint from;
      bool used = false;
    };
    std::unordered_multimap<std::uint64_t, Segment> segments;
    for (const std::uint32_t t : crossing_[row]) {
      std::optional<std::uint64_t> up, down;
      ClipperLib::IntPoint from;
      for (std::size_t c = 0; c < 3; ++c) {
        const int a = part_.triangles[t][c], b = part_.triangles[t][(c + 1) % 3];
        const Eigen::Vector3d &p = part_.vertices[static_cast<std::size_t>(a)],
                              &q = part_.vertices[static_cast<std::size_t>(b)];
        // A vertex in the plane counts as above it.
        if ((p.z() >= z) == (q.z() >= z))
          continue;
        (p.z() < z ? up : down) = edgeOf(a, b);
        if (p.z() >= z)
          from = crossingOf(q, p, z);
      }
      if (up && down)
        segments.emplace(*down, Segment{*up, from});
    }
    Paths contours;
    for (auto& [edge, first] : segments) {
      if (first.used)
        continue;
      Path contour;
      Segment* at = &first;
      while (at) {
        at->used = true;
        contour.push_back(at->from);
        if (at->to == edge)
          break;
        const auto [begin, end] = segments.equal_range(at->to);
        const auto next =
            std::find_if(begin, end, [](const auto& other) { return !other.second.used; });
        at = next == end ? nullptr : &next->second;
      }
      if (!at)
        return std::nullopt;
      contours.push_back(std::move(contour));
    }
    return contours;
  }

private:
  static std::uint64_t edgeOf(int a, int b) {
    return static_cast<std::uint64_t>(std::min(a, b)) << 32U |
           static_cast<std::uint64_t>(std::max(a, b));
  }
  static ClipperLib::IntPoint crossingOf(const Eigen::Vector3d& below, const Eigen::Vector3d& above,
                                         double z) {
    const double share = (z - below.z()) / (above.z() - below.z());
    return geometry::pathPoint((below + share * (above - below)).head<2>());
  }

  const geometry::TriangleMesh& part_;
  std::vector<std::vector<std::uint32_t>> crossing_;
};

// Returns the places of a section that no disc of this radius covers which fits into it.
Paths narrowPlaces(const Paths& section, double radiusMm) {
  geometry::OffsetStyle style;
  style.arcMm = kArc * radiusMm;
  const Paths core = geometry::offsetPaths(section, -radiusMm, style);
  const Paths reached =
      core.empty() ? core : geometry::offsetPaths(core, radiusMm + kRoundingMm, style);
  return geometry::combined(section, reached, ClipperLib::ctDifference);
}

// Polygons cut into lines along x, kRows to a cell.
class ScanLines {
public:
  ScanLines(const Paths& polygons, const voxel::VoxelGrid& grid) {
    for (const Path& path : polygons)
      for (std::size_t i = 0; i < path.size(); ++i) {
        const auto inCells = [&](const ClipperLib::IntPoint& point) -> Eigen::Vector2d {
          return (geometry::pointMm(point) - grid.origin.head<2>()) / grid.pitch;
        };
        Eigen::Vector2d a = inCells(path[i]), b = inCells(path[(i + 1) % path.size()]);
        if (a.y() > b.y())
          std::swap(a, b);
        const auto lineAfter = [](double y) {
          return static_cast<int>(std::ceil(y * kRows - 0.5));
        };
        for (int line = lineAfter(a.y()); line < lineAfter(b.y()); ++line) {
          const double y = (line + 0.5) / kRows;
          crossings_.emplace_back(line, a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
      }
    std::ranges::sort(crossings_);
  }

  // Calls visit(column, row) for each cell that a line inside the polygons passes.
  template <typename Visit> void eachCell(const voxel::VoxelGrid& grid, const Visit& visit) const {
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      const auto [line, from] = crossings_[i];
      if (line < 0 || line >= kRows * grid.size.y())
        continue;
      const double to = std::min<double>(grid.size.x(), crossings_[i + 1].second);
      for (int x = static_cast<int>(std::max(0.0, from)); x < to; ++x)
        visit(x, line / kRows);
    }
  }

  // Returns the share of a cell that is inside.
  double areaIn(int column, int row) const {
    double sum = 0.0;
    for (int line = kRows * row; line < kRows * (row + 1); ++line)
      for (auto at = std::ranges::lower_bound(crossings_, std::pair(line, -1e9));
           at != crossings_.end() && at->first == line; at += 2)
        sum += std::max(0.0, std::min((at + 1)->second, column + 1.0) -
                                 std::max<double>(at->second, column));
    return sum / kRows;
  }

private:
  std::vector<std::pair<int, double>> crossings_; // line, x in cells; two for each stretch inside
};

// Of a cell, over the cuts of its row.
struct CellAreas {
  double thin = 0.0, all = 0.0;
};

void addAreas(const Paths& contours, double radiusMm, const voxel::VoxelGrid& grid,
              std::unordered_map<std::uint32_t, CellAreas>& areas) {
  const Paths section = geometry::united(contours), narrow = narrowPlaces(section, radiusMm);
  if (narrow.empty())
    return;
  const ScanLines thin(narrow, grid), all(section, grid);
  std::unordered_set<std::uint32_t> seen;
  thin.eachCell(grid, [&](int column, int row) {
    const auto cell = static_cast<std::uint32_t>(grid.index(column, row, 0));
    if (!seen.insert(cell).second)
      return;
    areas[cell].thin += thin.areaIn(column, row);
    areas[cell].all += all.areaIn(column, row);
  });
}

} // namespace

bool hasLevelLayers(const plan::ToolPlan& plan) {
  constexpr double kUpright = 0.999, kNearlyAll = 0.95;
  std::size_t upright = 0, all = 0;
  for (const plan::ToolPath& path : plan.paths) {
    if (path.kind == plan::PathKind::Support || plan::isWaste(path.kind))
      continue;
    all += path.count;
    for (std::size_t i = path.first; i < path.first + path.count; ++i)
      upright += plan.direction[i].z() > kUpright ? 1 : 0;
  }
  return all > 0 && static_cast<double>(upright) >= kNearlyAll * static_cast<double>(all);
}

ThinCells thinCells(const geometry::TriangleMesh& part, const PartCells& cells,
                    const voxel::VoxelGrid& grid, double narrowestMm, const base::RunContext& ctx) {
  const Slices slices(part, grid);
  const auto rows = static_cast<std::size_t>(grid.size.z());
  const int cuts =
      std::clamp(kEnoughCuts / std::max(1, static_cast<int>(slices.rows())), 1, kMostCuts);
  const std::size_t perRow =
      static_cast<std::size_t>(grid.size.x()) * static_cast<std::size_t>(grid.size.y());
  std::vector<std::vector<ThinCells::Cell>> found(rows);
  base::parallelChunks(ctx, rows, 1, [&](std::size_t row, std::size_t) {
    if (slices.isEmpty(row) || ctx.cancelled())
      return;
    std::unordered_map<std::uint32_t, CellAreas> areas;
    for (int cut = 0; cut < cuts; ++cut) {
      const double z =
          grid.origin.z() + grid.pitch * (static_cast<double>(row) + (cut + 0.5) / cuts);
      if (const auto contours = slices.contoursAt(row, z); contours && !contours->empty())
        addAreas(*contours, 0.5 * kSlack * narrowestMm, grid, areas);
    }
    for (const auto& [inRow, area] : areas) {
      const std::size_t cell = row * perRow + inRow;
      // The share of the cell that a few vertical lines found may differ from the section's.
      const auto share = static_cast<std::uint8_t>(
          std::lround(cells.share[cell] * std::min(1.0, area.thin / std::max(area.all, 1e-9))));
      if (share > 0)
        found[row].push_back({static_cast<std::uint32_t>(cell), share});
    }
    std::ranges::sort(found[row], {}, &ThinCells::Cell::index);
  });
  ctx.checkpoint();
  ThinCells thin;
  double sum = 0.0;
  thin.firstOfRow.reserve(rows + 1);
  for (const auto& row : found) {
    thin.firstOfRow.push_back(thin.cells.size());
    thin.cells.insert(thin.cells.end(), row.begin(), row.end());
    for (const ThinCells::Cell& cell : row)
      sum += cell.share;
  }
  thin.firstOfRow.push_back(thin.cells.size());
  thin.volumeMm3 = sum / 255.0 * std::pow(grid.pitch, 3);
  return thin;
}

} // namespace voluta::replay
