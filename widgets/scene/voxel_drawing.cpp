#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::scene {

namespace {

using Bytes = std::array<std::uint8_t, 3>;

struct Square {
  Eigen::Vector3i cell; // its lower corner along `axis` is the face's
  int axis;
  int layer; // colour
};

// Writes the squares as two triangles each, in order, with their four points.
class SquareWriter {
public:
  SquareWriter(const voxel::VoxelGrid& grid, std::vector<Bytes> colours)
      : grid_(grid), colours_(std::move(colours)) {}

  std::int32_t addPoints(const Square& s) {
    const int u = (s.axis + 1) % 3, v = (s.axis + 2) % 3;
    const auto first = static_cast<std::int32_t>(buffers.points.size() / 3);
    for (int k = 0; k < 4; ++k) {
      Eigen::Vector3i corner = s.cell;
      corner[u] += k == 1 || k == 2;
      corner[v] += k >= 2;
      buffers.addPoint(grid_.origin + grid_.pitch * corner.cast<double>());
      if (!colours_.empty()) {
        const Bytes& c = colours_[static_cast<std::size_t>(s.layer)];
        buffers.rgb.insert(buffers.rgb.end(), c.begin(), c.end());
      }
    }
    return first;
  }
  void addFace(std::int32_t first) { buffers.addQuad(first, first + 1, first + 2, first + 3); }

  MeshBuffers buffers;

private:
  const voxel::VoxelGrid& grid_;
  std::vector<Bytes> colours_;
};

std::vector<Bytes> layerColours(int layers) {
  std::vector<Bytes> colours;
  for (int i = 0; i < layers; ++i) {
    const Colour c = sequentialColour(layers > 1 ? double(i) / (layers - 1) : 0.0);
    colours.push_back({static_cast<std::uint8_t>(std::lround(255 * c[0])),
                       static_cast<std::uint8_t>(std::lround(255 * c[1])),
                       static_cast<std::uint8_t>(std::lround(255 * c[2]))});
  }
  return colours;
}

struct Faces {
  std::vector<Square> squares, missed;
  std::vector<LayeredFace> outer, upper, lower; // face: index in squares
};

Faces facesOf(const voxel::VoxelGrid& grid, const std::vector<std::int32_t>& rank) {
  Faces out;
  const auto at = [&](const Eigen::Vector3i& c) {
    return grid.contains(c.x(), c.y(), c.z()) ? rank[grid.index(c.x(), c.y(), c.z())] : 0;
  };
  // Each cell looks back; one row beyond the grid closes the far sides.
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
          if ((own < 0) != (other < 0))
            out.missed.push_back({cell, axis, 0});
          const std::int32_t low = std::min(own, other), high = std::max(own, other);
          if (high <= 0)
            continue;
          const auto index = static_cast<std::int32_t>(out.squares.size());
          const bool outside = low <= 0;
          out.squares.push_back({cell, axis, (outside ? high : low) - 1});
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

// Ranks, or where the layers' height is known the layers of the field, counted from 1.
std::vector<std::int32_t> ordersOf(const curved::Decomposition& d, double layerHeightMm) {
  std::vector<std::int32_t> orders = d.rank;
  if (layerHeightMm > 0.0 && !d.field.empty())
    for (std::size_t c = 0; c < orders.size(); ++c)
      if (orders[c] > 0 && std::isfinite(d.field[c]))
        orders[c] =
            1 + std::max(0, static_cast<int>(std::floor(double(d.field[c]) / layerHeightMm)));
  return orders;
}

} // namespace

std::shared_ptr<const VoxelDrawing> drawVoxels(const curved::Decomposition& decomposition,
                                               double layerHeightMm) {
  auto drawing = std::make_shared<VoxelDrawing>();
  drawing->grid = decomposition.grid;
  drawing->rank = ordersOf(decomposition, layerHeightMm);
  const voxel::VoxelGrid& grid = drawing->grid;
  std::int32_t highest = 0;
  for (std::size_t c = 0; c < drawing->rank.size(); ++c)
    if (drawing->rank[c] != 0) {
      highest = std::max(highest, drawing->rank[c]);
      const Eigen::Vector3d low = grid.origin + grid.pitch * grid.cell(c).cast<double>();
      drawing->box.extend(low);
      drawing->box.extend(low + Eigen::Vector3d::Constant(grid.pitch));
    }
  drawing->layers = highest;

  Faces faces = facesOf(grid, drawing->rank);
  const std::vector<Bytes> colours = layerColours(highest);
  SquareWriter outside(grid, colours), inside(grid, colours), missed(grid, {});
  drawing->outer = LayeredFaces(faces.outer, 0, 2);
  for (const LayeredFace& f : faces.outer)
    outside.addFace(outside.addPoints(faces.squares[static_cast<std::size_t>(f.face)]));

  drawing->upper = LayeredFaces(faces.upper, 0, 2);
  std::vector<std::int32_t> pointsOf(faces.squares.size());
  for (const LayeredFace& f : faces.upper) {
    const auto square = static_cast<std::size_t>(f.face);
    pointsOf[square] = inside.addPoints(faces.squares[square]);
    inside.addFace(pointsOf[square]);
  }
  drawing->lower = LayeredFaces(faces.lower, 2 * faces.upper.size(), 2);
  for (const LayeredFace& f : faces.lower)
    inside.addFace(pointsOf[static_cast<std::size_t>(f.face)]);

  for (const Square& s : faces.missed)
    missed.addFace(missed.addPoints(s));
  drawing->outside = polyDataOf(outside.buffers);
  drawing->inside = polyDataOf(inside.buffers);
  drawing->missed = polyDataOf(missed.buffers);
  return drawing;
}

int layerCount(const VoxelDrawing& drawing) {
  return drawing.layers;
}

} // namespace voluta::scene
