#include "support/column_layers.h"

#include "base/error.h"
#include "geometry/mesh_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace voluta::support {

namespace {

using curved::Decomposition;

// Approximate edge length of a slice's triangles, and in widths of beads over 1.2 mm.
constexpr double kFinestMm = 0.4, kFinestWidths = 1.0 / 3.0;

// Face-connected cells of one layer of the grid.
struct Block {
  int k = 0;
  std::vector<std::array<int, 2>> cells; // (i, j)
  double level = 0.0;                    // of the field at its centre, mm
  std::vector<int> below, above;         // blocks
};

bool isSupport(const Decomposition& d, int i, int j, int k) {
  return d.grid.contains(i, j, k) && d.support[d.grid.index(i, j, k)] != 0;
}
bool isPart(const Decomposition& d, int i, int j, int k) {
  if (!d.grid.contains(i, j, k))
    return false;
  const std::size_t c = d.grid.index(i, j, k);
  return d.rank[c] != 0 && d.support[c] == 0;
}

double levelAt(const Decomposition& d, std::size_t cell) {
  return d.field.empty() ? (d.rank[cell] - 0.5) * d.grid.pitch : static_cast<double>(d.field[cell]);
}

// Returns all blocks of support, from the bottom up.
std::vector<Block> blocksOf(const Decomposition& d) {
  std::vector<Block> blocks;
  std::map<std::size_t, int> of; // block of a cell
  for (std::size_t seed = 0; seed < d.support.size(); ++seed) {
    if (!d.support[seed] || of.count(seed))
      continue;
    const auto number = static_cast<int>(blocks.size());
    Block block;
    block.k = d.grid.cell(seed).z();
    std::vector<std::size_t> open{seed};
    of[seed] = number;
    while (!open.empty()) {
      const std::size_t c = open.back();
      open.pop_back();
      const Eigen::Vector3i at = d.grid.cell(c);
      block.cells.push_back({at.x(), at.y()});
      block.level += levelAt(d, c);
      for (const auto& [di, dj] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        if (isSupport(d, at.x() + di, at.y() + dj, at.z())) {
          const std::size_t next = d.grid.index(at.x() + di, at.y() + dj, at.z());
          if (of.try_emplace(next, number).second)
            open.push_back(next);
        }
    }
    block.level /= static_cast<double>(block.cells.size());
    std::sort(block.cells.begin(), block.cells.end());
    blocks.push_back(std::move(block));
  }
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (const auto& [i, j] : blocks[b].cells)
      if (isSupport(d, i, j, blocks[b].k - 1)) {
        const int under = of.at(d.grid.index(i, j, blocks[b].k - 1));
        auto& below = blocks[b].below;
        if (std::find(below.begin(), below.end(), under) == below.end()) {
          below.push_back(under);
          blocks[static_cast<std::size_t>(under)].above.push_back(static_cast<int>(b));
        }
      }
  return blocks;
}

class Slicer {
public:
  Slicer(const Decomposition& d, const geometry::TriangleMesh& part, const ColumnLayerOptions& o)
      : d_(d), options_(o), part_(part), blocks_(blocksOf(d)),
        widen_(0.5 * std::max(0.0, o.beadWidthMm - d.grid.pitch)) {}

  std::vector<curved::SupportPatch> run(const base::RunContext& ctx) {
    // Stretches without a branch, from their lowest block.
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      ctx.checkpoint();
      const Block& block = blocks_[b];
      const bool continues = block.below.size() == 1 && at(block.below[0]).above.size() == 1;
      if (continues)
        continue;
      std::vector<int> stretch{static_cast<int>(b)};
      while (at(stretch.back()).above.size() == 1 &&
             at(at(stretch.back()).above[0]).below.size() == 1)
        stretch.push_back(at(stretch.back()).above[0]);
      slice(stretch);
    }
    return std::move(out_);
  }

private:
  const Block& at(int block) const { return blocks_[static_cast<std::size_t>(block)]; }
  double bottomOf(const Block& b) const { return d_.grid.origin.z() + d_.grid.pitch * b.k; }

  // Returns the distance from a face of the block (sign -1: lower, +1: upper) to the part's surface
  // beyond it, where cells of the part are there: the minimum over its centre and corners.
  double gap(const Block& block, int sign) const {
    const double z = bottomOf(block) + (sign > 0 ? d_.grid.pitch : 0.0);
    std::optional<double> minimum;
    for (const auto& [i, j] : block.cells) {
      if (!isPart(d_, i, j, block.k + sign))
        continue;
      const Eigen::Vector3d middle = d_.grid.centre(i, j, block.k);
      const double half = 0.5 * d_.grid.pitch + widen_;
      for (const auto& [dx, dy] :
           {std::array{0.0, 0.0}, {-half, -half}, {half, -half}, {-half, half}, {half, half}}) {
        const Eigen::Vector3d from(middle.x() + dx, middle.y() + dy, z);
        const double reach = 2.0 * d_.grid.pitch;
        if (part_.inside(from))
          return 0.0;
        if (const auto hit = part_.firstHit(from, from + sign * reach * Eigen::Vector3d::UnitZ()))
          minimum = std::min(minimum.value_or(reach), hit->t * reach);
      }
    }
    return minimum.value_or(0.0);
  }

  void slice(const std::vector<int>& stretch) {
    const Block &first = at(stretch.front()), &last = at(stretch.back());
    const double low = bottomOf(first) - gap(first, -1),
                 high = bottomOf(last) + d_.grid.pitch + gap(last, 1);
    const double height = high - low;
    double count = std::max(1.0, std::round(height / options_.layerHeightMm));
    if (height / count > options_.heightMaxMm)
      count += 1.0;
    if (height / count < options_.heightMinMm)
      count = std::max(1.0, std::floor(height / options_.heightMinMm));
    const double thickness = height / count;
    double level = 0.0;
    for (int n = 0; n < static_cast<int>(count); ++n) {
      const double z = low + n * thickness;
      // Levels must increase even where the field hardly rises.
      const double wanted = levelAtHeight(stretch, z);
      level = n == 0 ? std::max(0.0, wanted) : std::max(level + 0.3 * thickness, wanted);
      out_.push_back({patch(stretch, z, thickness), level});
    }
  }

  // Returns the field along the stretch, interpolated linearly between the centres of its blocks.
  double levelAtHeight(const std::vector<int>& stretch, double z) const {
    const double t = (z - bottomOf(at(stretch.front()))) / d_.grid.pitch - 0.5;
    if (stretch.size() == 1)
      return at(stretch[0]).level + t * d_.grid.pitch;
    const int lower =
        std::clamp(static_cast<int>(std::floor(t)), 0, static_cast<int>(stretch.size()) - 2);
    const double a = at(stretch[static_cast<std::size_t>(lower)]).level,
                 b = at(stretch[static_cast<std::size_t>(lower) + 1]).level;
    return a + (t - lower) * (b - a);
  }

  layers::Patch patch(const std::vector<int>& stretch, double z, double thickness) const {
    const double pitch = d_.grid.pitch, bottom = bottomOf(at(stretch.front()));
    const auto blockAt = [&](double height) {
      return std::clamp(static_cast<int>(std::floor((height - bottom) / pitch)), 0,
                        static_cast<int>(stretch.size()) - 1);
    };
    const double middle = z + 0.5 * thickness;
    std::vector<std::array<int, 2>> cells;
    const Block& main = at(stretch[static_cast<std::size_t>(blockAt(middle))]);
    for (int n = blockAt(z); n <= blockAt(z + thickness); ++n) {
      const Block& block = at(stretch[static_cast<std::size_t>(n)]);
      const double centre = bottomOf(block) + 0.5 * pitch;
      if (&block == &main || (centre > z && centre < z + thickness))
        cells.insert(cells.end(), block.cells.begin(), block.cells.end());
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());

    layers::Patch out;
    out.group = layers::kSupportGroup;
    const double edgeMm = std::max(kFinestMm, kFinestWidths * options_.beadWidthMm);
    const int parts = std::max(1, static_cast<int>(std::ceil(pitch / edgeMm)));
    std::map<std::array<int, 2>, int> vertexAt;
    const auto vertex = [&](int i, int j, int u, int v) {
      const auto [entry, isNew] =
          vertexAt.try_emplace({i * parts + u, j * parts + v}, static_cast<int>(vertexAt.size()));
      if (isNew) {
        const double s = static_cast<double>(u) / parts, t = static_cast<double>(v) / parts;
        const Eigen::Vector2d p =
            (1.0 - t) * ((1.0 - s) * corner(cells, i, j) + s * corner(cells, i + 1, j)) +
            t * ((1.0 - s) * corner(cells, i, j + 1) + s * corner(cells, i + 1, j + 1));
        out.surface.vertices.emplace_back(p.x(), p.y(), middle);
        out.thicknessMm.push_back(thickness);
        out.direction.push_back(Eigen::Vector3d::UnitZ());
        out.clearDirection.push_back(clearDirection(main, i, j));
      }
      return entry->second;
    };
    for (const auto& [i, j] : cells)
      for (int v = 0; v < parts; ++v)
        for (int u = 0; u < parts; ++u) {
          const int a = vertex(i, j, u, v), b = vertex(i, j, u + 1, v),
                    c = vertex(i, j, u + 1, v + 1), e = vertex(i, j, u, v + 1);
          out.surface.triangles.push_back({a, b, c});
          out.surface.triangles.push_back({a, c, e});
        }
    return out;
  }

  // Returns a corner of cells, moved outwards if the cells around it are all on one side.
  Eigen::Vector2d corner(const std::vector<std::array<int, 2>>& cells, int i, int j) const {
    const auto has = [&](int x, int y) {
      return std::binary_search(cells.begin(), cells.end(), std::array{x, y});
    };
    const bool left = has(i - 1, j - 1) || has(i - 1, j), right = has(i, j - 1) || has(i, j),
               front = has(i - 1, j - 1) || has(i, j - 1), back = has(i - 1, j) || has(i, j);
    const auto outwards = [&](bool before, bool after) {
      return before == after ? 0.0 : before ? widen_ : -widen_;
    };
    return d_.grid.origin.head<2>() + d_.grid.pitch * Eigen::Vector2d(i, j) +
           Eigen::Vector2d(outwards(left, right), outwards(front, back));
  }

  Eigen::Vector3d clearDirection(const Block& block, int i, int j) const {
    const Eigen::Vector3f n = isSupport(d_, i, j, block.k)
                                  ? d_.frontNormal[d_.grid.index(i, j, block.k)]
                                  : Eigen::Vector3f(Eigen::Vector3f::Zero());
    return n.isZero() ? Eigen::Vector3d(Eigen::Vector3d::UnitZ())
                      : n.cast<double>().normalized().eval();
  }

  const Decomposition& d_;
  const ColumnLayerOptions& options_;
  geometry::MeshQuery part_;
  std::vector<Block> blocks_;
  double widen_;
  std::vector<curved::SupportPatch> out_;
};

} // namespace

std::vector<curved::SupportPatch> columnLayers(const Decomposition& decomposition,
                                               const geometry::TriangleMesh& part,
                                               const ColumnLayerOptions& options,
                                               const base::RunContext& ctx) {
  base::require(options.heightMinMm > 0.0 && options.heightMinMm <= options.layerHeightMm &&
                    options.layerHeightMm <= options.heightMaxMm && options.beadWidthMm > 0.0,
                "columnLayers: 0 < heightMin <= layerHeight <= heightMax, a bead width");
  if (decomposition.support.empty())
    return {};
  base::require(decomposition.support.size() == decomposition.grid.cellCount(),
                "columnLayers: one entry a cell");
  return Slicer(decomposition, part, options).run(ctx);
}

} // namespace voluta::support
