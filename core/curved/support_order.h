// Which voxel carries which while a set is peeled.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// A set of voxels with a distance each. A voxel rests on its neighbours of lower distance (of equal
// ones: lower index, where ties carry); it must keep one of them, unless it stands on the platform.
class SupportOrder {
public:
  // Chamfer distances from the platform over the voxels with present[v] (flood()), ties carry.
  // `present` holds exactly what is reached afterwards. Keeps references.
  SupportOrder(const VoxelGraph& graph, std::vector<std::uint8_t>& present,
               const base::RunContext& ctx);
  // Given distances, > 0 where a voxel is present: ties do not carry.
  SupportOrder(const VoxelGraph& graph, std::vector<std::uint8_t>& present,
               const std::vector<std::int32_t>& order, const base::RunContext& ctx);

  // Distances anew for what is present: costs what is left, not what there was.
  void flood(const base::RunContext& ctx);
  // Lets v go, which the caller has taken out of `present`; drop() it then. What rested on nothing
  // else, `most` voxels at most, gets distances by other ways: those a flood would find over it,
  // from the distances around as they are (Ramalingam and Reps 1996, for what only grows). False,
  // and nothing done, where it is more than that or has no other way. Precondition: nothing is
  // lifted.
  bool reroute(std::size_t v, std::size_t most);
  // What is present, in the order of voxels, as of the last flood().
  const std::vector<std::int32_t>& remaining() const { return remaining_; }

  // Later voxels come before earlier ones.
  bool later(std::size_t a, std::size_t b) const {
    return distance_[a] != distance_[b] ? distance_[a] > distance_[b] : a > b;
  }

  // Whether everything that rests on v keeps another support.
  bool allows(std::size_t v) const;
  // v carries nothing for the time being, and again.
  void lift(std::size_t v) { change(v, -1); }
  void putBack(std::size_t v) { change(v, 1); }
  // v, lifted before, is gone for good; `present` is the caller's.
  void drop(std::size_t v) { supports_[v] = kFree; }

private:
  // More than a voxel's neighbours could ever take from it: asks nothing of them.
  static constexpr std::uint8_t kFree = 64;

  bool uprootAll(std::size_t from, std::size_t most);
  void uproot(std::size_t from);
  bool findOtherWays();
  bool rests(std::size_t on, std::size_t v) const {
    return distance_[on] != distance_[v] ? distance_[on] < distance_[v] : tiesCarry_ && on < v;
  }
  void change(std::size_t v, int by);
  void gatherRemaining();
  void countAll(const base::RunContext& ctx);
  void count(std::size_t v);

  const VoxelGraph& graph_;
  std::vector<std::uint8_t>& present_;
  bool tiesCarry_;
  std::vector<std::int32_t> remaining_;
  // reroute(): what rests on nothing any more, its distances before, and what rests on one less, as
  // often as it does; marks of the uprooted.
  std::vector<std::int32_t> uprooted_, lessened_;
  std::vector<float> was_;
  std::vector<std::uint32_t> mark_;
  std::uint32_t marked_ = 0;
  std::vector<float> distance_;
  std::vector<std::uint8_t>
      supports_; // neighbours it rests on that stay, of voxels off the platform
  std::vector<std::uint32_t> carries_; // bit n: the n-th neighbour rests on it
};

} // namespace voluta::curved
