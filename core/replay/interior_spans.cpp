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
constexpr double kWidestMm = 10.0;

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
    const double width = sectionOf(piece, kWidestMm).widthMm;
    const PrintState moment{static_cast<std::uint32_t>(p), piece.run, piece.runMm,
                            static_cast<float>(2.0 * width)};
    const std::array<double, 2> sides{-kBeside * width, kBeside * width};
    const bool isBeside = std::ranges::any_of(sides, [&](double aside) {
      const std::uint32_t neighbour =
          printed_.pieceAt(tip - 0.5 * height * up + aside * side, moment);
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
  for (std::size_t p = 0; p < pieces.size();) {
    if (held[p] != Held::InteriorGap) {
      if (held[p] == Held::Beside)
        support[p] = kHeld;
      ++p;
      continue;
    }
    const auto isSameBead = [&](std::size_t q) {
      return q < pieces.size() && pieces[q].run == pieces[p].run;
    };
    double lengthMm = 0.0;
    std::size_t end = p;
    for (; isSameBead(end) && held[end] == Held::InteriorGap; ++end)
      lengthMm += (pieces[end].to - pieces[end].from).norm();
    const auto holds = [&](std::size_t q) {
      return isSameBead(q) && (held[q] == Held::Below || held[q] == Held::Beside);
    };
    if (p > 0 && holds(p - 1) && holds(end) && lengthMm <= interior.bridgeMm(pieces[p]))
      std::fill(support.begin() + static_cast<std::ptrdiff_t>(p),
                support.begin() + static_cast<std::ptrdiff_t>(end), kHeld);
    p = end;
  }
}

} // namespace voluta::replay
