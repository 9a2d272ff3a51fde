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
      {"auto", "Automatic"_text, "Peels the part and keeps the best of several passes"_text, true,
       growByPeeling},
      {"reverse", "Reverse peeling"_text,
       "Removes voxels from outside while the rest stays supported; printed in the opposite order"_text,
       true, growByPeeling},
      {"guided", "Guided by peeling"_text,
       "Grows from the platform, held back by the peeling field"_text, false,
       forward<ForwardScheme::Guided>},
      {"adaptive", "Halved layers"_text,
       "Grows from the platform; a layer that would shadow voxels is halved until it does not"_text,
       false, forward<ForwardScheme::Adaptive>},
      {"incremental", "Voxel by voxel"_text,
       "Grows from the platform; a layer takes each voxel that shadows no other"_text, false,
       forward<ForwardScheme::Incremental>},
      {"greedy", "Greedy"_text,
       "Grows from the platform by whole layers, whatever they shadow"_text, false,
       forward<ForwardScheme::Greedy>},
  };
  return kRows;
}

} // namespace voluta::curved
