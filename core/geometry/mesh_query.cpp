#include "geometry/mesh_query.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace voluta::geometry {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

namespace {

constexpr int kLeafTriangles = 4;
constexpr int kBins = 16;
// Below this depth nodes are split at the median, which bounds the depth and thereby the stacks.
constexpr int kHeuristicDepth = 40;
constexpr std::size_t kStack = 128;
// A cluster is far if the distance to its centre exceeds this many of its radii.
constexpr double kFar = 2.4;

double halfArea(const AlignedBox3d& box) {
  const Vector3d s = box.sizes();
  return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

double squaredDistanceToBox(const Vector3d& p, const Vector3d& low, const Vector3d& high) {
  return (low - p).cwiseMax(p - high).cwiseMax(0.0).squaredNorm();
}

struct Split {
  int axis = -1;
  double at = 0.0;
};

// Returns the cut of lowest surface area cost between kBins slabs of the centroids' box, along its
// longest side. The two other axes are rarely cheaper, and testing them takes twice as long.
Split bestSplit(const std::vector<AlignedBox3d>& boxes, const int* begin, const int* end) {
  AlignedBox3d centres;
  for (const int* i = begin; i != end; ++i)
    centres.extend(boxes[static_cast<std::size_t>(*i)].center());
  Split best;
  double bestCost = std::numeric_limits<double>::infinity();
  Eigen::Index axis = 0;
  const double width = centres.sizes().maxCoeff(&axis), low = centres.min()[axis];
  if (width > 0.0) {
    std::array<AlignedBox3d, kBins> bins;
    std::array<int, kBins> counts{};
    for (const int* i = begin; i != end; ++i) {
      const AlignedBox3d& box = boxes[static_cast<std::size_t>(*i)];
      const auto bin = static_cast<std::size_t>(
          std::clamp(static_cast<int>(kBins * (box.center()[axis] - low) / width), 0, kBins - 1));
      bins[bin].extend(box);
      ++counts[bin];
    }
    std::array<double, kBins> rightCost{};
    AlignedBox3d right;
    int rightCount = 0;
    for (std::size_t bin = kBins; bin-- > 1;) {
      right.extend(bins[bin]);
      rightCount += counts[bin];
      rightCost[bin] = rightCount ? rightCount * halfArea(right) : 0.0;
    }
    AlignedBox3d left;
    int leftCount = 0;
    for (std::size_t bin = 0; bin + 1 < kBins; ++bin) {
      left.extend(bins[bin]);
      leftCount += counts[bin];
      if (leftCount == 0 || leftCount == end - begin)
        continue;
      const double cost = leftCount * halfArea(left) + rightCost[bin + 1];
      if (cost < bestCost) {
        bestCost = cost;
        best = {static_cast<int>(axis), low + width * static_cast<double>(bin + 1) / kBins};
      }
    }
  }
  return best;
}

} // namespace

MeshQuery::MeshQuery(const TriangleMesh& mesh, Of what) {
  for (const Vector3d& v : mesh.vertices)
    base::require(v.allFinite(), "MeshQuery: coordinates are finite");
  for (const auto& t : mesh.triangles)
    for (const int v : t)
      base::require(v >= 0 && static_cast<std::size_t>(v) < mesh.vertices.size(),
                    "MeshQuery: vertex indices in range");
  if (mesh.empty())
    return;
  build(mesh);
  if (what == Of::Solid)
    expandClusters();
}

void MeshQuery::build(const TriangleMesh& mesh) {
  const std::size_t n = mesh.triangles.size();
  std::vector<AlignedBox3d> boxes(n);
  for (std::size_t t = 0; t < n; ++t)
    for (int k = 0; k < 3; ++k)
      boxes[t].extend(mesh.corner(t, k));
  index_.resize(n);
  std::iota(index_.begin(), index_.end(), 0);

  struct Task {
    std::size_t node;
    int begin, end, depth;
  };
  nodes_.reserve(n);
  nodes_.emplace_back();
  std::vector<Task> tasks{{0, 0, static_cast<int>(n), 0}};
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    int* const begin = index_.data() + task.begin;
    int* const end = index_.data() + task.end;
    AlignedBox3d box;
    for (const int* i = begin; i != end; ++i)
      box.extend(boxes[static_cast<std::size_t>(*i)]);
    nodes_[task.node].low = box.min();
    nodes_[task.node].high = box.max();
    if (end - begin <= kLeafTriangles) {
      nodes_[task.node].first = task.begin;
      nodes_[task.node].count = task.end - task.begin;
      continue;
    }
    int* middle = begin;
    if (task.depth < kHeuristicDepth) {
      const Split split = bestSplit(boxes, begin, end);
      if (split.axis >= 0)
        middle = std::stable_partition(begin, end, [&](int i) {
          return boxes[static_cast<std::size_t>(i)].center()[split.axis] < split.at;
        });
    }
    if (middle == begin || middle == end)
      middle = begin + (end - begin) / 2;
    const int cut = static_cast<int>(middle - index_.data());
    const std::size_t left = nodes_.size();
    nodes_[task.node].first = static_cast<int>(left);
    nodes_[task.node].count = 0;
    nodes_.emplace_back();
    nodes_.emplace_back();
    tasks.push_back({left + 1, cut, task.end, task.depth + 1});
    tasks.push_back({left, task.begin, cut, task.depth + 1});
  }
  triangles_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto t = static_cast<std::size_t>(index_[i]);
    triangles_[i] = {mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
  }
}

