#include "curved/decomposition.h"
#include "scene/coarse_voxels.h"
#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"
#include "voxel/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace voluta::scene {

namespace {

using Bytes = std::array<std::uint8_t, 3>;

struct Square {
  Eigen::Vector3i cell; // its lower corner along `axis` is the face's
  int axis;
  std::size_t owner; // cell that determines the colour
};

Bytes bytesOf(const Colour& c) {
  Bytes out{};
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = static_cast<std::uint8_t>(std::lround(255 * c[k]));
  return out;
}

// While dragging, no more faces are on the outside than this. Few enough for a processor that
// draws 15 frames a second.
constexpr std::size_t kCoarseFaces = 36'000;
constexpr int kCoarsest = 12; // voxels along a block

std::int32_t highestOf(std::span<const std::int32_t> values) {
  return values.empty() ? 1 : std::max(1, *std::ranges::max_element(values));
}

// Colours of cells by a value from 1 to the maximum.
class CellColours {
public:
  CellColours(const ShownCells& cells, std::int32_t highest)
      : values_(cells.value), support_(cells.support), highest_(highest) {
    for (int i = 0; i < highest_; ++i)
      map_.push_back(bytesOf(sequentialColour(highest_ > 1 ? double(i) / (highest_ - 1) : 0.0)));
  }
  const Bytes& of(std::size_t cell) const {
    if (!support_.empty() && support_[cell])
      return supportBytes_;
    return map_[static_cast<std::size_t>(std::clamp(values_[cell], 1, highest_) - 1)];
  }

private:
  std::span<const std::int32_t> values_;
  std::span<const std::uint8_t> support_;
  std::int32_t highest_;
  std::vector<Bytes> map_;
  Bytes supportBytes_ = bytesOf(supportColour());
};

// Writes squares as two triangles each, in order, with four points each.
class SquareWriter {
public:
  // colours: null if the squares have no individual colours.
  SquareWriter(const voxel::VoxelGrid& grid, const CellColours* colours)
      : grid_(grid), colours_(colours) {}

  std::int32_t addPoints(const Square& s) {
    const int u = (s.axis + 1) % 3, v = (s.axis + 2) % 3;
    const auto first = static_cast<std::int32_t>(buffers.points.size() / 3);
    for (int k = 0; k < 4; ++k) {
      Eigen::Vector3i corner = s.cell;
      corner[u] += k == 1 || k == 2;
      corner[v] += k >= 2;
      buffers.addPoint(grid_.origin + grid_.pitch * corner.cast<double>());
      if (colours_) {
        const Bytes& c = colours_->of(s.owner);
        buffers.rgb.insert(buffers.rgb.end(), c.begin(), c.end());
      }
    }
    return first;
  }
  void addFace(std::int32_t first) { buffers.addQuad(first, first + 1, first + 2, first + 3); }

