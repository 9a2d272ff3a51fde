// Growth found backwards: peel voxels off the convex front while all that remains stays supported,
// then turn the order round (docs/growth.md; the peeling of dissertation 3.4.4, which
// ignores support, taken further).
#pragma once

#include "base/run_context.h"
#include "curved/convex_front.h"
#include "curved/flood.h"
#include "process/process.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace voluta::curved {

// Lengths in cells.
struct PeelOptions {
  double sheet = 0.6;     // how deep below the front voxels are peeled in one round
  double tolerance = 0.0; // how deep inside the front of what is laid before a voxel may be laid
  double stuckTolerance = 0.5; // the same, only where nothing else can go on
  bool relaxSheets = false; // there: the whole sheet at that tolerance, not only what hangs on one
  double levelStep = 0.5;   // guided: the level falls by this each round
  double levelSlack = 0.0;  // guided: how long a voxel may wait and still count as on time
  bool eases = false;       // guided: what waits for long may lie deeper than the tolerance
  // Guided: per voxel, how much deeper than the tolerance it may lie at any time; empty: none may.
  std::span<const float> allowance;
  bool sacrifice = true; // where nothing can go on at all: give up voxels. False: stop.
  // Where a voxel would have to be given up: a head that may reach it all the same (NozzleReach).
  // Null: the front is flat everywhere.
  const process::HeadShape* head = nullptr;
  int runs = 12; // peelAll(): at most
  // Once it is cancelled what is peeled is not wanted any more: as if nothing could go on.
  std::optional<base::CancelToken> superseded;
};

struct Peeling {
  std::vector<std::int32_t> rank;  // per voxel: 1 is laid first; 0: not laid
  std::vector<float> level;        // per voxel, guided: min(guide, level at which it was peeled)
  std::vector<std::uint8_t> given; // per voxel: given up so that the others can be laid
  // Per voxel: a direction in which the head clears all that is earlier, of voxels that only the
  // head reaches (inside the flat front); zero for the others. Empty where there are none.
  std::vector<Eigen::Vector3f> headDirection;
  std::size_t byHead = 0; // number of those
  std::int32_t ranks = 0;
  std::size_t remaining = 0; // voxels left where it stopped (neither laid nor given up)
  std::size_t abandoned = 0;
  std::size_t fallen = 0;  // of them: only because their support was given up (the cascade)
  std::size_t relaxed = 0; // voxels laid deeper inside the front than `tolerance`
  double deepest = 0.0;    // of any of them, and of `tolerance` where that is more
};

// Peels the voxels with use[v] (empty: all) that the platform reaches, as soon as the front meets
// them. Each round: candidates on the front, and below it where a corner of it may go, farthest
// from the platform first, are taken as long as every present neighbour that was reached later
// keeps another earlier neighbour; the hull of the rest is built; what lies deeper than the
// tolerance inside it is put back (which does not change that hull). So a round costs what changes
// in it. Read backwards: every voxel of rank r has an AM-stable neighbour of lower rank or stands
// on the platform (constraint 1), and lies no deeper than the tolerance inside the hull of the
// platform and all lower ranks (constraint 2), but for `relaxed` voxels (stuckTolerance) and for
// what had its support given up: peelAll cures that. Throws Cancelled.
Peeling peel(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
             const PeelOptions& options, const base::RunContext& ctx);

// peel(), repeated without what was given up until nothing more has to be; what stood on it falls
// too (`fallen`). Of these runs, options.runs at most, the one that lays most: both constraints
// hold for all that has a rank. With sacrifice it ends with nothing remaining.
Peeling peelAll(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
                const PeelOptions& options, const base::RunContext& ctx);

// Peels by level: a voxel goes only once a falling level is below its `guide` (cells). `order` (the
// ranks of a growth, > 0 for every voxel) says which of two neighbours carries the other: with it
// loops open where that growth opened them, so no tip of a hook holds up all that carries it. What
// waits too long may lie deeper than the tolerance where options.eases: the levels that come of it
// are then a wish for a field to follow, not an order to print in. Throws Cancelled.
Peeling peelGuided(const VoxelGraph& graph, const std::vector<float>& guide,
                   const std::vector<std::int32_t>& order, const PeelOptions& options,
                   const base::RunContext& ctx);

} // namespace voluta::curved
