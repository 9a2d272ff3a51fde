#include "curved/extraction.h"

#include "base/error.h"
#include "base/parallel.h"
#include "curved/cell_contour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace voluta::curved {

namespace {

// A node this near to a level (share of the pitch) counts as just below it. Otherwise a level
// through voxel centres would be cut at random by rounding errors of the field.
constexpr double kSnap = 1e-3;
// [voxels]: beyond this distance the local slope does not predict where the next level is.
constexpr double kFarGuess = 2.0;
// If its direction's z component is smaller, level 0 is not treated as a first layer on the plate.
constexpr double kFlat = 0.8;

struct CellKey {
  int i, j, k;
};

// Builds one level from the cells it passes through.
class LevelBuilder {
public:
  LevelBuilder(const LevelField& field, int level, double spacing)
      : field_(field), spacing_(spacing), iso_((level + 0.5) * spacing),
        snap_(kSnap * field.grid().pitch) {
    out_.level = level;
  }

  void addCell(const CellKey& key) {
    const std::optional<LevelField::Cell> cell = field_.cell(key.i, key.j, key.k);
    if (!cell)
      return;
    std::uint8_t below = 0;
    std::array<double, 8> height;
    for (std::size_t c = 0; c < 8; ++c) {
      height[c] = heightOf(cell->nodes[c]);
      if (height[c] < 0.0)
        below |= static_cast<std::uint8_t>(1u << c);
    }
    for (const std::vector<int>& loop : cubeLoops(below)) {
      std::vector<int>& polygon = polygon_;
      polygon.clear();
      for (int e : loop)
        polygon.push_back(edgeVertex(key, *cell, height, e));
      fillPolygon(key, *cell, loop);
    }
  }

  RawLevel take() { return std::move(out_); }

private:
  double heightOf(int node) const {
    const double h = field_.value(node) - iso_;
    return std::abs(h) < snap_ ? -snap_ : h;
  }

  Eigen::Vector3d cornerOf(const CellKey& key, int c) const {
    return field_.grid().centre(key.i + (c & 1), key.j + (c >> 1 & 1), key.k + (c >> 2));
  }

  int edgeVertex(const CellKey& key, const LevelField::Cell& cell,
                 const std::array<double, 8>& height, int e) {
    const CubeEdge edge = cubeEdges()[static_cast<std::size_t>(e)];
    const auto from = static_cast<std::size_t>(edge.from), to = static_cast<std::size_t>(edge.to);
    const auto a = static_cast<std::uint64_t>(std::min(cell.nodes[from], cell.nodes[to]));
    const auto b = static_cast<std::uint64_t>(std::max(cell.nodes[from], cell.nodes[to]));
    const auto [at, isNew] = vertexOf_.try_emplace(a << 32 | b, -1);
    if (isNew) {
      const double t = height[from] / (height[from] - height[to]);
      const Eigen::Vector3d p = (1.0 - t) * cornerOf(key, edge.from) + t * cornerOf(key, edge.to);
      const Eigen::Vector3d g =
          (1.0 - t) * field_.gradient(cell.nodes[from]) + t * field_.gradient(cell.nodes[to]);
      at->second = addVertex(key, cell, p, g);
    }
    return at->second;
  }

  int addVertex(const CellKey& key, const LevelField::Cell& cell, const Eigen::Vector3d& p,
                const Eigen::Vector3d& gradient) {
    const double slope = std::max(gradient.norm(), 1e-3);
    const Eigen::Vector3d direction =
        gradient.norm() > 1e-6 ? Eigen::Vector3d(gradient.normalized()) : Eigen::Vector3d::UnitZ();
    Eigen::Vector3d position = p;
    const double up = march(p, direction, slope, 1.0), down = march(p, direction, slope, -1.0);
    double thickness = up + down;
    const double bottom = p.z() - down * direction.z(), top = p.z() + up * direction.z();
    if (out_.level == 0 && direction.z() > kFlat && top > 0.1 * spacing_) {
      // Full shift if the field starts at the plate; less with the distance from it.
      const double share = std::clamp(2.0 - std::abs(bottom) / (0.25 * spacing_), 0.0, 1.0);
      position += direction * (share * (0.5 * top - p.z()) / direction.z());
      thickness += share * (top / direction.z() - thickness);
    } else if (direction.z() > kFlat && p.z() > 0.0 && p.z() < down * direction.z()) {
      thickness = up + p.z() / direction.z();
    }
    out_.surface.vertices.push_back(position);
    out_.direction.push_back(direction);
    out_.thicknessMm.push_back(thickness);
    out_.clearDirection.push_back(clearDirection(key, cell, p, direction));
    return static_cast<int>(out_.surface.vertices.size()) - 1;
  }

