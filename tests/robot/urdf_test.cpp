// Robots from URDF: the resulting arm, notes about missing values, and files that are refused.
#include "joints_in_degrees.h"
#include "resource_fixture.h"
#include "urdf_arms.h"
#include "urdf_text.h"

#include "base/error.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/temporary_folder.h"
#include "robot/cell/robot_file_writer.h"
#include "robot/kinematics/chain_kinematics.h"
#include "robot/shape/capsule_fit.h"
#include "robot/urdf/urdf_chain.h"
#include "robot/urdf/urdf_reader.h"
#include "robot/urdf/urdf_shapes.h"

#include <fstream>
#include <gmock/gmock.h>
#include <random>

namespace voluta::robot {
namespace {

using base::kPi;
using Eigen::Vector3d;
using ::testing::Contains;
using ::testing::HasSubstr;

class Urdf : public test::WithResources {
protected:
  std::filesystem::path written(const std::string& text) {
    std::filesystem::create_directories(folder_ / std::filesystem::path("my_arm/urdf"));
    const auto file = folder_ / std::filesystem::path("my_arm/urdf/arm.urdf");
    std::ofstream(file) << text;
    return file;
  }
  UrdfRobot read(const std::string& text, const UrdfOptions& options = {}) {
    return readUrdf(written(text), options);
  }
  std::string complaint(const std::string& text, const UrdfOptions& options = {}) {
    try {
      read(text, options);
    } catch (const base::Error& e) {
      EXPECT_THAT(e.what(), HasSubstr("arm.urdf"));
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
      EXPECT_NE(e.code(), base::ErrorCode::Internal);
      return e.what();
    }
    return {};
  }
  static std::string with(std::string text, const std::string& what, const std::string& instead) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), instead);
  }

  const test::TemporaryFolder folder_;
};

TEST_F(Urdf, IsTheArmThatItDescribes) {
  const UrdfRobot robot = read(test::ur5Urdf());
  EXPECT_EQ(robot.model.id, "my-ur5-left");
  EXPECT_EQ(robot.model.label, "My UR5, left");
  const auto* chain = dynamic_cast<const ChainKinematics*>(robot.model.kinematics.get());
  ASSERT_NE(chain, nullptr);
  EXPECT_EQ(chain->kind(), ArmKind::ParallelAxes);
  // The description's "base" is the controller's: the poses are those of the arm that comes along.
  const RobotModel known = loadRobot("ur5");
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  std::vector<Eigen::Isometry3d> here, there;
  for (int n = 0; n < 500; ++n) {
    JointVector q(6);
    for (int i = 0; i < 6; ++i)
      q[i] = angle(random);
    const PoseError error =
        poseError(robot.model.kinematics->flange(q), known.kinematics->flange(q));
    ASSERT_LT(error.mm, 1e-6);
    ASSERT_LT(error.rad, 1e-9);
    robot.model.kinematics->linkPoses(q, here);
    known.kinematics->linkPoses(q, there);
    for (std::size_t i = 0; i < there.size(); ++i) {
      ASSERT_LT(poseError(here[i], there[i]).mm, 1e-6) << i;
      ASSERT_LT(poseError(here[i], there[i]).rad, 1e-9) << i;
    }
  }
  ASSERT_EQ(robot.model.limits.size(), 6u);
  EXPECT_NEAR(robot.model.limits[2].max, kPi, 1e-6);
  EXPECT_NEAR(robot.model.limits[5].velocity, 3.14, 1e-12);
  EXPECT_THAT(robot.model.assumed, Contains(HasSubstr("accelerations of 800")));
  EXPECT_THAT(robot.model.assumed, Contains(HasSubstr("frame of link 'base'")));
}

TEST_F(Urdf, EqualsTheBundledIrb1200) {
  const UrdfRobot robot = read(test::urdfOf(test::irb1200()));
  const RobotModel known = loadRobot("irb1200");
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  for (int n = 0; n < 500; ++n) {
    JointVector q(6);
    for (int i = 0; i < 6; ++i)
      q[i] = angle(random);
    const PoseError error =
        poseError(robot.model.kinematics->flange(q), known.kinematics->flange(q));
    ASSERT_LT(error.mm, 1e-6);
    ASSERT_LT(error.rad, 1e-9);
  }
}

