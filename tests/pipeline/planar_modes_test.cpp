// Modes planar and flat on the road.
#include "helpers/given_parameters.h"
#include "layers/layer_stack.h"
#include "modes/planar_modes.h"
#include "planar/planar_decomposition.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/octagon_prism.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "pipeline/outputs.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;

namespace {

using test::boxRequest;

base::RunContext context() {
  return base::RunContext(base::CancelToken(), 2);
}

PlanRequest request(const std::string& mode, Stage until = Stage::Layers) {
  PlanRequest r = boxRequest();
  r.choices.item().mode = mode;
  r.until = until;
  return r;
}

// A T: a leg of 8 x 8 x 12 with a bar of 32 x 8 x 8 on it.
std::shared_ptr<const LoadedPart> tee() {
  return loadedFrom("tee.stl", std::make_shared<geometry::TriangleMesh>(test::tee(12, 32)), {},
                    true, {});
}

int overhangsIn(const Report& report) {
  return static_cast<int>(std::ranges::count_if(report.findings, [](const plan::Finding& finding) {
    return plan::reportId(finding) == "overhang";
  }));
}

TEST(FlatMode, ABoxIsSlicedFromThePlateToItsTopAndPassesReplay) {
  const PlanResult result = planPart(request("flat", Stage::Replay), context());
  const Report& r = result.job.report;
  EXPECT_EQ(result.job.item().decomposition(), nullptr);
  ASSERT_NE(result.job.item().pieces(), nullptr);
  EXPECT_EQ(r.item().decomposition.mode, "flat");
  EXPECT_EQ(r.item().decomposition.pieces, 1);
  EXPECT_EQ(r.item().decomposition.missedVoxels, 0u);
  EXPECT_EQ(r.item().decomposition.riskyAreaMm2, 0.0);
  EXPECT_EQ(r.item().layers.count, 10);
  EXPECT_NEAR(r.item().layers.areaMm2, 3600.0, 1e-6);
  EXPECT_NEAR(r.item().layers.thicknessMeanMm, 0.8, 1e-9);
  EXPECT_TRUE(r.replay.passed);
  EXPECT_TRUE(nothingBlocks(r));
}

TEST(FlatMode, OverhangIsMeasuredInAreaAndInVoxels) {
  PlanRequest flat = request("flat");
  flat.item().loaded = tee();
  const PlanResult result = planPart(flat, context());
  const DecompositionReport& d = result.job.report.item().decomposition;
  EXPECT_NEAR(d.riskyAreaMm2, 2 * 12 * 8, 1e-6);
  EXPECT_EQ(d.riskyAreaBeforeMm2, d.riskyAreaMm2);
  EXPECT_GT(d.missedVoxels, 1000u);
  std::size_t misses = 0;
  for (const plan::Finding& f : result.job.report.findings)
    if (voluta::plan::reportId(f) == "uniformMisses") {
      misses += f.count;
      const std::string reason = voluta::plan::englishReason(f);
      EXPECT_TRUE(reason.starts_with("unsupported voxels in flat layers: " +
                                     std::to_string(f.count) + " of "))
          << reason;
      EXPECT_TRUE(reason.ends_with("no layer below carries them")) << reason;
    }
  EXPECT_EQ(overhangsIn(result.job.report), 2);
  EXPECT_EQ(misses, d.missedVoxels);
  // On its head it needs nothing.
  flat.choices.item().parameters["orient"] = "leastRisky";
  const PlanResult turned = planPart(flat, context());
  EXPECT_NEAR(turned.job.report.item().decomposition.riskyAreaMm2, 0.0, 1e-6);
  EXPECT_EQ(turned.job.report.item().decomposition.missedVoxels, 0u);
}

TEST(FlatMode, SupportsCarryOverhangsAndCountSeparately) {
  PlanRequest flat = request("flat", Stage::Replay);
  flat.item().loaded = tee();
  flat.choices.item().platform = project::Platform("fit:15");
  flat.choices.formats = {"urscript"};
  setParameters(flat.choices, {"supports=auto"});
  const PlanResult result = planPart(flat, context());
  const Report& r = result.job.report;
  // Two columns of 12 x 8 x 12 less the gap to the leg, which taper to trunks.
  EXPECT_LT(r.item().decomposition.supportVolumeMm3, 0.7 * 2 * 11.7 * 8 * 12);
  EXPECT_GT(r.item().decomposition.supportVolumeMm3, 2 * 4.8 * 4.8 * 12);
  EXPECT_NEAR(r.item().layers.areaMm2 * r.item().layers.thicknessMeanMm, 8 * 8 * 12 + 32 * 8 * 8,
              1e-3);
  EXPECT_EQ(r.replay.collisions, 0u);
  EXPECT_LT(r.replay.unsupportedFraction, 0.005);
  EXPECT_NEAR(r.replay.massRatio, 1.0, 0.03);
  EXPECT_EQ(overhangsIn(r), 0) << "both are supported";
}

// Overhangs of pieces are supported too. Layers along the user's planes have no supports, and the
// planes of another mode do not count.
TEST(PlanarModes, OverhangsWithoutSupportsGiveFindings) {
  const std::string under = R"([{"point": [0, 0, 6], "normal": [0, 0, 1]}])";
  const auto overhangs = [&](const char* mode, const std::vector<std::string>& parameters) {
    PlanRequest tees = request(mode);
    tees.item().loaded = tee();
    tees.choices.item().platform = project::Platform("fit:15");
    setParameters(tees.choices, parameters);
    return overhangsIn(planPart(tees, context()).job.report);
  };
  const std::string cut = "cutPlanes=" + under, layers = "layerPlanes=" + under;
  EXPECT_GT(overhangs("planar", {cut, "supports=none"}), 0);
  EXPECT_EQ(overhangs("planar", {cut, "supports=auto"}), 0);
  EXPECT_EQ(overhangs("planar", {cut, "supports=auto", layers}), 0);
  EXPECT_GT(overhangs("flat", {layers, "supports=auto"}), 0);
}

TEST(FlatMode, LayersAreOnThePlanesOfTheUser) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "planes.json",
                  R"([{"point": [0, 0, 0.4], "normal": [0, 0, 1]},
                      {"corners": [[-11, -10, 1.2], [0, -10, 1.2], [0, 10, 1.2], [-11, 10, 1.2]]},
                      {"point": [0, 0, 90], "normal": [0, 0, 1]}])");
  PlanRequest flat = request("flat");
  setParameters(flat.choices, {"layerPlanes=" + (folder / "planes.json").string()});
  EXPECT_EQ(flat.choices.item().parameters.at("layerPlanes").front(), '[')
      << "goes with the project";
  const PlanResult result = planPart(flat, context());
  EXPECT_EQ(result.job.report.item().layers.count, 2);
  EXPECT_NEAR(result.job.report.item().layers.areaMm2, 360.0 + 180.0, 1e-6);
  EXPECT_EQ(plan::reportId(result.job.report.findings.back()), "planeMisses");
  PlanRequest wrong = request("flat");
  wrong.choices.item().parameters["layerPlanes"] = (folder / "none.json").string();
  EXPECT_THROW(planPart(wrong, context()), base::Error);
  wrong.choices.item().parameters["layerPlanes"] = "[{}]";
  EXPECT_THROW(planPart(wrong, context()), base::Error);
}

