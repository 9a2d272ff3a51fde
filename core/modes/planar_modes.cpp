#include "modes/planar_modes.h"

#include "base/error.h"
#include "base/filled_file.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "layers/support_rules.h"
#include "modes/growth_plate.h"
#include "modes/level_choices.h"
#include "modes/mode_stages.h"
#include "modes/part_voxels.h"
#include "modes/piece_search.h"
#include "modes/planar_platform.h"
#include "plan/finding_kinds.h"
#include "planar/flat.h"
#include "planar/given_cuts.h"
#include "planar/search/beam_search.h"
#include "planar/slicing/slicing.h"
#include "planar/slicing/uniform_misses.h"
#include "planar/slicing/user_planes.h"
#include "project/report.h"
#include "support/supports.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <utility>
#include <variant>

namespace voluta::modes {

namespace {

// Slicing options, and given planes as JSON in the order in which they cut; empty if none are
// given.
struct SlicePlan {
  planar::SliceOptions options; // without the plate
  std::string planes;
};

SlicePlan slicePlan(const ModeChoices& in) {
  planar::SliceOptions options;
  options.heights.wantedMm = in.process.layerHeightMm;
  options.heights.minMm = in.process.layerHeightMinMm;
  options.heights.maxMm = in.process.layerHeightMaxMm;
  options.heights.adaptive = in.values.boolean("adaptiveLayers");
  options.heights.cuspMm = in.values.number("cuspMm");
  options.heights.firstMm = firstLayerMm(in);
  options.beadWidthMm = in.process.beadWidthMm;
  options.edgeMm = std::max(options.edgeMm, in.process.beadWidthMm / 1.2);
  options.supports = support::supportRule(in.values);
  options.sizes = {in.process.scaleX, in.process.scaleY, in.process.outlineOffsetMm,
                   in.process.holeOffsetMm};
  options.overhangRad = riskRule(in).overhangRad;
  return {options, {}};
}

std::string givenPlanes(const ModeChoices& in, const char* key) {
  return planesText(in.values.text(key));
}

// Two walls around a pocket hold the pressure of its shot.
planar::StitchRule stitchRule(const ModeChoices& in) {
  constexpr double kWalls = 2.0;
  return {in.values.number("stitchSpacing"), in.values.number("stitchDiameter"),
          in.values.text("stitchShape") == "cone" ? planar::PocketShape::Cone
                                                  : planar::PocketShape::Dovetail,
          static_cast<int>(in.values.integer("stitchLayers")), kWalls * in.process.beadWidthMm};
}

SlicePlan flatSlicePlan(const ModeChoices& in) {
  SlicePlan plan = slicePlan(in);
  plan.planes = givenPlanes(in, "layerPlanes");
  plan.options.stitches = stitchRule(in);
  if (plan.options.stitches.makesPockets() && !plan.planes.empty())
    throw base::Error(base::ErrorCode::Usage, "stitches need horizontal layers"_text,
                      "stitchSpacing"_name, "set `stitchSpacing=0`, or give no `layerPlanes`"_text);
  return plan;
}

// Parses "white PLA, red PLA": one material per piece, starting over if there are more pieces.
// Returns the process's material if none is named.
std::vector<std::string> materialsOf(const ModeChoices& in) {
  std::vector<std::string> materials;
  const std::string text = in.values.text("pieceMaterials") + ",";
  for (std::size_t from = 0, to = 0; (to = text.find(',', from)) != std::string::npos;
       from = to + 1) {
    const std::string name = text.substr(from, to - from);
    const std::size_t first = name.find_first_not_of(' '), last = name.find_last_not_of(' ');
    if (first != std::string::npos)
      materials.push_back(name.substr(first, last - first + 1));
  }
  if (materials.empty())
    materials.push_back(in.process.material.label);
  return materials;
}

void reportPieces(const planar::PlanarDecomposition& d, const planar::RiskRule& rule,
                  const std::vector<std::string>& materials, DecomposeStage& stage) {
  project::DecompositionReport& r = stage.report;
  r.pieces = static_cast<int>(d.pieces.size());
  r.riskyAreaMm2 = d.riskyMm2;
  r.riskyAreaBeforeMm2 = d.riskyBeforeMm2;
  for (std::size_t i = 0; i < d.pieces.size(); ++i) {
    const planar::Piece& piece = d.pieces[i];
    r.pieceList.push_back({piece.parent, geometry::volume(piece.solid.mesh),
                           planar::riskyArea(piece, rule), piece.base.normal,
                           materials[i % materials.size()]});
  }
  stage.findings.insert(stage.findings.end(), d.findings.begin(), d.findings.end());
}

struct PiecesPlan {
  planar::RiskRule rule;
  process::HeadShape head;
  planar::PlanarPlatform carrier; // without the plate
  project::Platform platform;
  std::vector<std::string> materials;
  std::string cuts;        // given cuts, instead of a search
  double cutWidthMm = 0.0; // width of the given cuts
  PieceSearch search;
};

PiecesPlan piecesPlan(const ModeChoices& in) {
  PiecesPlan plan{riskRule(in),
                  process::erodedHead(in.process.head, in.process.contactToleranceMm),
                  carrierOf(in.choices, in.process),
                  in.choices.item().platform,
                  materialsOf(in),
                  givenPlanes(in, "cutPlanes"),
                  0.0,
                  {}};
  if (plan.cuts.empty())
    plan.search = pieceSearch(in.values);
  else
    plan.cutWidthMm = in.process.beadWidthMm;
  return plan;
}

// The finding has no position: the motion stage reports the waypoints concerned.
plan::Finding blockedPieces(const planar::PlanarDecomposition& d) {
  return plan::makeFinding(plan::FindingKind::BlockedPieces,
                           {{"blocked", d.blockedPieces}, {"pieces", d.pieces.size()}},
                           std::nullopt, d.blockedPieces);
}

// The pieces that are printed on the plate may have a much smaller base area than the whole part,
// and they hold all other pieces.
std::optional<plan::Finding> smallFoot(const geometry::TriangleMesh& part,
                                       const std::vector<planar::Piece>& pieces,
                                       const planar::RiskRule& rule) {
  constexpr double kMinShare = 0.5;
  const double whole = planar::baseArea(planar::wholePart(part, rule), rule);
  double left = 0.0;
  std::optional<Eigen::Vector3d> foot;
  for (const planar::Piece& piece : pieces)
    if (piece.baseTag == planar::kPlate) {
      if (!foot)
        foot = geometry::bounds(piece.solid.mesh).center();
      left += planar::baseArea(piece, rule);
    }
  if (!foot || left >= kMinShare * whole)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::SmallFoot,
                           {{"foot", base::mm2(left)}, {"whole", base::mm2(whole)}}, foot);
}

std::shared_ptr<const DecomposeStage>
decomposePlanar(const PiecesPlan& plan, const DecomposeInput& input, const base::RunContext& ctx) {
  const base::Stopwatch watch;
  auto stage = std::make_shared<DecomposeStage>();
  planar::PlanarOptions options;
  options.rule = plan.rule;
  options.head = plan.head;
  options.platform = planarPlatform(plan.carrier, plan.platform, input.placed.platform);
  const auto pieces = std::make_shared<planar::PlanarDecomposition>(
      plan.cuts.empty() ? searchPieces(*input.placed.part, options, plan.search, ctx)
                        : planar::decomposeByCuts(*input.placed.part,
                                                  planar::readGivenCuts(plan.cuts, "cutPlanes"),
                                                  options, plan.cutWidthMm, ctx));
  stage->platform = planar::plateOf(pieces->pieces, options);
  if (stage->platform.polygon.size() < 3)
    throw base::Error(base::ErrorCode::UnusableInput, "the part does not touch the plate"_text, {},
                      "drop it to the plate"_text);
  reportPieces(*pieces, plan.rule, plan.materials, *stage);
  const plan::Findings left =
      planar::overhangFindings(pieces->pieces, options.rule, planar::Overhangs::Pieces);
  stage->findings.insert(stage->findings.end(), left.begin(), left.end());
  if (const auto foot = smallFoot(*input.placed.part, pieces->pieces, options.rule))
    stage->findings.push_back(*foot);
  if (pieces->blockedPieces > 0)
    stage->findings.push_back(blockedPieces(*pieces));
  stage->result = project::Pieces(pieces);
  stage->timings.decompose = watch.seconds();
  return stage;
}

struct FlatPlan {
  double voxelMm;
  // Outside of regions. Supports carry missed voxels; the layers stage reports those they cannot.
  layers::SupportRule supports;
  planar::RiskRule rule;
  project::Platform platform;
  std::vector<std::string> materials;
};

FlatPlan flatPlan(const ModeChoices& in) {
  return {in.values.number("voxelMm"), support::supportRule(in.values), riskRule(in),
          in.choices.item().platform, materialsOf(in)};
}

plan::Finding uniformMissesFinding(const planar::UniformMisses& misses,
                                   const voxel::SolidVoxels& solid) {
  std::optional<Eigen::Vector3d> where;
  for (std::size_t c = 0; c < misses.missed.size() && !where; ++c)
    if (misses.missed[c] != 0) {
      const Eigen::Vector3i cell = solid.grid.cell(c);
      where = solid.grid.centre(cell.x(), cell.y(), cell.z());
    }
  const double share = static_cast<double>(misses.count) / static_cast<double>(solid.count);
  return plan::makeFinding(
      plan::FindingKind::UniformMisses,
      {{"share", base::percent(100.0 * share)}, {"missed", misses.count}, {"voxels", solid.count}},
      where, misses.count);
}

std::shared_ptr<const DecomposeStage>
decomposeFlat(const FlatPlan& plan, const DecomposeInput& input, const base::RunContext& ctx) {
  auto stage = std::make_shared<DecomposeStage>();
  ctx.report(0.0, "voxelise"_text);
  const std::shared_ptr<const PartVoxels> part = input.voxels(plan.voxelMm, ctx.sub(0.0, 0.8));
  const voxel::SolidVoxels& solid = *part->voxels;
  stage->timings.voxelise = part->seconds;
  stage->platform = plateOf(plan.platform, solid, input.placed.platform);

  const base::Stopwatch watch;
  const auto pieces = std::make_shared<planar::PlanarDecomposition>(
      planar::flatDecomposition(*input.placed.part, plan.rule));
  reportPieces(*pieces, plan.rule, plan.materials, *stage);
  const planar::UniformMisses misses = planar::uniformMisses(solid);
  const layers::SupportRules rules(
      input.supports ? input.supports->places : std::vector<layers::SupportPlace>(), plan.supports);
  const auto isCarried = [&](const Eigen::Vector3d& at) {
    return rules.at(at) != layers::SupportRule::None;
  };
  const planar::UniformMisses left =
      misses.count > 0 ? planar::uniformMisses(solid, isCarried) : misses;
  project::DecompositionReport& r = stage->report;
  r.voxelMm = solid.grid.pitch;
  r.voxels = solid.count;
  r.missedVoxels = misses.count;
  r.missedAfterSupports = left.count;
  if (left.count > 0)
    stage->findings.push_back(uniformMissesFinding(left, solid));
  stage->result = project::Pieces(pieces);
  stage->timings.decompose = watch.seconds();
  return stage;
}

std::shared_ptr<const LayersStage> layersFrom(planar::SliceResult sliced) {
  auto stage = std::make_shared<LayersStage>();
  stage->report = sliced.statistics;
  stage->findings = std::move(sliced.findings);
  stage->supportVolumeMm3 = sliced.supportVolumeMm3;
  stage->timings.extract = sliced.seconds.extract;
  stage->layers = layers::kept(std::move(sliced.stack));
  return stage;
}

std::shared_ptr<const LayersStage> sliced(const SlicePlan& plan, const DecomposeStage& decomposed,
                                          const LayersInput& input, const base::RunContext& ctx) {
  planar::SliceOptions options = plan.options;
  options.plate = decomposed.platform.polygon;
  return layersFrom(plan.planes.empty()
                        ? planar::slicePieces(std::get<project::Pieces>(decomposed.result)->pieces,
                                              options, ctx, input.supports)
                        : planar::sliceByPlanes(input.part,
                                                planar::readUserPlanes(plan.planes, "layerPlanes"),
                                                options, ctx));
}

} // namespace