  MeshBuffers buffers;

private:
  const voxel::VoxelGrid& grid_;
  const CellColours* colours_;
};

struct Faces {
  std::vector<Square> squares, missed;
  std::vector<LayeredFace> outer, upper, lower; // face: index in squares
};

Faces facesOf(const voxel::VoxelGrid& grid, std::span<const std::int32_t> rank) {
  Faces out;
  const auto inGrid = [&](const Eigen::Vector3i& c) { return grid.contains(c.x(), c.y(), c.z()); };
  const auto indexOf = [&](const Eigen::Vector3i& c) { return grid.index(c.x(), c.y(), c.z()); };
  const auto at = [&](const Eigen::Vector3i& c) { return inGrid(c) ? rank[indexOf(c)] : 0; };
  // Each cell is compared with its predecessors; one more row beyond the grid closes the far sides.
  for (int k = 0; k <= grid.size.z(); ++k)
    for (int j = 0; j <= grid.size.y(); ++j)
      for (int i = 0; i <= grid.size.x(); ++i) {
        const Eigen::Vector3i cell(i, j, k);
        const std::int32_t own = at(cell);
        for (int axis = 0; axis < 3; ++axis) {
          Eigen::Vector3i before = cell;
          --before[axis];
          const std::int32_t other = at(before);
          if (own == other)
            continue;
          const std::size_t ownCell = inGrid(cell) ? indexOf(cell) : 0;
          const std::size_t otherCell = inGrid(before) ? indexOf(before) : 0;
          if ((own < 0) != (other < 0))
            out.missed.push_back({cell, axis, own < 0 ? ownCell : otherCell});
          const std::int32_t low = std::min(own, other), high = std::max(own, other);
          if (high <= 0)
            continue;
          const auto index = static_cast<std::int32_t>(out.squares.size());
          const bool outside = low <= 0;
          // Between two layers the face belongs to the lower one, since the higher does not exist
          // yet.
          const bool ofOwn = outside ? own == high : own == low;
          out.squares.push_back({cell, axis, ofOwn ? ownCell : otherCell});
          if (outside) {
            out.outer.push_back({high - 1, kNeverHidden, index});
          } else {
            out.upper.push_back({low - 1, high - 1, index});
            out.lower.push_back({high - 1, 1 - low, index});
          }
        }
      }
  return out;
}

// Returns the ranks or, if the layer height is known, the field's layers, counted from 1.
std::vector<std::int32_t> ordersOf(const curved::Decomposition& d, double layerHeightMm) {
  std::vector<std::int32_t> orders = d.rank;
  if (layerHeightMm > 0.0 && !d.field.empty())
    for (std::size_t c = 0; c < orders.size(); ++c)
      if (orders[c] > 0 && std::isfinite(d.field[c]))
        orders[c] =
            1 + std::max(0, static_cast<int>(std::floor(double(d.field[c]) / layerHeightMm)));
  return orders;
}

std::size_t reasonOf(std::span<const curved::Loss> losses, std::size_t cell) {
  const curved::Loss loss = losses.empty() ? curved::Loss::Shadowed : losses[cell];
  return loss == curved::Loss::None ? 0 : static_cast<std::size_t>(loss) - 1;
}

// Adds the cells' faces to a drawing, in the colours of values up to `highest`.
void addFaces(VoxelDrawing& drawing, const ShownCells& cells, std::int32_t highest) {
  const voxel::VoxelGrid& grid = cells.grid;
  const CellColours colours(cells, highest);
  Faces faces = facesOf(grid, cells.rank);
  SquareWriter outside(grid, &colours), inside(grid, &colours), missed(grid, nullptr);
  drawing.outer = LayeredFaces(faces.outer, 0, 2);
  for (const LayeredFace& f : faces.outer)
    outside.addFace(outside.addPoints(faces.squares[static_cast<std::size_t>(f.face)]));

  drawing.upper = LayeredFaces(faces.upper, 0, 2);
  std::vector<std::int32_t> pointsOf(faces.squares.size());
  for (const LayeredFace& f : faces.upper) {
    const auto square = static_cast<std::size_t>(f.face);
    pointsOf[square] = inside.addPoints(faces.squares[square]);
    inside.addFace(pointsOf[square]);
  }
  drawing.lower = LayeredFaces(faces.lower, 2 * faces.upper.size(), 2);
  for (const LayeredFace& f : faces.lower)
    inside.addFace(pointsOf[static_cast<std::size_t>(f.face)]);

  std::size_t written = 0;
  for (std::size_t reason = 0; reason < kLossCount; ++reason) {
    drawing.missedFaces[reason].first = written;
    for (const Square& s : faces.missed)
      if (reasonOf(cells.loss, s.owner) == reason) {
        missed.addFace(missed.addPoints(s));
        written += 2;
      }
    drawing.missedFaces[reason].count = written - drawing.missedFaces[reason].first;
  }
  drawing.outside = polyDataOf(outside.buffers);
  drawing.inside = polyDataOf(inside.buffers);
  drawing.missed = polyDataOf(missed.buffers);
}

// Returns how many voxels wide blocks have to be so that few enough of them are on the outside.
int coarseFactor(std::size_t outerFaces) {
  int factor = 1;
  while (factor < kCoarsest &&
         outerFaces > kCoarseFaces * static_cast<std::size_t>(factor * factor))
    ++factor;
  return factor;
}

} // namespace

std::shared_ptr<const VoxelDrawing> drawVoxels(const curved::Decomposition& decomposition,
                                               const VoxelLook& look) {
  auto drawing = std::make_shared<VoxelDrawing>();
  drawing->grid = decomposition.grid;
  drawing->bySteps = look.bySteps;
  const bool hasLayers = look.layerHeightMm > 0.0 && !decomposition.field.empty();
  const bool peels = look.colourBy == ColourBy::Peeling && look.peeling;
  drawing->colouredBy = peels                                                 ? ColourBy::Peeling
                        : look.colourBy == ColourBy::GrowthStep || !hasLayers ? ColourBy::GrowthStep
                                                                              : ColourBy::Layer;
  const std::vector<std::int32_t> layers = ordersOf(decomposition, look.layerHeightMm);
  drawing->rank = look.bySteps ? decomposition.rank : layers;
  const ShownCells cells{drawing->grid, drawing->rank,
                         drawing->colouredBy == ColourBy::Peeling      ? *look.peeling
                         : drawing->colouredBy == ColourBy::GrowthStep ? decomposition.rank
                                                                       : layers,
                         decomposition.support, decomposition.loss};
  drawing->highest = highestOf(cells.value);
  const voxel::VoxelGrid& grid = drawing->grid;
  std::int32_t highest = 0;
  for (std::size_t c = 0; c < drawing->rank.size(); ++c)
    if (drawing->rank[c] != 0) {
      highest = std::max(highest, drawing->rank[c]);
      const Eigen::Vector3d low = grid.origin + grid.pitch * grid.cell(c).cast<double>();
      drawing->box.extend(low);
      drawing->box.extend(low + Eigen::Vector3d::Constant(grid.pitch));
      if (drawing->rank[c] < 0)
        ++drawing->lost[reasonOf(cells.loss, c)];
      else if (!decomposition.support.empty() && decomposition.support[c])
        ++drawing->support;
    }
  drawing->layers = highest;
  addFaces(*drawing, cells, drawing->highest);
  if (const int factor = coarseFactor(drawing->outer.size()); factor > 1) {
    auto coarse = std::make_shared<VoxelDrawing>();
    coarse->lost = drawing->lost;
    addFaces(*coarse, CoarseVoxels(cells, factor).cells(), drawing->highest);
    drawing->coarse = std::move(coarse);
  }
  return drawing;
}

int layerCount(const VoxelDrawing& drawing) {
  return drawing.layers;
}

std::size_t missedCount(const VoxelDrawing& drawing) {
  return std::accumulate(drawing.lost.begin(), drawing.lost.end(), std::size_t{0});
}

} // namespace voluta::scene
