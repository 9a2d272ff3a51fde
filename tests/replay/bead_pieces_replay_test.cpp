// From an executed program to pieces of bead, and the printed part by place: each by an independent
// count.
#include "base/run_context.h"
#include "replay/alignment.h"
#include "replay/beads.h"
#include "replay/printed_part.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;

// Two beads with a travel between; the first turns a rounded corner and ends with a push on the
// spot.
plan::ReadProgram twoBeads() {
  plan::ReadProgram program;
  const auto add = [&](const Vector3d& at, double volume, double blend = 0.0) {
    plan::ProgramMotion m;
    m.target = plan::TargetKind::ToolPoint;
    m.position = at;
    m.speedMmPerS = 20.0;
    m.extruding = volume > 0.0;
    m.volumeMm3 = volume;
    m.blendMm = blend;
    program.motions.push_back(m);
  };
  add({0, 0, 1}, -1);
  add({7.3, 0, 1}, 6.0, 1.5);
  add({7.3, 5, 1}, 4.5);
  add({7.3, 5, 1}, 0.5);
  add({0, 9, 1}, -1);
  add({3, 9, 1.5}, 2.0);
  add({3.4, 9, 1.5}, 0.3);
  return program;
}

TEST(BeadPieces, ShareTheirMotionsMaterialByLength) {
  const plan::ReadProgram program = twoBeads();
  const ExecutedPath path = executeToolPoints(program, {});
  std::vector<double> volume;
  for (std::size_t m = 0; m < program.motions.size(); ++m)
    volume.push_back(motionVolume(program, path, m));
  EXPECT_EQ(volume, (std::vector<double>{0.0, 6.0, 4.5, 0.5, 0.0, 2.0, 0.3}));
  std::vector<BeadKnowledge> knowledge(7);
  for (std::size_t m = 0; m < 7; ++m)
    knowledge[m] = {0.5f + 0.1f * static_cast<float>(m), 0.6f + 0.1f * static_cast<float>(m), m < 4,
                    m >= 4};
  const std::vector<BeadPiece> pieces = beadPieces(volume, path, knowledge);
  std::vector<double> deposited(7, 0.0), length(7, 0.0), whole(7, 0.0);
  for (std::size_t m = 1; m < 7; ++m)
    for (std::size_t s = path.firstSample[m]; s < path.firstSample[m + 1]; ++s)
      whole[m] += (path.tip[s] - path.tip[s - 1]).norm();
  double run = 0.0;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const BeadPiece& piece = pieces[p];
    const std::size_t m = piece.motion;
    const double step = (piece.to - piece.from).norm();
    const bool begins = p == 0 || pieces[p - 1].run != piece.run;
    EXPECT_EQ(piece.run, m < 4 ? 1u : 2u);
    EXPECT_EQ(piece.ofPart, m < 4);
    EXPECT_EQ(piece.waste, m >= 4);
    if (!begins) {
      EXPECT_EQ(piece.from, pieces[p - 1].to);
    }
    EXPECT_LE(step, 1.05 + 1e-9);
    // Heights go evenly with the way.
    const auto height = [&](double distance) {
      return 0.5 + 0.1 * static_cast<double>(m) +
             (whole[m] > 0.0 ? 0.1 * distance / whole[m] : 0.1);
    };
    EXPECT_NEAR(piece.fromHeightMm, height(length[m]), 2e-3);
    deposited[m] += static_cast<double>(piece.volumeMm3);
    run = (begins ? 0.0 : run) + step;
    length[m] += step;
    EXPECT_NEAR(piece.toHeightMm, height(length[m]), 2e-3);
    EXPECT_NEAR(static_cast<double>(piece.runMm), run, 0.02) << "chords of the corner";
    if (step > 0.0) {
      EXPECT_NEAR(static_cast<double>(piece.volumeMm3) / step, volume[m] / whole[m], 0.02);
    } else {
      EXPECT_EQ(m, 3u) << "on the spot";
    }
    // Samples between its ends are beside its chord.
    for (std::size_t s = path.firstSample[m]; s < path.firstSample[m + 1]; ++s) {
      const Vector3d r = path.tip[s] - piece.from;
      const double t = step > 0.0 ? r.dot(piece.to - piece.from) / (step * step) : -1.0;
      if (t > 0.0 && t < 1.0 && m != 3) {
        EXPECT_LE((r - t * (piece.to - piece.from)).norm(), 0.03 + 1e-9);
      }
    }
  }
  for (std::size_t m = 0; m < 7; ++m) {
    EXPECT_NEAR(deposited[m], volume[m], 1e-5);
    EXPECT_NEAR(length[m], volume[m] > 0.0 ? whole[m] : 0.0, 0.01);
  }
  const std::vector<std::uint32_t> first = firstPieceOfMotions(depositedPieces(pieces, 6.0), 7);
  ASSERT_EQ(first.size(), 8u);
  for (std::size_t m = 0; m <= 7; ++m) {
    std::size_t wanted = 0;
    while (wanted < pieces.size() && pieces[wanted].motion < m)
      ++wanted;
    EXPECT_EQ(first[m], wanted);
  }
}

TEST(BeadPieces, MaterialIsAnAmountOrARateByTime) {
  plan::ProgramMotion m;
  m.flowMm3PerS = 4.0;
  EXPECT_EQ(motionVolume(m, 2.5), 0.0) << "not extruding";
  m.extruding = true;
  EXPECT_EQ(motionVolume(m, 2.5), 10.0);
  m.volumeMm3 = 0.0;
  EXPECT_EQ(motionVolume(m, 2.5), 0.0);
  m.volumeMm3 = 3.0;
  EXPECT_EQ(motionVolume(m, 2.5), 3.0);
}