// A file that states nothing usable is refused by its name, not taken for a text that was not
// given.
TEST(FlatMode, FilesOfParametersWithoutAValueAreRefused) {
  const test::TemporaryFolder folder;
  const auto refusalOf = [&](const std::string& key, const std::string& content) {
    base::writeFile(folder / "values.txt", content);
    project::Choices choices = request("flat").choices;
    try {
      setParameters(choices, {key + "=" + (folder / "values.txt").string()});
    } catch (const base::Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  const base::ParameterTable table = allParameters();
  for (const base::ParameterSpec& spec : table.specs()) {
    if (!spec.file.read)
      continue;
    for (const std::string content : {"", " \n"})
      EXPECT_THAT(refusalOf(spec.key, content),
                  ::testing::HasSubstr("values.txt: the file is empty"))
          << spec.key;
    EXPECT_THAT(refusalOf(spec.key, "hello"),
                ::testing::StartsWith((folder / "values.txt").string()))
        << spec.key;
  }
  EXPECT_THAT(refusalOf("layerPlanes", "{}"), ::testing::HasSubstr("not a JSON list"));
  EXPECT_EQ(refusalOf("layerPlanes", R"([{"point": [0, 0, 1], "normal": [0, 0, 1]}])"), "");
}

TEST(PlanarMode, ATeeComesInPiecesThatNeedNoSupport) {
  PlanRequest planar = request("planar");
  planar.item().loaded = tee();
  test::giveParameters(planar.choices,
                       {{"pieceMaterials", "white PLA, red PLA"}, {"output.debug", "true"}});
  PlanResult result = planPart(planar, context());
  ASSERT_NE(result.job.item().pieces(), nullptr);
  const DecompositionReport& d = result.job.report.item().decomposition;
  EXPECT_GT(d.pieces, 1);
  EXPECT_NEAR(d.riskyAreaBeforeMm2, 192.0, 1e-6);
  EXPECT_LT(d.riskyAreaMm2, 2.0);
  double volume = 0.0;
  for (std::size_t i = 0; i < d.pieceList.size(); ++i) {
    volume += d.pieceList[i].volumeMm3;
    EXPECT_EQ(d.pieceList[i].material, i % 2 == 0 ? "white PLA" : "red PLA");
    EXPECT_LT(d.pieceList[i].parent, static_cast<int>(i));
  }
  const double whole = 8 * 8 * 12 + 32 * 8 * 8;
  EXPECT_NEAR(volume, whole, 1e-6 * whole);
  EXPECT_NEAR(result.job.report.item().layers.areaMm2 *
                  result.job.report.item().layers.thicknessMeanMm,
              whole, 0.01 * whole);
  for (const layers::Patch& p : result.job.item().layers->patches)
    EXPECT_LT(p.group, d.pieces);

  const test::TemporaryFolder folder;
  writeOutputs(result, folder.path(), {});
  for (int i = 0; i < d.pieces; ++i)
    EXPECT_TRUE(std::filesystem::exists(folder / "pieces" / (std::to_string(i) + ".stl")));
  const Job back = readJob(folder / "job.voluta", allParameters());
  ASSERT_NE(back.item().pieces(), nullptr);
  EXPECT_EQ(back.item().pieces()->pieces.size(), result.job.item().pieces()->pieces.size());
  EXPECT_EQ(back.report.item().decomposition.pieceList.size(), d.pieceList.size());

  // The cuts that were found, given by the user.
  planar.choices.item().parameters.clear();
  setParameters(planar.choices, {"cutPlanes=" + (folder / "pieces/cuts.json").string()});
  EXPECT_EQ(planar.choices.item().parameters.at("cutPlanes").front(), '[')
      << "goes with the project";
  const PlanResult given = planPart(planar, context());
  EXPECT_EQ(given.job.report.item().decomposition.pieces, d.pieces);
  EXPECT_NEAR(given.job.report.item().decomposition.riskyAreaMm2, d.riskyAreaMm2, 1e-3);
  planar.choices.item().parameters["cutPlanes"] = R"([{"point": [0, 0, 90], "normal": [0, 0, 1]}])";
  EXPECT_THROW(planPart(planar, context()), base::Error);
}

} // namespace
