#include "replay/alignment.h"

#include "base/run_context.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;

struct Sequence {
  std::vector<Vector3d> tip, direction;
  operator PoseSequence() const { return {tip, direction}; }
  void add(const Vector3d& p) {
    tip.push_back(p);
    direction.push_back(Vector3d::UnitZ());
  }
  void erase(std::size_t at, std::size_t count) {
    const auto a = static_cast<std::ptrdiff_t>(at), n = static_cast<std::ptrdiff_t>(count);
    tip.erase(tip.begin() + a, tip.begin() + a + n);
    direction.erase(direction.begin() + a, direction.begin() + a + n);
  }
};

// Rows of a zigzag: long collinear stretches, where a missing waypoint changes no geometry.
Sequence zigzag(int rows, int columns, double step = 1.0) {
  Sequence s;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      s.add({step * (r % 2 ? columns - 1 - c : c), 1.1 * r, 0.0});
  return s;
}

Alignment align(const Sequence& program, const Sequence& plan) {
  return alignToPlan(program, plan, AlignmentOptions{}, base::RunContext());
}

TEST(Alignment, TheSameIsTheSame) {
  const Sequence plan = zigzag(10, 40);
  const Alignment a = align(plan, plan);
  EXPECT_TRUE(a.deviations.empty());
  for (std::size_t i = 0; i < a.pointOf.size(); ++i)
    EXPECT_EQ(a.pointOf[i], i);
}

TEST(Alignment, FindsAMovedWaypoint) {
  const Sequence plan = zigzag(10, 40);
  for (const std::size_t at : {0u, 57u, 200u, 398u, 399u}) {
    Sequence program = plan;
    program.tip[at].x() += 2.0;
    const Alignment a = align(program, plan);
    ASSERT_EQ(a.deviations.size(), 1u) << at;
    EXPECT_EQ(a.deviations[0].kind, DeviationKind::Moved);
    EXPECT_EQ(a.deviations[0].motion, at);
    EXPECT_NEAR(a.deviations[0].distanceMm, 2.0, 1e-9);
  }
}

TEST(Alignment, PointsOnTheWayAreUnmatchedAndNoDeviations) {
  const Sequence plan = zigzag(10, 40);
  Sequence program = plan;
  const Vector3d off(0.0, 0.0, 30.0); // on the way to points 57 and 200
  for (const std::size_t at : {200u, 57u, 57u}) {
    program.tip.insert(program.tip.begin() + at, plan.tip[at] + off);
    program.direction.insert(program.direction.begin() + at, Vector3d::UnitZ());
  }
  const auto isVia = [&](std::size_t motion, std::size_t point) {
    return (point == 57 || point == 200) && program.tip[motion].z() > 20.0;
  };
  const Alignment a = alignToPlan(program, plan, AlignmentOptions{}, base::RunContext(), isVia);
  EXPECT_TRUE(a.deviations.empty());
  EXPECT_EQ(a.pointOf[57], kUnmatched);
  EXPECT_EQ(a.pointOf[58], kUnmatched);
  EXPECT_EQ(a.pointOf[59], 57u);
  EXPECT_EQ(a.pointOf[202], kUnmatched);
  EXPECT_EQ(a.pointOf[203], 200u);
  EXPECT_EQ(a.pointOf.back(), plan.tip.size() - 1);
  const Alignment without = align(program, plan);
  EXPECT_EQ(without.deviations.size(), 2u);
}

TEST(Alignment, FindsTenDeletedOnAStraightLine) {
  const Sequence plan = zigzag(10, 40);
  for (const std::size_t at : {0u, 5u, 121u, 215u, 350u}) {
    Sequence program = plan;
    program.erase(at, 10);
    const Alignment a = align(program, plan);
    ASSERT_EQ(a.deviations.size(), 1u) << at;
    EXPECT_EQ(a.deviations[0].kind, DeviationKind::Missing);
    EXPECT_EQ(a.deviations[0].motion, at);
    EXPECT_EQ(a.deviations[0].point, at);
    EXPECT_EQ(a.deviations[0].count, 10u);
  }
}

