// A branching part that is dense along its pith (TreeD printing, Castelli 6.4.4).
#include "helpers/given_parameters.h"
#include "pipeline/checked_program.h"
#include "pipeline/road.h"
#include "plan/tool_plan.h"

#include "base/run_context.h"
#include "base/units.h"
#include "pipeline/plan_reasons.h"
#include "process/bead_model.h"
#include "project/loaded_part.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// A Y of three arms around the origin, standing on z = 0.
geometry::TriangleMesh treeY(double armMm, double widthMm, double heightMm) {
  std::vector<Vector2d> outline;
  const double inner = widthMm / std::sqrt(3.0);
  for (int k = 0; k < 3; ++k) {
    const double a = base::kTwoPi * k / 3.0 - 0.5 * base::kPi, notch = a + base::kPi / 3.0;
    const Vector2d along(std::cos(a), std::sin(a)), lateral(-along.y(), along.x());
    outline.push_back(armMm * along - 0.5 * widthMm * lateral);
    outline.push_back(armMm * along + 0.5 * widthMm * lateral);
    outline.emplace_back(inner * std::cos(notch), inner * std::sin(notch));
  }
  geometry::TriangleMesh mesh;
  for (const double z : {0.0, heightMm})
    for (const Vector2d& p : outline)
      mesh.vertices.emplace_back(p.x(), p.y(), z);
  const int n = static_cast<int>(outline.size());
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    mesh.triangles.push_back({k, next, next + n});
    mesh.triangles.push_back({k, next + n, k + n});
  }
  // The notches are corners 2, 5 and 8; each arm is between two of them.
  for (int k = 0; k < 3; ++k) {
    const int before = (3 * k + 8) % 9, right = 3 * k, left = right + 1, notch = right + 2;
    for (const auto& t : {std::array<int, 3>{before, right, left}, {before, left, notch}}) {
      mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
      mesh.triangles.push_back({t[0], t[2], t[1]});
    }
  }
  mesh.triangles.push_back({2 + n, 5 + n, 8 + n});
  mesh.triangles.push_back({2, 8, 5});
  return mesh;
}

TEST(TreeDPlans, AYIsDenseAlongItsPith) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  PlanRequest request;
  request.item().loaded = project::loadedFrom(
      "tree.stl", std::make_shared<geometry::TriangleMesh>(treeY(45.0, 26.0, 10.0)), {}, true, {});
  request.choices.formats = {"gcode-extended"};
  request.choices.item().mode = "flat";
  test::giveParameters(request.choices, {{"infillDensity", "0.3"},
                                         {"sparsePattern", "pith"},
                                         {"walls", "1"},
                                         {"topLayers", "0"},
                                         {"bottomLayers", "0"},
                                         {"output.proof", "false"}});
  const PlanResult plan = planPart(request, {});
  ASSERT_EQ(plan.checked.size(), 1u);
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << test::reasons(plan);
  // Of an arm's sparse lines, far from the branching: more within the middle third than outside.
  const plan::ToolPlan& beads = *plan.job.toolPlan;
  double middle = 0.0, outside = 0.0;
  for (const plan::ToolPath& path : beads.paths)
    for (std::size_t i = path.first + 1;
         i < path.first + path.count && path.kind == plan::PathKind::SparseInfill; ++i) {
      const Vector3d p = 0.5 * (beads.position[i] + beads.position[i - 1]);
      if (p.y() > -20.0)
        continue;
      (std::abs(p.x()) < 13.0 / 3.0 ? middle : outside) +=
          (beads.position[i] - beads.position[i - 1]).norm();
    }
  EXPECT_GT(middle, outside);
}

} // namespace
} // namespace voluta::pipeline
