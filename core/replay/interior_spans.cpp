#include "replay/interior_spans.h"

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
enum class Held : std::uint8_t { Below, Beside, InteriorGap, OtherGap };

class Judge {
public:
  Judge(const std::vector<BeadPiece>& pieces, const PrintedPart& printed, const Interior& interior,
        const std::vector<PieceSupport>& support)
      : pieces_(pieces), printed_(printed), interior_(interior), support_(support) {}

  Held of(std::size_t p) const {
    if (support_[p].supported)
      return Held::Below;
    const BeadPiece& piece = pieces_[p];
    const Vector3d tip = 0.5 * (piece.from + piece.to);
    const Vector3d up = (piece.fromDirection + piece.toDirection).normalized();
    const double height = 0.5 * (static_cast<double>(piece.fromHeightMm) + piece.toHeightMm);
    if (!interior_.part.inside(tip - kBelow * height * up))
      return Held::OtherGap;
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
  const Interior& interior_;
  const std::vector<PieceSupport>& support_;
};
// Finds the gaps along the beads: pieces [begin, end) of one bead.
class Spans {
public:
  Spans(const std::vector<BeadPiece>& pieces, const std::vector<Held>& held)
      : pieces_(pieces), held_(held) {}

  std::size_t endOf(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (continues(end) && held_[end] == Held::InteriorGap)
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
  double allowedMm(std::size_t begin, std::size_t end, const Interior& interior) const {
    const bool isFirst = !continues(begin), isLast = !continues(end);
    const bool before = !isFirst && isHeld(begin - 1), after = !isLast && isHeld(end);
    if (before && after)
      return interior.bridgeMm(pieces_[begin]);
    return (isFirst && after) || (before && isLast)
               ? sectionOf(pieces_[begin], widestOf(pieces_[begin])).widthMm
               : 0.0;
  }

private:
  bool isHeld(std::size_t p) const { return held_[p] == Held::Below || held_[p] == Held::Beside; }
  // Returns whether piece p continues the bead of the piece before it.
  bool continues(std::size_t p) const {
    return p > 0 && p < pieces_.size() && pieces_[p].run == pieces_[p - 1].run;
  }

  const std::vector<BeadPiece>& pieces_;
  const std::vector<Held>& held_;
};
} // namespace

void acceptInteriorSpans(const std::vector<BeadPiece>& pieces, const PrintedPart& printed,
                         const Interior& interior, std::vector<PieceSupport>& support,
                         const base::RunContext& ctx) {
  std::vector<Held> held(pieces.size());
  const Judge judge(pieces, printed, interior, support);
  base::parallelChunks(ctx, pieces.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      held[p] = judge.of(p);
  });
  constexpr PieceSupport kHeld{true, 1.0};
  const Spans spans(pieces, held);
  for (std::size_t p = 0; p < pieces.size();) {
    if (held[p] == Held::Beside)
      support[p] = kHeld;
    if (held[p] != Held::InteriorGap) {
      ++p;
      continue;
    }
    const std::size_t end = spans.endOf(p);
    if (spans.lengthMm(p, end) <= spans.allowedMm(p, end, interior))
      std::fill(support.begin() + static_cast<std::ptrdiff_t>(p),
                support.begin() + static_cast<std::ptrdiff_t>(end), kHeld);
    p = end;
  }
}

} // namespace voluta::replay
