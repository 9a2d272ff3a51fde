#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "scene/coarse_slabs.h"
#include "scene/drawing_data.h"
#include "scene/mesh_buffers.h"

#include "base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace voluta::scene {

namespace {

using CellKey = std::uint64_t;

// Width of the ledges kept along boundaries, in thicknesses of a layer: the visible depth between
// layers where a part's slope is shallow.
constexpr double kLedgeInCells = 1.8;
// Few enough for a processor that draws 15 frames a second.
constexpr std::size_t kFastTriangles = 60'000;
constexpr double kCellsPerRatio = 0.9; // edges of the rim that a joined one replaces

// An unbounded grid.
class CellKeys {
public:
  explicit CellKeys(double pitch) : pitch_(pitch) {}
  double pitch() const { return pitch_; }
  CellKey keyOf(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d c = (p / pitch_).array().floor().matrix();
    constexpr double kHalf = 1 << 20; // 21 bits per axis
    return (static_cast<CellKey>(c.x() + kHalf) << 42) |
           (static_cast<CellKey>(c.y() + kHalf) << 21) | static_cast<CellKey>(c.z() + kHalf);
  }

private:
  double pitch_;
};

// The layers with material in a cell, for finding the next one above or below a layer.
class LayerMarks {
public:
  explicit LayerMarks(double pitch) : cells_(pitch) {}

  const CellKeys& cells() const { return cells_; }
  void mark(const Eigen::Vector3d& p, std::int32_t layer) {
    marks_.emplace_back(cells_.keyOf(p), layer);
  }
  void finish() {
    std::sort(marks_.begin(), marks_.end());
    marks_.erase(std::unique(marks_.begin(), marks_.end()), marks_.end());
    for (std::size_t i = 0; i < marks_.size(); ++i)
      if (i == 0 || marks_[i].first != marks_[i - 1].first)
        firstOf_.emplace(marks_[i].first, i);
  }
  std::optional<std::int32_t> above(const Eigen::Vector3d& p, std::int32_t layer) const {
    for (std::size_t i = firstAt(p), end = i; i < marks_.size(); ++i) {
      if (marks_[i].first != marks_[end].first)
        break;
      if (marks_[i].second > layer)
        return marks_[i].second;
    }
    return std::nullopt;
  }
  std::optional<std::int32_t> below(const Eigen::Vector3d& p, std::int32_t layer) const {
    std::optional<std::int32_t> best;
    for (std::size_t i = firstAt(p), begin = i; i < marks_.size(); ++i) {
      if (marks_[i].first != marks_[begin].first || marks_[i].second >= layer)
        break;
      best = marks_[i].second;
    }
    return best;
  }

private:
  std::size_t firstAt(const Eigen::Vector3d& p) const {
    const auto found = firstOf_.find(cells_.keyOf(p));
    return found == firstOf_.end() ? marks_.size() : found->second;
  }

  CellKeys cells_;
  std::vector<std::pair<CellKey, std::int32_t>> marks_;
  std::unordered_map<CellKey, std::size_t> firstOf_;
};

double meanThickness(const layers::LayerStack& stack) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const layers::Patch& patch : stack.patches)
    for (const double t : patch.thicknessMm) {
      sum += t;
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : 1.0;
}

LayerMarks marksOf(const layers::LayerStack& stack) {
  LayerMarks marks(meanThickness(stack));
  for (const layers::Patch& patch : stack.patches)
    for (const auto& t : patch.surface.triangles) {
      const Eigen::Vector3d &a = patch.surface.vertices[static_cast<std::size_t>(t[0])],
                            &b = patch.surface.vertices[static_cast<std::size_t>(t[1])],
                            &c = patch.surface.vertices[static_cast<std::size_t>(t[2])];
      for (const Eigen::Vector3d& p :
           {a, b, c, Eigen::Vector3d((a + b) / 2), Eigen::Vector3d((b + c) / 2),
            Eigen::Vector3d((c + a) / 2), Eigen::Vector3d((a + b + c) / 3)})
        marks.mark(p, patch.layer);
    }
  marks.finish();
  return marks;
}

using Edge = std::pair<int, int>;

