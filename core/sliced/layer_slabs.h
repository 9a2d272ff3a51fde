// Slabs between the tops of level layers, and the beads in each.
#pragma once

#include "plan/tool_plan.h"

#include <cstddef>
#include <vector>

namespace voluta::sliced {

class LayerSlabs {
public:
  // `takes`: the kinds of beads that count. Precondition: there are some, with heights > 0.
  LayerSlabs(const plan::ToolPlan& plan, bool (*takes)(plan::PathKind));

  // A segment that ends at waypoint `end`.
  struct Segment {
    std::size_t path, end;
  };

  std::size_t count() const { return bounds_.size() - 1; }
  const std::vector<Segment>& segments(std::size_t slab) const { return segments_[slab]; }
  // Returns z [mm] at a number of slabs above the lowest bound, linear within a slab.
  double heightAt(double slabs) const;

private:
  // Returns the slab that contains a height, or the nearest.
  std::size_t slabAt(double z) const;

  std::vector<double> bounds_; // Ascending
  std::vector<std::vector<Segment>> segments_;
};

} // namespace voluta::sliced
