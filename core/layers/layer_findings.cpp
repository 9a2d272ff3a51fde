#include "layers/layer_findings.h"

#include "plan/finding_kinds.h"

namespace voluta::layers {

NotLaid notLaid(const std::vector<DroppedPiece>& dropped) {
  NotLaid sum;
  double most = 0.0;
  for (const DroppedPiece& piece : dropped) {
    if (sum.pieces == 0 || piece.volumeMm3 > most) {
      most = piece.volumeMm3;
      sum.largestAt = piece.centre;
    }
    ++sum.pieces;
    sum.volumeMm3 += piece.volumeMm3;
  }
  return sum;
}

std::optional<plan::Finding> sliversFinding(const NotLaid& slivers, double laidMm3,
                                            double blockingShare) {
  if (slivers.pieces == 0)
    return std::nullopt;
  const double whole = laidMm3 + slivers.volumeMm3;
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
