#include "regions/part_regions.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_boolean.h"
#include "regions/closed_contour.h"
#include "regions/plane_layers.h"
#include "regions/region_kinds.h"
#include "regions/region_uses.h"
#include "substrate/ground_distance.h"
#include "substrate/skin.h"
#include "substrate/substrate_layers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace voluta::regions {

namespace {
using geometry::BooleanOperation;
using geometry::TriangleMesh;

// Mean thickness up to which a piece is rounding, as between two bodies that touch.
constexpr double kFilmMm = 0.01;
constexpr double kBoxMargin = 4.0; // [grid]: of the box around a part

TriangleMesh moved(TriangleMesh mesh, const PlacedPart& part) {
  for (Eigen::Vector3d& v : mesh.vertices)
    v = part.work_T_file * (part.scale * v);
  return mesh;
}

TriangleMesh withoutFilms(const TriangleMesh& mesh) {
  const geometry::Components pieces = geometry::components(mesh);
  std::vector<bool> isKept(mesh.triangles.size(), true);
  for (int piece = 0; piece < pieces.count; ++piece) {
    std::vector<bool> isOfPiece(isKept.size());
    for (std::size_t t = 0; t < isOfPiece.size(); ++t)
      isOfPiece[t] = pieces.ofTriangle[t] == piece;
    const TriangleMesh one = geometry::subMesh(mesh, isOfPiece);
    if (2.0 * std::abs(geometry::volume(one)) < kFilmMm * geometry::area(one))
      for (std::size_t t = 0; t < isKept.size(); ++t)
        isKept[t] = isKept[t] && !isOfPiece[t];
  }
  return geometry::subMesh(mesh, isKept);
}

TriangleMesh combined(BooleanOperation operation, const TriangleMesh& part,
                      const TriangleMesh& body, const project::Region& region) {
  auto made = geometry::meshBoolean(operation, part, body, true);
  if (!made)
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("region {region} cannot be separated from the part: one of "
                                    "them is not closed or intersects itself"_text,
                                    region.shape),
                      {}, "repair the part, or move the region a little"_text);
  return withoutFilms(*made);
}

bool isSkin(const project::Region& region) {
  return findUse(region.use).layers == RegionLayers::Surface;
}

// Returns per face of the part whether a skin follows it.
std::vector<char> followedFaces(const project::Region& region, const Shape& shape,
                                const PlacedPart& part) {
  if (shape.kind->mesh != ShapeMesh::Painted)
    return substrate::upperFaces(part.mesh, base::degreesToRadians(shape.numbers[1]));
  base::require(region.mesh != nullptr, "the region has its mesh");
  return substrate::paintedFaces(part.mesh, moved(*region.mesh, part));
}

// A plane is exact on any grid, and a large curved surface nearly so.
double skinGridMm(const TriangleMesh& part, double depthMm, const substrate::LevelOptions& levels) {
  constexpr double kMostCells = 300.0; // along the part's longest side
  const double coarse = geometry::bounds(part).sizes().maxCoeff() / kMostCells;
  return std::min(depthMm, std::max(substrate::offsetGridMm(levels), coarse));
}

TriangleMesh skinBody(const project::Region& region, const Shape& shape, const PlacedPart& placed,
                      const substrate::LevelOptions& levels, const base::RunContext& ctx) {
  const TriangleMesh& part = placed.mesh;
  const substrate::Skin skin{followedFaces(region, shape, placed), shape.numbers[0]};
  if (skin.depthMm < levels.heightMinMm)
    throw base::Error(
        base::ErrorCode::UnusableInput,
        base::message("region {region} is thinner than the lowest layer ({least})"_text,
                      region.shape, base::mm(levels.heightMinMm)),
        {}, "make it deeper, or use a process with lower layers"_text);
  const double gridMm = skinGridMm(part, skin.depthMm, levels);
  const substrate::SkinSurface surface(part, skin, gridMm);
  if (surface.empty())
    throw base::Error(
        base::ErrorCode::UnusableInput,
        shape.kind->mesh == ShapeMesh::Painted
            ? base::message("region {region}: half of no face of the part is painted"_text,
                            region.shape)
            : base::message("region {region}: no face of the part is as flat as that"_text,
                            region.shape),
        {},
        shape.kind->mesh == ShapeMesh::Painted ? "paint whole faces"_text
                                               : "give a steeper slope"_text);
  // Only what is in the part matters.
  Eigen::AlignedBox3d box = geometry::bounds(part);
  box.min().array() -= kBoxMargin * gridMm;
  box.max().array() += kBoxMargin * gridMm;
  const auto outsideMm = [&](const Eigen::Vector3d& p) {
    return -(p - box.min()).cwiseMin(box.max() - p).minCoeff() + gridMm;
  };
  return closedContour(
      {[&](const Eigen::Vector3d& p) { return std::max(surface.excess(p), outsideMm(p)); },
       [&](const Eigen::Vector3d& p) { return std::max(surface.excessOfDepth(p), outsideMm(p)); }},
      box, gridMm, ctx);
}
} // namespace

