// The cover of a part does not depend on the size of its mesh's facets: the curved bar of Dai
// 5.4.2.
#include "helpers/given_parameters.h"
#include "pipeline/checked_program.h"
#include "pipeline/road.h"
#include "project/loaded_part.h"

#include "base/files.h"
#include "base/run_context.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/temporary_folder.h"
#include "project/specimens.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <vector>

namespace voluta::pipeline {
namespace {

// Plans the bar on its mould, both with facets of that size, in seven layers.
double coveredBar(double facetDeg, const std::filesystem::path& folder) {
  base::writeFile(folder / "mould.stl",
                  geometry::writeStl(project::mouldOfCurvedSpecimen(facetDeg)));
  PlanRequest request;
  request.item().loaded = project::loadedFrom(
      "bar.stl", std::make_shared<geometry::TriangleMesh>(project::curvedSpecimen(facetDeg)), {},
      true, {});
  request.choices.formats = {"gcode-extended"};
  request.choices.item().mode = "substrate";
  request.choices.item().platform = project::Platform("mesh:" + (folder / "mould.stl").string());
  test::giveParameters(request.choices, {{"layerHeightMm", "0.6"}, {"output.proof", "false"}});
  const PlanResult plan = planPart(request, {});
  EXPECT_TRUE(plan.checked.at(0)->verdict.passed) << facetDeg;
  return plan.checked[0]->verdict.coveredFraction;
}

TEST(Facets, DoNotDecideWhetherABarIsCovered) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  const test::TemporaryFolder folder;
  std::vector<double> covered;
  for (const double facetDeg : {1.3, 1.0, 0.5, 0.25})
    covered.push_back(coveredBar(facetDeg, folder.path()));
  const auto [minimum, maximum] = std::ranges::minmax(covered);
  EXPECT_GT(minimum, 0.985);
  EXPECT_LT(maximum - minimum, 0.003);
}

} // namespace
} // namespace voluta::pipeline