// The branch continued from a pose is one that the whole inverse has.
TEST_F(Urdf, FollowsABranchWhereItsInverseIsSlow) {
  const UrdfRobot robot = read(test::urdfOf(test::oddArm()));
  const RobotModel& model = robot.model;
  ASSERT_FALSE(model.kinematics->isFast());
  EXPECT_TRUE(read(test::ur5Urdf()).model.kinematics->isFast());
  const JointVector from = test::joints({10, 30, -20, 15, 60, -40});
  for (const double step : {0.2, 1.0, 5.0}) {
    JointVector to = from;
    for (int i = 0; i < 6; ++i)
      to[i] += (i % 2 ? -1.0 : 1.0) * step * kPi / 180.0;
    const auto next = nextBranch(model, model.kinematics->flange(to), from, 0.3);
    ASSERT_TRUE(next) << step;
    EXPECT_LT((*next - to).norm(), 1e-6) << step;
  }
  JointVector far = from;
  far[0] += 0.5;
  EXPECT_FALSE(
      nextBranch(model, model.kinematics->flange(far), from, 0.3)); // further than the limit
  Eigen::Isometry3d out = model.kinematics->flange(from);
  out.translation().x() += 5000.0;
  EXPECT_FALSE(nextBranch(model, out, from, 7.0));
  JointVector end = from;
  end[2] = model.limits[2].max + 1e-3;
  JointVector near = end;
  near[2] = model.limits[2].max - 1e-3;
  EXPECT_FALSE(nextBranch(model, model.kinematics->flange(end), near, 0.3)); // beyond a limit
}

TEST_F(Urdf, HasTheSolidsOfItsLinks) {
  const UrdfRobot robot = read(test::ur5Urdf());
  const std::vector<Body>& links = robot.model.links;
  ASSERT_EQ(links.size(), 7u);
  EXPECT_EQ(links[0].name, "base_link");
  const auto& foot = std::get<Frustum>(links[0].shapes.at(0));
  EXPECT_LT((foot.p0 - Vector3d(0, 0, 0)).norm() + (foot.p1 - Vector3d(0, 0, 80)).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(foot.r0, 70.0);
  const auto& upper = std::get<Frustum>(links[2].shapes.at(0));
  EXPECT_LT((upper.p0 - Vector3d(-462.5, 0, 132)).norm(), 1e-9);
  EXPECT_LT((upper.p1 - Vector3d(37.5, 0, 132)).norm(), 1e-9);
  const auto& fore = std::get<Box>(links[3].shapes.at(0));
  EXPECT_LT((fore.half - Vector3d(180, 35, 35)).norm(), 1e-9);
  EXPECT_DOUBLE_EQ(std::get<Capsule>(links[4].shapes.at(0)).radius, 55.0); // the visual shape
  EXPECT_EQ(links[6].frame, 6);
}

TEST_F(Urdf, IsReadBackFromItsFile) {
  UrdfOptions options;
  options.id = "left-arm";
  options.controller = "urscript";
  const UrdfRobot robot = read(test::ur5Urdf(), options);
  const auto file = folder_ / std::filesystem::path("left-arm.json");
  std::ofstream(file) << robotFileJson(robot.model, robot.chain, robot.source);
  const RobotModel back = readRobot(file);
  EXPECT_EQ(back.controller, "urscript");
  EXPECT_EQ(back.neverMeet, robot.model.neverMeet);
  EXPECT_EQ(back.assumed, robot.model.assumed);
  ASSERT_EQ(back.links.size(), robot.model.links.size());
  const JointVector q = test::joints({10, -70, 60, 20, 80, -30});
  std::vector<Eigen::Isometry3d> here, there;
  back.kinematics->linkPoses(q, here);
  robot.model.kinematics->linkPoses(q, there);
  for (std::size_t i = 0; i < there.size(); ++i)
    EXPECT_LT(poseError(here[i], there[i]).mm, 1e-9) << i;
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(back.limits[i].min, robot.model.limits[i].min, 1e-9);
    EXPECT_NEAR(back.limits[i].velocity, robot.model.limits[i].velocity, 1e-9);
  }
  EXPECT_NEAR(std::get<Box>(back.links[3].shapes.at(0)).half.x(), 180.0, 1e-9);
}

