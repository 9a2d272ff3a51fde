#include "pipeline/pedestal.h"

#include "geometry/append_mesh.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "geometry/mesh_boolean.h"
#include "geometry/prism.h"
#include "robot/plate.h"

#include <Eigen/Core>
#include <algorithm>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

using Eigen::Vector2d;

// Group codes and values, one per line (AutoCAD R12 DXF: POLYLINE, its closed flag, VERTEX).
std::string polylineDxf(const std::vector<Vector2d>& outline, std::string_view layer) {
  std::string text = fmt::format("0\nPOLYLINE\n8\n{}\n66\n1\n70\n1\n", layer);
  for (const Vector2d& p : outline)
    text += fmt::format("0\nVERTEX\n8\n{}\n10\n{:.4f}\n20\n{:.4f}\n30\n0.0\n", layer, p.x(), p.y());
  return text + fmt::format("0\nSEQEND\n8\n{}\n", layer);
}

// Sorts the triangles by their corners: the order of a boolean may depend on addresses in memory,
// and so on the threads of the plan.
void sortTriangles(geometry::TriangleMesh& mesh) {
  const auto isBefore = [&](int a, int b) {
    return std::ranges::lexicographical_compare(mesh.vertices[static_cast<std::size_t>(a)],
                                                mesh.vertices[static_cast<std::size_t>(b)]);
  };
  for (auto& t : mesh.triangles)
    std::ranges::rotate(t, std::ranges::min_element(t, isBefore));
  std::ranges::sort(mesh.triangles, [&](const auto& a, const auto& b) {
    return std::ranges::lexicographical_compare(a, b, isBefore);
  });
}

// Returns whether the platform's own position, the z axis of the work frame, is below the part's
// bounding box.
bool coversAxis(const geometry::TriangleMesh& part) {
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  return (box.min().head<2>().array() <= 0.0).all() && (box.max().head<2>().array() >= 0.0).all();
}

} // namespace

double adriftMm(const project::Platform& platform, const geometry::TriangleMesh& part,
                const robot::Cell& cell) {
  return platform.marginMm() && coversAxis(part) ? 0.0 : robot::platformGapMm(cell);
}

std::vector<plan::ProgramFile> pedestalFiles(const PlanResult& plan) {
  const project::Job& job = plan.job;
  const robot::Prism* plate = plan.cell ? robot::plateOf(*plan.cell) : nullptr;
  if (!job.choices.item().platform.marginMm() || job.item().platform.polygon.size() < 3 || !plate)
    return {};
  std::string outlines = polylineDxf(plate->polygon, "PEDESTAL");
  geometry::TriangleMesh solid = geometry::prismOver(plate->polygon, plate->zMin, plate->zMax);
  if (const robot::Prism* foot = robot::footOf(*plan.cell)) {
    outlines += polylineDxf(foot->polygon, "FOOT");
    const geometry::TriangleMesh slab = geometry::prismOver(foot->polygon, foot->zMin, foot->zMax);
    // If the union fails, the bodies overlap in the file; slicers treat them as one body as well.
    auto joined = geometry::meshBoolean(geometry::BooleanOperation::Union, solid, slab, false);
    if (joined)
      solid = *std::move(joined);
    else
      geometry::appendMesh(solid, slab);
  }
  sortTriangles(solid);
  return {{"pedestal.dxf", "0\nSECTION\n2\nENTITIES\n" + outlines + "0\nENDSEC\n0\nEOF\n"},
          {"pedestal.stl", geometry::writeStl(solid)}};
}

} // namespace voluta::pipeline