TEST(Alignment, FindsSwappedNeighboursAndFarOnes) {
  const Sequence plan = zigzag(10, 40);
  for (const std::size_t apart : {1u, 2u, 7u, 60u}) {
    Sequence program = plan;
    std::swap(program.tip[100], program.tip[100 + apart]);
    const Alignment a = align(program, plan);
    ASSERT_FALSE(a.deviations.empty());
    EXPECT_EQ(a.deviations[0].motion, 100u);
    if (apart < 3) {
      ASSERT_EQ(a.deviations.size(), 1u);
      EXPECT_EQ(a.deviations[0].kind, DeviationKind::Swapped);
      EXPECT_EQ(a.deviations[0].other, 100u + apart);
    } else {
      ASSERT_EQ(a.deviations.size(), 2u);
      EXPECT_EQ(a.deviations[1].motion, 100u + apart);
    }
  }
}

TEST(Alignment, FindsInsertedMotions) {
  const Sequence plan = zigzag(10, 40);
  Sequence program = plan;
  program.tip.insert(program.tip.begin() + 150, Vector3d(3, 3, 30));
  program.direction.insert(program.direction.begin() + 150, Vector3d::UnitZ());
  const Alignment a = align(program, plan);
  ASSERT_EQ(a.deviations.size(), 1u);
  EXPECT_EQ(a.deviations[0].kind, DeviationKind::Extra);
  EXPECT_EQ(a.deviations[0].motion, 150u);
}

TEST(Alignment, FindsWhereAFileIsCutShort) {
  const Sequence plan = zigzag(10, 40);
  for (const std::size_t left : {1u, 40u, 399u}) {
    Sequence program = plan;
    program.erase(left, 400 - left);
    const Alignment a = align(program, plan);
    ASSERT_EQ(a.deviations.size(), 1u);
    EXPECT_EQ(a.deviations[0].kind, DeviationKind::CutShort);
    EXPECT_EQ(a.deviations[0].motion, left - 1);
    EXPECT_EQ(a.deviations[0].count, 400 - left);
  }
}

TEST(Alignment, SeesMissingPointsCloserThanItsTolerance) {
  const Sequence plan = zigzag(4, 200, 0.04);
  Sequence program = plan;
  program.erase(90, 1);
  const Alignment a = align(program, plan);
  ASSERT_EQ(a.deviations.size(), 1u);
  EXPECT_EQ(a.deviations[0].kind, DeviationKind::Missing);
  EXPECT_EQ(a.deviations[0].motion, 90u);
}

TEST(Alignment, ALargeGapAndAnotherProgramEnd) {
  const Sequence plan = zigzag(50, 40);
  Sequence program = plan;
  program.erase(500, 300);
  Alignment a = align(program, plan);
  ASSERT_EQ(a.deviations.size(), 1u);
  EXPECT_EQ(a.deviations[0].count, 300u);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(0, 100);
  Sequence other;
  for (int i = 0; i < 3000; ++i)
    other.add({u(random), u(random), u(random)});
  a = align(other, plan);
  EXPECT_TRUE(a.gaveUp);
}

// Rounding to four decimals and one random edit: the edit is named, nothing else is.
TEST(Alignment, OneRandomEditIsOneDeviation) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int round = 0; round < 200; ++round) {
    Sequence plan;
    Vector3d p = Vector3d::Zero();
    for (int i = 0; i < 300; ++i) {
      p += Vector3d(1.0 + u(random) * 0.3, u(random), 0.2 * u(random));
      plan.add(p);
    }
    Sequence program = plan;
    for (Vector3d& q : program.tip)
      q = (q * 1e4).array().round().matrix() * 1e-4;
    const auto at = static_cast<std::size_t>(random() % 280) + 5;
    switch (round % 3) {
    case 0:
      program.tip[at] += Vector3d(0, 0, 0.4);
      break;
    case 1:
      program.erase(at, 3);
      break;
    default:
      std::swap(program.tip[at], program.tip[at + 1]);
    }
    const Alignment a = align(program, plan);
    ASSERT_EQ(a.deviations.size(), 1u) << round;
    EXPECT_EQ(a.deviations[0].motion, at);
  }
}

