#include "regions/region_patches.h"

#include "base/parallel.h"
#include "geometry/append_mesh.h"
#include "geometry/measures.h"
#include "geometry/polygon_paths.h"
#include "layers/clean_surface.h"
#include "layers/part_boundary.h"
#include "layers/patches.h"
#include "layers/trim.h"
#include "planar/slicing/section.h"
#include "planar/slicing/section_paths.h"
#include "toolpath/plane/connected_parts.h"
#include "toolpath/plane/plane_patch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::regions {

namespace {
using ClipperLib::Paths;
using Eigen::Vector3d;
using geometry::TriangleMesh;
using layers::Patch;

constexpr double kSmallestMm2 = 1e-3;
constexpr double kNarrow = 0.5;    // [beads]
constexpr double kCellMm = 2.0;    // of the grid that finds places near a body
constexpr double kBeyondMm = 10.0; // of the box around a region whose outside is wanted

// A body with its inside and its outside as boundaries for trimming, and its sections.
class Body {
public:
  Body(const SettingsRegion& region, const Eigen::AlignedBox3d& around, const base::RunContext& ctx)
      : region_(region), inside_(region.body, kCellMm, ctx),
        outside_(outsideOf(region.body, around), kCellMm, ctx),
        upwards_(region.body, Vector3d::UnitZ()) {}

  int number() const { return region_.number; }
  double interlockMm() const { return region_.interlockMm; }
  const layers::PartBoundary& boundary(bool inside) const { return inside ? inside_ : outside_; }

  // Returns the section by the plane of a patch, in the frame of the patch.
  Paths section(const toolpath::PlanePatch& plane) const {
    const bool isLevel = plane.direction == Vector3d::UnitZ();
    const planar::Section cut =
        isLevel ? upwards_.at(plane.heightMm)
                : planar::Sections(region_.body, plane.direction).at(plane.heightMm);
    std::map<int, std::vector<int>> next;
    for (const auto& [a, b] : cut.edges)
      next[a].push_back(b);
    Paths loops;
    while (!next.empty()) {
      ClipperLib::Path loop;
      int at = next.begin()->first;
      for (auto entry = next.find(at); entry != next.end(); entry = next.find(at)) {
        loop.push_back(geometry::pathPoint(
            (plane.plane_R_work * cut.points[static_cast<std::size_t>(at)]).head<2>()));
        at = entry->second.back();
        entry->second.pop_back();
        if (entry->second.empty())
          next.erase(entry);
      }
      loops.push_back(std::move(loop));
    }
    return geometry::united(loops);
  }

private:
  // Returns a box around everything with the body as a cavity.
  static TriangleMesh outsideOf(const TriangleMesh& body, Eigen::AlignedBox3d box) {
    box.extend(geometry::bounds(body));
    const Vector3d low = box.min().array() - kBeyondMm, high = box.max().array() + kBeyondMm;
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k)
      mesh.vertices.emplace_back((k & 1) != 0 ? high.x() : low.x(),
                                 (k & 2) != 0 ? high.y() : low.y(),
                                 (k & 4) != 0 ? high.z() : low.z());
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    TriangleMesh cavity = body;
    for (auto& t : cavity.triangles)
      std::swap(t[1], t[2]);
    geometry::appendMesh(mesh, cavity);
    return mesh;
  }

  const SettingsRegion& region_;
  layers::PartBoundary inside_, outside_;
  planar::Sections upwards_;
};

Patch withPlaceOf(Patch patch, const Patch& like, int region) {
  layers::takePlace(patch, like);
  patch.region = region;
  return patch;
}

// Appends a patch for each connected part of the area. Returns whether all of them could be made.
bool addPlaneParts(const Paths& area, const toolpath::PlanePatch& plane, const Patch& like,
                   int region, std::vector<Patch>& to) {
  for (const Paths& part : toolpath::connectedParts(area)) {
    if (std::abs(geometry::areaMm2(part)) < kSmallestMm2)
      continue;
    toolpath::PlanePatch outline = plane;
    outline.outline = part;
    auto made = toolpath::patchOver(part, outline, like);
    if (!made)
      return false;
    if (!made->surface.empty())
      to.push_back(withPlaceOf(std::move(*made), like, region));
  }
  return true;
}

bool isNothing(const Paths& area) {
  return std::abs(geometry::areaMm2(area)) < kSmallestMm2;
}

bool isNarrow(const Paths& area, double widthMm) {
  return geometry::offsetPaths(area, -0.5 * widthMm, {}).empty();
}

// Moves the connected parts of `from` that are narrower than `widthMm` to `to`.
void moveNarrow(Paths& from, Paths& to, double widthMm) {
  Paths wide;
  bool anyNarrow = false;
  for (const Paths& part : toolpath::connectedParts(from)) {
    const bool moves = isNarrow(part, widthMm);
    Paths& side = moves ? to : wide;
    side.insert(side.end(), part.begin(), part.end());
    anyNarrow = anyNarrow || moves;
  }
  if (!anyNarrow)
    return;
  from = std::move(wide);
  to = geometry::united(to);
}

// Lets one side of a boundary within the outline reach over it.
void interlock(const Paths& outline, bool insideReaches, double byMm, Paths& inside,
               Paths& outside) {
  Paths &reaching = insideReaches ? inside : outside, &other = insideReaches ? outside : inside;
  if (reaching.empty() || other.empty())
    return;
  reaching = geometry::combined(
      outline, geometry::offsetPaths(reaching, byMm, {.corners = ClipperLib::jtMiter}),
      ClipperLib::ctIntersection);
  other = geometry::combined(outline, reaching, ClipperLib::ctDifference);
}

