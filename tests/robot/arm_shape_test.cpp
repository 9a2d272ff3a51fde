// Shapes of robots: every robot has one, and every solid of it is a clean surface near the solids
// that are checked.
#include "resource_fixture.h"
#include "sampled_distance.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/json_node.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "robot/planning_text.h"
#include "robot/robot_model.h"
#include "robot/shape/arm_look.h"
#include "robot/shape/default_shape.h"
#include "robot/shape/loft.h"
#include "robot/shape/tool_shape.h"

#include <gmock/gmock.h>
#include <map>
#include <tuple>

namespace voluta::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

using base::kPi;

// Edges used once in each direction, vertices at one place taken as one.
bool isClosed(const geometry::TriangleMesh& mesh) {
  std::map<std::tuple<double, double, double>, int> places;
  std::vector<int> placeOf;
  for (const Vector3d& v : mesh.vertices) {
    const auto rounded = [](double x) { return std::round(x * 1e5); };
    const auto key = std::tuple(rounded(v.x()), rounded(v.y()), rounded(v.z()));
    placeOf.push_back(places.emplace(key, static_cast<int>(places.size())).first->second);
  }
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = placeOf[static_cast<std::size_t>(t[k])];
      const int b = placeOf[static_cast<std::size_t>(t[(k + 1) % 3])];
      ++edges[{a, b}];
    }
  return std::ranges::all_of(edges, [&](const auto& edge) {
    const auto back = edges.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != edges.end() && back->second == 1;
  });
}

// The largest angle between a triangle and the normals at its corners, rad.
double worstNormal(const LoftMesh& loft) {
  double worst = 0.0;
  for (std::size_t i = 0; i < loft.mesh.triangles.size(); ++i) {
    const Vector3d facet = geometry::triangleNormal(loft.mesh, i);
    for (const int corner : loft.mesh.triangles[i])
      worst = std::max(
          worst, std::acos(std::clamp(facet.dot(loft.normals[static_cast<std::size_t>(corner)]),
                                      -1.0, 1.0)));
  }
  return worst;
}

double minArea(const geometry::TriangleMesh& mesh) {
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    minimum = std::min(minimum, geometry::triangleArea(mesh, i));
  return minimum;
}

TEST(Loft, IsACylinderOfItsSize) {
  Loft loft;
  loft.frame_T_loft = loftPose({0, 0, 5}, Vector3d::UnitX());
  loft.sections = {circleSection(0.0, 10.0), circleSection(30.0, 10.0)};
  const LoftMesh sharp = meshOf(loft);
  EXPECT_TRUE(isClosed(sharp.mesh));
  EXPECT_NEAR(geometry::volume(sharp.mesh), kPi * 100.0 * 30.0, 0.01 * kPi * 3000.0);
  const Eigen::AlignedBox3d box = geometry::bounds(sharp.mesh);
  EXPECT_LT((box.min() - Vector3d(0, -10, -5)).norm(), 1e-9);
  EXPECT_LT((box.max() - Vector3d(30, 10, 15)).norm(), 1e-9);
  EXPECT_LT(worstNormal(sharp), 0.07) << "each side of a sharp edge has normals of its own";
  loft.roundMm = 4.0;
  const LoftMesh round = meshOf(loft);
  EXPECT_TRUE(isClosed(round.mesh));
  EXPECT_LT(geometry::volume(round.mesh), geometry::volume(sharp.mesh));
  EXPECT_LT(worstNormal(round), 0.3) << "rounded edges are smooth";
}