// Returns edges of one triangle only, in that triangle's orientation.
std::vector<Edge> boundaryOf(const geometry::TriangleMesh& surface) {
  std::vector<std::pair<Edge, Edge>> edges; // sorted ends, and the triangle's orientation
  for (const auto& t : surface.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge{t[k], t[(k + 1) % 3]};
      edges.push_back({std::minmax(edge.first, edge.second), edge});
    }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> boundary;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i + 1;
    while (j < edges.size() && edges[j].first == edges[i].first)
      ++j;
    if (j == i + 1)
      boundary.push_back(edges[i].second);
    i = j;
  }
  return boundary;
}

// Per vertex: whether it is within about a cell's width of the boundary.
std::vector<char> nearBoundary(const geometry::TriangleMesh& surface,
                               const std::vector<Edge>& boundary, const CellKeys& cells) {
  std::unordered_set<CellKey> marked;
  for (const Edge& edge : boundary) {
    const Eigen::Vector3d &a = surface.vertices[static_cast<std::size_t>(edge.first)],
                          &b = surface.vertices[static_cast<std::size_t>(edge.second)];
    for (const double share : {0.0, 0.5})
      for (int i = 0; i < 27; ++i)
        marked.insert(
            cells.keyOf(a + share * (b - a) +
                        cells.pitch() * Eigen::Vector3d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1)));
  }
  std::vector<char> near;
  for (const Eigen::Vector3d& v : surface.vertices)
    near.push_back(marked.count(cells.keyOf(v)) > 0);
  return near;
}

// Collects points with their values and triangles with their patch, and assigns each triangle to
// one of the three kinds of faces.
class SlabBuilder {
public:
  void add(const layers::Patch& patch, std::uint32_t index, const LayerMarks& marks) {
    const auto& vertices = patch.surface.vertices;
    std::vector<std::int32_t> top(vertices.size()), bottom(vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const Eigen::Vector3d half = 0.5 * patch.thicknessMm[v] * patch.direction[v];
      top[v] = addPoint(vertices[v] + half, patch.direction[v], patch, v, {true, false});
      bottom[v] = addPoint(vertices[v] - half, -patch.direction[v], patch, v, {false, false});
    }
    const std::vector<Edge> boundary = boundaryOf(patch.surface);
    const std::vector<char> atEdge =
        nearBoundary(patch.surface, boundary, CellKeys(kLedgeInCells * marks.cells().pitch()));
    for (const auto& t : patch.surface.triangles) {
      const auto a = static_cast<std::size_t>(t[0]), b = static_cast<std::size_t>(t[1]),
                 c = static_cast<std::size_t>(t[2]);
      // Layers do not end at the same line: near its boundary one is visible next to the next.
      const bool open = atEdge[a] || atEdge[b] || atEdge[c];
      const Eigen::Vector3d centre = (vertices[a] + vertices[b] + vertices[c]) / 3.0;
      const Eigen::Vector3d step =
          (patch.thicknessMm[a] * patch.direction[a] + patch.thicknessMm[b] * patch.direction[b] +
           patch.thicknessMm[c] * patch.direction[c]) /
          3.0;
      const auto above = marks.above(centre + step, patch.layer);
      const auto below = marks.below(centre - step, patch.layer);
      addFace(faces.upper, patch.layer, above && !open ? *above : kNeverHidden,
              {top[a], top[b], top[c]}, index);
      addFace(faces.lower, patch.layer, below && !open ? -*below : kNeverHidden,
              {bottom[a], bottom[c], bottom[b]}, index);
    }
    for (const auto& [from, to] : boundary) {
      const auto a = static_cast<std::size_t>(from), b = static_cast<std::size_t>(to);
      const Eigen::Vector3d out =
          (vertices[b] - vertices[a]).cross(patch.direction[a] + patch.direction[b]).normalized();
      const Eigen::Vector3d halfA = 0.5 * patch.thicknessMm[a] * patch.direction[a],
                            halfB = 0.5 * patch.thicknessMm[b] * patch.direction[b];
      const auto p = addPoint(vertices[a] - halfA, out, patch, a, {false, true});
      const auto q = addPoint(vertices[b] - halfB, out, patch, b, {false, true});
      const auto r = addPoint(vertices[b] + halfB, out, patch, b, {true, true});
      const auto s = addPoint(vertices[a] + halfA, out, patch, a, {true, true});
      addFace(faces.bands, patch.layer, kNeverHidden, {p, q, r}, index);
      addFace(faces.bands, patch.layer, kNeverHidden, {p, r, s}, index);
      rimMm_ += (vertices[b] - vertices[a]).norm();
    }
  }

