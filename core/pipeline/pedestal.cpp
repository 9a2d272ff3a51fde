#include "pipeline/pedestal.h"

#include "geometry/formats/mesh_reader.h"
#include "robot/plate.h"

#include <Eigen/Core>
#include <fmt/format.h>

namespace voluta::pipeline {

namespace {

using Eigen::Vector2d;

std::string outlineDxf(const std::vector<Vector2d>& outline) {
  // Group codes and values, a line each (AutoCAD R12 DXF: POLYLINE, its closed flag, VERTEX).
  std::string text = "0\nSECTION\n2\nENTITIES\n0\nPOLYLINE\n8\nPEDESTAL\n66\n1\n70\n1\n";
  for (const Vector2d& p : outline)
    text += fmt::format("0\nVERTEX\n8\nPEDESTAL\n10\n{:.4f}\n20\n{:.4f}\n30\n0.0\n", p.x(), p.y());
  return text + "0\nSEQEND\n8\nPEDESTAL\n0\nENDSEC\n0\nEOF\n";
}

geometry::TriangleMesh prism(const std::vector<Vector2d>& outline, double height) {
  geometry::TriangleMesh mesh;
  const int n = static_cast<int>(outline.size());
  for (const double z : {-height, 0.0})
    for (const Vector2d& p : outline)
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
    if (i > 0 && j > 0) {
      mesh.triangles.push_back({0, j, i});
      mesh.triangles.push_back({n, n + i, n + j});
    }
  }
  return mesh;
}

} // namespace

std::vector<plan::ProgramFile> pedestalFiles(const PlanResult& plan) {
  const project::Job& job = plan.job;
  const robot::Prism* plate = plan.cell ? robot::plateOf(*plan.cell) : nullptr;
  if (!job.choices.platform.marginMm() || job.platform.polygon.size() < 3 || !plate)
    return {};
  const double height = plate->zMax - plate->zMin;
  return {{"pedestal.dxf", outlineDxf(job.platform.polygon)},
          {"pedestal.stl", geometry::writeStl(prism(job.platform.polygon, height))}};
}

} // namespace voluta::pipeline