TEST(Loft, IsABarAndARectangle) {
  Loft bar;
  bar.roundMm = 2.0;
  bar.sections = {{0.0, {{{0, 0}, 20.0}, {{100, 0}, 10.0}}},
                  {30.0, {{{0, 0}, 20.0}, {{100, 0}, 10.0}}}};
  EXPECT_TRUE(isClosed(meshOf(bar).mesh));
  EXPECT_NEAR(geometry::bounds(meshOf(bar).mesh).sizes().x(), 130.0, 1e-9);
  Loft rectangle;
  rectangle.roundMm = 2.0;
  rectangle.sections = {rectangleSection(0.0, {60, 40}, 5.0),
                        rectangleSection(30.0, {50, 50}, 20.0)};
  EXPECT_TRUE(isClosed(meshOf(rectangle).mesh));
  EXPECT_NEAR(geometry::bounds(meshOf(rectangle).mesh).sizes().x(), 60.0, 0.5);
}

class Shapes : public test::WithResources {
protected:
  static base::JsonNode fileOf(const std::string& id) {
    return base::JsonNode::readFile(base::dataFile("robots", id, "unknown robot '{id}'"_text));
  }
  static JointVector restOf(const RobotModel& robot) {
    JointVector q(robot.dof());
    for (int i = 0; i < robot.dof(); ++i)
      q[i] = std::clamp(0.0, robot.limits[static_cast<std::size_t>(i)].min,
                        robot.limits[static_cast<std::size_t>(i)].max);
    return q;
  }
  static void expectClean(const std::vector<ShapeSolid>& solids, const std::string& of) {
    for (std::size_t i = 0; i < solids.size(); ++i) {
      const LoftMesh loft = meshOf(solids[i].loft);
      const std::string which = of + ", solid " + std::to_string(i);
      ASSERT_FALSE(loft.mesh.empty()) << which;
      EXPECT_TRUE(isClosed(loft.mesh)) << which;
      EXPECT_GT(geometry::volume(loft.mesh), 0.0) << which;
      EXPECT_GT(minArea(loft.mesh), 1e-7) << which;
      // Shaded by its geometry: no facet beside a right-angled edge takes part in both of its
      // faces.
      EXPECT_LT(worstNormal(loft), kPi / 4.0) << which;
      for (const Vector3d& normal : loft.normals)
        ASSERT_NEAR(normal.norm(), 1.0, 1e-9) << which;
    }
  }
};

TEST_F(Shapes, EachRobotHasOneOfItsOwn) {
  for (const std::string& id : robotIds()) {
    const RobotModel robot = loadRobot(id);
    const base::JsonNode file = fileOf(id);
    ASSERT_TRUE(file.has("shape")) << id;
    const std::vector<ShapeSolid> solids = readArmShape(file.at("shape"), robot.dof());
    expectClean(solids, id);
    for (const Body& link : robot.links)
      EXPECT_TRUE(std::ranges::any_of(
          solids, [&](const ShapeSolid& solid) { return solid.frame == link.frame; }))
          << id << ": " << link.name;
    EXPECT_EQ(lookOf(robot).solids.size(), solids.size()) << id;
  }
}

TEST_F(Shapes, AnArmWithoutOneGetsItFromItsKinematics) {
  for (const std::string& id : robotIds()) {
    RobotModel robot = loadRobot(id);
    robot.id = "nobody-has-such-an-arm";
    const std::vector<ShapeSolid> solids = lookOf(robot).solids;
    expectClean(solids, id);
    std::vector<Isometry3d> poses;
    robot.kinematics->linkPoses(restOf(robot), poses);
    // Its flange is where the kinematics have it.
    double nearest = std::numeric_limits<double>::infinity();
    for (const ShapeSolid& solid : solids)
      for (const Vector3d& v : meshOf(solid.loft).mesh.vertices)
        nearest = std::min(
            nearest,
            (poses[static_cast<std::size_t>(solid.frame)] * v - poses.back().translation()).norm());
    EXPECT_LT(nearest, 1.0) << id;
  }
}

// The radius of a round solid, half the least width of another.
double halfWidth(const Shape& shape) {
  if (const auto* capsule = std::get_if<Capsule>(&shape))
    return capsule->radius;
  if (const auto* frustum = std::get_if<Frustum>(&shape))
    return std::max(frustum->r0, frustum->r1);
  if (const auto* box = std::get_if<Box>(&shape))
    return box->half.minCoeff();
  return 0.0;
}

