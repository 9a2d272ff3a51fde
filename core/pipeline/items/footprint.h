// The space that a placed part takes on the plate, and what the head needs beside it.
#pragma once

#include "geometry/triangle_mesh.h"
#include "process/process.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::pipeline {

struct Footprint {
  std::vector<Eigen::Vector2d> outline; // convex hull of the part seen from above [mm]
  double heightMm = 0.0;                // of its highest point above the plate
  bool leans = false;                   // its layers may tilt the head
};

// Returns the footprint of a part that is placed. Precondition: the part is not empty.
Footprint footprintOf(const geometry::TriangleMesh& placed, bool leans);

// Returns the distance between two outlines [mm]; 0 if they overlap.
double gapBetween(const Footprint& a, const Footprint& b);

// Returns the distance [mm] that the head needs from `other`, which is printed completely, while it
// prints `printed` beside it: the largest radius of the head up to the height of `other`; its
// largest radius if layers tilt it.
double headNeedsMm(const process::HeadShape& head, const Footprint& printed,
                   const Footprint& other);

} // namespace voluta::pipeline