// A patch that a region divides, and how it meets the region.
struct Divided {
  std::vector<Patch> parts;
  RegionMeeting meeting = RegionMeeting::None;
};

std::optional<Divided> dividedPlane(const Patch& patch, const Body& body, double beadWidthMm) {
  const auto plane = toolpath::planePatch(patch);
  if (!plane || !plane->isEven || !plane->seams.empty())
    return std::nullopt;
  const Paths section = body.section(*plane);
  Paths inside = geometry::combined(plane->outline, section, ClipperLib::ctIntersection);
  Paths outside = geometry::combined(plane->outline, section, ClipperLib::ctDifference);
  if (isNothing(inside))
    return Divided{{patch}};
  const bool insideReaches = patch.layer % 2 == 0;
  bool isCrossed = false; // by the interlock of the part around the region
  if (body.interlockMm() > 0.0) {
    isCrossed = !insideReaches && !isNarrow(inside, kNarrow * beadWidthMm);
    interlock(plane->outline, insideReaches, 0.5 * body.interlockMm(), inside, outside);
  }
  moveNarrow(inside, outside, kNarrow * beadWidthMm);
  if (isNothing(inside))
    return Divided{{patch}, isCrossed ? RegionMeeting::Crossed : RegionMeeting::Narrow};
  moveNarrow(outside, inside, kNarrow * beadWidthMm);
  Divided divided{{}, RegionMeeting::Divided};
  if (!addPlaneParts(outside, *plane, patch, patch.region, divided.parts) ||
      !addPlaneParts(inside, *plane, patch, body.number(), divided.parts))
    return std::nullopt;
  return divided;
}

Divided dividedSurface(const Patch& patch, const Body& body, const base::RunContext& ctx) {
  Divided divided;
  for (const bool inside : {false, true}) {
    layers::LevelSurface surface =
        layers::trimToPart(layers::surfaceOf(patch), body.boundary(inside), {}, ctx);
    if (surface.surface.empty())
      continue;
    layers::cleanSurface(surface, {}, ctx);
    layers::PatchesOfLevel made = layers::makePatches(surface, {0.0});
    for (Patch& part : made.patches) {
      divided.parts.push_back(
          withPlaceOf(std::move(part), patch, inside ? body.number() : patch.region));
      if (inside)
        divided.meeting = RegionMeeting::Divided;
    }
  }
  return divided;
}

// Returns how each body meets the layers, by the way in which the patches meet it.
std::vector<LayersMet> layersMet(const layers::LayerStack& stack, std::size_t bodies,
                                 const std::vector<std::vector<RegionMeeting>>& meetings) {
  std::vector<LayersMet> all(bodies);
  for (std::size_t b = 0; b < bodies; ++b) {
    std::map<int, RegionMeeting> ofLayer;
    for (std::size_t i = 0; i < meetings.size(); ++i)
      if (!meetings[i].empty()) {
        RegionMeeting& most = ofLayer[stack.patches[i].layer];
        most = std::max(most, meetings[i][b]);
      }
    for (const auto& [layer, meeting] : ofLayer) {
      all[b].layers += meeting != RegionMeeting::None ? 1 : 0;
      all[b].narrow += meeting == RegionMeeting::Narrow ? 1 : 0;
      all[b].crossed += meeting == RegionMeeting::Crossed ? 1 : 0;
    }
  }
  return all;
}
} // namespace

base::ParameterTable regionParameters() {
  return base::ParameterTable({base::ofRegion(base::numberParameter(
      "interlockMm", "mm", 0.0, 0.0, 50.0, "Tool-paths"_text, "interlock of a region"_text,
      "In flat layers the region reaches half of it into the part around it, in every other layer "
      "the part reaches as far into the region, so that both hold each other."_text))});
}

DividedLayers dividedPatches(const layers::LayerStack& stack,
                             std::span<const SettingsRegion> regions, double beadWidthMm,
                             const base::RunContext& ctx) {
  Eigen::AlignedBox3d box;
  for (const Patch& patch : stack.patches)
    box.extend(geometry::bounds(patch.surface));
  std::vector<std::unique_ptr<const Body>> bodies;
  for (const SettingsRegion& region : regions)
    bodies.push_back(std::make_unique<const Body>(region, box, ctx));
  std::vector<std::vector<Patch>> divided(stack.patches.size());
  std::vector<std::vector<RegionMeeting>> meetings(stack.patches.size());
  base::parallelChunks(ctx, divided.size(), 1, [&](std::size_t begin, std::size_t end) {
    const base::RunContext silent = ctx.quiet();
    for (std::size_t i = begin; i < end; ++i) {
      std::vector<Patch>& parts = divided[i];
      parts = {stack.patches[i]};
      if (stack.patches[i].group == layers::kSupportGroup)
        continue;
      for (const auto& body : bodies) {
        std::vector<Patch> next;
        RegionMeeting most = RegionMeeting::None;
        for (const Patch& part : parts) {
          if (part.surface.empty() || part.region > body->number()) {
            next.push_back(part);
            continue;
          }
          auto made = dividedPlane(part, *body, beadWidthMm);
          if (!made || made->parts.empty())
            made = dividedSurface(part, *body, silent);
          most = std::max(most, made->meeting);
          std::ranges::move(made->parts, std::back_inserter(next));
        }
        meetings[i].push_back(most);
        parts = std::move(next);
      }
    }
  });
  DividedLayers result;
  result.stack.layerCount = stack.layerCount;
  result.stack.pockets = stack.pockets;
  for (std::vector<Patch>& parts : divided)
    std::ranges::move(parts, std::back_inserter(result.stack.patches));
  result.met = layersMet(stack, bodies.size(), meetings);
  return result;
}

} // namespace voluta::regions