TEST_F(Urdf, StatesTheAssumedLimits) {
  const auto assumedWith = [&](const std::string& last) {
    const UrdfRobot robot = read(test::ur5Urdf("", last));
    EXPECT_NEAR(robot.model.limits[5].max, 2 * kPi, 1e-12);
    return robot.model.assumed;
  };
  const auto zero = assumedWith(R"(<limit lower="0" upper="0" velocity="0"/>)");
  EXPECT_THAT(zero, Contains(HasSubstr("'wrist_3_joint' turns +-360 deg: the description has zero "
                                       "limits")));
  EXPECT_THAT(zero, Contains(HasSubstr("'wrist_3_joint' turns at 180 deg/s")));
  EXPECT_THAT(assumedWith(""), Contains(HasSubstr("has no limits")));
  EXPECT_THAT(complaint(test::ur5Urdf("", R"(<limit lower="1" upper="-1" velocity="1"/>)")),
              HasSubstr("'wrist_3_joint': the lower limit is not below the upper one"));
}

TEST_F(Urdf, SafetyControllersTightenLimits) {
  const auto lastOf = [&](const std::string& safety) {
    return read(test::ur5Urdf("", R"(<limit lower="-6" upper="6" velocity="3"/>)" + safety)).model;
  };
  const RobotModel tight =
      lastOf(R"(<safety_controller soft_lower_limit="-1" soft_upper_limit="9" k_velocity="1"/>)");
  EXPECT_DOUBLE_EQ(tight.limits[5].min, -1.0);
  EXPECT_DOUBLE_EQ(tight.limits[5].max, 6.0);
  EXPECT_THAT(tight.assumed, Contains(HasSubstr("'wrist_3_joint' turns from -57.3 to 343.8 deg")));
  // Without effect on positions, or beyond the joint's own
  for (const char* safety :
       {R"(<safety_controller k_velocity="1"/>)",
        R"(<safety_controller soft_lower_limit="-7" soft_upper_limit="7" k_velocity="1"/>)"}) {
    const RobotModel same = lastOf(safety);
    EXPECT_DOUBLE_EQ(same.limits[5].min, -6.0);
    EXPECT_DOUBLE_EQ(same.limits[5].max, 6.0);
    EXPECT_EQ(same.assumed, lastOf("").assumed);
  }
  EXPECT_THAT(complaint(test::ur5Urdf("", R"(<limit lower="-1" upper="1" velocity="1"/>
                          <safety_controller soft_lower_limit="2" soft_upper_limit="3"/>)")),
              HasSubstr("'wrist_3_joint': the limits of its safety controller leave no room"));
}

TEST_F(Urdf, NamesSolidsThatItLeavesOut) {
  const std::string ur5 = test::ur5Urdf();
  const auto assumedOf = [&](const std::string& forearm) {
    return read(with(ur5, R"(<box size="0.36 0.07 0.07"/>)", forearm)).model.assumed;
  };
  EXPECT_THAT(assumedOf(R"(<sphere radius="-0.05"/>)"),
              Contains(HasSubstr("link 'forearm': a sphere of radius -50 mm is left out")));
  EXPECT_THAT(assumedOf(R"(<cylinder radius="0.1" length="-1"/>)"),
              Contains(HasSubstr("a cylinder of radius 100 mm and length -1000 mm is left out")));
  EXPECT_THAT(assumedOf(R"(<box size="0.1 -0.2 0.1"/>)"),
              Contains(HasSubstr("a box of 100 x -200 x 100 mm is left out")));
  EXPECT_THAT(assumedOf(R"(<capsule radius="0.1" length="1"/>)"),
              Contains(HasSubstr("a solid of unknown shape 'capsule' is left out")));
}

TEST_F(Urdf, RefusesUnsupportedRobotsInOneLine) {
  const std::string ur5 = test::ur5Urdf();
  EXPECT_EQ(complaint(ur5), "");
  const auto elbowAs = [&](const std::string& type) {
    return with(ur5, R"(<joint name="elbow" type="revolute">)",
                "<joint name=\"elbow\" type=\"" + type + "\">");
  };
  EXPECT_THAT(complaint(elbowAs("prismatic")), HasSubstr("'elbow' is prismatic"));
  EXPECT_THAT(complaint(elbowAs("floating")), HasSubstr("'elbow' is floating"));
  EXPECT_THAT(complaint(elbowAs("planar")), HasSubstr("'elbow' is planar"));
  EXPECT_THAT(complaint(elbowAs("ball")), HasSubstr("unknown type: 'ball'"));
  EXPECT_THAT(complaint(elbowAs("fixed")), HasSubstr("has 5 turning axes; six are needed"));
  EXPECT_THAT(complaint(test::ur5Urdf("", "<mimic joint=\"pan\"/>")),
              HasSubstr("'wrist_3_joint' mimics 'pan'"));
  EXPECT_THAT(complaint(test::ur5Urdf(R"(<joint name="rod" type="revolute"><parent link="shoulder"/>
                                          <child link="forearm"/></joint>)")),
              HasSubstr("link 'forearm' has two parent joints, 'elbow' and 'rod': loops"));
  EXPECT_THAT(complaint(R"(<robot name="r"><link name="a"/><link name="b"/>
      <joint name="1" type="revolute"><parent link="a"/><child link="b"/></joint>
      <joint name="2" type="revolute"><parent link="b"/><child link="a"/></joint></robot>)"),
              HasSubstr("is part of a loop"));
  EXPECT_THAT(complaint(test::ur5Urdf("<link name=\"table\"/>")),
              HasSubstr("two bases, 'world' and 'table'"));
  EXPECT_THAT(complaint(with(ur5, R"(<joint name="lift")", R"(<joint name="pan")")),
              HasSubstr("two joints are named 'pan'"));
  EXPECT_THAT(complaint(R"(<robot name="r"><link name="a"/></robot>)"), HasSubstr("has no tip"));
  EXPECT_THAT(complaint(R"(<robot name="r"></robot>)"), HasSubstr("has no links"));
  EXPECT_THAT(complaint(ur5, {.tip = "tool1", .base = {}, .id = {}}),
              HasSubstr("no link is named 'tool1' (did you mean tool0?)"));
  EXPECT_THAT(complaint(test::ur5Urdf(R"(<link name="finger"/><joint name="grip" type="prismatic">
      <parent link="wrist_3"/><child link="finger"/></joint>)")),
              HasSubstr("several tips: tool0, finger"));
  EXPECT_THAT(complaint(test::ur5Urdf(R"(<joint name="j" type="fixed"><parent link="lost"/>
      <child link="tool0"/></joint>)")),
              HasSubstr("'j' names an unknown link: 'lost'"));
  EXPECT_THAT(complaint(with(ur5, R"(xyz="-0.425 0 0")", R"(xyz="-0.425 0")")),
              HasSubstr("must be three numbers"));
  EXPECT_THAT(
      complaint(with(ur5, "<robot ", "<robot xmlns:xacro=\"http://ros.org/wiki/xacro\" ") + ""),
      "");
  EXPECT_THAT(complaint(R"(<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">
      <xacro:macro name="m"/></robot>)"),
              HasSubstr("is a xacro file"));
  EXPECT_THAT(complaint("<sdf/>"), HasSubstr("is not a URDF"));
  EXPECT_THAT(complaint("robot"), HasSubstr("arm.urdf"));
}

TEST_F(Urdf, LeavesOutJointsBesideTheArm) {
  UrdfOptions options;
  options.tip = "tool0";
  const UrdfRobot robot =
      read(test::ur5Urdf(R"(<link name="finger"/><joint name="grip" type="prismatic">
      <parent link="wrist_3"/><child link="finger"/></joint>)"),
           options);
  EXPECT_THAT(robot.model.assumed, Contains(HasSubstr("the branch moved by joint 'grip'")));
  options.base = "world";
  const UrdfRobot other = read(test::ur5Urdf(), options);
  const JointVector zero = JointVector::Zero(6);
  const Vector3d p = robot.model.kinematics->flange(zero).translation(),
                 w = other.model.kinematics->flange(zero).translation();
  EXPECT_LT((Vector3d(-p.x(), -p.y(), p.z()) - w).norm(), 1e-9); // half a turn about z
}

TEST_F(Urdf, EnclosesMeshesAndReplacesThoseThatAreNotThere) {
  // A bar of 200 x 40 x 20 mm in metres, aslant in its link.
  geometry::TriangleMesh bar;
  for (int i = 0; i < 8; ++i)
    bar.vertices.emplace_back(i & 1 ? 0.2 : 0.0, i & 2 ? 0.04 : 0.0, i & 4 ? 0.02 : 0.0);
  bar.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4}};
  std::filesystem::create_directories(folder_ / std::filesystem::path("my_arm/meshes"));
  std::ofstream(folder_ / std::filesystem::path("my_arm/meshes/bar.stl"), std::ios::binary)
      << geometry::writeStl(bar);
  const std::string box = R"(<box size="0.36 0.07 0.07"/>)";
  const std::string urdf =
      with(with(test::ur5Urdf(), box, R"(<mesh filename="package://my_arm/meshes/bar.stl"/>)"),
           R"(<sphere radius="0.04"/>)", R"(<mesh filename="../meshes/none.stl"/>)");
  const UrdfRobot robot = read(urdf);
  for (const Vector3d& v : bar.vertices) {
    const Vector3d p = 1000.0 * v + Vector3d(-196, 0, 27);
    double nearest = 1e9;
    for (const Shape& shape : robot.model.links[3].shapes) {
      const auto& capsule = std::get<Capsule>(shape);
      EXPECT_LT(capsule.radius, 25.0);
      const Vector3d along = capsule.p1 - capsule.p0;
      const double t = std::clamp((p - capsule.p0).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - capsule.p0 - t * along).norm() - capsule.radius);
    }
    EXPECT_LE(nearest, 1e-3);
  }
  EXPECT_THAT(robot.model.assumed,
              Contains(HasSubstr("link 'wrist_2' is a capsule along it: its mesh "
                                 "../meshes/none.stl is missing")));
  EXPECT_LT((std::get<Capsule>(robot.model.links[5].shapes.at(0)).p1 - Vector3d(0, 82.3, 0)).norm(),
            1e-9);
  const UrdfRobot dae = read(
      with(test::ur5Urdf(), box, R"(<mesh filename="file://../meshes/bar.stl" scale="2 2 2"/>)"));
  EXPECT_GT(std::get<Capsule>(dae.model.links[3].shapes.at(0)).radius,
            1.9 * std::get<Capsule>(robot.model.links[3].shapes.at(0)).radius);
}

// An L of two bars: one capsule about it would be four times as large.
TEST_F(Urdf, SeveralCapsulesHoldAMeshTightly) {
  std::vector<Corners> triangles;
  const auto addBox = [&](const Vector3d& low, const Vector3d& high) {
    std::array<Vector3d, 8> p;
    for (std::size_t i = 0; i < 8; ++i)
      p[i] = {i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z()};
    for (const auto& f : {std::array{0, 2, 3, 1},
                          {4, 5, 7, 6},
                          {0, 1, 5, 4},
                          {2, 6, 7, 3},
                          {0, 4, 6, 2},
                          {1, 3, 7, 5}})
      for (std::size_t k = 2; k < 4; ++k)
        triangles.push_back({p[static_cast<std::size_t>(f[0])],
                             p[static_cast<std::size_t>(f[k - 1])],
                             p[static_cast<std::size_t>(f[k])]});
  };
  addBox({0, -30, -30}, {400, 30, 30});
  addBox({-30, -30, -30}, {30, 30, 300});
  const auto volume = [](const std::vector<Capsule>& capsules) {
    double sum = 0.0;
    for (const Capsule& c : capsules)
      sum += kPi * c.radius * c.radius * ((c.p1 - c.p0).norm() + 4.0 / 3.0 * c.radius);
    return sum;
  };
  const auto one = enclosingCapsules(triangles, Vector3d::UnitX(), 1);
  const auto three = enclosingCapsules(triangles, Vector3d::UnitX(), 3);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_LE(three.size(), 3u);
  EXPECT_LT(volume(three), 0.4 * volume(one));
  // Every point of every triangle is in one of them, not the corners alone.
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const Corners& t : triangles)
    for (int n = 0; n < 200; ++n) {
      double u = share(random), v = share(random);
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      const Vector3d p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      const bool held = std::any_of(three.begin(), three.end(), [&](const Capsule& c) {
        const Vector3d along = c.p1 - c.p0;
        const double square = along.squaredNorm();
        const double at = square > 0.0 ? std::clamp((p - c.p0).dot(along) / square, 0.0, 1.0) : 0.0;
        return (p - c.p0 - at * along).norm() <= c.radius + 1e-9;
      });
      ASSERT_TRUE(held) << p.transpose();
    }
}

TEST_F(Urdf, NumbersOutOfRangeAreRefusedOrReplaced) {
  const std::string ur5 = test::ur5Urdf();
  EXPECT_THAT(complaint(with(ur5, R"(xyz="-0.425 0 0")", R"(xyz="-4e9 0 0")")),
              HasSubstr("'xyz' is NaN or out of range"));
  EXPECT_THAT(complaint(with(ur5, R"(xyz="-0.425 0 0")", R"(xyz="nan 0 0")")),
              HasSubstr("must be three numbers"));
  EXPECT_THAT(complaint(with(ur5, R"(<axis xyz="0 0 1"/>)", R"(<axis xyz="0 0 0"/>)")),
              HasSubstr("axis of zero length"));
  const UrdfRobot endless =
      read(test::ur5Urdf("", R"(<limit lower="-1e9" upper="1e9" velocity="1e12"/>)"));
  EXPECT_NEAR(endless.model.limits[5].max, 2 * kPi, 1e-12);
  EXPECT_THAT(endless.model.assumed, Contains(HasSubstr("no usable velocity")));
  EXPECT_THAT(endless.model.assumed, Contains(HasSubstr("-1e+09 and 1e+09 rad, are more than")));
  // In degrees
  const UrdfRobot degrees =
      read(test::ur5Urdf("", R"(<limit lower="-90" upper="170" velocity="3"/>)"));
  EXPECT_NEAR(degrees.model.limits[5].min, -2 * kPi, 1e-12);
  EXPECT_THAT(degrees.model.assumed,
              Contains(HasSubstr("'wrist_3_joint' turns +-360 deg: the description's limits, -90 "
                                 "and 170 rad, are more than four turns (limits are in radians")));
  // Cut off in the middle.
  EXPECT_THAT(complaint(ur5.substr(0, ur5.size() / 2)), HasSubstr("arm.urdf"));
  EXPECT_THAT(complaint(""), HasSubstr("arm.urdf"));
}

TEST_F(Urdf, ListsPossibleFlangeLinks) {
  const auto file = written(test::ur5Urdf(R"(<link name="finger"/><joint name="grip"
      type="prismatic"><parent link="wrist_3"/><child link="finger"/></joint>)"));
  EXPECT_EQ(urdfTips(readUrdfTree(file), "arm.urdf"),
            (std::vector<std::string>{"tool0", "finger"}));
}

TEST_F(Urdf, CapsulesHoldEveryPoint) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(0.0, 1.0);
  for (int n = 0; n < 50; ++n) {
    const Vector3d size(20.0 + n, 30, 300);
    const Eigen::Matrix3d rotation =
        Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
            .normalized()
            .toRotationMatrix();
    std::vector<Vector3d> points;
    for (int i = 0; i < 500; ++i)
      points.push_back(rotation *
                       size.cwiseProduct(Vector3d(normal(random), normal(random), normal(random))));
    const Capsule capsule = enclosingCapsule(points, Vector3d::UnitX());
    double closest = 1e9;
    for (const Vector3d& p : points) {
      const Vector3d along = capsule.p1 - capsule.p0;
      const double t = std::clamp((p - capsule.p0).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const double inside = capsule.radius - (p - capsule.p0 - t * along).norm();
      ASSERT_GE(inside, 0.0);
      closest = std::min(closest, inside);
    }
    EXPECT_LT(closest, 0.2); // no fatter than it has to be
  }
  // Two points and a ball's points: the least there is.
  EXPECT_DOUBLE_EQ(enclosingCapsule({{0, 0, 0}, {100, 0, 0}}, {0, 0, 0}).radius, 0.1);
  const Capsule point = enclosingCapsule({{1, 2, 3}}, {0, 0, 0});
  EXPECT_LT((point.p0 - Vector3d(1, 2, 3)).norm() + (point.p1 - point.p0).norm(), 1e-9);
}

} // namespace
} // namespace voluta::robot
