// Diagnosis of a mesh: kinds of defects and their places.
#pragma once

#include "base/run_context.h"
#include "base/text.h"
#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

namespace voluta::geometry {

// Count of one kind of defect, and the place of the first (mm; undefined if count is 0).
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
  Defect misorientedEdges;    // with two triangles that traverse it in the same direction
  Defect duplicateFaces;      // triangles with the same corners as an earlier one
  Defect degenerateFaces;     // without area: with a repeated or with collinear corners
  Defect selfIntersections;   // pairs
  Defect insideOutComponents; // see insideOutComponents() in orientation.h
  bool watertight = false;    // every edge as often forward as backward: the inside is well-defined
  double volumeMm3 = 0.0, areaMm2 = 0.0;
  Eigen::AlignedBox3d boundsMm;
  std::optional<int> genus; // sum over components; only for a watertight manifold

  // Returns whether there is nothing to repair.
  bool clean() const;
  // Returns one sentence per kind of defect, with its place; empty if clean.
  std::vector<base::Message> sentences() const;
};

// Precondition (Error{Internal}): indices in range, coordinates finite. An empty mesh is not
// watertight.
Diagnosis diagnose(const TriangleMesh& mesh, const base::RunContext& ctx = {});

// Computes Diagnosis::watertight only.
bool isWatertight(const TriangleMesh& mesh);

} // namespace voluta::geometry