// Drawn and checked shapes must agree: a part that looks clear of the arm is, and one that meets
// the solids looks near it. Solids are few and round, links have corners: those of a square housing
// about a round solid are at 1.41 times its radius.
TEST_F(Shapes, StayNearTheSolidsThatAreChecked) {
  const double cornerShare = std::sqrt(2.0) - 1.0;
  constexpr double kSmallMm = 20.0; // flange plates and caps, on solids of small radius
  constexpr double kFootMm = 20.0;  // plates on which the arm is mounted: nothing gets beside them
  for (const std::string& id : robotIds()) {
    const RobotModel robot = loadRobot(id);
    std::vector<Isometry3d> poses;
    robot.kinematics->linkPoses(restOf(robot), poses);
    const std::vector<ShapeSolid> solids = lookOf(robot).solids;
    double ground = 0.0;
    for (const ShapeSolid& solid : solids)
      for (const Vector3d& v : meshOf(solid.loft).mesh.vertices)
        ground = solid.frame == 0 ? std::min(ground, v.z()) : ground;
    std::map<int, double> worst; // beyond the allowance of its nearest solid, mm
    for (const ShapeSolid& solid : solids)
      for (const Vector3d& v : meshOf(solid.loft).mesh.vertices) {
        if (solid.frame == 0 && v.z() < ground + kFootMm)
          continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Body& link : robot.links) {
          // Joints reach into the links beside them.
          if (std::abs(link.frame - solid.frame) > 1)
            continue;
          const Vector3d local = poses[static_cast<std::size_t>(link.frame)].inverse() *
                                 (poses[static_cast<std::size_t>(solid.frame)] * v);
          for (const Shape& shape : link.shapes)
            nearest = std::min(nearest, test::signedDistance(local, shape) -
                                            std::max(kSmallMm, cornerShare * halfWidth(shape)));
        }
        worst[solid.frame] = std::max(worst[solid.frame], nearest);
      }
    for (const auto& [frame, beyond] : worst)
      EXPECT_LE(beyond, 0.0) << id << ", link " << frame;
  }
}

// Faces of two solids in one place, facing the same way: they would flicker.
TEST_F(Shapes, NoTwoFacesCoincide) {
  constexpr double kApartMm = 0.15, kSameDirection = 0.995, kSpotMm2 = 12.0;
  for (const std::string& id : robotIds()) {
    const RobotModel robot = loadRobot(id);
    std::vector<Isometry3d> poses;
    robot.kinematics->linkPoses(restOf(robot), poses);
    std::vector<geometry::TriangleMesh> meshes;
    std::vector<Eigen::AlignedBox3d> boxes;
    for (const ShapeSolid& solid : lookOf(robot).solids) {
      meshes.push_back(meshOf(solid.loft).mesh);
      for (Vector3d& v : meshes.back().vertices)
        v = poses[static_cast<std::size_t>(solid.frame)] * v;
      boxes.push_back(geometry::bounds(meshes.back()));
    }
    for (std::size_t b = 0; b < meshes.size(); ++b) {
      const geometry::MeshQuery query(meshes[b], geometry::MeshQuery::Of::Surface);
      for (std::size_t a = 0; a < meshes.size(); ++a) {
        if (a == b || !boxes[a].intersects(boxes[b]))
          continue;
        double area = 0.0;
        for (std::size_t t = 0; t < meshes[a].triangles.size(); ++t) {
          const Vector3d middle =
              (meshes[a].corner(t, 0) + meshes[a].corner(t, 1) + meshes[a].corner(t, 2)) / 3.0;
          const auto there = query.closest(middle, kApartMm);
          if (there.triangle >= 0 &&
              geometry::triangleNormal(meshes[a], t)
                      .dot(geometry::triangleNormal(
                          meshes[b], static_cast<std::size_t>(there.triangle))) > kSameDirection)
            area += geometry::triangleArea(meshes[a], t);
        }
        EXPECT_LT(area, kSpotMm2) << id << ": solids " << a << " and " << b;
      }
    }
  }
}

