// The head's flat underside over a straight bead, by closed forms.
#include "replay/underside.h"

#include "process/bead_model.h"

#include <cmath>
#include <gtest/gtest.h>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;

constexpr double kWidth = 1.2, kHeight = 0.8, kFlat = 0.5 * (kWidth - kHeight);

// Along x, 20 mm, in pieces of one.
std::vector<BeadPiece> beadAlongX(double height = kHeight) {
  std::vector<BeadPiece> pieces(20);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    BeadPiece& piece = pieces[p];
    piece.from = Vector3d(static_cast<double>(p), 0.0, kHeight);
    piece.to = piece.from + Vector3d::UnitX();
    piece.fromDirection = piece.toDirection = Vector3d::UnitZ();
    piece.fromHeightMm = piece.toHeightMm = static_cast<float>(kHeight);
    piece.volumeMm3 = static_cast<float>(process::beadArea(kWidth, height));
    piece.run = 1;
    piece.runMm = static_cast<float>(p + 1);
  }
  return pieces;
}

// Leans about the bead's direction: the rim on the side of the bead is the lowest.
FlatDisc leaning(double angle, double y, double z, double radius) {
  return {{9.5, y, z}, {0.0, std::sin(angle), std::cos(angle)}, radius};
}

// A disc from the side with its lowest place within the bead's flat top: the rim is nearest, at its
// height over the top; beyond, it is nearest to the rounding.
double closedForm(const FlatDisc& disc, double angle) {
  const double y = disc.centre.y() + disc.radius * std::cos(angle),
               z = disc.centre.z() - disc.radius * std::sin(angle);
  return std::hypot(std::max(0.0, std::abs(y) - kFlat), z - 0.5 * kHeight) - 0.5 * kHeight;
}

TEST(Underside, ComesAsNearToABeadAsItsRim) {
  const RoundedQuad bead = solidOf(beadAlongX()[9], 6.0);
  int tried = 0;
  for (const double angle : {0.0, 0.05, 0.2, 0.5, 1.0})
    for (const double z : {0.85, 0.95, 1.1, 1.5, 2.5})
      for (const double radius : {0.3, 0.5, 2.0}) {
        const FlatDisc disc = leaning(angle, -0.1 - radius * std::cos(angle), z, radius);
        if (z - radius * std::sin(angle) < 0.5 * kHeight)
          continue; // the rim is below the bead's middle
        const double wanted = closedForm(disc, angle);
        ++tried;
        if (wanted > 1e-3)
          EXPECT_NEAR(distanceBetween(disc, bead), wanted, 2e-4) << angle << " " << z;
        else
          EXPECT_LT(distanceBetween(disc, bead), 2e-3) << angle << " " << z;
      }
  EXPECT_GT(tried, 50);
}

TEST(Underside, IsFoundAsDeepAsProgramsAreWritten) {
  const process::HeadShape head{{{0.4, 0.5}, {12.4, 5.6}}}; // less the tolerance
  const Underside underside(head, beadAlongX(), 6.0);
  PrintState all;
  all.before = 20;
  for (const double angle : {0.0, 0.1, 0.3})
    for (const double deep : {-0.1, -0.02, 0.03, 0.1}) {
      // The rim over the bead's middle, so deep below its top.
      const Vector3d direction(0.0, std::sin(angle), std::cos(angle));
      const Vector3d centre(9.5, -0.5 * std::cos(angle), kHeight - deep + 0.5 * std::sin(angle));
      const Vector3d tip = centre - 0.4 * direction;
      EXPECT_EQ(underside.touched(tip, direction, all).has_value(), deep > 0.0)
          << angle << " " << deep;
      PrintState none = all;
      none.before = 0;
      EXPECT_FALSE(underside.touched(tip, direction, none));
      PrintState soft = all; // of the same bead, 1.5 mm on
      soft.run = 1;
      soft.runMm = 11.0f;
      soft.recentMm = 2.4f;
      EXPECT_FALSE(underside.touched(tip, direction, soft));
      soft.runMm = 14.0f;
      EXPECT_EQ(underside.touched(tip, direction, soft).has_value(), deep > 0.0);
    }
}

// A step at the tip: the wider of two sections there counts.
TEST(Underside, OfAStepIsTheWiderSection) {
  const std::vector<BeadPiece> bead = beadAlongX();
  const process::HeadShape stepped{{{0.4, 0.5}, {0.4, 3.0}, {12.4, 5.6}}},
      usual{{{0.4, 0.5}, {12.4, 5.6}}};
  PrintState all;
  all.before = 20;
  // Beside the bead, its axis 2 mm from it, and 0.1 mm below its top.
  const Vector3d tip(9.5, 2.0, kHeight - 0.1 - 0.4);
  EXPECT_TRUE(Underside(stepped, bead, 6.0).touched(tip, Vector3d::UnitZ(), all));
  EXPECT_FALSE(Underside(usual, bead, 6.0).touched(tip, Vector3d::UnitZ(), all));
}

// A bead that got less material than planned keeps its bottom.
TEST(Underside, BeadLowerThanPlannedKeepsItsPlannedPlace) {
  std::vector<BeadPiece> pieces = beadAlongX();
  const double diameter = 0.5;
  pieces[9].volumeMm3 = static_cast<float>(0.25 * M_PI * diameter * diameter);
  const RoundedQuad thin = solidOf(pieces[9], 6.0);
  EXPECT_NEAR(thin.radius, 0.5 * diameter, 1e-6);
  EXPECT_NEAR(distanceBetween({{9.5, 0.0, 1.0}, Vector3d::UnitZ(), 0.5}, thin), 1.0 - diameter,
              2e-4);
}

} // namespace
} // namespace voluta::replay