TriangleMesh bodyOf(const project::Region& region, const PlacedPart& part,
                    const substrate::LevelOptions& levels, const base::RunContext& ctx) {
  const Shape shape = parsedShape(region.shape);
  switch (shape.kind->frame) {
  case ShapeFrame::Plate:
    return shape.kind->body(shape.numbers, geometry::bounds(part.mesh));
  case ShapeFrame::Part:
    return skinBody(region, shape, part, levels, ctx);
  case ShapeFrame::File:
    break;
  }
  if (shape.kind->mesh == ShapeMesh::None)
    return moved(shape.kind->body(shape.numbers, geometry::bounds(part.mesh)), part);
  if (shape.kind->mesh == ShapeMesh::Painted && (!region.mesh || region.mesh->empty()))
    return {};
  base::require(region.mesh != nullptr, "the region has its mesh");
  if (isSkin(region))
    return skinBody(region, shape, part, levels, ctx);
  const TriangleMesh mesh = moved(*region.mesh, part);
  return shape.kind->mesh == ShapeMesh::Painted
             ? substrate::bodyAround(mesh, shape.numbers[0],
                                     skinGridMm(part.mesh, shape.numbers[0], levels), ctx)
             : mesh;
}

TriangleMesh withoutCuts(const PlacedPart& part, std::span<const project::Region> all,
                         const substrate::LevelOptions& levels, const base::RunContext& ctx) {
  TriangleMesh left = part.mesh;
  for (const project::Region& region : all) {
    if (!findUse(region.use).cuts)
      continue;
    const TriangleMesh body = bodyOf(region, part, levels, ctx);
    if (body.empty())
      continue;
    left = combined(BooleanOperation::Difference, left, body, region);
    if (left.empty())
      throw base::Error(
          base::ErrorCode::UnusableInput,
          base::message("region {region} cuts away the whole part"_text, region.shape), {},
          "make the region smaller, or move it"_text);
    ctx.checkpoint();
  }
  return left;
}

PartRegions divided(const PlacedPart& part, std::span<const project::Region> all,
                    const substrate::LevelOptions& levels, const base::RunContext& ctx) {
  PartRegions result{part.mesh, {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const project::Region& region = all[i];
    if (!findUse(region.use).hasLayers())
      continue;
    const TriangleMesh body = bodyOf(region, part, levels, ctx);
    if (body.empty())
      continue;
    TriangleMesh solid = combined(BooleanOperation::Intersection, part.mesh, body, region);
    ctx.checkpoint();
    if (solid.empty())
      continue;
    for (LayeredRegion& earlier : result.layered)
      earlier.solid = combined(BooleanOperation::Difference, earlier.solid, body, region);
    result.rest = combined(BooleanOperation::Difference, result.rest, body, region);
    if (result.rest.empty())
      throw base::Error(
          base::ErrorCode::UnusableInput,
          base::message("region {region} contains the whole part: nothing carries its "
                        "layers"_text,
                        region.shape),
          {}, "make the region smaller"_text);
    result.layered.push_back({i, std::move(solid)});
    if (isSkin(region))
      result.layered.back().followed = followedFaces(region, parsedShape(region.shape), part);
    ctx.checkpoint();
  }
  std::erase_if(result.layered, [](const LayeredRegion& region) { return region.solid.empty(); });
  return result;
}

substrate::StackedLevels layersOf(const project::Region& region, const LayeredRegion& layered,
                                  const RegionGround& ground, const substrate::LevelOptions& levels,
                                  const base::RunContext& ctx) {
  const TriangleMesh& solid = layered.solid;
  switch (findUse(region.use).layers) {
  case RegionLayers::Surface:
    return substrate::stackLevels(
        solid,
        substrate::skinLevels(solid, ground.whole,
                              {layered.followed, parsedShape(region.shape).numbers[0]}, levels),
        levels, ctx);
  case RegionLayers::Around: {
    substrate::SubstrateOptions offset;
    static_cast<substrate::LevelOptions&>(offset) = levels;
    offset.firstLayerMm = 0.0;
    return substrate::stackLevels(
        solid, substrate::substrateLevels(solid, substrate::distanceFrom(ground.rest), offset, ctx),
        offset, ctx);
  }
  case RegionLayers::Flat:
    return flatLayers(solid, directionOf(region.use), levels, ctx);
  case RegionLayers::Turning:
    return turningLayers(solid, directionOf(region.use), levels, ctx);
  case RegionLayers::None:
    break;
  }
  base::require(false, "layersOf: a region with layers of its own");
  return {};
}

} // namespace voluta::regions
