// Support relation between the voxels of a set while it is peeled.
#pragma once

#include "base/run_context.h"
#include "curved/voxel_graph.h"

#include <cstdint>
#include <vector>

namespace voluta::curved {

// A set of voxels with a distance each. A voxel rests on its neighbours of lower distance (of equal
// distance and lower index, if ties carry); it has to keep one of them, unless it is on the
// platform.
class SupportOrder {
public:
  // Chamfer distances from the platform over the voxels with present[v] (flood()); ties carry.
  // Afterwards `present` contains exactly the voxels that were reached. Keeps references.
  SupportOrder(const VoxelGraph& graph, std::vector<std::uint8_t>& present,
               const base::RunContext& ctx);
  // With given distances, > 0 for present voxels; ties do not carry.
  SupportOrder(const VoxelGraph& graph, std::vector<std::uint8_t>& present,
               const std::vector<std::int32_t>& order, const base::RunContext& ctx);

  // Recomputes the distances of the present voxels; the cost depends on their number only.
  void flood(const base::RunContext& ctx);
  // Removes v, which the caller has taken out of `present`; call drop() afterwards. Voxels that
  // rested on nothing else, at most `limit`, get new distances over other ways: those that a flood
  // would find from the surrounding distances (Ramalingam and Reps 1996, for increases only).
  // Returns false and changes nothing if there are more or they have no other way. Precondition: no
  // voxel is lifted.
  bool reroute(std::size_t v, std::size_t limit);
  // The present voxels, in the order of voxels, as of the last flood().
  const std::vector<std::int32_t>& remaining() const { return remaining_; }

  // Returns whether a comes after b: larger distance, or equal distance and larger index.
  bool later(std::size_t a, std::size_t b) const {
    return distance_[a] != distance_[b] ? distance_[a] > distance_[b] : a > b;
  }

  // Returns whether all voxels that rest on v keep another support.
  bool allows(std::size_t v) const;
  // Tentatively removes v as a support, and puts it back.
  void lift(std::size_t v) { change(v, -1); }
  void putBack(std::size_t v) { change(v, 1); }
  // Removes v, which was lifted before, for good; the caller updates `present`.
  void drop(std::size_t v) { supports_[v] = kFree; }

private:
  // More supports than a voxel has neighbours: it never loses the last one.
  static constexpr std::uint8_t kFree = 64;

  bool uprootAll(std::size_t from, std::size_t limit);
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
  // reroute(): voxels that lost all supports, their previous distances, and voxels that lost a
  // support, once per lost support; marks of the uprooted.
  std::vector<std::int32_t> uprooted_, lessened_;
  std::vector<float> was_;
  std::vector<std::uint32_t> mark_;
  std::uint32_t marked_ = 0;
  std::vector<float> distance_;
  std::vector<std::uint8_t>
      supports_; // per voxel off the platform: number of present neighbours that it rests on
  std::vector<std::uint32_t> carries_; // bit n: the n-th neighbour rests on it
};

} // namespace voluta::curved