void MeshQuery::expandClusters() {
  const Vector3d origin = 0.5 * (nodes_[0].low + nodes_[0].high);
  std::vector<FarFieldSums> sums(nodes_.size());
  clusters_.resize(nodes_.size());
  // Children have larger indices than their parent.
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    const auto first = static_cast<std::size_t>(node.first);
    if (node.count > 0) {
      for (std::size_t t = first; t < first + static_cast<std::size_t>(node.count); ++t)
        sums[i].addTriangle(triangles_[t].a - origin, triangles_[t].b - origin,
                            triangles_[t].c - origin);
    } else {
      sums[i].add(sums[first]);
      sums[i].add(sums[first + 1]);
    }
    clusters_[i] = FarField(sums[i], origin, node.low, node.high);
  }
}

MeshQuery::Closest MeshQuery::closest(const Vector3d& p, double maxDistance) const {
  Closest best;
  if (nodes_.empty() || !(maxDistance >= 0.0))
    return best;
  double bound = maxDistance * maxDistance;
  struct Entry {
    int node;
    double squared;
  };
  std::array<Entry, kStack> stack;
  std::size_t top = 0;
  stack[top++] = {0, squaredDistanceToBox(p, nodes_[0].low, nodes_[0].high)};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (entry.squared > bound)
      continue;
    const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
    if (node.count > 0) {
      for (int i = node.first; i < node.first + node.count; ++i) {
        const auto t = static_cast<std::size_t>(i);
        const Triangle& tri = triangles_[t];
        const Vector3d q = closestPointOnTriangle(p, tri.a, tri.b, tri.c);
        const double squared = (q - p).squaredNorm();
        if (squared < bound ||
            (squared == bound && (best.triangle < 0 || index_[t] < best.triangle))) {
          bound = squared;
          best.point = q;
          best.triangle = index_[t];
        }
      }
      continue;
    }
    const auto left = static_cast<std::size_t>(node.first);
    Entry near{node.first, squaredDistanceToBox(p, nodes_[left].low, nodes_[left].high)};
    Entry far{node.first + 1, squaredDistanceToBox(p, nodes_[left + 1].low, nodes_[left + 1].high)};
    if (far.squared < near.squared)
      std::swap(near, far);
    if (far.squared <= bound)
      stack[top++] = far;
    if (near.squared <= bound)
      stack[top++] = near;
  }
  if (best.triangle >= 0)
    best.distance = std::sqrt(bound);
  return best;
}

double MeshQuery::windingNumber(const Vector3d& p) const {
  if (nodes_.empty())
    return 0.0;
  base::require(!clusters_.empty(), "MeshQuery: winding numbers are of solids");
  double angle = 0.0;
  std::array<int, kStack> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const auto i = static_cast<std::size_t>(stack[--top]);
    if (clusters_[i].isFar(p, kFar)) {
      angle += clusters_[i].solidAngle(p);
      continue;
    }
    const Node& node = nodes_[i];
    if (node.count == 0) {
      stack[top++] = node.first + 1;
      stack[top++] = node.first;
      continue;
    }
    const auto first = static_cast<std::size_t>(node.first);
    for (std::size_t t = first; t < first + static_cast<std::size_t>(node.count); ++t)
      angle += solidAngle(p, triangles_[t].a, triangles_[t].b, triangles_[t].c);
  }
  return angle / (4.0 * base::kPi);
}

double MeshQuery::signedDistance(const Vector3d& p) const {
  const double distance = closest(p).distance;
  return inside(p) ? -distance : distance;
}

std::optional<MeshQuery::Hit> MeshQuery::firstHit(const Vector3d& a, const Vector3d& b) const {
  if (nodes_.empty())
    return std::nullopt;
  const SegmentTest segment(a, b);
  Hit best{1.0, -1};
  std::array<int, kStack> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--top])];
    if (!segment.mayTouch(node.low, node.high, best.t))
      continue;
    if (node.count == 0) {
      // Visit the child that the segment enters first.
      const auto left = static_cast<std::size_t>(node.first);
      const Vector3d apart =
          (nodes_[left + 1].low + nodes_[left + 1].high) - (nodes_[left].low + nodes_[left].high);
      const int leftFirst = apart.dot(b - a) >= 0.0 ? 1 : 0;
      stack[top++] = node.first + leftFirst;
      stack[top++] = node.first + 1 - leftFirst;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const auto t = static_cast<std::size_t>(i);
      const auto at = segment.cross(triangles_[t].a, triangles_[t].b, triangles_[t].c);
      if (at &&
          (*at < best.t || (*at == best.t && (best.triangle < 0 || index_[t] < best.triangle))))
        best = {*at, index_[t]};
    }
  }
  if (best.triangle < 0)
    return std::nullopt;
  return best;
}

void MeshQuery::hits(const Vector3d& a, const Vector3d& b, std::vector<Hit>& out) const {
  out.clear();
  if (nodes_.empty())
    return;
  const SegmentTest segment(a, b);
  std::array<int, kStack> stack;
  std::size_t top = 0;
  stack[top++] = 0;
  while (top > 0) {
    const Node& node = nodes_[static_cast<std::size_t>(stack[--top])];
    if (!segment.mayTouch(node.low, node.high, 1.0))
      continue;
    if (node.count == 0) {
      stack[top++] = node.first + 1;
      stack[top++] = node.first;
      continue;
    }
    for (int i = node.first; i < node.first + node.count; ++i) {
      const auto t = static_cast<std::size_t>(i);
      if (const auto at = segment.cross(triangles_[t].a, triangles_[t].b, triangles_[t].c))
        out.push_back({*at, index_[t]});
    }
  }
  std::sort(out.begin(), out.end(), [](const Hit& x, const Hit& y) {
    return x.t != y.t ? x.t < y.t : x.triangle < y.triangle;
  });
}

} // namespace voluta::geometry
