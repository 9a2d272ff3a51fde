// Joins loops that lie side by side to one closed curve.
#pragma once

#include "toolpath/patch_surface.h"

#include <vector>

namespace voluta::toolpath {

// A closed curve made of loops.
struct JoinedLoops {
  std::vector<SurfacePoint> points;
  std::vector<int> loop; // Per point: number of the loop that it is on; -1 between loops
};

// Returns the loop as points at even distances.
JoinedLoops evenLoop(const PatchSurface& surface, const SurfaceCurve& loop, int number,
                     double hatchMm);

// Returns a double spiral through a chain of loops, each beside the next and all in the same
// direction: inwards over every other loop and outwards over the others (a Fermat spiral; Zhao et
// al. 2016). Along a short stretch of the chain, where the loops are straightest, the curve changes
// from each loop to the one after the next. Precondition: loops from evenLoop(), at least one.
JoinedLoops doubleSpiral(const PatchSurface& surface, const std::vector<JoinedLoops>& chain,
                         double hatchMm);

// Where two closed curves run side by side.
struct Adjacency {
  int a = -1, b = -1;     // Index of the point of each curve; -1: nowhere
  double cost = INFINITY; // 0: straight and a hatch apart
};
// Returns the best place to join two curves, among the points of `a` on one of the loops `loopsOfA`
// and the points of `b` on the loop `loopOfB`, at most `farthest` hatches apart.
Adjacency bestAdjacency(const JoinedLoops& a, const std::vector<int>& loopsOfA,
                        const JoinedLoops& b, int loopOfB, double farthest, double hatchMm);
// Opens both curves over a hatch at the place and joins their ends: `a` continues along `b`.
void join(JoinedLoops& a, const JoinedLoops& b, const Adjacency& place, double hatchMm);

} // namespace voluta::toolpath
