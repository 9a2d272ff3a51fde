// A skin over lines of sparse infill: what turns in the air at its free edge is no bridge. Judged
// by distances along the bead, without cells.
#include "base/run_context.h"
#include "geometry/mesh_query.h"
#include "helpers/shapes.h"
#include "process/bead_model.h"
#include "replay/beads.h"
#include "replay/bridged_spans.h"
#include "replay/depositor.h"
#include "replay/printed_part.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;

constexpr double kWidth = 1.2, kHeight = 0.8;

void add(std::vector<BeadPiece>& pieces, const std::vector<Vector3d>& points) {
  constexpr double kPieceMm = 0.25;
  const std::uint32_t run = pieces.empty() ? 1 : pieces.back().run + 1;
  double runMm = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) {
    const Vector3d step = points[k] - points[k - 1];
    const int cuts = std::max(1, static_cast<int>(std::ceil(step.norm() / kPieceMm - 1e-9)));
    for (int c = 0; c < cuts; ++c) {
      BeadPiece p;
      p.from = points[k - 1] + step * c / cuts;
      p.to = points[k - 1] + step * (c + 1) / cuts;
      p.fromDirection = p.toDirection = Vector3d::UnitZ();
      p.fromHeightMm = p.toHeightMm = static_cast<float>(kHeight);
      p.volumeMm3 = static_cast<float>(process::beadArea(kWidth, kHeight) * step.norm() / cuts);
      p.runMm = static_cast<float>(runMm += step.norm() / cuts);
      p.run = run;
      p.motion = static_cast<std::uint32_t>(pieces.size());
      pieces.push_back(p);
    }
  }
}

// Lines along y, `apartMm` from each other, and on top of them a zigzag along x that turns at
// x = 0 and at the skin's edge.
struct Skin {
  double apartMm = 5.0, edgeMm = 12.5;
  int lines = 8;

  std::vector<Vector3d> zigzag() const {
    std::vector<Vector3d> points;
    const double hatch = process::hatchOf(kWidth, kHeight);
    for (int line = 0; line < lines; ++line) {
      const double y = 8.0 + hatch * line;
      const bool isForth = line % 2 == 0;
      points.emplace_back(isForth ? 0.0 : edgeMm, y, 3.0 * kHeight);
      points.emplace_back(isForth ? edgeMm : 0.0, y, 3.0 * kHeight);
    }
    return points;
  }

  bool isHeld(double x) const {
    const double off = std::abs(std::remainder(x, apartMm));
    return off <= 0.5 * kWidth;
  }

  // The length of the zigzag that is in the air between two places on lines and turns there.
  double turningMm() const {
    constexpr double kStep = 0.01;
    const std::vector<Vector3d> points = zigzag();
    double sum = 0.0, air = 0.0;
    bool turns = false;
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Vector3d step = points[k] - points[k - 1];
      const int count = static_cast<int>(step.norm() / kStep);
      for (int c = 0; c < count; ++c) {
        const double x = points[k - 1].x() + step.x() * (c + 0.5) / count;
        if (isHeld(x)) {
          sum += turns ? air : 0.0;
          air = 0.0;
          turns = false;
          continue;
        }
        air += step.norm() / count;
        turns = turns || std::abs(step.y()) > 0.1;
      }
    }
    return sum;
  }

  double unsupportedMm(double bridgeMm) const {
    std::vector<BeadPiece> pieces;
    for (const double z : {kHeight, 2.0 * kHeight})
      for (double x = 0.0; x < edgeMm + apartMm; x += apartMm)
        add(pieces, {{x, 2, z}, {x, 28, z}});
    add(pieces, zigzag());
    const BeadGrid beads = depositBeads(gridOver({-3, -3, -1}, {33, 33, 6}, 0.3, 50'000'000),
                                        pieces, DepositOptions{}, base::RunContext());
    const PrintedPart printed(beads, pieces);
    const platform::PlatformSolid plate{{-2, -2}, {32, -2}, {32, 32}, {-2, 32}};
    const geometry::TriangleMesh part = test::box({-2, 0, 0}, {32, 30, 6});
    const Bridging bridging{[&](const BeadPiece&) { return bridgeMm; }, geometry::MeshQuery(part)};
    return findSupport(pieces, printed, GroundProbe(plate), base::RunContext(), &bridging)
        .unsupportedMm;
  }
};

TEST(SkinEdge, TurnsInTheAirAreNoBridges) {
  std::mt19937_64 random(3);
  const auto within = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (int n = 0; n < 12; ++n) {
    Skin skin;
    skin.apartMm = within(4.5, 6.0);
    skin.edgeMm = (2.0 + within(0.4, 0.6)) * skin.apartMm;
    SCOPED_TRACE(testing::Message() << skin.apartMm << " " << skin.edgeMm);
    const double turning = skin.turningMm();
    ASSERT_GT(turning, 10.0);
    const double unsupported = skin.unsupportedMm(20.0);
    EXPECT_LE(unsupported, 1.05 * turning);
    // A line carries the bead a little beyond its own edges.
    EXPECT_GE(unsupported, turning - 1.2 * kWidth * 0.5 * skin.lines);
  }
}

TEST(SkinEdge, IsHeldByTheNextLine) {
  Skin skin;
  skin.edgeMm = 3.0 * skin.apartMm;
  EXPECT_EQ(skin.turningMm(), 0.0);
  EXPECT_EQ(skin.unsupportedMm(20.0), 0.0);
  EXPECT_GT(skin.unsupportedMm(2.0), 20.0) << "spans longer than the material bridges";
}

} // namespace
} // namespace voluta::replay
