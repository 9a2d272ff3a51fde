#include "toolpath/plane/same_patches.h"

#include "base/error.h"
#include "base/parallel.h"
#include "toolpath/plane/plane_patch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace voluta::toolpath {

namespace {
using ClipperLib::Path;
using ClipperLib::Paths;

constexpr std::size_t kGrain = 8;
// Rounding puts points of straight edges that far off; and the same lengths that far apart.
constexpr double kStraight = 1.5, kSameMm = 1e-6;

struct Shape {
  // All that has to be the same, as numbers: outlines, seams, lengths, directions, choices.
  std::vector<double> key;
  double heightMm = 0.0;
};

bool isBefore(const ClipperLib::IntPoint& a, const ClipperLib::IntPoint& b) {
  return a.X < b.X || (a.X == b.X && a.Y < b.Y);
}

// Points on straight edges differ from layer to layer: a mesh has them where its triangles meet.
Paths withoutStraightPoints(Paths paths) {
  for (Path& path : paths) {
    std::ranges::rotate(path, std::ranges::min_element(path, isBefore));
    ClipperLib::CleanPolygon(path, kStraight);
    if (!path.empty())
      std::ranges::rotate(path, std::ranges::min_element(path, isBefore));
  }
  std::ranges::sort(paths, [](const Path& a, const Path& b) {
    return std::ranges::lexicographical_compare(a, b, isBefore);
  });
  return paths;
}

void append(std::vector<double>& key, const Paths& paths) {
  key.push_back(static_cast<double>(paths.size()));
  for (const Path& path : paths) {
    key.push_back(static_cast<double>(path.size()));
    for (const ClipperLib::IntPoint& p : path) {
      key.push_back(static_cast<double>(p.X));
      key.push_back(static_cast<double>(p.Y));
    }
  }
}

std::optional<Shape> shapeOf(const layers::Patch& patch, const std::vector<double>& choices) {
  const std::optional<PlanePatch> plane = planePatch(patch);
  if (!plane || !plane->isEven)
    return std::nullopt;
  Shape shape;
  shape.heightMm = plane->heightMm;
  std::vector<double>& key = shape.key;
  append(key, withoutStraightPoints(plane->outline));
  append(key, withoutStraightPoints(plane->seams));
  key.push_back(std::round(plane->thicknessMm / kSameMm));
  for (const Eigen::Vector3d* direction : {&plane->direction, &plane->clearDirection})
    key.insert(key.end(), direction->begin(), direction->end());
  key.insert(key.end(), {static_cast<double>(patch.group), static_cast<double>(patch.tool)});
  key.insert(key.end(), choices.begin(), choices.end());
  return shape;
}
} // namespace

std::vector<SameShape> sameShapes(const std::vector<const layers::Patch*>& patches,
                                  const std::vector<std::vector<double>>& choices,
                                  const base::RunContext& ctx) {
  base::require(choices.size() == patches.size(), "choices per patch");
  std::vector<std::optional<Shape>> shapes(patches.size());
  base::parallelChunks(ctx, patches.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      shapes[i] = shapeOf(*patches[i], choices[i]);
  });
  std::map<std::vector<double>, std::size_t> firsts;
  std::vector<SameShape> same(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i) {
    same[i].patch = i;
    if (!shapes[i])
      continue;
    const auto [first, isNew] = firsts.try_emplace(std::move(shapes[i]->key), i);
    if (isNew)
      continue;
    same[i].patch = first->second;
    same[i].shiftMm =
        (shapes[i]->heightMm - shapes[first->second]->heightMm) * patches[i]->direction.front();
  }
  return same;
}

} // namespace voluta::toolpath
