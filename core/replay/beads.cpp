#include "replay/beads.h"

#include "base/error.h"
#include "base/parallel.h"
#include "replay/beneath.h"
#include "replay/bridged_spans.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

double motionVolume(const plan::ProgramMotion& motion, double seconds) {
  if (!motion.extruding)
    return 0.0;
  if (motion.volumeMm3 >= 0.0)
    return motion.volumeMm3;
  return motion.flowMm3PerS * seconds;
}

double motionVolume(const plan::ReadProgram& program, const ExecutedPath& path, std::size_t m) {
  return motionVolume(program.motions[m], path.durationS[m]);
}

std::vector<BeadKnowledge> beadKnowledge(const std::vector<std::size_t>& pointOf,
                                         const plan::Trajectory& trajectory,
                                         const plan::ToolPlan& plan, double defaultHeightMm) {
  std::vector<const plan::ToolPath*> pathOf(plan.waypointCount());
  for (const plan::ToolPath& path : plan.paths)
    std::fill_n(pathOf.begin() + static_cast<std::ptrdiff_t>(path.first), path.count, &path);
  // Points between waypoints (subdivisions) get the height of the next waypoint along the bead.
  std::vector<std::size_t> waypointAt(trajectory.pointCount(), plan::kNoWaypoint);
  std::size_t next = plan::kNoWaypoint;
  for (std::size_t j = trajectory.pointCount(); j-- > 0;) {
    if (trajectory.waypoint[j] != plan::kNoWaypoint)
      next = trajectory.waypoint[j];
    waypointAt[j] = next;
    if (trajectory.move[j] != plan::MoveKind::Print)
      next = plan::kNoWaypoint; // an approach does not continue the bead before it
  }
  std::vector<BeadKnowledge> result(pointOf.size());
  BeadKnowledge last{static_cast<float>(defaultHeightMm), static_cast<float>(defaultHeightMm), true,
                     false};
  for (std::size_t m = 0; m < pointOf.size(); ++m) {
    BeadKnowledge here{last.toHeightMm, last.toHeightMm, last.ofPart,
                       last.waste,      last.item,       last.tape};
    const std::size_t w =
        pointOf[m] < waypointAt.size() ? waypointAt[pointOf[m]] : plan::kNoWaypoint;
    if (w < plan.waypointCount()) {
      here.toHeightMm = plan.heightMm[w];
      here.waste = plan::isWaste(pathOf[w]->kind);
      here.tape = pathOf[w]->kind == plan::PathKind::Tape;
      here.ofPart = !here.waste && !here.tape && pathOf[w]->kind != plan::PathKind::Support;
      here.item = static_cast<std::uint8_t>(pathOf[w]->item);
    }
    result[m] = last = here;
  }
  return result;
}

namespace {
// Pieces shorter than a grid cell would be deposited with few, uneven samples. Therefore collinear
// samples are merged into one piece. Blends deviate from their chord by less than this sagitta if
// the program keeps to its blends. For beads of up to kTunedHeightMm; more for higher ones.
constexpr double kPieceMm = 1.05, kPieceSagittaMm = 0.03, kTunedHeightMm = 1.0;

// Returns the last sample before `end` that a straight piece from sample `start` may reach, of a
// bead of this height.
std::size_t straightFrom(const std::vector<Eigen::Vector3d>& tip, std::size_t start,
                         std::size_t end, double heightMm) {
  const double scale = std::max(1.0, heightMm / kTunedHeightMm);
  const double longest = kPieceMm * scale, sagitta = kPieceSagittaMm * scale;
  std::size_t last = start + 1;
  for (std::size_t s = start + 2; s < end; ++s) {
    const Eigen::Vector3d chord = tip[s] - tip[start];
    if (chord.norm() > longest)
      break;
    const Eigen::Vector3d along = chord.normalized();
    for (std::size_t k = start + 1; k < s; ++k) {
      const Eigen::Vector3d r = tip[k] - tip[start];
      if ((r - r.dot(along) * along).norm() > sagitta || r.dot(along) < 0.0)
        return last;
    }
    last = s;
  }
  return last;
}
// Cuts motions into pieces, in the order of the program.
class PieceCutter {
public:
  explicit PieceCutter(const ExecutedPath& path) : path_(path) {}

  void stop() { laying_ = false; }

