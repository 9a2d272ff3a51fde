// Growth computed backwards: peels voxels off the convex front while all that remains stays
// supported, then reverses the order (docs/growth.md). Extends the peeling of dissertation 3.4.4,
// which ignores support.
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
  double sheet = 0.6;          // depth below the front of the voxels peeled in one round
  double tolerance = 0.0;      // maximum depth of a voxel inside the front of earlier material
  double stuckTolerance = 0.5; // the same, used only if peeling is stuck
  bool relaxSheets = false; // then: for the whole sheet, not only for the voxels that rest on one
  double levelStep = 0.5;   // guided: decrease of the level per round
  double levelSlack = 0.0;  // guided: how long a voxel may wait and still count as on time
  bool eases = false;       // guided: voxels that wait for long may be deeper than the tolerance
  // Guided: per voxel, how much deeper than the tolerance it may always be; empty: none.
  std::span<const float> allowance;
  bool sacrifice = true; // if nothing else helps: true: give up voxels; false: stop
  // A head that may reach voxels that would otherwise be given up (NozzleReach). Null: the front is
  // flat everywhere.
  const process::HeadShape* head = nullptr;
  int runs = 12; // peelAll(): maximum number
  // Once cancelled, the result is no longer needed: peeling stops as if it were stuck.
  std::optional<base::CancelToken> superseded;
};

struct Peeling {
  std::vector<std::int32_t> rank;  // per voxel: 1 is printed first; 0: not printed
  std::vector<float> level;        // per voxel, guided: min(guide, level at which it was peeled)
  std::vector<std::uint8_t> given; // per voxel: given up so that the others can be printed
  // Per voxel, for voxels that only the head reaches (inside the flat front): a direction in which
  // the head is clear of all earlier material; zero for the others. Empty if there are none.
  std::vector<Eigen::Vector3f> headDirection;
  std::size_t byHead = 0; // number of those
  std::int32_t ranks = 0;
  std::size_t remaining = 0; // voxels left when it stopped (neither printed nor given up)
  std::size_t abandoned = 0;
  std::size_t fallen = 0;  // of them: only because their support was given up (the cascade)
  std::size_t relaxed = 0; // voxels printed deeper inside the front than `tolerance`
  double deepest = 0.0;    // maximum depth of those, or `tolerance` if that is larger
};

// Peels the voxels with use[v] (empty: all) that are reachable from the platform, as soon as the
// front reaches them. In each round, candidates on the front, and below it where one of its corners
// can be removed, are taken, farthest from the platform first, as long as every present neighbour
// that was reached later keeps another earlier neighbour. Then the hull of the rest is built, and
// voxels deeper than the tolerance inside it are put back (which does not change that hull). The
// cost of a round is proportional to its changes. Read backwards: every voxel of rank r has an
// AM-stable neighbour of lower rank or is on the platform (constraint 1), and is no deeper than the
// tolerance inside the hull of the platform and all lower ranks (constraint 2), except `relaxed`
// voxels (stuckTolerance) and those whose support was given up: peelAll removes these. Throws
// Cancelled.
Peeling peel(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
             const PeelOptions& options, const base::RunContext& ctx);

// Repeats peel() without the given-up voxels until none more has to be given up; voxels that rested
// on them are dropped too (`fallen`). Returns the run, of at most options.runs, that prints most
// voxels: both constraints hold for all voxels with a rank. With sacrifice, nothing remains at the
// end.
Peeling peelAll(const VoxelGraph& graph, const std::vector<std::uint8_t>& use,
                const PeelOptions& options, const base::RunContext& ctx);

// Peels by level: a voxel is removed only once a falling level is below its `guide` (cells).
// `order` (the ranks of a growth, > 0 for every voxel) determines which of two neighbours supports
// the other: loops then open where that growth opened them, so that the tip of a hook does not
// block all voxels that support it. With options.eases, voxels that wait too long may be deeper
// than the tolerance: the resulting levels are a target for a field, not an order of printing.
// Throws Cancelled.
Peeling peelGuided(const VoxelGraph& graph, const std::vector<float>& guide,
                   const std::vector<std::int32_t>& order, const PeelOptions& options,
                   const base::RunContext& ctx);

} // namespace voluta::curved
