#include "toolpath/sparse/stack_layers.h"

#include <cstddef>

namespace voluta::toolpath {

StackLayers::StackLayers(const layers::LayerStack& stack, bool always, const base::RunContext& ctx)
    : levels(stack, ctx) {
  bool isAnyCurved = always;
  for (std::size_t i = 0; i < stack.patches.size() && !isAnyCurved; ++i)
    isAnyCurved = !levels.isEven(i) && !stack.patches[i].surface.empty() &&
                  stack.patches[i].group != layers::kSupportGroup;
  if (isAnyCurved)
    count.emplace(stack, ctx);
}

} // namespace voluta::toolpath