  // Of motion m's end.
  void shoot(std::size_t m, double volumeMm3, const BeadKnowledge& known) {
    BeadPiece piece;
    piece.run = ++run_;
    piece.motion = static_cast<std::uint32_t>(m);
    piece.item = known.item;
    piece.shot = true;
    runMm_ = 0.0;
    addOnTheSpot(piece, path_.firstSample[m + 1] - 1, volumeMm3, known);
    stop();
  }

  void cut(std::size_t m, double volumeMm3, const BeadKnowledge& known) {
    if (!laying_) {
      ++run_;
      runMm_ = 0.0;
      laying_ = true;
    }
    const std::size_t first = path_.firstSample[m], end = path_.firstSample[m + 1];
    double length = 0.0;
    for (std::size_t s = std::max<std::size_t>(first, 1); s < end; ++s)
      length += (path_.tip[s] - path_.tip[s - 1]).norm();
    BeadPiece piece;
    piece.run = run_;
    piece.motion = static_cast<std::uint32_t>(m);
    piece.ofPart = known.ofPart;
    piece.waste = known.waste;
    piece.item = known.item;
    if (length < 1e-6)
      addOnTheSpot(piece, end - 1, volumeMm3, known);
    else
      addAlong(piece, std::max<std::size_t>(first, 1), end, length, volumeMm3, known);
  }

  std::vector<BeadPiece> take() { return std::move(pieces_); }

private:
  void addOnTheSpot(BeadPiece piece, std::size_t sample, double volumeMm3,
                    const BeadKnowledge& known) {
    piece.from = piece.to = path_.tip[sample];
    piece.fromDirection = piece.toDirection = path_.direction[sample];
    piece.fromHeightMm = piece.toHeightMm = known.toHeightMm;
    piece.volumeMm3 = static_cast<float>(volumeMm3);
    piece.runMm = static_cast<float>(runMm_);
    pieces_.push_back(piece);
  }

  // Of the samples [first, end), `length` long.
  void addAlong(BeadPiece piece, std::size_t first, std::size_t end, double length,
                double volumeMm3, const BeadKnowledge& known) {
    const auto heightAt = [&](double at) {
      return static_cast<float>(known.fromHeightMm +
                                at / length * (known.toHeightMm - known.fromHeightMm));
    };
    double done = 0.0;
    for (std::size_t s = first; s < end;) {
      const std::size_t last =
          straightFrom(path_.tip, s - 1, end, std::min(known.fromHeightMm, known.toHeightMm));
      double step = 0.0;
      for (std::size_t k = s; k <= last; ++k)
        step += (path_.tip[k] - path_.tip[k - 1]).norm();
      piece.from = path_.tip[s - 1];
      piece.to = path_.tip[last];
      piece.fromDirection = path_.direction[s - 1];
      piece.toDirection = path_.direction[last];
      s = last + 1;
      if (step <= 0.0)
        continue;
      piece.fromHeightMm = heightAt(done);
      done += step;
      runMm_ += step;
      piece.toHeightMm = heightAt(done);
      piece.volumeMm3 = static_cast<float>(volumeMm3 * step / length);
      piece.runMm = static_cast<float>(runMm_);
      pieces_.push_back(piece);
    }
  }

  const ExecutedPath& path_;
  std::vector<BeadPiece> pieces_;
  std::uint32_t run_ = 0; // beads without a stop
  double runMm_ = 0.0;
  bool laying_ = false;
};

} // namespace

std::vector<BeadPiece> beadPieces(const std::vector<double>& volumeMm3, const ExecutedPath& path,
                                  const std::vector<BeadKnowledge>& knowledge,
                                  const std::vector<double>& shotMm3) {
  base::require(knowledge.size() == path.motionCount() && volumeMm3.size() == path.motionCount(),
                "beadPieces: volume and knowledge per motion");
  PieceCutter cutter(path);
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    if (volumeMm3[m] <= 0.0 || knowledge[m].tape)
      cutter.stop();
    else
      cutter.cut(m, volumeMm3[m], knowledge[m]);
    if (m < shotMm3.size() && shotMm3[m] > 0.0)
      cutter.shoot(m, shotMm3[m], knowledge[m]);
  }
  return cutter.take();
}

