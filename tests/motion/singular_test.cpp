// Straight motions keep to one side of the arm's singular poses, as a controller does that follows
// them: the cell "irb1200-moving" with a straight nozzle, whose wrist is stretched where the nozzle
// leans as the forearm.
#include "base/run_context.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "motion/motion.h"
#include "motion/motion_options.h"
#include "motion/motion_scene.h"
#include "motion/nozzle_frame.h"
#include "motion/sample_plans.h"
#include "process/tooling.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numeric>

using namespace voluta;
using Eigen::Isometry3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

// A line across which the nozzle leans back to the arm, further and further, and a little aside.
plan::ToolPlan leaningBack(double fromDeg, double toDeg, double offset) {
  plan::ToolPlan plan;
  std::vector<Vector3d> points, directions;
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i) {
    const double lean = base::degreesToRadians(fromDeg + (toDeg - fromDeg) * i / kSteps);
    points.emplace_back(i - 0.5 * kSteps, 0.0, 40.0);
    directions.push_back(Vector3d(-std::sin(lean), offset, std::cos(lean)).normalized());
  }
  test::appendPath(plan, points, directions, 0);
  return plan;
}

class Singular : public testing::Test {
protected:
  process::Process process_ = process::loadProcess("fdm-1.0");
  robot::Cell cell_ = straightNozzle(process_);

  static robot::Cell straightNozzle(const process::Process& process) {
    nlohmann::json cell = nlohmann::json::parse(
        std::ifstream(VOLUTA_SOURCE_DIR "/resources/cells/irb1200-moving.json"));
    cell["nozzle"]["pose"] = {{"xyzMm", {0, 0, 200}}};
    cell["nozzle"]["holder"] = nlohmann::json::parse(
        R"([{"frustum": {"p0Mm": [0, 0, -110], "p1Mm": [0, 0, -175], "r0Mm": 20, "r1Mm": 20}}])");
    cell["platform"]["pose"]["xyzMm"] = {500, 0, 120};
    cell["platform"]["stem"][0]["frustum"]["p0Mm"] = {0, 0, -150};
    cell["homeDeg"] = {0.0, 28.8, -1.5, 0.0, 62.7, 0.0};
    return robot::Cell::readText(cell.dump(), "irb1200-moving.json", process, plate());
  }
  static platform::PlatformSolid plate() {
    platform::PlatformSolid solid;
    solid.polygon = test::disc(20.0);
    return solid;
  }

  // As a controller follows a straight motion: in small steps, each time the joints next to those
  // before. How far from `to` it ends, rad.
  double endsBeside(const JointVector& from, const JointVector& to) const {
    const Isometry3d a = cell_.work_T_tool(from), b = cell_.work_T_tool(to);
    std::vector<JointVector> solutions;
    JointVector q = from;
    constexpr int kSteps = 400;
    for (int k = 1; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      Isometry3d pose = Isometry3d::Identity();
      pose.translation() = (1.0 - t) * a.translation() + t * b.translation();
      pose.linear() = Quaterniond(a.linear()).slerp(t, Quaterniond(b.linear())).toRotationMatrix();
      cell_.inverse(pose, q, solutions);
      const auto away = [&](const JointVector& s) { return (s - q).norm(); };
      if (solutions.empty())
        return base::kPi;
      q = *std::min_element(
          solutions.begin(), solutions.end(),
          [&](const JointVector& s, const JointVector& u) { return away(s) < away(u); });
    }
    return (q - to).cwiseAbs().maxCoeff();
  }
};

} // namespace

// Joints next to those before lead from one side of the stretched wrist to the other, past which
// the controller would have to turn joint 4 by half a turn at once.
TEST_F(Singular, TheNearestJointsMayBeOnTheOtherSide) {
  for (const double offset : {0.0, 1e-3}) {
    const plan::ToolPlan plan = leaningBack(12.5, 42.5, offset);
    const collision::CellCollision collision(cell_, process_);
    const collision::GrowingPart part(plan, 1.0, {});
    const motion::MotionOptions options;
    const motion::MotionScene scene{plan, cell_, collision, part, options};
    std::vector<JointVector> scratch;
    motion::RobotState at{plan.position[0], motion::uprightTool(), cell_.home()};
    int changed = 0;
    for (std::size_t i = 0; i < plan.waypointCount(); ++i) {
      const motion::RobotState last = at;
      at.tip = plan.position[i];
      at.tool = motion::carried(at.tool, plan.direction[i]);
      if (!motion::solveNear(cell_, at.tip, at.tool, last.q, i == 0 ? 4.0 : 0.5, scratch, at.q))
        break;
      if (i == 0 || scene.sideOf(last.q) * scene.sideOf(at.q) >= 0)
        continue;
      ++changed;
      EXPECT_LT(at.q[4] * last.q[4], 0.0);
      EXPECT_EQ(scene.movesStraight(last, at), offset == 0.0) << i;
      EXPECT_EQ(endsBeside(last.q, at.q) < 1e-6, offset == 0.0) << i;
    }
    EXPECT_EQ(changed, 1) << offset;
  }
}

// Exactly through the stretched wrist in one go; past it with a millimetre or two left out at most.
TEST_F(Singular, PathsPassNoSingularPoseOnTheirWay) {
  for (const double offset : {0.0, 1e-3, -3e-3, 0.1}) {
    const plan::ToolPlan plan = leaningBack(12.5, 42.5, offset);
    const collision::GrowingPart part(plan, 1.0, {});
    const motion::MotionResult moved =
        motion::MotionPlanner(plan, cell_, process::Tooling(process_), part, {}).plan({});
    EXPECT_LE(moved.skipped.size(), std::abs(offset) > 0.0 && std::abs(offset) < 0.05 ? 2u : 0u)
        << "aside " << offset;
    const plan::Trajectory& t = moved.trajectory;
    for (std::size_t i = 1; i < t.pointCount(); ++i) {
      if (t.move[i] == plan::MoveKind::Joint)
        continue;
      const JointVector from = Eigen::Map<const Eigen::VectorXd>(t.at(i - 1), t.dof),
                        to = Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
      EXPECT_LT(endsBeside(from, to), 1e-6) << i << " aside " << offset;
    }
  }
}
