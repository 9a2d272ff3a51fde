// Frames and tips that are known, measured with noise that is known.
#include "robot/measured/measured_frames.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/directions.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::robot {
namespace {

using base::kPi;
using Eigen::Vector3d;

class Measured {
public:
  explicit Measured(unsigned long seed) : random_(seed) {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3d point(double half) {
    return {number(-half, half), number(-half, half), number(-half, half)};
  }
  Eigen::Isometry3d pose(double half) {
    std::normal_distribution<double> normal;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = point(half);
    pose.linear() =
        Eigen::Quaterniond(normal(random_), normal(random_), normal(random_), normal(random_))
            .normalized()
            .toRotationMatrix();
    return pose;
  }
  Vector3d noisy(const Vector3d& p, double deviationMm) {
    std::normal_distribution<double> noise(0.0, deviationMm);
    return p + Vector3d(noise(random_), noise(random_), noise(random_));
  }
  // Tilted from upright by tiltRad at most, about any axis, and turned about its own.
  Eigen::Matrix3d tilted(double tiltRad) {
    const double side = number(-kPi, kPi);
    return (Eigen::AngleAxisd(side, Vector3d::UnitZ()) *
            Eigen::AngleAxisd(number(0.0, tiltRad), Vector3d::UnitX()) *
            Eigen::AngleAxisd(number(-kPi, kPi), Vector3d::UnitZ()))
        .toRotationMatrix();
  }

private:
  std::mt19937_64 random_;
};

double angleBetweenFrames(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

// A plate's marks: on a rectangle of 200 x 150 mm, evenly round its rim.
std::vector<Vector3d> marks(std::size_t count) {
  std::vector<Vector3d> marks;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = base::kTwoPi * static_cast<double>(i) / static_cast<double>(count);
    const Vector3d out(std::cos(angle), std::sin(angle), 0);
    marks.push_back(out / std::max(std::abs(out.x()) / 100.0, std::abs(out.y()) / 75.0));
  }
  return marks;
}

TEST(MeasuredFrames, threePointsByHand) {
  const Eigen::Isometry3d frame = frameFromPoints({10, 20, 30}, {10, 25, 30}, {3, 21, 30});
  Eigen::Matrix4d expected;
  expected << 0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1;
  EXPECT_LT((frame.matrix() - expected).norm(), 1e-15);
}

TEST(MeasuredFrames, threePointsOfAnyFrameGiveItBack) {
  Measured measured(1);
  for (int n = 0; n < 1000; ++n) {
    const Eigen::Isometry3d frame = measured.pose(800);
    const Vector3d onX(measured.number(5, 400), 0, 0),
        inPlane(measured.number(-300, 300), measured.number(5, 400), 0);
    const Eigen::Isometry3d found =
        frameFromPoints(frame.translation(), frame * onX, frame * inPlane);
    EXPECT_LT((found.matrix() - frame.matrix()).norm(), 1e-9);
  }
}

TEST(MeasuredFrames, pointsWithoutNoiseGiveTheFrameToRounding) {
  Measured measured(2);
  for (std::size_t count = 3; count < 12; ++count) {
    const Eigen::Isometry3d frame = measured.pose(800);
    std::vector<TouchedPoint> points;
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d p = measured.point(120);
      points.push_back({p, frame * p});
    }
    const MeasuredFrame found = frameFromPoints(points);
    EXPECT_LT((found.base_T_frame.matrix() - frame.matrix()).norm(), 1e-9);
    EXPECT_LT(found.residual.worstMm, 1e-9);
  }
}

// Points of a mirror image fit no turn: the residual shows it, and the result is a turn all the
// same.
TEST(MeasuredFrames, aMirrorImageIsNoFrame) {
  std::vector<TouchedPoint> points;
  for (const Vector3d& p : {Vector3d(1, 2, 3), Vector3d(40, 0, 5), Vector3d(0, 50, 9),
                            Vector3d(7, 8, 60), Vector3d(30, 30, -20)})
    points.push_back({p, Vector3d(p.x(), p.y(), -p.z())});
  const MeasuredFrame found = frameFromPoints(points);
  EXPECT_NEAR(found.base_T_frame.linear().determinant(), 1.0, 1e-12);
  EXPECT_GT(found.residual.worstMm, 1.0);
}

// No turn or shift nearby is better: least squares, whatever the points.
TEST(MeasuredFrames, noFrameNearbyFitsBetter) {
  Measured measured(3);
  for (int n = 0; n < 50; ++n) {
    const Eigen::Isometry3d frame = measured.pose(500);
    std::vector<TouchedPoint> points;
    for (int i = 0; i < 6; ++i) {
      const Vector3d p = measured.point(100);
      points.push_back({p, measured.noisy(frame * p, 0.5)});
    }
    const auto squares = [&](const Eigen::Isometry3d& at) {
      double sum = 0.0;
      for (const TouchedPoint& p : points)
        sum += (at * p.inFrame - p.inBase).squaredNorm();
      return sum;
    };
    const MeasuredFrame found = frameFromPoints(points);
    const double minimum = squares(found.base_T_frame);
    EXPECT_NEAR(found.residual.rmsMm, std::sqrt(minimum / 6), 1e-9);
    for (int k = 0; k < 50; ++k) {
      Eigen::Isometry3d other = found.base_T_frame;
      other.translation() += measured.point(0.05);
      other.rotate(
          Eigen::AngleAxisd(measured.number(-1e-3, 1e-3), measured.pose(1).linear().col(0)));
      EXPECT_GE(squares(other), minimum);
    }
  }
}

// 0.1 mm on every coordinate, sixteen marks round the plate: within 0.1 mm and 0.1 degrees.
TEST(MeasuredFrames, noiseOfATenthIsMeasuredAway) {
  int within = 0;
  double noise = 0.0, place = 0.0, rotation = 0.0;
  double squaredPlace = 0.0, squaredRotation = 0.0;
  constexpr int kSeeds = 1000;
  for (int seed = 0; seed < kSeeds; ++seed) {
    Measured measured(static_cast<unsigned long>(seed));
    const Eigen::Isometry3d frame = measured.pose(600);
    std::vector<TouchedPoint> points;
    for (const Vector3d& p : marks(16))
      points.push_back({p, measured.noisy(frame * p, 0.1)});
    const MeasuredFrame found = frameFromPoints(points);
    const double mm = (found.base_T_frame.translation() - frame.translation()).norm(),
                 rad = angleBetweenFrames(found.base_T_frame, frame);
    within += mm <= 0.1 && rad <= base::degreesToRadians(0.1);
    squaredPlace += mm * mm / 3.0 / kSeeds;
    squaredRotation += rad * rad / 3.0 / kSeeds;
    noise += *found.residual.noiseMm / kSeeds;
    place += *found.residual.placeMm / kSeeds;
    rotation += *found.residual.angleRad / kSeeds;
  }
  EXPECT_GE(within, 990);
  // The noise and the accuracy estimated from the residual are right.
  EXPECT_NEAR(noise, 0.1, 0.002);
  EXPECT_NEAR(place / std::sqrt(squaredPlace), 1.0, 0.05);
  EXPECT_GE(rotation, std::sqrt(squaredRotation)); // of the worst direction
  EXPECT_LE(rotation, 2.0 * std::sqrt(squaredRotation));
}

TEST(MeasuredFrames, pointsWithoutAFrameAreRefused) {
  const Vector3d a(1, 2, 3), b(11, 2, 3), c(50, 2, 3), d(1, 40, 3);
  EXPECT_NO_THROW(frameFromPoints(a, b, d));
  EXPECT_THROW(frameFromPoints(a, b, c), base::Error);
  EXPECT_THROW(frameFromPoints(a, c, b), base::Error);
  EXPECT_THROW(frameFromPoints(a, a, d), base::Error);
  EXPECT_THROW(frameFromPoints(a, b, a), base::Error);
  EXPECT_THROW(frameFromPoints(a, b, {1, NAN, 3}), base::Error);
  const auto same = [](const Vector3d& p) { return TouchedPoint{p, p}; };
  EXPECT_NO_THROW(frameFromPoints({same(a), same(b), same(d)}));
  EXPECT_THROW(frameFromPoints({same(a), same(b)}), base::Error);
  EXPECT_THROW(frameFromPoints({same(a), same(b), same(c), same({80, 2, 3})}), base::Error);
  // Drawn in a plane, touched on a line.
  EXPECT_THROW(frameFromPoints({{a, a}, {b, b}, {d, c}}), base::Error);
  try {
    frameFromPoints(a, b, c);
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
    EXPECT_NE(std::string(e.what()).find("on a line"), std::string::npos);
  }
}

std::vector<Eigen::Isometry3d> touching(Measured& measured, const Vector3d& tip,
                                        const Vector3d& point, std::size_t count, double tiltRad,
                                        double deviationMm) {
  std::vector<Eigen::Isometry3d> poses;
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = measured.tilted(tiltRad);
    pose.translation() = measured.noisy(point - pose.linear() * tip, deviationMm);
    poses.push_back(pose);
  }
  return poses;
}

