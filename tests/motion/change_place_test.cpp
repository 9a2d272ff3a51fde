// Where tools are changed and nozzles purged: in every cell nothing drips on the print or the
// plate.
#include "motion/change_place.h"

#include "base/error.h"
#include "base/files.h"
#include "geometry/drop.h"
#include "motion/motion.h"
#include "motion/sample_plans.h"
#include "motion/sequence.h"
#include "plan/waypoints.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using Eigen::Vector3d;
using robot::JointVector;

namespace {

class ChangePlace : public testing::Test {
protected:
  process::Process process_ = process::loadProcess("fdm-1.0");
  plan::ToolPlan plan_ = test::slab(40.0, 3);
  motion::MotionOptions options_;

  template <typename Use> void with(const robot::Cell& cell, const Use& use) {
    const collision::CellCollision collision(cell, process_);
    const collision::GrowingPart part(plan_, 0.45, {});
    use(motion::MotionScene{plan_, cell, collision, part, options_, motion::leversOf(plan_, cell)});
  }
  robot::Cell cellOf(const std::string& choice) const {
    return robot::loadCell(choice, process_, test::disc(50.0));
  }
  static std::string withPlace(const char* cell, const std::vector<double>& mm) {
    nlohmann::json json = nlohmann::json::parse(
        base::readFile(base::resourceFolder() / "cells" / (std::string(cell) + ".json")));
    json["id"] = "with-place";
    json["purgeMm"] = mm;
    return json.dump();
  }
  static bool drops(const robot::Cell& cell, const JointVector& q, const Eigen::AlignedBox3d& on) {
    return geometry::dropMeets(cell.work_T_tool(q).translation(),
                               cell.base_T_work(q).linear().transpose() * -Vector3d::UnitZ(), on);
  }
};

TEST_F(ChangePlace, IsBesideThePlateInEveryCellWithAPlate) {
  std::size_t checked = 0;
  for (const std::string& id : robot::cellIds()) {
    if (id == "lathe")
      continue;
    SCOPED_TRACE(id);
    const robot::Cell cell = cellOf(id);
    ++checked;
    with(cell, [&](const motion::MotionScene& scene) {
      const auto places = motion::purgePlaces(scene, cell.home());
      ASSERT_FALSE(places.empty());
      Eigen::AlignedBox3d plate(Vector3d(-50, -50, -5), Vector3d(50, 50, 3));
      for (const motion::PurgePlace& place : places)
        EXPECT_FALSE(drops(cell, place.at, plate));
      EXPECT_FALSE(motion::dropsOnPart(scene, places.front().at));
      const auto trip = motion::purgeTrip(
          scene, motion::stateAt(cell, cell.home()), places,
          [&](const motion::RobotState& from, const motion::RobotState& to, bool isStraight) {
            const motion::TransferPlanner planner(scene);
            return isStraight ? planner.straight(from, to, 0) : planner.between(from, to, 0, 1, {});
          });
      ASSERT_TRUE(trip);
      ASSERT_FALSE(trip->back.empty());
      EXPECT_TRUE(trip->back.back().at.q.isApprox(cell.home()));
      if (cell.nozzleMount() != robot::Mount::Flange)
        return;
      // A moving nozzle is low, points down and wipes.
      const Eigen::Isometry3d base_T_tool =
          cell.base_T_work(places.front().at) * cell.work_T_tool(places.front().at);
      EXPECT_LT(base_T_tool.linear().col(2).z(), -0.999);
      const double up =
          base_T_tool.translation().z() - cell.base_T_work(cell.home()).translation().z();
      EXPECT_GE(up, 5.0);
      EXPECT_LE(up, 110.0);
    });
  }
  EXPECT_GE(checked, 15u);
}

TEST_F(ChangePlace, HomeAboveThePrintDropsOnIt) {
  const robot::Cell cell = cellOf("five-axis");
  with(cell, [&](const motion::MotionScene& scene) {
    EXPECT_TRUE(motion::dropsOnPart(scene, cell.home()));
  });
}

TEST_F(ChangePlace, TheCellsOwnPlaceIsTaken) {
  const robot::Cell cell = cellOf(withPlace("five-axis", {-150.0, -120.0, 60.0}));
  with(cell, [&](const motion::MotionScene& scene) {
    const auto places = motion::purgePlaces(scene, cell.home());
    ASSERT_FALSE(places.empty());
    const Vector3d tip =
        (cell.base_T_work(places[0].at) * cell.work_T_tool(places[0].at)).translation();
    EXPECT_TRUE(tip.isApprox(Vector3d(-150.0, -120.0, 60.0), 1e-6)) << tip.transpose();
  });
  const robot::Cell far = cellOf(withPlace("five-axis", {5000.0, 0.0, 0.0}));
  with(far, [&](const motion::MotionScene& scene) {
    const auto never = [](const motion::RobotState&, const motion::RobotState&,
                          bool) -> std::optional<motion::Transfer> { return std::nullopt; };
    EXPECT_THROW(motion::purgeTrip(scene, motion::stateAt(far, far.home()),
                                   motion::purgePlaces(scene, far.home()), never),
                 base::Error);
  });
  EXPECT_THROW(cellOf(withPlace("ur5-fixed", {0.0, 0.0, 0.0})), base::Error)
      << "the nozzle does not move";
}

// A print that begins with the second tool, and one without a priming bead.
TEST_F(ChangePlace, TheMotionBeginsWithTheToolOfItsFirstBead) {
  process::Tool tool{process_};
  const process::Tooling two({tool, tool});
  for (plan::ToolPath& path : plan_.paths)
    path.tool = 1;
  const robot::Cell cell = cellOf("ur5-moving");
  const collision::GrowingPart part(plan_, 0.45, {});
  motion::MotionOptions options;
  options.purge.primesBeside = true;
  const plan::Trajectory t =
      motion::MotionPlanner(plan_, cell, two, part, options).plan({}).trajectory;
  EXPECT_EQ(t.firstTool, 1);
  EXPECT_FALSE(t.changesTool());
  ASSERT_EQ(t.events.size(), 1u);
  EXPECT_EQ(t.events[0].kind, plan::EventKind::Purge);
  EXPECT_NEAR(t.events[0].volumeMm3, motion::primeMm3(process_), 1e-9);
  EXPECT_TRUE(plan::purgesFirst(t));
  EXPECT_FALSE(plan::primesAtStart(plan_, t));
  const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(t.at(t.events[0].point - 1), t.dof);
  EXPECT_FALSE(drops(cell, q, Eigen::AlignedBox3d(Vector3d(-50, -50, -5), Vector3d(50, 50, 3))));
}

} // namespace
