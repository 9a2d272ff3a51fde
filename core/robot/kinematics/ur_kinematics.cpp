#include "robot/kinematics/ur_kinematics.h"

#include "base/error.h"
#include "base/units.h"

#include <cmath>

namespace voluta::robot {

namespace {

using base::kPi;

// Below this sin(theta5) the wrist counts as singular: keeping theta6 at 0 rotates the flange by no
// more than this.
constexpr double kWristSingular = 1e-10;
// Tolerances [mm] and [cosine of the elbow]: a pose out of reach by less is accepted as rounding.
constexpr double kShoulderSlackMm = 1e-9;
constexpr double kElbowSlack = 2e-11;

// std::hypot without its protection against overflow and underflow, which these lengths don't need.
double lengthOf(double x, double y) {
  return std::sqrt(x * x + y * y);
}

double wrapped(double angle) {
  if (angle > kPi)
    angle -= 2.0 * kPi;
  if (angle > kPi)
    angle -= 2.0 * kPi;
  if (angle <= -kPi)
    angle += 2.0 * kPi;
  if (angle <= -kPi)
    angle += 2.0 * kPi;
  return angle;
}

// Rotation by (c, s) about z after a rotation of +90, 0 or -90 degrees about x.
Eigen::Isometry3d step(double x, double y, double z, int quarterTurnsX, double q) {
  const double c = std::cos(q), s = std::sin(q);
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  t.translation() = Eigen::Vector3d(x, y, z);
  if (quarterTurnsX == 0)
    t.linear() << c, -s, 0, s, c, 0, 0, 0, 1;
  else if (quarterTurnsX > 0)
    t.linear() << c, -s, 0, 0, 0, -1, s, c, 0;
  else
    t.linear() << c, -s, 0, 0, 0, 1, -s, -c, 0;
  return t;
}

// Joints of a branch that the elbow does not change; theta234 is the sum of joints 2 to 4.
struct OuterJoints {
  double theta1, theta234, theta5, theta6;
};

// Appends the branches of the elbow: joints 2 and 3 are two bars in the arm's plane that reach (x,
// y) from the shoulder.
void appendElbows(const UrGeometry& g, double x, double y, const OuterJoints& outer,
                  std::vector<JointVector>& solutions) {
  const double c3 = (x * x + y * y - g.a2 * g.a2 - g.a3 * g.a3) / (2.0 * g.a2 * g.a3);
  if (std::abs(c3) > 1.0 + kElbowSlack)
    return;
  const double cosine = std::clamp(c3, -1.0, 1.0);
  const double bend = std::sqrt((1.0 - cosine) * (1.0 + cosine)), bend3 = std::atan2(bend, cosine);
  for (int elbow = 0; elbow < (bend > 0.0 ? 2 : 1); ++elbow) {
    const double s3 = elbow == 0 ? bend : -bend;
    const double theta3 = elbow == 0 ? bend3 : -bend3;
    const double k = g.a2 + g.a3 * cosine, m = g.a3 * s3;
    // (x, y) = (k, m) rotated by theta2; k = m = 0 leaves joint 2 free.
    const double theta2 = std::atan2(y * k - x * m, x * k + y * m);
    JointVector q(6);
    q << outer.theta1, theta2, theta3, wrapped(outer.theta234 - theta2 - theta3), outer.theta5,
        outer.theta6;
    for (int i : {0, 1, 2, 4, 5}) // atan2 may return -pi
      if (q[i] <= -kPi)
        q[i] = kPi;
    solutions.push_back(q);
  }
}

} // namespace

UrKinematics::UrKinematics(const UrGeometry& geometry) : g_(geometry) {
  base::require(g_.a2 != 0.0 && g_.a3 != 0.0 && g_.d6 != 0.0, "UR arm with a link of no length");
}

void UrKinematics::linkPoses(const JointVector& q,
                             std::vector<Eigen::Isometry3d>& base_T_link) const {
  base::require(q.size() >= 6, "a UR has six joints");
  base_T_link.resize(8);
  auto& t = base_T_link;
  t[0].setIdentity();
  t[1] = step(0, 0, g_.d1, 0, q[0]);
  t[2] = t[1] * step(0, 0, 0, 1, q[1]);
  t[3] = t[2] * step(g_.a2, 0, 0, 0, q[2]);
  t[4] = t[3] * step(g_.a3, 0, g_.d4, 0, q[3]);
  t[5] = t[4] * step(0, -g_.d5, 0, 1, q[4]);
  t[6] = t[5] * step(0, g_.d6, 0, -1, q[5]);
  t[7] = t[6];
}

Eigen::Isometry3d UrKinematics::flange(const JointVector& q) const {
  base::require(q.size() >= 6, "a UR has six joints");
  const double c1 = std::cos(q[0]), s1 = std::sin(q[0]);
  const double c2 = std::cos(q[1]), s2 = std::sin(q[1]);
  const double c23 = std::cos(q[1] + q[2]), s23 = std::sin(q[1] + q[2]);
  const double c234 = std::cos(q[1] + q[2] + q[3]), s234 = std::sin(q[1] + q[2] + q[3]);
  const double c5 = std::cos(q[4]), s5 = std::sin(q[4]);
  const double c6 = std::cos(q[5]), s6 = std::sin(q[5]);
  // In the arm's plane (along the arm, up) and across it (n = (s1, -c1, 0)).
  const Eigen::Vector3d along(c1, s1, 0.0), up(0.0, 0.0, 1.0), across(s1, -c1, 0.0);
  const Eigen::Vector3d forward = c234 * along + s234 * up;
  const Eigen::Vector3d down = s234 * along - c234 * up;
  const Eigen::Vector3d x5 = c5 * forward + s5 * across; // x of DH frame 5
  const Eigen::Vector3d z6 = -s5 * forward + c5 * across;
  Eigen::Isometry3d t = Eigen::Isometry3d::Identity();
  t.linear().col(0) = c6 * x5 - s6 * down;
  t.linear().col(1) = -s6 * x5 - c6 * down;
  t.linear().col(2) = z6;
  t.translation() = (g_.a2 * c2 + g_.a3 * c23) * along + (g_.d1 + g_.a2 * s2 + g_.a3 * s23) * up +
                    g_.d4 * across + g_.d5 * down + g_.d6 * z6;
  return t;
}

void UrKinematics::inverse(const Eigen::Isometry3d& base_T_flange,
                           std::vector<JointVector>& solutions) const {
  const auto x6 = base_T_flange.linear().col(0), y6 = base_T_flange.linear().col(1),
             z6 = base_T_flange.linear().col(2);
  const Eigen::Vector3d p5 = base_T_flange.translation() - g_.d6 * z6;

  // Joint 1: the wrist centre is d4 across the arm's plane.
  const double reach = lengthOf(p5.x(), p5.y());
  if (reach < std::abs(g_.d4) - kShoulderSlackMm || reach == 0.0)
    return;
  const double planar = std::sqrt(std::max(0.0, (reach - g_.d4) * (reach + g_.d4)));
  const int shoulders = planar > 0.0 ? 2 : 1;
  for (int shoulder = 0; shoulder < shoulders; ++shoulder) {
    const double a = shoulder == 0 ? planar : -planar; // Wrist centre along the arm
    // p5 = a along + d4 across, along = (c1, s1), across = (s1, -c1).
    const double c1 = (a * p5.x() - g_.d4 * p5.y()) / (reach * reach);
    const double s1 = (a * p5.y() + g_.d4 * p5.x()) / (reach * reach);
    const double theta1 = std::atan2(s1, c1);
    const double size1 = lengthOf(c1, s1);
    const double ux = c1 / size1, uy = s1 / size1; // along; across = (uy, -ux)

    // Joints 5 and 6: `across` seen from the flange is (s5 c6, -s5 s6, c5).
    const double nx = uy * x6.x() - ux * x6.y(), ny = uy * y6.x() - ux * y6.y(),
                 nz = uy * z6.x() - ux * z6.y();
    const double sine = lengthOf(nx, ny);
    const bool singular = sine < kWristSingular;
    const double size5 = lengthOf(sine, nz);
    const double c5 = singular ? std::copysign(1.0, nz) : nz / size5;
    const double bend5 = std::atan2(singular ? 0.0 : sine / size5, c5);
    for (int wrist = 0; wrist < (singular ? 1 : 2); ++wrist) {
      const double sign = wrist == 0 ? 1.0 : -1.0;
      const double s5 = singular ? 0.0 : sign * sine / size5;
      const double c6 = singular ? 1.0 : sign * nx / sine, s6 = singular ? 0.0 : -sign * ny / sine;
      const double theta5 = sign * bend5, theta6 = singular ? 0.0 : std::atan2(s6, c6);

      // Sum of joints 2-4: x of DH frame 4 in the arm's plane.
      const Eigen::Vector3d forward = c5 * (c6 * x6 - s6 * y6) - s5 * z6;
      double c234 = ux * forward.x() + uy * forward.y(), s234 = forward.z();
      const double size234 = lengthOf(c234, s234);
      c234 /= size234;
      s234 /= size234;
      const double theta234 = std::atan2(s234, c234);

      // Joints 2 and 3 bring the end of the forearm to (along, up) in the plane.
      appendElbows(g_, a - g_.d5 * s234, p5.z() - g_.d1 + g_.d5 * c234,
                   {theta1, theta234, theta5, theta6}, solutions);
    }
  }
}

} // namespace voluta::robot
