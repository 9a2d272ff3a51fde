#include "scene/drawn.h"

#include "scene/colour_values.h"
#include "scene/piece_actors.h"
#include "scene/visible_beads.h"

#include <algorithm>

namespace voluta::scene {

namespace {
constexpr double kSolidOpacity = 0.5; // fainter drawings count as transparent

void keepNearest(std::optional<RayHit>& best, const std::optional<RayHit>& hit) {
  if (hit && (!best || hit->t < best->t))
    best = hit;
}
} // namespace

bool Between::machine() const {
  return platform || std::ranges::find(roles, true) != roles.end();
}

const VoxelDrawing* Drawn::shownVoxels() const {
  return replaysGrowth() ? growth.get() : view.voxels ? voxels.get() : nullptr;
}

bool Drawn::isSeeThrough() const {
  return view.partOpacity < kSolidOpacity;
}

std::vector<Stretch> Drawn::layerStretches(bool undersides) const {
  std::vector<Stretch> shown;
  const std::int32_t above = view.sectionOn ? -kNeverHidden : view.lastLayer;
  const std::int32_t below = view.sectionOn ? -kNeverHidden : -view.firstLayer;
  const Slabs& slabs =
      view.dragging && layers->coarse.size() > 0 && layers->slabs.size() > view.draggedTriangles
          ? layers->coarse
          : layers->slabs;
  slabs.bands.append(shown, view.firstLayer, view.lastLayer, -kNeverHidden, view.dragging);
  slabs.upper.append(shown, view.firstLayer, view.lastLayer, above, view.dragging);
  if (undersides)
    slabs.lower.append(shown, view.firstLayer, view.lastLayer, below, view.dragging);
  return shown;
}

std::optional<RayHit> Drawn::nearestPrinted(const Ray& ray, bool solid) const {
  const IsShown shown = [&](const Eigen::Vector3d& p) {
    return !view.sectionOn || (p - view.sectionOrigin).dot(view.sectionNormal) <= 0.0;
  };
  std::optional<RayHit> best;
  if (shows(view.part, part.get()) && view.partOpacity > 0.0 && !(solid && isSeeThrough()))
    keepNearest(best, pickPart(*part, ray, shown));
  if (view.otherParts && !(solid && view.otherPartsOpacity < kSolidOpacity))
    keepNearest(best, pickOther(others, ray, shown));
  if (replaysGrowth()) {
    std::optional<RayHit> hit = pickVoxel(*growth, ray, 0, *view.growthStep - 1, shown);
    if (hit)
      hit->hit.layer = -1;
    keepNearest(best, hit);
  } else if (const VoxelDrawing* drawing = shownVoxels(); drawing && !(solid && view.seeThrough)) {
    keepNearest(best, pickVoxel(*drawing, ray, view.firstLayer, view.lastLayer, shown));
  }
  if (shows(view.pieces, pieces.get()))
    keepNearest(best, pickPiece(*pieces, ray, pieceOffsets(*pieces, view.explodeMm), shown));
  if (shows(view.layers, layers.get()))
    keepNearest(best, pickLayer(*layers, ray, layerStretches(true), shown));
  if (shows(view.paths, paths.get()))
    keepNearest(best, pickPath(*paths, ray, visibleBeads(*paths, view).stretches, shown));
  return best;
}

std::vector<Eigen::Isometry3d> Drawn::framesInWork() const {
  std::vector<Eigen::Isometry3d> work_T_frame = world_T_frame;
  for (Eigen::Isometry3d& pose : work_T_frame)
    pose = world_T_work.inverse() * pose;
  return work_T_frame;
}

bool Drawn::isBodyShown(std::size_t body) const {
  const robot::BodyRole role = cell->cell.bodies()[body].role;
  return view.roles[static_cast<std::size_t>(role)] &&
         (!view.cellDimmed || role == robot::BodyRole::Platform);
}

std::optional<RayHit> Drawn::nearest(const Ray& ray) const {
  std::optional<RayHit> best = nearestPrinted(ray, false);
  if (shows(view.platform, platform.get()))
    keepNearest(best, pickPlatform(*platform, ray));
  if (!shows(view.cell, cell.get()))
    return best;
  const std::vector<Eigen::Isometry3d> work_T_frame = framesInWork();
  for (std::size_t body = 0; body < cell->cell.bodies().size(); ++body)
    if (isBodyShown(body))
      keepNearest(best, pickBody(*cell, body, work_T_frame, ray));
  return best;
}

Between Drawn::between(const Ray& ray, double lengthMm, bool printed) const {
  const auto isBetween = [&](const std::optional<RayHit>& hit) { return hit && hit->t < lengthMm; };
  Between between;
  between.printed = printed && isBetween(nearestPrinted(ray, true));
  between.platform =
      shows(view.platform, platform.get()) && isBetween(pickPlatform(*platform, ray));
  if (!shows(view.cell, cell.get()))
    return between;
  const std::vector<Eigen::Isometry3d> work_T_frame = framesInWork();
  const auto& bodies = cell->cell.bodies();
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    const auto role = static_cast<std::size_t>(bodies[body].role);
    if (isBodyShown(body) && !between.roles[role])
      between.roles[role] = isBetween(pickBody(*cell, body, work_T_frame, ray));
  }
  return between;
}

Legend Drawn::legend(const Theme& theme) const {
  if (const VoxelDrawing* drawing = shownVoxels()) {
    Legend legend = voxelLegend(*drawing, theme);
    if (drawing->bySteps && view.front)
      legend.marks.insert(legend.marks.begin() + 1, {0.0, "Convex front"_text, theme.front});
    return legend;
  }
  if (shows(view.pieces, pieces.get()))
    return pieceLegend(*pieces, theme, !view.pieceNumbers);
  if (shows(view.layers, layers.get()))
    return legendOf(layers->values, shownColouring(layers->values, view.colourBy));
  if (shows(view.paths, paths.get()) && !view.materialColour)
    return legendOf(paths->values, shownColouring(paths->values, view.colourBy));
  if (shows(view.reach, reach.get()))
    return reachLegend();
  return {};
}

} // namespace voluta::scene
