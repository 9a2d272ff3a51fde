#include "pipeline/printed_mesh.h"

#include "process/bead_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace voluta::pipeline {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr double kStraightMm = 0.15;
constexpr double kTurn = 0.97, kSection = 0.1; // cosine, and share, within which points are alike
constexpr int kCorners = 8;

const std::array<Vector3i, 6> kSides{Vector3i(1, 0, 0),  Vector3i(-1, 0, 0), Vector3i(0, 1, 0),
                                     Vector3i(0, -1, 0), Vector3i(0, 0, 1),  Vector3i(0, 0, -1)};

// What is outside the part: cells that are empty with all their neighbours and hang together around
// it. Channels between beads, a cell or two wide, are no outside though they open to it.
class Outside {
public:
  explicit Outside(const collision::GrowingPart& part) {
    grid_ = part.grid();
    grid_.origin -= grid_.pitch * kBorder * Vector3d::Ones();
    grid_.size += 2 * kBorder * Vector3i::Ones();
    markWide(part);
    std::vector<std::size_t> front{grid_.index(1, 1, 1)};
    cells_[front.front()] = kOutside;
    const auto steps = stepsOf();
    while (!front.empty()) {
      const std::size_t cell = front.back();
      front.pop_back();
      for (const std::ptrdiff_t step : steps)
        if (char& next = cells_[moved(cell, step)]; next == kWide) {
          next = kOutside;
          front.push_back(moved(cell, step));
        }
    }
  }

  // Is a cell of the part's own grid next to the outside?
  bool sees(const Vector3i& cell) const {
    const Vector3i here = cell + kBorder * Vector3i::Ones();
    for (const Vector3i& side : kSides)
      for (int far = 1; far <= 2; ++far) {
        const Vector3i next = here + far * side;
        if (cells_[grid_.index(next.x(), next.y(), next.z())] == kOutside)
          return true;
      }
    return false;
  }

private:
  enum : char { kFilled, kEmpty, kWide, kOutside };
  static constexpr int kBorder = 3;

  static std::size_t moved(std::size_t cell, std::ptrdiff_t by) {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + by);
  }
  // To the cells beside one.
  std::array<std::ptrdiff_t, 6> stepsOf() const {
    const std::ptrdiff_t x = 1, y = grid_.size.x(), z = y * grid_.size.y();
    return {x, -x, y, -y, z, -z};
  }

  // The outermost cells stay as they are: nothing spreads beyond them.
  void markWide(const collision::GrowingPart& part) {
    cells_.assign(grid_.cellCount(), kEmpty);
    const voxel::VoxelGrid& own = part.grid();
    std::size_t c = 0;
    for (int k = 0; k < own.size.z(); ++k)
      for (int j = 0; j < own.size.y(); ++j)
        for (int i = 0; i < own.size.x(); ++i, ++c)
          if (part.filledAt(c) != collision::GrowingPart::kNeverFilled)
            cells_[grid_.index(i + kBorder, j + kBorder, k + kBorder)] = kFilled;
    const auto steps = stepsOf();
    for (int k = 1; k + 1 < grid_.size.z(); ++k)
      for (int j = 1; j + 1 < grid_.size.y(); ++j)
        for (int i = 1; i + 1 < grid_.size.x(); ++i) {
          const std::size_t cell = grid_.index(i, j, k);
          if (cells_[cell] != kFilled && std::ranges::none_of(steps, [&](auto by) {
                return cells_[moved(cell, by)] == kFilled;
              }))
            cells_[cell] = kWide;
        }
  }

  voxel::VoxelGrid grid_; // the part's with a border
  std::vector<char> cells_;
};

// Is the segment that ends at a waypoint seen from outside?
std::vector<char> seenSegments(const plan::ToolPlan& plan, const collision::GrowingPart& part) {
  const voxel::VoxelGrid& grid = part.grid();
  const Outside outside(part);
  std::vector<char> seen(plan.waypointCount(), 0);
  for (std::size_t c = 0; c < grid.cellCount(); ++c) {
    const std::uint32_t at = part.filledAt(c);
    if (at < seen.size() && !seen[at] && outside.sees(grid.cell(c)))
      seen[at] = 1;
  }
  return seen;
}

