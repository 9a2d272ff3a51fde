// Shortest path through a ladder graph: one node per rung, adjacent nodes connected (Dai 3.5.3, eq.
// 3.4).
#pragma once

#include "robot/robot_model.h"

#include <cstddef>
#include <vector>

namespace voluta::motion {

struct LadderNode {
  robot::JointVector q;
  int sample = 0;       // Index of the rotation about the nozzle, 0 .. samples - 1 (circular)
  int offset = 0;       // Offset of the last external axis from its scheduled position [steps]
  double cost = 0.0;    // Cost of the node, added to the path's length
  bool blocked = false; // Not usable
  int side = 0; // Sign of the Jacobian determinant: the side of the singular poses, -1 or 1; 0: any
};
using Rung = std::vector<LadderNode>;

// A start at a node of the first rung: its joints, with whole turns chosen, and the cost of
// reaching it.
struct LadderStart {
  robot::JointVector q;
  double cost = 0.0;
};

struct LadderOptions {
  int samples = 24;     // Rotations about the nozzle per full circle
  int window = 2;       // Maximum difference of neighbours' samples
  int offsetWindow = 1; // Maximum difference of neighbours' steps of the last external axis
  std::vector<double> maxStepRad; // Per rung: maximum joint step from the previous rung
};

struct LadderPath {
  std::size_t reached = 0;           // Rungs 0 .. reached - 1 are connected; the others are not
  std::vector<int> node;             // Per reached rung
  std::vector<robot::JointVector> q; // Per reached rung, whole turns chosen so that steps are small
  double cost = 0.0;                 // Start cost + node costs + sum of L1 steps
};

// Returns the path with the minimum sum of L1 joint steps from the first rung to the last,
// including starting costs (one per node of the first rung) and node costs. Dijkstra on a layered
// graph is a sweep over its layers. Sliding joints count by robot::asAngle. Nodes on different
// sides of the arm's singular poses are not connected. Joints take the whole turn nearest to the
// predecessor's, as far as limits allow it. If no node of a rung can be reached, the path ends
// before it, at the cheapest node. Of equals, the node at the nearest sample is used.
// Preconditions: a start for each node of rungs.front(); one maxStepRad per rung; all q of equal
// length, at least as long as limits (joints without limits are already determined and cost
// nothing); samples in [0, options.samples).
LadderPath shortestPath(const std::vector<Rung>& rungs, const std::vector<LadderStart>& starts,
                        const std::vector<robot::JointLimits>& limits,
                        const LadderOptions& options);

} // namespace voluta::motion
