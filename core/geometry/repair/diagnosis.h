// What is wrong with a mesh, and where.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace voluta::geometry {

// A kind of defect: how often, and the place of the first (mm; meaningless when count is 0).
struct Defect {
  std::size_t count = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

struct Diagnosis {
  std::size_t triangles = 0, vertices = 0; // vertices that triangles use
  int components = 0;
  Defect boundaryEdges; // with one triangle
  std::size_t boundaryLoops = 0;
  Defect nonManifoldEdges;    // with more than two triangles
  Defect misorientedEdges;    // with two triangles that run the same way
  Defect duplicateFaces;      // triangles on the corners of an earlier one
  Defect degenerateFaces;     // without area: a corner twice, or three on a line
  Defect selfIntersections;   // pairs
  Defect insideOutComponents; // see insideOutComponents() in orientation.h
  bool watertight = false;    // every edge as often forward as backward: the inside is well-defined
  double volumeMm3 = 0.0, areaMm2 = 0.0;
  Eigen::AlignedBox3d boundsMm;
  std::optional<int> genus; // sum over components; only of a watertight manifold

  // Nothing to repair.
  bool clean() const;
  // One sentence a kind of defect, with its place; empty when clean.
  std::vector<base::Message> sentences() const;
};

// Precondition (Error{Internal}): indices in range, coordinates finite. An empty mesh is not
// watertight.
Diagnosis diagnose(const TriangleMesh& mesh, const base::RunContext& ctx = {});

// Diagnosis::watertight alone.
bool isWatertight(const TriangleMesh& mesh);

} // namespace voluta::geometry
