// The layers of all parts of a job.
#pragma once

#include "layers/print_order.h"
#include "project/job.h"

#include <algorithm>
#include <memory>
#include <vector>

namespace voluta::window {

// Two are equal if they are the same data, so that nothing is drawn twice.
struct JobLayers {
  std::vector<std::shared_ptr<const layers::LayerStack>> stacks; // by item
  layers::PrintOrder order = layers::PrintOrder::OneAfterAnother;
  bool operator==(const JobLayers&) const = default;

  // Returns whether every item has its layers.
  bool complete() const {
    return !stacks.empty() && std::ranges::none_of(stacks, [](const auto& s) { return !s; });
  }
  // Returns all layers in print order. Precondition: complete().
  std::shared_ptr<const layers::LayerStack> joined() const {
    return layers::joinStacks(stacks, order);
  }
};

inline JobLayers layersOf(const project::Job& job) {
  JobLayers all{{}, job.choices.printOrder};
  for (const project::JobItem& item : job.items)
    all.stacks.push_back(item.layers);
  return all;
}

} // namespace voluta::window
