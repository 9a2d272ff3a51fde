#include "curved/growth_rows.h"

#include "base/stopwatch.h"
#include "curved/peeling_passes.h"

#include <utility>

namespace voluta::curved {

namespace {

template <ForwardScheme kScheme>
Growth forward(const GrowthInput& in, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  ForwardGrowth grown = forwardGrowth(in.graph, kScheme, in.forward, ctx);
  Growth out;
  out.growSeconds = watch.seconds();
  out.rank = std::move(grown.rank);
  out.ranks = grown.ranks;
  return out;
}

} // namespace

const std::vector<GrowthRow>& growthRows() {
  static const std::vector<GrowthRow> kRows{
      {"auto", "Automatic", "Peels the part and keeps the best of several passes", true,
       growByPeeling},
      {"reverse", "Peeling, turned round",
       "Takes voxels off from outside while the rest keeps its support; printed in the opposite "
       "order",
       true, growByPeeling},
      {"guided", "Guided by peeling", "Grows from the platform, held back by the peeling field",
       false, forward<ForwardScheme::Guided>},
      {"adaptive", "Halved layers",
       "Grows from the platform; a layer that would cut voxels off is halved until it does not",
       false, forward<ForwardScheme::Adaptive>},
      {"incremental", "Voxel by voxel",
       "Grows from the platform; a layer takes each voxel that cuts off no other", false,
       forward<ForwardScheme::Incremental>},
      {"greedy", "Greedy", "Grows from the platform by whole layers, whatever they cut off", false,
       forward<ForwardScheme::Greedy>},
  };
  return kRows;
}

} // namespace voluta::curved