void dropFallen(std::vector<BeadPiece>& pieces, const GroundProbe& ground) {
  constexpr double kBeneath = 1.25; // heights below the tip, as for all beads
  std::uint32_t firstRun = 0;
  bool held = false;
  std::size_t count = 0;
  for (const BeadPiece& piece : pieces) {
    firstRun = count == 0 ? piece.run : firstRun;
    if (!piece.waste || piece.run != firstRun)
      break;
    const Eigen::Vector3d tip = 0.5 * (piece.from + piece.to);
    const double height = 0.5 * (static_cast<double>(piece.fromHeightMm) + piece.toHeightMm);
    held = held || ground.holds(tip - kBeneath * height * piece.fromDirection, 0.0);
    ++count;
  }
  if (!held)
    pieces.erase(pieces.begin(), pieces.begin() + static_cast<std::ptrdiff_t>(count));
}

std::vector<DepositedPiece> depositedPieces(const std::vector<BeadPiece>& pieces,
                                            double widthMaxMm) {
  std::vector<DepositedPiece> deposited;
  deposited.reserve(pieces.size());
  for (const BeadPiece& piece : pieces)
    deposited.push_back({piece.motion, piece.run, piece.runMm,
                         static_cast<float>(2.0 * sectionOf(piece, widthMaxMm).widthMm)});
  return deposited;
}

std::vector<std::uint32_t> firstPieceOfMotions(const std::vector<DepositedPiece>& pieces,
                                               std::size_t motions) {
  std::vector<std::uint32_t> first(motions + 1);
  std::size_t p = 0;
  for (std::size_t m = 0; m <= motions; ++m) {
    while (p < pieces.size() && pieces[p].motion < m)
      ++p;
    first[m] = static_cast<std::uint32_t>(p);
  }
  return first;
}

namespace {
// The longest run of consecutive pieces of one bead that share a defect.
struct LongestRun {
  double longestMm = 0.0;
  std::optional<std::uint32_t> first; // first piece; empty if no piece has the defect

  void add(std::size_t piece, double lengthMm, bool continuesBead, bool hasDefect) {
    if (!continuesBead || !hasDefect)
      runMm_ = 0.0;
    if (!hasDefect)
      return;
    if (runMm_ == 0.0)
      from_ = static_cast<std::uint32_t>(piece);
    runMm_ += lengthMm;
    if (runMm_ > longestMm) {
      longestMm = runMm_;
      first = from_;
    }
  }

private:
  double runMm_ = 0.0;
  std::uint32_t from_ = 0;
};
} // namespace

SupportedBeads findSupport(const std::vector<BeadPiece>& pieces, const PrintedPart& printed,
                           const GroundProbe& ground, const base::RunContext& ctx,
                           const Bridging* bridging) {
  std::vector<PieceSupport> found(pieces.size());
  base::parallelChunks(ctx, pieces.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      if (pieces[p].waste || pieces[p].shot) {
        found[p] = {true, 1.0};
        continue;
      }
      const Beneath beneath(pieces, static_cast<std::uint32_t>(p), printed, ground);
      found[p] = {beneath.supported(), beneath.carriedShare()};
    }
  });
  if (bridging != nullptr)
    acceptBridgedSpans(pieces, printed, *bridging, found, ctx);
  SupportedBeads result;
  LongestRun inTheAir, unsupported, halfCarried;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (pieces[p].waste || pieces[p].shot)
      continue;
    const double length = (pieces[p].to - pieces[p].from).norm();
    const bool continues = p > 0 && pieces[p].run == pieces[p - 1].run;
    inTheAir.add(p, length, continues, found[p].carried <= 0.0);
    unsupported.add(p, length, continues, !found[p].supported);
    halfCarried.add(p, length, continues, found[p].carried < 0.5);
    result.lengthMm += length;
    if (result.lengthOfItemMm.size() <= pieces[p].item) {
      result.lengthOfItemMm.resize(pieces[p].item + 1U);
      result.unsupportedOfItemMm.resize(pieces[p].item + 1U);
    }
    result.lengthOfItemMm[pieces[p].item] += length;
    if (!found[p].supported) {
      result.unsupportedMm += length;
      result.unsupportedOfItemMm[pieces[p].item] += length;
      result.unsupported.push_back(static_cast<std::uint32_t>(p));
    }
    if (found[p].carried < 0.5)
      result.halfCarriedMm += length;
  }
  result.longestUnsupportedMm = inTheAir.longestMm;
  result.longestFrom = inTheAir.first.value_or(0);
  result.unsupportedFrom = unsupported.first;
  result.halfCarriedFrom = halfCarried.first;
  return result;
}

} // namespace voluta::replay