TEST(ToolTip, isFoundFromFourPosesWithoutNoise) {
  Measured measured(4);
  for (int n = 0; n < 200; ++n) {
    const Vector3d tip = measured.point(250), point = measured.point(700);
    const MeasuredTip found = toolTip(touching(measured, tip, point, 4, 1.0, 0.0));
    EXPECT_LT((found.tipInFlange - tip).norm(), 1e-8);
    EXPECT_LT((found.pointInBase - point).norm(), 1e-8);
    EXPECT_LT(found.residual.worstMm, 1e-8);
  }
}

TEST(ToolTip, noiseOfATenthIsMeasuredAway) {
  constexpr int kSeeds = 1000;
  int within = 0;
  double noise = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    Measured measured(static_cast<unsigned long>(seed));
    const Vector3d tip = measured.point(200), point = measured.point(700);
    const MeasuredTip found =
        toolTip(touching(measured, tip, point, 24, base::degreesToRadians(60), 0.1));
    within += (found.tipInFlange - tip).norm() <= 0.1;
    noise += *found.residual.noiseMm / kSeeds;
  }
  EXPECT_GE(within, 950);
  EXPECT_NEAR(noise, 0.1, 0.002);
}

TEST(ToolTip, insufficientPosesAreRefused) {
  Measured measured(5);
  const Vector3d tip(10, 20, 150), point(400, 100, 50);
  auto poses = touching(measured, tip, point, 4, 1.0, 0.0);
  EXPECT_NO_THROW(toolTip(poses));
  EXPECT_THROW(toolTip({poses[0], poses[1], poses[2]}), base::Error);
  EXPECT_THROW(toolTip({poses[0], poses[1], poses[2], poses[0]}), base::Error);
  // Upright all of them: the tip's height is open.
  EXPECT_THROW(toolTip(touching(measured, tip, point, 6, 0.0, 0.0)), base::Error);
  poses[1].translation().x() = INFINITY;
  EXPECT_THROW(toolTip(poses), base::Error);
}

} // namespace
} // namespace voluta::robot
