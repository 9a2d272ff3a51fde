#include "modes/cut_estimate.h"

#include "modes/planar_modes.h"
#include "planar/published/greedy_decompose.h"

namespace voluta::modes {

CutEstimateOptions cutEstimateOptions(const ModeChoices& in) {
  return {riskRule(in), process::erodedHead(in.process.head, in.process.contactToleranceMm)};
}

CutEstimate estimatedCuts(const geometry::TriangleMesh& part, const CutEstimateOptions& options,
                          const base::RunContext& ctx) {
  planar::PlanarOptions planar;
  planar.rule = options.rule;
  planar.head = options.head;
  const planar::PlanarDecomposition cut = planar::greedyDecompose(part, planar, {}, ctx);
  return {cut.riskyMm2, cut.pieces.size()};
}

} // namespace voluta::modes
