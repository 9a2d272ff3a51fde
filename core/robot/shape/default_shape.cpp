#include "robot/shape/default_shape.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr Rgb kBody{0.82, 0.83, 0.85}, kCap{0.36, 0.40, 0.45}, kMetal{0.62, 0.64, 0.66};
constexpr double kTestRotationRad = 0.5; // Test rotation of a joint, for finding its axis
constexpr double kTestSlideMm = 50.0;
constexpr double kThickAtBase = 0.055,
                 kThickAtFlange = 0.03; // Housing radii as shares of the arm's length
constexpr double kOfSolid = 0.85;       // Maximum share of a housing's radius in its solid's
constexpr double kTubeShare = 0.72;     // Share of the thinner housing's radius
constexpr double kTogetherMm = 1.0;     // Closer joints have no tube between them

// A joint's axis in the frame of the link that it moves, and in that of the previous link.
struct JointPlace {
  Vector3d point, axis; // In the moved link's frame
  Vector3d pointBefore; // In the previous link's frame
  bool slides = false;
};

JointPlace placeOf(const Kinematics& arm, const JointVector& q, int joint) {
  std::vector<Isometry3d> here, there;
  JointVector moved = q;
  const bool slides = arm.kindOf(joint) == JointKind::Sliding;
  moved[joint] += slides ? kTestSlideMm : kTestRotationRad;
  arm.linkPoses(q, here);
  arm.linkPoses(moved, there);
  const auto link = static_cast<std::size_t>(joint) + 1;
  const Isometry3d before_T_link = here[link - 1].inverse() * here[link];
  const Isometry3d step = before_T_link.inverse() * there[link - 1].inverse() * there[link];
  JointPlace place{Vector3d::Zero(), Vector3d::UnitZ(), before_T_link.translation(), slides};
  if (slides) {
    place.axis = step.translation().normalized();
  } else {
    const Eigen::AngleAxisd rotation(step.linear());
    place.axis = rotation.axis();
    // The point of the axis that is nearest to the frame's origin.
    const Eigen::Matrix3d fixed =
        Eigen::Matrix3d::Identity() - step.linear() + place.axis * place.axis.transpose();
    place.point = fixed.fullPivLu().solve(step.translation() -
                                          place.axis * place.axis.dot(step.translation()));
    place.pointBefore = before_T_link * place.point;
  }
  return place;
}

double thinnest(const Shape& shape) {
  struct Radius {
    double operator()(const Capsule& c) const { return c.radius; }
    double operator()(const Box& b) const { return b.half.minCoeff(); }
    double operator()(const Frustum& f) const { return std::max(f.r0, f.r1); }
    double operator()(const Prism& p) const { return 0.5 * (p.zMax - p.zMin); }
  };
  return std::visit(Radius(), shape);
}

// Returns the radius of the housing at a link's lower end.
double housingRadius(const RobotModel& robot, int frame, double byLength) {
  double radius = byLength, solid = 0.0;
  for (const Body& link : robot.links)
    if (link.frame == frame)
      for (const Shape& shape : link.shapes)
        solid = std::max(solid, thinnest(shape));
  return solid > 0.0 ? std::min(radius, kOfSolid * solid) : radius;
}

class Builder {
public:
  explicit Builder(const RobotModel& robot) : dof_(robot.dof()) {
    q_ = JointVector::Zero(dof_);
    for (int i = 0; i < dof_; ++i)
      q_[i] = std::clamp(0.0, robot.limits[static_cast<std::size_t>(i)].min,
                         robot.limits[static_cast<std::size_t>(i)].max);
    for (int i = 0; i < dof_; ++i)
      places_.push_back(placeOf(*robot.kinematics, q_, i));
    std::vector<Isometry3d> poses;
    robot.kinematics->linkPoses(q_, poses);
    last_T_flange_ = poses[static_cast<std::size_t>(dof_)].inverse() * poses.back();
    double length = last_T_flange_.translation().norm();
    for (int i = 0; i < dof_; ++i)
      length += (end(i) - start(i)).norm();
    // The slides of a Cartesian machine all begin in one point.
    for (const JointLimits& limit : robot.limits)
      if (length < kTogetherMm && limit.kind == JointKind::Sliding)
        length = limit.max - limit.min;
    for (int i = 0; i <= dof_; ++i) {
      const double share = static_cast<double>(i) / dof_;
      radii_.push_back(housingRadius(
          robot, i, length * ((1.0 - share) * kThickAtBase + share * kThickAtFlange)));
    }
  }

