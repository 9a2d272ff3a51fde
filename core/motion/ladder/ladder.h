// Shortest way through a ladder graph: one node a rung, close ones joined (Dai 3.5.3, eq. 3.4).
#pragma once

#include "robot/robot_model.h"

#include <cstddef>
#include <vector>

namespace voluta::motion {

struct LadderNode {
  robot::JointVector q;
  int sample = 0;       // which turn about the nozzle, 0 .. samples - 1 (circular)
  int aside = 0;        // how far the last external axis is from where it stands by itself, steps
  double cost = 0.0;    // of being here, added to the way's length
  bool blocked = false; // not to be used
  int side = 0;         // of the arm's singular poses, -1 or 1; 0: either will do
};
using Rung = std::vector<LadderNode>;

// How the way may begin at a node of the first rung: its joints, by whole turns, and what it costs
// to get there.
struct LadderStart {
  robot::JointVector q;
  double cost = 0.0;
};

struct LadderOptions {
  int samples = 24;               // turns about the nozzle in a full circle
  int window = 2;                 // neighbours differ by at most so many samples
  int asideWindow = 1;            // and by at most so many steps aside
  std::vector<double> maxStepRad; // per rung: largest joint step from the rung before
};

struct LadderWay {
  std::size_t reached = 0;           // rungs 0 .. reached - 1 are joined; the others not
  std::vector<int> node;             // per reached rung
  std::vector<robot::JointVector> q; // per reached rung, whole turns chosen so that steps are small
  double cost = 0.0;                 // start cost + node costs + sum of L1 steps
};

// Dijkstra on a layered graph is a sweep over its layers: the least sum of L1 joint steps from the
// first rung to the last, starting costs (one a node of the first rung) and node costs included;
// sliding joints count as robot::asTurn has them.
// Nodes on different sides of the arm's singular poses are not joined.
// Joints are taken by whole turns nearest to the predecessor's, as long as limits allow it. Where
// no node of a rung can be reached the way ends before it, at the cheapest node. Ties go to the
// node at the nearest sample.
// Preconditions: a start for each node of rungs.front(), maxStepRad as rungs; all q of one length,
// limits no longer: joints behind those are where they have to be and cost nothing; samples in [0,
// options.samples).
LadderWay shortestWay(const std::vector<Rung>& rungs, const std::vector<LadderStart>& starts,
                      const std::vector<robot::JointLimits>& limits, const LadderOptions& options);

} // namespace voluta::motion
