#include "replay/covered_beads.h"

#include "base/parallel.h"
#include "replay/beneath.h"

#include <algorithm>

namespace voluta::replay {

namespace {

constexpr double kTolerance = 0.02; // of a limit

// A piece on the clock of the run.
struct TimedPiece {
  double middleS = 0.0, lengthMm = 0.0;
  std::size_t motion = 0;
  double share = 0.0; // of its motion, at its middle
};

std::vector<TimedPiece> timedPieces(const std::vector<DepositedPiece>& pieces,
                                    const std::vector<std::uint32_t>& firstPiece, const Run& run) {
  const auto startMm = [&](std::size_t p) {
    return p > 0 && pieces[p - 1].run == pieces[p].run ? static_cast<double>(pieces[p - 1].runMm)
                                                       : 0.0;
  };
  std::vector<TimedPiece> timed(pieces.size());
  for (std::size_t m = 0; m + 1 < firstPiece.size(); ++m) {
    const std::size_t first = firstPiece[m], end = firstPiece[m + 1];
    if (first == end)
      continue;
    const double from = startMm(first);
    const double length = std::max(static_cast<double>(pieces[end - 1].runMm) - from, 1e-9);
    for (std::size_t p = first; p < end; ++p) {
      const double begin = startMm(p), to = static_cast<double>(pieces[p].runMm);
      const double share = std::clamp((0.5 * (begin + to) - from) / length, 0.0, 1.0);
      timed[p] = {run.beginS[m] + share * (run.endS[m] - run.beginS[m]), to - begin, m, share};
    }
  }
  return timed;
}

CoveredPlace coveredPlace(const TimedPiece& piece, double timeS, const ExecutedPath& path) {
  const std::size_t first = path.firstSample[piece.motion],
                    count = path.firstSample[piece.motion + 1] - first;
  CoveredPlace place{timeS, piece.motion};
  if (count > 0)
    place.where =
        path.tip[first + std::min(count - 1, static_cast<std::size_t>(piece.share *
                                                                      static_cast<double>(count)))];
  return place;
}

} // namespace

std::vector<std::uint32_t> piecesBelow(const std::vector<BeadPiece>& pieces,
                                       const PrintedPart& printed, const GroundProbe& ground,
                                       const base::RunContext& ctx) {
  std::vector<std::uint32_t> below(pieces.size(), kNeverFilled);
  base::parallelChunks(ctx, pieces.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      if (!pieces[p].waste && !pieces[p].shot)
        below[p] = Beneath(pieces, static_cast<std::uint32_t>(p), printed, ground).pieceBelow();
  });
  return below;
}

CoveredBeads coveredBeads(const std::vector<DepositedPiece>& pieces,
                          const std::vector<std::uint32_t>& below,
                          const std::vector<std::uint32_t>& firstPiece, const Run& run,
                          const plan::LayerTimes& limits) {
  const std::vector<TimedPiece> timed = timedPieces(pieces, firstPiece, run);
  CoveredBeads out;
  LayerTimeFigures& figures = out.figures;
  figures.lengthMm.assign(kLayerTimeClassesS.size() + 1, 0.0);
  double length = 0.0, sum = 0.0;
  std::size_t shortest = 0, longest = 0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (below[p] == kNeverFilled || timed[below[p]].motion < run.firstMotion)
      continue;
    const double time = timed[p].middleS - timed[below[p]].middleS, mm = timed[p].lengthMm;
    if (length == 0.0 || time < figures.shortestS) {
      figures.shortestS = time;
      shortest = p;
    }
    if (length == 0.0 || time > figures.longestS) {
      figures.longestS = time;
      longest = p;
    }
    length += mm;
    sum += time * mm;
    const auto above = std::ranges::upper_bound(kLayerTimeClassesS, time);
    figures.lengthMm[static_cast<std::size_t>(above - kLayerTimeClassesS.begin())] += mm;
    if (limits.minS > 0.0 && time < (1.0 - kTolerance) * limits.minS)
      out.youngMm += mm;
    if (limits.maxS > 0.0 && time > (1.0 + kTolerance) * limits.maxS)
      out.oldMm += mm;
  }
  if (length == 0.0)
    return out;
  figures.meanS = sum / length;
  out.shortest = coveredPlace(timed[shortest], figures.shortestS, run.path);
  out.longest = coveredPlace(timed[longest], figures.longestS, run.path);
  return out;
}

} // namespace voluta::replay