  // Appends the triangles of all faces in their sorted order.
  Slabs sorted(SlabFaces& given, std::vector<std::uint32_t>& patches) {
    return {sorted(given, given.bands, patches), sorted(given, given.upper, patches),
            sorted(given, given.lower, patches)};
  }
  // Returns larger faces, few enough for fast frames; empty: these are.
  SlabFaces coarser() {
    std::size_t shown = faces.bands.size();
    for (const auto* list : {&faces.upper, &faces.lower})
      shown += static_cast<std::size_t>(std::ranges::count_if(
          *list, [](const LayeredFace& face) { return face.key == kNeverHidden; }));
    if (shown <= kFastTriangles)
      return {};
    const double edgeMm = rimMm_ / (0.5 * static_cast<double>(faces.bands.size()));
    const double ratio = static_cast<double>(shown) / kFastTriangles;
    return coarseSlabs(faces, points_, kCellsPerRatio * ratio * edgeMm, buffers, values);
  }

  MeshBuffers buffers;
  ColourValues values;
  SlabFaces faces;

private:
  std::int32_t addPoint(const Eigen::Vector3d& p, const Eigen::Vector3d& normal,
                        const layers::Patch& patch, std::size_t vertex, SlabPoint kind) {
    points_.push_back(kind);
    values.layer.push_back(patch.layer);
    values.group.push_back(patch.group);
    values.item.push_back(patch.item);
    values.region.push_back(patch.region);
    values.height.push_back(static_cast<float>(patch.thicknessMm[vertex]));
    values.tiltDeg.push_back(static_cast<float>(
        base::radiansToDegrees(std::acos(std::clamp(patch.direction[vertex].z(), -1.0, 1.0)))));
    return buffers.addPoint(p, normal);
  }
  void addFace(std::vector<LayeredFace>& to, std::int32_t layer, std::int32_t key,
               const std::array<std::int32_t, 3>& triangle, std::uint32_t patch) {
    faces.add(to, {layer, key, 0}, triangle, patch);
  }
  LayeredFaces sorted(const SlabFaces& given, std::vector<LayeredFace> list,
                      std::vector<std::uint32_t>& patches) {
    const std::size_t first = buffers.corners.size() / 3;
    LayeredFaces result(list, first, 1);
    for (const LayeredFace& f : list) {
      const auto& t = given.triangles[static_cast<std::size_t>(f.face)];
      buffers.addTriangle(t[0], t[1], t[2]);
      patches.push_back(given.patchOf[static_cast<std::size_t>(f.face)]);
    }
    return result;
  }

  std::vector<SlabPoint> points_;
  double rimMm_ = 0.0; // of all patches
};

} // namespace

std::shared_ptr<const LayersDrawing> drawLayers(const layers::LayerStack& stack,
                                                const HeightLimits& heights) {
  auto drawing = std::make_shared<LayersDrawing>();
  const LayerMarks marks = marksOf(stack);
  SlabBuilder slabs;
  for (std::size_t i = 0; i < stack.patches.size(); ++i) {
    slabs.add(stack.patches[i], static_cast<std::uint32_t>(i), marks);
    for (const Eigen::Vector3d& v : stack.patches[i].surface.vertices)
      drawing->box.extend(v);
    drawing->layers = std::max(drawing->layers, stack.patches[i].layer + 1);
  }
  drawing->slabs = slabs.sorted(slabs.faces, drawing->patchOfTriangle);
  if (SlabFaces coarse = slabs.coarser(); !coarse.triangles.empty())
    drawing->coarse = slabs.sorted(coarse, drawing->patchOfTriangle);
  drawing->surface = polyDataOf(slabs.buffers);
  drawing->values = std::move(slabs.values);
  drawing->values.heights = heights;
  return drawing;
}

int layerCount(const LayersDrawing& drawing) {
  return drawing.layers;
}

} // namespace voluta::scene