// Pieces on the way to point 57 come nearer and nearer, closer together than the tolerance.
TEST(Alignment, PiecesCloserThanItsToleranceLeadToTheirPoint) {
  const Sequence plan = zigzag(4, 40);
  const std::size_t at = 57;
  for (const std::vector<double>& pieces :
       {std::vector<double>{0.3, 0.2, 0.1}, {0.045, 0.03, 0.015}, {0.009, 0.006, 0.004}, {0.04}}) {
    SCOPED_TRACE(pieces.front());
    Sequence program = plan;
    for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
      program.tip.insert(program.tip.begin() + at, plan.tip[at] + Vector3d(0, 0, *piece));
      program.direction.insert(program.direction.begin() + at, Vector3d::UnitZ());
    }
    const auto isVia = [&](std::size_t, std::size_t point) { return point == at; };
    const Alignment a = alignToPlan(program, plan, AlignmentOptions{}, base::RunContext(), isVia);
    EXPECT_TRUE(a.deviations.empty());
    for (std::size_t i = 0; i < program.tip.size(); ++i)
      if (i < at || i >= at + pieces.size()) {
        EXPECT_EQ(a.pointOf[i], i < at ? i : i - pieces.size());
        EXPECT_EQ(a.leadsTo[i], kUnmatched);
      } else {
        EXPECT_EQ(a.pointOf[i], kUnmatched);
        EXPECT_EQ(a.leadsTo[i], at);
      }
  }
}

// A motion at its point, to the text's digits, is the target, whatever comes after; so is the last
// one.
TEST(Alignment, ATargetAtItsPointIsNoPieceOfTheWay) {
  const Sequence plan = zigzag(2, 20);
  const auto onTheWay = [](std::size_t, std::size_t) { return true; };
  const auto aligned = [&](const Sequence& program) {
    return alignToPlan(program, plan, AlignmentOptions{}, base::RunContext(), onTheWay);
  };
  Sequence program = plan;
  for (Vector3d& p : program.tip)
    p.z() += 0.0015;
  Alignment a = aligned(program);
  EXPECT_TRUE(a.deviations.empty());
  for (std::size_t i = 0; i < a.pointOf.size(); ++i)
    EXPECT_EQ(a.pointOf[i], i);
  program = plan;
  program.tip.back().z() += 0.03;
  a = aligned(program);
  EXPECT_TRUE(a.deviations.empty());
  EXPECT_EQ(a.pointOf.back(), plan.tip.size() - 1);
}

TEST(Alignment, FindsMotionsMovedOrTiltedFromTheirPoint) {
  const Sequence plan = zigzag(4, 40);
  for (const auto& [mm, rad] : {std::pair(0.04, 0.009), {0.06, 0.0}, {0.0, 0.011}, {0.7, 0.2}}) {
    Sequence program = plan;
    program.tip[70].z() -= mm;
    program.direction[70] = {std::sin(rad), 0.0, std::cos(rad)};
    const Alignment a = align(program, plan);
    const bool same = mm < 0.05 && rad < 0.01;
    ASSERT_EQ(a.deviations.size(), same ? 0u : 1u) << mm;
    EXPECT_EQ(a.pointOf[70], 70u);
    if (same)
      continue;
    EXPECT_EQ(a.deviations[0].kind, DeviationKind::Moved);
    EXPECT_EQ(a.deviations[0].point, 70u);
    EXPECT_EQ(a.deviations[0].count, 1u);
    EXPECT_NEAR(a.deviations[0].distanceMm, mm, 1e-12);
    EXPECT_NEAR(a.deviations[0].angleRad, rad, 1e-9);
  }
}