TEST_F(Shapes, ErrorsNameTheFault) {
  const auto complaint = [](const std::string& solid) {
    const std::string text =
        R"({"shape": {"colours": {"white": "#ffffff"}, "solids": [)" + solid + "]}}";
    try {
      readArmShape(base::JsonNode::parse(text, "arm.json").at("shape"), 6);
    } catch (const base::Error& error) {
      return base::english(error.whole());
    }
    return std::string();
  };
  const std::string line = R"("fromMm": [0, 0, 0], "axis": [0, 0, 1])";
  using ::testing::HasSubstr;
  EXPECT_EQ(complaint(R"({"frame": 1, "colour": "white", )" + line +
                      R"(, "turnedMm": [[0, 5], [9, 5]]})"),
            "");
  EXPECT_THAT(complaint(R"({"frame": 7, "colour": "white", )" + line +
                        R"(, "turnedMm": [[0, 5], [9, 5]]})"),
              HasSubstr("frame"));
  EXPECT_THAT(
      complaint(R"({"frame": 1, "colour": "pink", )" + line + R"(, "turnedMm": [[0, 5], [9, 5]]})"),
      HasSubstr("'pink'"));
  EXPECT_THAT(complaint(R"({"frame": 1, "colour": "white", )" + line +
                        R"(, "turnedMm": [[9, 5], [0, 5]]})"),
              HasSubstr("before the previous one"));
  EXPECT_THAT(complaint(R"({"frame": 1, "colour": "white", )" + line +
                        R"(, "across": [1, 0, 0], "sectionsMm": [[0, [[0, 0, 9], [1, 0, 2]]],)"
                        R"( [9, [[0, 0, 9], [1, 0, 2]]]]})"),
              HasSubstr("a disc inside another"));
}

// The nozzle's tip is the tool frame's origin, and the head fills its solids without leaving them.
TEST_F(Shapes, TheHeadEndsAtTheToolsTip) {
  Body head{"head", BodyRole::Head, 9, {}};
  head.shapes = {Frustum{{0, 0, 0}, {0, 0, -12}, 0.9, 6}, Frustum{{0, 0, -12}, {0, 0, -45}, 10, 10},
                 Frustum{{0, 0, -45}, {0, 0, -110}, 22, 22}};
  const std::vector<ShapeSolid> solids = toolShape(head);
  expectClean(solids, "head");
  double lowest = -1e9, beyond = 0.0;
  for (const ShapeSolid& solid : solids) {
    EXPECT_EQ(solid.frame, 9);
    for (const Vector3d& v : meshOf(solid.loft).mesh.vertices) {
      lowest = std::max(lowest, v.z());
      double nearest = std::numeric_limits<double>::infinity();
      for (const Shape& shape : head.shapes)
        nearest = std::min(nearest, test::signedDistance(v, shape));
      beyond = std::max(beyond, nearest);
    }
  }
  EXPECT_NEAR(lowest, 0.0, 1e-9);
  EXPECT_LT(beyond, 1.0);
}

TEST(PlanningText, LeavesTheShapeOut) {
  EXPECT_EQ(planningText("{\n  \"id\": \"a\",\n  \"shape\": {\"solids\": [1, \"}\"]}\n}\n"),
            "{\n  \"id\": \"a\"\n}\n");
  EXPECT_EQ(planningText(R"({"id": "a", "shape": {}, "b": [1, 2]})"),
            R"({"id": "a", "b": [1, 2]})");
  for (const char* text :
       {R"({"id": "shape", "links": [{"shape": 1}]})", R"({"shape": 1})", "", "{"})
    EXPECT_EQ(planningText(text), text);
}

} // namespace
} // namespace voluta::robot