class Tubes {
public:
  explicit Tubes(const plan::ToolPlan& plan) : plan_(plan) {}

  // Along waypoints [first, last].
  void add(std::size_t first, std::size_t last) {
    std::vector<std::size_t> kept{first};
    for (std::size_t i = first + 1; i < last; ++i)
      if (!straight(kept.back(), i, i + 1))
        kept.push_back(i);
    kept.push_back(last);
    int before = -1;
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const Vector3d along = (plan_.position[kept[std::min(k + 1, kept.size() - 1)]] -
                              plan_.position[kept[k > 0 ? k - 1 : 0]]);
      const int ring = addRing(kept[k], along);
      if (before >= 0)
        join(before, ring);
      else
        close(ring, true);
      before = ring;
    }
    close(before, false);
  }

  geometry::TriangleMesh take() { return std::move(mesh_); }

private:
  // Does what lies between `from` and `to` keep near the line, as `at` does?
  bool straight(std::size_t from, std::size_t at, std::size_t to) const {
    const Vector3d line = (plan_.position[to] - plan_.position[from]).normalized();
    for (std::size_t i = from + 1; i <= at; ++i) {
      const Vector3d off = plan_.position[i] - plan_.position[from];
      if ((off - off.dot(line) * line).norm() > kStraightMm)
        return false;
    }
    const auto alike = [&](const std::vector<float>& v) {
      return std::abs(v[to] - v[from]) <= kSection * v[from];
    };
    return plan_.direction[from].dot(plan_.direction[to]) > kTurn && alike(plan_.widthMm) &&
           alike(plan_.heightMm);
  }

  int addRing(std::size_t i, const Vector3d& along) {
    const Vector3d& up = plan_.direction[i];
    Vector3d side = up.cross(along);
    if (!(side.norm() > 1e-9))
      side = up.unitOrthogonal();
    side.normalize();
    // A rectangle with its corners cut off by as much as the round ends lack of it.
    const double height = plan_.heightMm[i], cut = height * std::sqrt(0.5 * process::kRoundLoss);
    const double w = 0.5 * std::max(static_cast<double>(plan_.widthMm[i]), height);
    const double h = 0.5 * height, wIn = w - cut, hIn = h - cut;
    const std::array<Eigen::Vector2d, kCorners> section{
        {{wIn, h}, {w, hIn}, {w, -hIn}, {wIn, -h}, {-wIn, -h}, {-w, -hIn}, {-w, hIn}, {-wIn, h}}};
    const Vector3d centre = plan_.position[i] - 0.5 * height * up;
    const int ring = static_cast<int>(mesh_.vertices.size());
    for (const Eigen::Vector2d& c : section)
      mesh_.vertices.push_back(centre + c.x() * side + c.y() * up);
    return ring;
  }

  // The ring runs clockwise seen from behind: side x up is against the way.
  void join(int a, int b) {
    for (int k = 0; k < kCorners; ++k) {
      const int next = (k + 1) % kCorners;
      mesh_.triangles.push_back({a + k, b + k, b + next});
      mesh_.triangles.push_back({a + k, b + next, a + next});
    }
  }
  void close(int ring, bool begin) {
    for (int k = 1; k + 1 < kCorners; ++k)
      if (begin)
        mesh_.triangles.push_back({ring, ring + k, ring + k + 1});
      else
        mesh_.triangles.push_back({ring, ring + k + 1, ring + k});
  }

  const plan::ToolPlan& plan_;
  geometry::TriangleMesh mesh_;
};

} // namespace

geometry::TriangleMesh outerBeads(const plan::ToolPlan& plan, const collision::GrowingPart& part) {
  const std::vector<char> seen = seenSegments(plan, part);
  Tubes tubes(plan);
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1, end = path.first + path.count;
         path.kind != plan::PathKind::Skirt && i < end;) {
      if (!seen[i]) {
        ++i;
        continue;
      }
      const std::size_t first = i - 1;
      while (i < end && seen[i])
        ++i;
      tubes.add(first, i - 1);
    }
  return tubes.take();
}

} // namespace voluta::pipeline