Mode planarMode() {
  Mode mode{"planar",
            "Planar pieces"_text,
            {piecesPlan, decomposePlanar},
            {slicePlan, sliced},
            project::ResultKind::InPieces,
            {"overhangAngle", "pieceMaterials", "cutPlanes", "planarScheme", "pieceClusters",
             "pieceRoot", "adaptiveLayers", "cuspMm", "firstLayerMm", "supports"}};
  mode.cuts = true;
  return mode;
}

Mode flatMode() {
  Mode mode = {"flat",
               "Flat layers"_text,
               {flatPlan, decomposeFlat},
               {flatSlicePlan, sliced},
               project::ResultKind::InPieces,
               {"voxelMm", "overhangAngle", "pieceMaterials", "adaptiveLayers", "cuspMm",
                "firstLayerMm", "layerPlanes", "supports", "stitchSpacing", "stitchDiameter",
                "stitchShape", "stitchLayers"}};
  mode.upright = true;
  return mode;
}

base::ParameterTable planarModeParameters() {
  base::ParameterTable table({
      base::numberParameter("overhangAngle", "deg", 45.0, 0.0, 80.0, "Layers"_text,
                            "overhang angle"_text,
                            "Largest overhang, measured from the vertical, that prints "
                            "without support; in all modes except curved."_text,
                            true),
      base::textParameter(
          "pieceMaterials", "Pieces"_text, "piece materials"_text,
          "Mode planar: materials or filaments of the pieces, separated by commas. The "
          "list starts over if there are more pieces. Empty: the process's material."_text),
      base::withFile(base::textParameter(
                         "cutPlanes", "Pieces"_text, "cutting planes"_text,
                         "Mode planar: a JSON file or JSON text with a point and a normal for each "
                         "cutting plane, in cutting order. Empty: automatic."_text),
                     {"*.json", "", planesText}),
      base::booleanParameter("adaptiveLayers", false, "Layers"_text, "adaptive layers"_text,
                             "Modes planar and flat: thinner layers where the surface is "
                             "inclined, within the process's limits."_text),
      base::numberParameter("cuspMm", "mm", 0.3, 0.05, 20.0, "Layers"_text, "step height"_text,
                            "Adaptive layers: largest distance between the edges of "
                            "layers and the surface."_text),
      base::withFile(
          base::textParameter(
              "layerPlanes", "Layers"_text, "layer planes"_text,
              "Mode flat: a JSON file or JSON text with the plane or quadrilateral of each "
              "layer. Empty: horizontal layers."_text),
          {"*.json", "", planesText}),
      base::numberParameter("stitchSpacing", "mm", planar::StitchRule{}.spacingMm, 0.0, 1000.0,
                            "Stitches"_text, "spacing of stitches"_text,
                            "Mode flat: distance of pockets that are filled from above in one shot "
                            "and lock the layers together. 0: none."_text),
      base::numberParameter("stitchDiameter", "mm", planar::StitchRule{}.diameterMm, 2.0, 200.0,
                            "Stitches"_text, "diameter of stitches"_text,
                            "Diameter of a pocket where it is widest. Its opening is half of it "
                            "wide."_text),
      base::choiceParameter("stitchShape", "dovetail",
                            {{"dovetail", "dovetail"_text}, {"cone", "cone"_text}}, "Stitches"_text,
                            "shape of stitches"_text,
                            "Dovetail: chamber, cone and opening, three quarters of the diameter "
                            "high. Cone: half of the diameter high."_text),
      base::integerParameter("stitchLayers", planar::StitchRule{}.everyLayers, 2, 10000,
                             "Stitches"_text, "stitches after every n-th layer"_text,
                             "Pockets end at the top of these layers."_text),
  });
  table.append(pieceSearchParameters());
  return table;
}

planar::RiskRule riskRule(const ModeChoices& in) {
  planar::RiskRule rule;
  rule.overhangRad = base::degreesToRadians(in.values.number("overhangAngle"));
  rule.contactMm = 0.5 * in.process.layerHeightMm;
  return rule;
}

std::string planesText(const std::string& value) {
  if (value.empty())
    return value;
  const std::size_t first = value.find_first_not_of(" \t\r\n");
  if (first != std::string::npos && value[first] == '[')
    return value;
  std::string text = base::readFilledFile(value);
  planar::readUserPlanes(text, value); // Names the file in errors
  return text;
}

} // namespace voluta::modes