  // Returns the distance along `ray` at which the field has changed by `change` or ends; at most
  // `limit`.
  double walk(const Eigen::Vector3d& p, const Eigen::Vector3d& ray, double change,
              double limit) const {
    const double step = 0.25 * field_.grid().pitch;
    for (double s = step; s < limit; s += step) {
      const std::optional<double> v = field_.valueAt(p + s * ray);
      if (!v || std::abs(*v - iso_) >= change)
        return s;
    }
    return limit;
  }

  // Returns the distance from the mid-surface along sign * direction to the level half a spacing
  // away, by secant steps in the interpolated field, or the first-order guess where the field ends
  // or jumps. Where the field is flat, that guess can be far outside the part; walk() replaces it
  // there.
  double march(const Eigen::Vector3d& p, const Eigen::Vector3d& direction, double slope,
               double sign) const {
    const double half = 0.5 * spacing_;
    double guess = half / slope;
    if (guess > kFarGuess * field_.grid().pitch)
      guess = walk(p, sign * direction, half, guess);
    double s = guess;
    for (int step = 0; step < 3; ++step) {
      const std::optional<double> v = field_.valueAt(p + sign * s * direction);
      if (!v)
        return guess;
      const double climbed = sign * (*v - iso_);
      if (!(climbed > 0.4 * half && climbed < 2.5 * half))
        return guess;
      s *= half / climbed;
      if (std::abs(climbed - half) < 1e-4 * half)
        break;
    }
    return std::clamp(s, 0.5 * guess, 2.0 * guess);
  }

  Eigen::Vector3d clearDirection(const CellKey& key, const LevelField::Cell& cell,
                                 const Eigen::Vector3d& p, const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d local =
        ((p - cornerOf(key, 0)) / field_.grid().pitch).cwiseMax(0.0).cwiseMin(1.0);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int c = 0; c < 8; ++c) {
      const double w = 1e-3 + (c & 1 ? local.x() : 1.0 - local.x()) *
                                  (c & 2 ? local.y() : 1.0 - local.y()) *
                                  (c & 4 ? local.z() : 1.0 - local.z());
      sum += w * field_.frontNormal(cell.nodes[static_cast<std::size_t>(c)]);
    }
    const double n = sum.norm();
    return n > 1e-6 ? Eigen::Vector3d(sum / n) : direction;
  }

  const Eigen::Vector3d& at(int v) const {
    return out_.surface.vertices[static_cast<std::size_t>(v)];
  }

  // Cuts the best-shaped ears first. Never uses a diagonal in a face of the cube, as the
  // neighbouring cube might use the same one.
  void fillPolygon(const CellKey& key, const LevelField::Cell& cell, std::vector<int> loop) {
    std::vector<int>& p = polygon_;
    auto& triangles = out_.surface.triangles;
    while (p.size() > 3) {
      const std::size_t n = p.size();
      std::size_t best = n;
      double bestLength = 0.0;
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t before = (k + n - 1) % n, after = (k + 1) % n;
        if (shareFace(loop[before], loop[after]))
          continue;
        const double length = (at(p[before]) - at(p[after])).squaredNorm();
        if (best == n || length < bestLength) {
          best = k;
          bestLength = length;
        }
      }
      if (best == n) {
        fanFromCentre(key, cell);
        return;
      }
      triangles.push_back({p[(best + n - 1) % n], p[best], p[(best + 1) % n]});
      p.erase(p.begin() + static_cast<std::ptrdiff_t>(best));
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(best));
    }
    triangles.push_back({p[0], p[1], p[2]});
  }

  void fanFromCentre(const CellKey& key, const LevelField::Cell& cell) {
    const std::vector<int> rim = polygon_;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), direction = Eigen::Vector3d::Zero();
    for (int v : rim) {
      centre += at(v);
      direction += out_.direction[static_cast<std::size_t>(v)];
    }
    centre /= static_cast<double>(rim.size());
    const std::optional<LevelField::Sample> s = field_.sample(centre);
    const int c = addVertex(key, cell, centre, s ? s->gradient : direction);
    for (std::size_t k = 0; k < rim.size(); ++k)
      out_.surface.triangles.push_back({rim[k], rim[(k + 1) % rim.size()], c});
  }

  const LevelField& field_;
  double spacing_, iso_, snap_;
  RawLevel out_;
  std::vector<int> polygon_;
  std::unordered_map<std::uint64_t, int> vertexOf_;
};