// A skirt, a wall of the part and a support, each with a divided step and come to from above, of
// which nothing is known: heights 0.3, 0.4, ... a waypoint.
TEST(BeadKnowledge, IsThatOfTheNextWaypointOnTheBead) {
  plan::ToolPlan plan;
  const plan::PathKind kinds[] = {plan::PathKind::Skirt, plan::PathKind::Wall,
                                  plan::PathKind::Support};
  plan::Trajectory t;
  const auto point = [&](plan::MoveKind move, std::size_t waypoint) {
    t.timeS.push_back(0.0);
    t.move.push_back(move);
    t.waypoint.push_back(waypoint);
  };
  for (std::size_t path = 0; path < 3; ++path) {
    plan.paths.push_back({2 * path, 2, kinds[path]});
    for (std::size_t w = 2 * path; w < 2 * path + 2; ++w) {
      plan.position.emplace_back(static_cast<double>(w), 0, 0);
      plan.heightMm.push_back(0.3f + 0.1f * static_cast<float>(w));
    }
    point(plan::MoveKind::Linear, plan::kNoWaypoint); // 4 path
    point(plan::MoveKind::Linear, 2 * path);
    point(plan::MoveKind::Print, plan::kNoWaypoint); // divided
    point(plan::MoveKind::Print, 2 * path + 1);
  }
  const std::size_t none = kUnmatched;
  //                                    none, approach, w0, divided, w1, a motion without a point
  const std::vector<std::size_t> pointOf{none, 0, 1, 2, 3, none, 4, 5, 6, 7, 9, 11};
  const auto knowledge = beadKnowledge(pointOf, t, plan, 0.77);
  const double to[] = {0.77, 0.77, 0.3, 0.4, 0.4, 0.4, 0.4, 0.5, 0.6, 0.6, 0.7, 0.8};
  ASSERT_EQ(knowledge.size(), 12u);
  for (std::size_t m = 0; m < 12; ++m) {
    EXPECT_NEAR(knowledge[m].toHeightMm, to[m], 1e-6) << m;
    EXPECT_NEAR(knowledge[m].fromHeightMm, m == 0 ? 0.77 : to[m - 1], 1e-6) << m;
    EXPECT_EQ(knowledge[m].waste, m >= 2 && m < 7) << m;
    EXPECT_EQ(knowledge[m].ofPart, m < 2 || (m >= 7 && m < 10)) << m;
  }
}

// Balls of any size, at any moment: found where a cell's centre is in one, and never else.
TEST(PrintedPart, FindsCellsInABallPrintedByThen) {
  std::mt19937 random(61);
  std::uniform_real_distribution<double> u(0, 1);
  BeadGrid beads;
  beads.grid.origin = {-3, 2, 0};
  beads.grid.pitch = 0.5;
  beads.grid.size = {23, 17, 9};
  beads.filler = base::ZeroedArray<std::uint32_t>(beads.grid.cellCount());
  std::vector<BeadPiece> pieces(40);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    pieces[p].run = static_cast<std::uint32_t>(p / 10);
    pieces[p].runMm = static_cast<float>(p % 10);
  }
  for (std::size_t c = 0; c < beads.grid.cellCount(); ++c)
    beads.filler[c] = u(random) < 0.03 ? 1 + static_cast<std::uint32_t>(u(random) * 40) : 0;
  const PrintedPart printed(beads, pieces);
  const auto there = [&](std::size_t cell, const PrintState& moment) {
    if (beads.filler[cell] == 0)
      return false;
    const std::uint32_t by = beads.filler[cell] - 1;
    const bool soft =
        pieces[by].run == moment.run && moment.runMm - pieces[by].runMm <= moment.recentMm;
    return by < moment.before && !soft;
  };
  int found = 0, none = 0;
  for (int round = 0; round < 600; ++round) {
    const PrintState moment{static_cast<std::uint32_t>(u(random) * 41),
                            static_cast<std::uint32_t>(u(random) * 4),
                            static_cast<float>(10 * u(random)), static_cast<float>(4 * u(random))};
    const Vector3d centre(-5 + 16 * u(random), 11 * u(random), -2 + 8 * u(random));
    const double radius = 0.2 + 2.0 * u(random);
    const auto cell =
        printed.firstWithin(centre, radius, moment, [&](const Vector3d& p, double reach) {
          return (p - centre).norm() <= radius + reach;
        });
    bool wanted = false;
    for (int k = 0; k < 9; ++k)
      for (int j = 0; j < 17; ++j)
        for (int i = 0; i < 23; ++i)
          wanted = wanted || ((beads.grid.centre(i, j, k) - centre).norm() <= radius &&
                              there(beads.grid.index(i, j, k), moment));
    EXPECT_EQ(cell.has_value(), wanted) << round;
    if (cell) {
      EXPECT_TRUE(there(*cell, moment));
    }
    (wanted ? found : none)++;
    const Eigen::Vector3i at = beads.grid.cellOf(centre);
    const bool inGrid = beads.grid.contains(at.x(), at.y(), at.z());
    EXPECT_EQ(printed.printedAt(centre, moment),
              inGrid && there(beads.grid.index(at.x(), at.y(), at.z()), moment));
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(none, 50);
}

} // namespace
} // namespace voluta::replay