// Motions before the first point and after the last one.
TEST(Alignment, FindsMotionsBeforeAndAfterThePlan) {
  const Sequence plan = zigzag(4, 40);
  Sequence program;
  for (int i = 0; i < 3; ++i)
    program.add({-50.0 - i, 0, 20});
  for (const Vector3d& p : plan.tip)
    program.add(p);
  for (int i = 0; i < 5; ++i)
    program.add({90.0 + i, 0, 20});
  const Alignment a = align(program, plan);
  ASSERT_EQ(a.deviations.size(), 2u);
  EXPECT_EQ(a.deviations[0].kind, DeviationKind::Extra);
  EXPECT_EQ(a.deviations[0].motion, 0u);
  EXPECT_EQ(a.deviations[0].count, 3u);
  EXPECT_EQ(a.deviations[1].kind, DeviationKind::Extra);
  EXPECT_EQ(a.deviations[1].motion, 163u);
  EXPECT_EQ(a.deviations[1].count, 5u);
  for (std::size_t i = 0; i < program.tip.size(); ++i)
    EXPECT_EQ(a.pointOf[i], i < 3 || i >= 163 ? kUnmatched : i - 3);
}

// More motions than points between two places that agree, and the other way round.
TEST(Alignment, PairsMotionsWithPointsAndCountsTheRest) {
  const Sequence plan = zigzag(4, 40);
  for (const bool more : {true, false}) {
    SCOPED_TRACE(more);
    Sequence program;
    for (std::size_t i = 0; i < plan.tip.size(); ++i) {
      const bool replaced = i >= 60 && i < (more ? 62u : 65u);
      if (!replaced)
        program.add(plan.tip[i]);
      if (i == 60)
        for (int k = 0; k < (more ? 5 : 2); ++k)
          program.add({5.0 * k, 0.0, 9.0});
    }
    for (const std::size_t k : {0u, 1u}) {
      const double lean = 0.1 * static_cast<double>(k + 1);
      program.direction[60 + k] = {std::sin(lean), 0.0, std::cos(lean)};
    }
    const Alignment a = align(program, plan);
    ASSERT_EQ(a.deviations.size(), 3u);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(a.deviations[k].kind, DeviationKind::Moved);
      EXPECT_EQ(a.deviations[k].motion, 60 + k);
      EXPECT_EQ(a.deviations[k].point, 60 + k);
      EXPECT_NEAR(a.deviations[k].distanceMm, (program.tip[60 + k] - plan.tip[60 + k]).norm(),
                  1e-12);
      EXPECT_NEAR(a.deviations[k].angleRad, 0.1 * static_cast<double>(k + 1), 1e-9);
    }
    EXPECT_EQ(a.deviations[2].kind, more ? DeviationKind::Extra : DeviationKind::Missing);
    EXPECT_EQ(a.deviations[2].motion, 62u);
    EXPECT_EQ(a.deviations[2].point, 62u);
    EXPECT_EQ(a.deviations[2].count, 3u);
    EXPECT_FALSE(a.gaveUp);
    EXPECT_EQ(a.pointOf.back(), plan.tip.size() - 1);
  }
}

TEST(Alignment, StopsAfterSoManyDeviations) {
  const Sequence plan = zigzag(10, 40);
  Sequence program = plan;
  for (std::size_t i = 5; i < 400; i += 10)
    program.tip[i].z() += 1.0;
  AlignmentOptions options;
  EXPECT_EQ(alignToPlan(program, plan, options, {}).deviations.size(), 40u);
  options.maxDeviations = 12;
  const Alignment a = alignToPlan(program, plan, options, {});
  EXPECT_TRUE(a.gaveUp);
  EXPECT_EQ(a.deviations.size(), 12u);
  EXPECT_EQ(a.pointOf[116], 116u);
  EXPECT_EQ(a.pointOf[126], kUnmatched);
}

} // namespace
} // namespace voluta::replay