  std::vector<ShapeSolid> solids() {
    addBase();
    for (int frame = 1; frame <= dof_; ++frame) {
      addHousing(frame);
      addTube(frame);
    }
    addFlange();
    return std::move(solids_);
  }

private:
  const JointPlace& below(int frame) const { return places_[static_cast<std::size_t>(frame) - 1]; }
  double radius(int frame) const { return radii_[static_cast<std::size_t>(frame)]; }
  // Return where a link begins and ends, in its frame.
  Vector3d start(int frame) const {
    return frame == 0 ? Vector3d::Zero().eval() : below(frame).point;
  }
  Vector3d end(int frame) const {
    return frame == dof_ ? last_T_flange_.translation().eval() : below(frame + 1).pointBefore;
  }

  void add(int frame, const Rgb& colour, const Vector3d& from, const Vector3d& axis,
           std::vector<LoftSection> sections, double roundMm) {
    solids_.push_back({frame, colour, {loftPose(from, axis), std::move(sections), roundMm}});
  }

  void addBase() {
    const double r = radius(0), height = std::max(end(0).norm(), r);
    const Vector3d up = end(0).norm() > kTogetherMm ? end(0) : Vector3d::UnitZ().eval();
    add(0, kMetal, Vector3d::Zero(), up,
        {circleSection(0.0, 1.35 * r), circleSection(0.18 * r, 1.35 * r)}, 0.05 * r);
    add(0, kBody, Vector3d::Zero(), up,
        {circleSection(0.1 * r, 1.1 * r), circleSection(height - 0.2 * r, 0.95 * r)}, 0.1 * r);
  }

  void addHousing(int frame) {
    const JointPlace& joint = below(frame);
    const double r = radius(frame);
    if (joint.slides) {
      add(frame, kMetal, joint.point - r * joint.axis, joint.axis,
          {circleSection(0.0, 0.4 * r), circleSection(2.0 * r, 0.4 * r)}, 0.05 * r);
      return;
    }
    add(frame, kBody, joint.point - r * joint.axis, joint.axis,
        {circleSection(0.0, r), circleSection(2.0 * r, r)}, 0.12 * r);
    // The housing of a nearby joint replaces the lids.
    if ((end(frame) - start(frame)).norm() < r)
      return;
    for (const double side : {-1.0, 1.0})
      add(frame, kCap, joint.point + side * 0.95 * r * joint.axis, side * joint.axis,
          {circleSection(0.0, 0.86 * r), circleSection(0.2 * r, 0.82 * r)}, 0.1 * r);
  }

  void addTube(int frame) {
    const Vector3d from = start(frame), to = end(frame);
    const double length = (to - from).norm();
    if (length < kTogetherMm)
      return;
    const double next = frame == dof_ ? 0.7 * radius(frame) : radius(frame + 1);
    const double thin = kTubeShare * std::min(radius(frame), next);
    add(frame, kBody, from, to - from,
        {circleSection(0.0, kTubeShare * 1.15 * radius(frame)), circleSection(0.3 * length, thin),
         circleSection(0.7 * length, thin), circleSection(length, kTubeShare * 1.05 * next)},
        0.2 * radius(frame));
  }

  void addFlange() {
    const double r = 0.62 * radius(dof_);
    const Vector3d z = last_T_flange_.linear().col(2);
    add(dof_, kMetal, last_T_flange_.translation() - 0.4 * r * z, z,
        {circleSection(0.0, r), circleSection(0.4 * r, r)}, 0.06 * r);
  }

  int dof_;
  JointVector q_;
  Isometry3d last_T_flange_;
  std::vector<JointPlace> places_;
  std::vector<double> radii_;
  std::vector<ShapeSolid> solids_;
};

} // namespace

std::vector<ShapeSolid> defaultShape(const RobotModel& robot) {
  return Builder(robot).solids();
}

} // namespace voluta::robot
