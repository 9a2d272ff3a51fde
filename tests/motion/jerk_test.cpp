#include "motion/jerk.h"

#include "helpers/five_point_jerk.h"
#include "motion/smoothing/banded_solver.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;

namespace {

std::vector<double> unevenTimes(int seed, std::size_t count) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> step(0.01, 0.09);
  std::vector<double> times{0.0};
  while (times.size() < count)
    times.push_back(times.back() + step(random));
  return times;
}

} // namespace

TEST(Jerk, FivePointsAreExactForQuartics) {
  const auto times = unevenTimes(1, 40);
  for (std::size_t i = 2; i + 2 < times.size(); ++i) {
    const auto w = test::fivePointJerk(times, i);
    const auto of = [&](auto f) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 5; ++k)
        sum += w[k] * f(times[i + k - 2]);
      return sum;
    };
    EXPECT_NEAR(of([](double t) { return 1.0 + t + t * t; }), 0.0, 1e-7);
    EXPECT_NEAR(of([](double t) { return t * t * t; }), 6.0, 1e-6);
    EXPECT_NEAR(of([](double t) { return t * t * t * t; }), 24.0 * times[i], 1e-5);
  }
}

TEST(Jerk, FivePointsOnEvenTimesAreTheCentralDifference) {
  const double h = 0.1;
  const auto w = test::fivePointJerk({0, h, 2 * h, 3 * h, 4 * h}, 2);
  const double unit = 1.0 / (2.0 * h * h * h); // eq. 4.11
  const double expected[] = {-1, 2, 0, -2, 1};
  for (std::size_t k = 0; k < 5; ++k)
    EXPECT_NEAR(w[k], expected[k] * unit, 1e-9 * unit);
}

// From 1 to 3 within a second, at rest before and behind: velocity 2 about 0.5 s, so accelerations
// of 4 and -4 about 0.25 and 0.75 s, jerks of 16 and -16.
TEST(Jerk, OfOneStepFromRestToRest) {
  const robot::JointVector from = robot::JointVector::Constant(1, 1.0),
                           to = robot::JointVector::Constant(1, 3.0);
  const motion::JerkMeasure jerk = motion::jerkOf({from, to}, {0.0, 1.0});
  ASSERT_EQ(jerk.maxAbs.size(), 1u);
  EXPECT_NEAR(jerk.maxAbs.front(), 16.0, 1e-12);
  EXPECT_NEAR(jerk.sumSquared, 2 * 256.0, 1e-9);
}

// Five points at even times do not show an alternating motion; four do.
TEST(Jerk, ToAndFroIsSeen) {
  std::vector<double> times;
  for (int i = 0; i < 9; ++i)
    times.push_back(0.1 * i);
  const auto five = test::fivePointJerk(times, 4);
  EXPECT_NEAR(five[0] - five[1] + five[2] - five[3] + five[4], 0.0, 1e-6);
  const motion::JerkStencil four = motion::jerkStencils(times)[4];
  EXPECT_NEAR(std::abs(four.weight[0] - four.weight[1] + four.weight[2] - four.weight[3]), 8000.0,
              1e-6);
}

TEST(Jerk, StencilsSeeNoParabolaAndAllOfACubic) {
  for (int seed = 1; seed <= 5; ++seed) {
    const auto times = unevenTimes(seed, 30);
    const auto even = [&](std::size_t i) { return 0.05 * static_cast<double>(i); };
    std::vector<double> steps;
    for (std::size_t i = 0; i < 30; ++i)
      steps.push_back(even(i));
    for (const motion::JerkStencil& s : motion::jerkStencils(times))
      if (s.last >= 3 && s.last < times.size()) {
        double one = 0.0, line = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
          one += s.weight[k];
          line += s.weight[k] * times[s.last + k - 3];
        }
        EXPECT_NEAR(one, 0.0, 1e-6);
        EXPECT_NEAR(line, 0.0, 1e-6);
      }
    for (const motion::JerkStencil& s : motion::jerkStencils(steps))
      if (s.last >= 3 && s.last < steps.size()) {
        double cubic = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
          cubic += s.weight[k] * std::pow(steps[s.last + k - 3], 3);
        EXPECT_NEAR(cubic, 6.0, 1e-6);
      }
  }
}

namespace {

template <std::size_t kWidth> void solvesRandomEquations() {
  constexpr int kBeside = static_cast<int>(kWidth) - 1;
  std::mt19937 random(9);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int n = 1; n < 40; n += 3) {
    Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i)
      for (int m = 0; m <= kBeside && i >= m; ++m)
        factor(i, i - m) = m == 0 ? 1.5 + value(random) : value(random) / (kBeside - 2);
    const Eigen::MatrixXd a = factor * factor.transpose();
    motion::BandedRows<kWidth> rows(static_cast<std::size_t>(n));
    std::vector<double> b, x;
    for (int i = 0; i < n; ++i) {
      for (int m = 0; m <= kBeside; ++m)
        rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(m)] =
            i + m < n ? a(i, i + m) : 0;
      b.push_back(value(random));
    }
    ASSERT_TRUE(motion::solveBanded(rows, b, x));
    const Eigen::VectorXd rest = a * Eigen::Map<const Eigen::VectorXd>(x.data(), n) -
                                 Eigen::Map<const Eigen::VectorXd>(b.data(), n);
    EXPECT_LT(rest.norm(), 1e-7 * (1.0 + Eigen::Map<const Eigen::VectorXd>(x.data(), n).norm()));
  }
}

} // namespace

TEST(BandedSolver, SolvesItsEquations) {
  solvesRandomEquations<4>();
  solvesRandomEquations<12>();
  std::vector<double> x;
  EXPECT_FALSE(motion::solveBanded<4>({{1.0, 2.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}}, {1.0, 1.0}, x));
}
