#include "layers/layer_findings.h"

#include "plan/finding_kinds.h"

namespace voluta::layers {

NotPrinted notPrinted(const std::vector<DroppedPiece>& dropped) {
  NotPrinted sum;
  double maximum = 0.0;
  for (const DroppedPiece& piece : dropped) {
    if (sum.pieces == 0 || piece.volumeMm3 > maximum) {
      maximum = piece.volumeMm3;
      sum.largestAt = piece.centre;
    }
    ++sum.pieces;
    sum.volumeMm3 += piece.volumeMm3;
  }
  return sum;
}

std::optional<plan::Finding> sliversFinding(const NotPrinted& slivers, double depositedMm3,
                                            double blockingShare) {
  if (slivers.pieces == 0)
    return std::nullopt;
  const double whole = depositedMm3 + slivers.volumeMm3;
  plan::Finding finding = plan::makeFinding(plan::FindingKind::Slivers,
                                            {{"pieces", slivers.pieces},
                                             {"volume", base::mm3(slivers.volumeMm3)},
                                             {"whole", base::mm3(whole)}},
                                            slivers.largestAt, slivers.pieces);
  finding.blocking = slivers.volumeMm3 > blockingShare * whole;
  return finding;
}

InAir patchesInAir(const std::vector<SupportCheck>& support, const IslandOptions& options) {
  InAir found;
  for (const SupportCheck& check : support) {
    if (check.supportedFraction >= options.supportedShare)
      continue;
    if (found.patches++ == 0)
      found.firstAt = check.unsupportedAt;
  }
  return found;
}

} // namespace voluta::layers