// Returns the cells that each level passes through, in grid order, restricted to wanted cells.
template <typename Wanted>
std::vector<std::vector<CellKey>> cellsOfLevels(const LevelField& field, double spacing,
                                                Wanted&& wanted, const base::RunContext& ctx) {
  const double snap = 2.0 * kSnap * field.grid().pitch;
  const int count =
      static_cast<int>(std::floor((field.maxPrinted() + field.grid().pitch) / spacing + 0.5)) + 1;
  std::vector<std::vector<CellKey>> cells(static_cast<std::size_t>(std::max(count, 0)));
  for (int k = -1; k < field.grid().size.z(); ++k) {
    ctx.checkpoint();
    for (int j = -1; j < field.grid().size.y(); ++j)
      for (int i = -1; i < field.grid().size.x(); ++i) {
        if (!wanted(i, j, k))
          continue;
        const std::optional<LevelField::Cell> cell = field.cell(i, j, k);
        if (!cell)
          continue;
        double low = field.value(cell->nodes[0]), high = low;
        for (int node : cell->nodes) {
          low = std::min(low, field.value(node));
          high = std::max(high, field.value(node));
        }
        const int first = std::max(0, static_cast<int>(std::ceil((low - snap) / spacing - 0.5)));
        const int last =
            std::min(count - 1, static_cast<int>(std::floor((high + snap) / spacing - 0.5)));
        for (int level = first; level <= last; ++level)
          cells[static_cast<std::size_t>(level)].push_back({i, j, k});
      }
  }
  return cells;
}

RawLevel levelThrough(const LevelField& field, int level, double spacing,
                      const std::vector<CellKey>& cells, const base::RunContext& ctx) {
  LevelBuilder builder(field, level, spacing);
  std::size_t done = 0;
  for (const CellKey& key : cells) {
    builder.addCell(key);
    if (++done % 4096 == 0)
      ctx.checkpoint();
  }
  return builder.take();
}

// Removes the parts of a slab's surface that are not printed.
void keepPrinted(RawLevel& level, const LevelField& field, const PartialLevels& partial,
                 const Slab& slab) {
  const auto& vertices = level.surface.vertices;
  std::vector<double> margin(vertices.size());
  bool whole = true;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::optional<LevelField::Sample> s = field.sample(vertices[v]);
    margin[v] =
        partial.margin(slab, vertices[v], s ? s->gradient : Eigen::Vector3d(level.direction[v]));
    whole &= margin[v] >= 0.0;
  }
  if (!whole)
    layers::keepPositive(level, margin);
}

} // namespace

std::vector<RawLevel> extractLevels(const LevelField& field, double spacingMm,
                                    const base::RunContext& ctx) {
  base::require(spacingMm > 0.0, "a positive spacing of levels");
  const std::vector<std::vector<CellKey>> cells = cellsOfLevels(
      field, spacingMm, [](int, int, int) { return true; }, ctx);
  std::vector<RawLevel> levels(cells.size());
  base::parallelChunks(ctx, cells.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t level = b; level < e; ++level)
      levels[level] = levelThrough(field, static_cast<int>(level), spacingMm, cells[level], ctx);
  });
  return levels;
}

std::vector<RawSlab> extractSlabs(const LevelField& field, const PartialLevels& partial,
                                  const base::RunContext& ctx) {
  struct Piece {
    Slab slab;
    std::vector<CellKey> cells;
  };
  std::vector<Piece> pieces;
  for (int scale = PartialLevels::kFinest; scale <= PartialLevels::kCoarsest; ++scale) {
    if (!partial.uses(scale))
      continue;
    auto cells = cellsOfLevels(
        field, partial.widthMm(scale),
        [&](int i, int j, int k) { return partial.mayHold(scale, i, j, k); }, ctx);
    for (std::size_t n = 0; n < cells.size(); ++n)
      if (!cells[n].empty())
        pieces.push_back({{scale, static_cast<int>(n)}, std::move(cells[n])});
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return PartialLevels::bottomOf(a.slab) < PartialLevels::bottomOf(b.slab);
  });
  std::vector<RawSlab> slabs(pieces.size());
  base::parallelChunks(ctx, pieces.size(), 1, [&](std::size_t b, std::size_t e) {
    for (std::size_t n = b; n < e; ++n) {
      const Slab& slab = pieces[n].slab;
      RawLevel surface =
          levelThrough(field, slab.index, partial.widthMm(slab.scale), pieces[n].cells, ctx);
      if (partial.any())
        keepPrinted(surface, field, partial, slab);
      surface.level = PartialLevels::bottomOf(slab);
      slabs[n] = {slab, std::move(surface)};
    }
  });
  return slabs;
}

std::vector<RawLevel> extractLevels(const Decomposition& decomposition, double spacingMm,
                                    const base::RunContext& ctx) {
  return extractLevels(LevelField(decomposition, ctx), spacingMm, ctx);
}

} // namespace voluta::curved
