#include "replay/bridged_spans.h"

#include "base/parallel.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace voluta::replay {

namespace {
using Eigen::Vector3d;

constexpr double kBelow = 1.15;  // [heights] below the tip
constexpr double kBeside = 0.65; // [widths] from the middle of the bead

// Where a piece is, and what holds it.
enum class Held : std::uint8_t { Below, Beside, InteriorGap, OpenGap };

class Judge {
public:
  Judge(const std::vector<BeadPiece>& pieces, const PrintedPart& printed, const Bridging& bridging,
        const std::vector<PieceSupport>& support)
      : pieces_(pieces), printed_(printed), bridging_(bridging), support_(support) {}

  Held of(std::size_t p) const {
    if (support_[p].supported)
      return Held::Below;
    const BeadPiece& piece = pieces_[p];
    const Vector3d tip = 0.5 * (piece.from + piece.to);
    const Vector3d up = (piece.fromDirection + piece.toDirection).normalized();
    const double height = 0.5 * (static_cast<double>(piece.fromHeightMm) + piece.toHeightMm);
    if (!bridging_.sparsePart || !bridging_.sparsePart->inside(tip - kBelow * height * up))
      return Held::OpenGap;
    const Vector3d side = up.cross(piece.to - piece.from).normalized();
    const double width = sectionOf(piece, widestOf(piece)).widthMm;
    const PrintState moment{static_cast<std::uint32_t>(p), piece.run, piece.runMm,
                            static_cast<float>(2.0 * width)};
    const std::array<double, 2> sides{-kBeside * width, kBeside * width};
    const bool isBeside = std::ranges::any_of(sides, [&](double lateral) {
      const std::uint32_t neighbour =
          printed_.pieceAt(tip - 0.5 * height * up + lateral * side, moment);
      return neighbour != kNeverFilled && support_[neighbour].supported;
    });
    return isBeside ? Held::Beside : Held::InteriorGap;
  }

private:
  const std::vector<BeadPiece>& pieces_;
  const PrintedPart& printed_;
  const Bridging& bridging_;
  const std::vector<PieceSupport>& support_;
};

// Finds the gaps along the beads: pieces [begin, end) of one bead.
class Spans {
public:
  Spans(const std::vector<BeadPiece>& pieces, const std::vector<Held>& held)
      : pieces_(pieces), held_(held) {}

  std::size_t endOf(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (continues(end) && !isHeld(end))
      ++end;
    return end;
  }
  double lengthMm(std::size_t begin, std::size_t end) const {
    double length = 0.0;
    for (std::size_t p = begin; p < end; ++p)
      length += (pieces_[p].to - pieces_[p].from).norm();
    return length;
  }
  // Returns the length that the gap may have.
  double allowedMm(std::size_t begin, std::size_t end, const Bridging& bridging) const {
    const bool isFirst = !continues(begin), isLast = !continues(end);
    const bool before = !isFirst && isHeld(begin - 1), after = !isLast && isHeld(end);
    if (before && after)
      return isStraight(begin, end) ? bridging.bridgeMm(pieces_[begin]) : 0.0;
    return held_[begin] == Held::InteriorGap && ((isFirst && after) || (before && isLast))
               ? widthMm(begin)
               : 0.0;
  }

private:
  double widthMm(std::size_t p) const {
    return sectionOf(pieces_[p], widestOf(pieces_[p])).widthMm;
  }
  bool isStraight(std::size_t begin, std::size_t end) const {
    const Vector3d from = pieces_[begin].from, chord = pieces_[end - 1].to - from;
    const double length = chord.norm();
    for (std::size_t p = begin; p + 1 < end; ++p) {
      const Vector3d to = pieces_[p].to - from;
      const double along = length > 0.0 ? std::clamp(to.dot(chord) / length, 0.0, length) : 0.0;
      const Vector3d nearest = length > 0.0 ? Vector3d(along / length * chord) : Vector3d::Zero();
      if ((to - nearest).norm() > 0.5 * widthMm(p))
        return false;
    }
    return true;
  }
  bool isHeld(std::size_t p) const { return held_[p] == Held::Below || held_[p] == Held::Beside; }
  // Returns whether piece p continues the bead of the piece before it.
  bool continues(std::size_t p) const {
    return p > 0 && p < pieces_.size() && pieces_[p].run == pieces_[p - 1].run;
  }

  const std::vector<BeadPiece>& pieces_;
  const std::vector<Held>& held_;
};
} // namespace

void acceptBridgedSpans(const std::vector<BeadPiece>& pieces, const PrintedPart& printed,
                        const Bridging& bridging, std::vector<PieceSupport>& support,
                        const base::RunContext& ctx) {
  std::vector<Held> held(pieces.size());
  const Judge judge(pieces, printed, bridging, support);
  base::parallelChunks(ctx, pieces.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      held[p] = judge.of(p);
  });
  const Spans spans(pieces, held);
  for (std::size_t p = 0; p < pieces.size();) {
    if (held[p] == Held::Beside)
      support[p] = {true, 1.0};
    if (held[p] == Held::Below || held[p] == Held::Beside) {
      ++p;
      continue;
    }
    const std::size_t end = spans.endOf(p);
    if (spans.lengthMm(p, end) <= spans.allowedMm(p, end, bridging))
      for (std::size_t k = p; k < end; ++k) {
        support[k].supported = true;
        if (held[k] == Held::InteriorGap)
          support[k].carried = 1.0; // a span in the open stays a span in the report
      }
    p = end;
  }
}

} // namespace voluta::replay
