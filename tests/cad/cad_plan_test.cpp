// A CAD file on its road to a checked program.
#include "cad_solids.h"
#include "helpers/temporary_folder.h"
#include "pipeline/road.h"
#include "project/cad_parts.h"
#include "project/report.h"

#include <gtest/gtest.h>

namespace voluta {
namespace {

TEST(CadPlan, AStepFileIsPlannedToAProgram) {
  const test::TemporaryFolder folder;
  test::writeCad({test::boxWithHoles()}, test::CadFormat::Step, "INCH", folder / "box.step");
  const geometry::Tessellation facets = geometry::tessellationFor(1.2);
  pipeline::PlanRequest request;
  request.item().loaded =
      project::loadParts((folder / "box.step").string(), true, facets, {}).front().part;
  request.choices.item().mode = "flat";
  request.choices.item().scale = "0.5";
  request.choices.formats = {"urscript"};
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  EXPECT_EQ(result.job.report.item().model.file, "box.step");
  EXPECT_TRUE(result.job.report.item().model.watertight);
  EXPECT_TRUE(pipeline::nothingBlocks(result.job.report));
}

} // namespace
} // namespace voluta
