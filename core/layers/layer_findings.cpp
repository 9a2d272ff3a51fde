#include "layers/layer_findings.h"

#include <fmt/format.h>
#include <utility>

namespace voluta::layers {

plan::Finding layerFinding(const char* kind, const Eigen::Vector3d& where, std::size_t count,
                           std::string reason, std::string remedy, bool blocking) {
  plan::Finding f;
  f.stage = "layers";
  f.kind = kind;
  f.where = where;
  f.count = count;
  f.reason = std::move(reason);
  f.remedy = std::move(remedy);
  f.blocking = blocking;
  return f;
}

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
  return layerFinding("slivers", slivers.largestAt, slivers.pieces,
                      fmt::format("{} pieces of layers are too small for a bead or would begin in "
                                  "the air, {:.3g} mm3 of {:.3g}: they are not laid",
                                  slivers.pieces, slivers.volumeMm3, whole),
                      "use a finer nozzle, or print the part larger",
                      slivers.volumeMm3 > blockingShare * whole);
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
