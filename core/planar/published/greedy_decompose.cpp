#include "planar/published/greedy_decompose.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "geometry/measures.h"
#include "geometry/simplify.h"
#include "planar/published/coarse_cuts.h"
#include "planar/published/fine_cuts.h"
#include "planar/published/piece_graph.h"
#include "planar/published/region_planes.h"
#include "planar/published/section_cut.h"
#include "planar/published/shape_diameter.h"
#include "planar/published/skeleton.h"
#include "planar/published/surface_regions.h"

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr double kOrderSpacingMm = 2.0;
constexpr double kMinGain = 0.002; // minimum gain of a cut, relative to the initial risky area

// Moves each vertex half-way to the mean of its neighbours: RoboFDM smooths once before computing
// the skeleton.
geometry::TriangleMesh smoothed(geometry::TriangleMesh mesh) {
  std::vector<Vector3d> sum(mesh.vertices.size(), Vector3d::Zero());
  std::vector<double> count(mesh.vertices.size(), 0.0);
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto v = static_cast<std::size_t>(t[k]);
      sum[v] += mesh.vertices[static_cast<std::size_t>(t[(k + 1) % 3])];
      count[v] += 1.0;
    }
  for (std::size_t v = 0; v < sum.size(); ++v)
    if (count[v] > 0.0)
      mesh.vertices[v] = 0.5 * (mesh.vertices[v] + sum[v] / count[v]);
  return mesh;
}

std::vector<RegionPlane> planesOutwards(const geometry::TriangleMesh& part, const Piece& whole,
                                        const PlanarOptions& options, const GreedyOptions& greedy,
                                        const base::RunContext& ctx) {
  const geometry::TriangleMesh mesh = smoothed(geometry::simplified(part, options.searchTriangles));
  ctx.report(0.0, "skeleton"_text);
  const CurveSkeleton skeleton = curveSkeleton(mesh, ctx.quiet());
  ctx.report(0.8, "pieces"_text);
  const SurfaceRegions regions =
      surfaceRegions(mesh, shapeDiameters(mesh, skeleton, ctx.quiet()), greedy.clusters);
  return pieceGraph(mesh, regions, regionPlanes(mesh, regions), whole, options.rule, greedy.root)
      .outwards;
}

} // namespace

PlanarDecomposition greedyDecompose(const geometry::TriangleMesh& part, const PlanarOptions& given,
                                    const GreedyOptions& greedy, const base::RunContext& ctx) {
  if (part.empty() || !isClosed(part))
    throw base::Error(base::ErrorCode::UnusableInput, "the mesh is not closed"_text, {},
                      "repair it, or use curved mode, which takes any mesh"_text);
  PlanarOptions options = given;
  options.lowestZ = kFacesUp;
  PlanarDecomposition out;
  const base::Stopwatch watch;
  Piece whole = wholePart(part, options.rule);
  out.riskyBeforeMm2 = riskyArea(whole, options.rule);
  const std::vector<RegionPlane> planes =
      planesOutwards(part, whole, options, greedy, ctx.sub(0.0, 0.4));
  out.seconds.search = watch.seconds();
  std::vector<Piece> pieces;
  if (out.riskyBeforeMm2 > 0.0) {
    std::int32_t tag = 0;
    FineCutOptions fine;
    fine.footing = footingOf(whole, options.rule);
    fine.spacingMm = kOrderSpacingMm;
    pieces = coarsePieces(std::move(whole), planes, options, tag, ctx.sub(0.4, 0.6));
    fine.minMm2 = kMinGain * out.riskyBeforeMm2;
    fine.targetMm2 = options.target * out.riskyBeforeMm2;
    pieces = fineCuts(std::move(pieces), options, fine, tag, ctx.sub(0.6, 1.0));
  } else {
    pieces.push_back(std::move(whole));
  }
  out.pieces = printOrder(std::move(pieces), options, kOrderSpacingMm, out.blockedPieces);
  for (const Piece& piece : out.pieces) {
    out.riskyMm2 += riskyArea(piece, options.rule);
    out.sectionMm2 += piece.baseTag == kPlate ? 0.0 : baseArea(piece, options.rule);
  }
  out.seconds.cut = watch.seconds() - out.seconds.search;
  ctx.report(1.0, "pieces"_text);
  return out;
}

} // namespace voluta::planar
