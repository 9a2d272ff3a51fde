#include "modes/planar_modes.h"

#include "base/error.h"
#include "base/files.h"
#include "base/stopwatch.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "modes/parameter_text.h"
#include "modes/piece_search.h"
#include "modes/planar_platform.h"
#include "modes/plate.h"
#include "plan/finding_kinds.h"
#include "planar/flat.h"
#include "planar/given_cuts.h"
#include "planar/search/beam_search.h"
#include "planar/slicing/slicing.h"
#include "planar/slicing/uniform_misses.h"
#include "planar/slicing/user_planes.h"
#include "project/content_hash.h"

#include <fmt/format.h>
#include <optional>

namespace voluta::modes {

namespace {

planar::SliceOptions sliceOptions(const ModeChoices& in,
                                  const std::vector<Eigen::Vector2d>& plate) {
  planar::SliceOptions options;
  options.heights.wantedMm = in.process.layerHeightMm;
  options.heights.minMm = in.process.layerHeightMinMm;
  options.heights.maxMm = in.process.layerHeightMaxMm;
  options.heights.adaptive = in.values.boolean("adaptiveLayers");
  options.heights.cuspMm = in.values.number("cuspMm");
  options.beadWidthMm = in.process.beadWidthMm;
  options.supports = in.values.text("supports") != "none";
  options.overhangRad = riskRule(in).overhangRad;
  options.plate = plate;
  return options;
}

// "white PLA, red PLA": one a piece, from the first again where there are more pieces; the
// process's where none is named.
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
    materials.push_back(in.process.material);
  return materials;
}

void tellPieces(const planar::PlanarDecomposition& d, const ModeChoices& in,
                DecomposeStage& stage) {
  project::DecompositionReport& r = stage.report;
  r.mode = in.choices.mode;
  r.pieces = static_cast<int>(d.pieces.size());
  r.riskyAreaMm2 = d.riskyMm2;
  r.riskyAreaBeforeMm2 = d.riskyBeforeMm2;
  const std::vector<std::string> materials = materialsOf(in);
  for (std::size_t i = 0; i < d.pieces.size(); ++i) {
    const planar::Piece& piece = d.pieces[i];
    r.pieceList.push_back({piece.parent, geometry::volume(piece.solid.mesh),
                           planar::riskyArea(piece, riskRule(in)), piece.base.normal,
                           materials[i % materials.size()]});
  }
  stage.findings.insert(stage.findings.end(), d.findings.begin(), d.findings.end());
}

std::string planesKey(const char* what, const std::string& planes) {
  return planes.empty() ? std::string()
                        : fmt::format("{} {}\n", what, project::contentHash(planesText(planes)));
}

std::string planarKey(const ModeChoices& in) {
  const std::string cuts = in.values.text("cutPlanes");
  return fmt::format("platform {}\n{}", in.choices.platform.text(), heightsText(in.process)) +
         headText(process::erodedHead(in.process.head, in.process.contactToleranceMm)) +
         carrierText(in.choices, in.process) +
         parameterText({"overhangAngle", "pieceMaterials"}, in.values) +
         (cuts.empty() ? pieceSearchKey(in.values) : planesKey("cuts", cuts));
}

// Motion says which waypoints.
plan::Finding blockedPieces(const planar::PlanarDecomposition& d) {
  return plan::makeFinding(plan::FindingKind::BlockedPieces,
                           {{"blocked", d.blockedPieces}, {"pieces", d.pieces.size()}},
                           std::nullopt, d.blockedPieces);
}

// What holds all pieces to the plate may be much less than what the part stands on.
std::optional<plan::Finding> smallFoot(const geometry::TriangleMesh& part,
                                       const std::vector<planar::Piece>& pieces,
                                       const planar::RiskRule& rule) {
  constexpr double kLeastShare = 0.5;
  const double whole = planar::baseArea(planar::wholePart(part, rule), rule);
  double left = 0.0;
  std::optional<Eigen::Vector3d> foot;
  for (const planar::Piece& piece : pieces)
    if (piece.baseTag == planar::kPlate) {
      if (!foot)
        foot = geometry::bounds(piece.solid.mesh).center();
      left += planar::baseArea(piece, rule);
    }
  if (!foot || left >= kLeastShare * whole)
    return std::nullopt;
  return plan::makeFinding(plan::FindingKind::SmallFoot,
                           {{"foot", base::mm2(left)}, {"whole", base::mm2(whole)}}, foot);
}

std::shared_ptr<const DecomposeStage> decomposePlanar(const DecomposeInput& input,
                                                      const base::RunContext& ctx) {
  const base::Stopwatch watch;
  const ModeChoices& in = input.choices;
  auto stage = std::make_shared<DecomposeStage>();
  planar::PlanarOptions options;
  options.rule = riskRule(in);
  options.head = process::erodedHead(in.process.head, in.process.contactToleranceMm);
  options.platform = planarPlatform(in.choices, in.process, input.placed.platform);
  const std::string cuts = in.values.text("cutPlanes");
  const auto pieces = std::make_shared<planar::PlanarDecomposition>(
      cuts.empty() ? searchPieces(*input.placed.part, options, in.values, ctx)
                   : planar::decomposeByCuts(*input.placed.part,
                                             planar::readGivenCuts(planesText(cuts), "cutPlanes"),
                                             options, in.process.beadWidthMm, ctx));
  stage->platform = planar::plateOf(pieces->pieces, options);
  if (stage->platform.polygon.size() < 3)
    throw base::Error(base::ErrorCode::UnusableInput, "the part does not touch the plate"_text, {},
                      "drop it to the plate"_text);
  tellPieces(*pieces, in, *stage);
  const plan::Findings left =
      planar::overhangFindings(pieces->pieces, options.rule, planar::Overhangs::Pieces);
  stage->findings.insert(stage->findings.end(), left.begin(), left.end());
  if (const auto foot = smallFoot(*input.placed.part, pieces->pieces, options.rule))
    stage->findings.push_back(*foot);
  if (pieces->blockedPieces > 0)
    stage->findings.push_back(blockedPieces(*pieces));
  stage->pieces = pieces;
  stage->timings.decompose = watch.seconds();
  return stage;
}

std::string flatKey(const ModeChoices& in) {
  return fmt::format("platform {}\n{}", in.choices.platform.text(), heightsText(in.process)) +
         parameterText({"overhangAngle", "voxelMm", "pieceMaterials"}, in.values);
}

plan::Finding uniformMissesFinding(const planar::UniformMisses& misses,
                                   const voxel::SolidVoxels& solid) {
  std::optional<Eigen::Vector3d> where;
  for (std::size_t c = 0; c < misses.missed.size() && !where; ++c)
    if (misses.missed[c] != 0) {
      const Eigen::Vector3i cell = solid.grid.cell(c);
      where = solid.grid.centre(cell.x(), cell.y(), cell.z());
    }
  return plan::makeFinding(plan::FindingKind::UniformMisses,
                           {{"missed", misses.count}, {"voxels", solid.count}}, where,
                           misses.count);
}

std::shared_ptr<const DecomposeStage> decomposeFlat(const DecomposeInput& input,
                                                    const base::RunContext& ctx) {
  const ModeChoices& in = input.choices;
  auto stage = std::make_shared<DecomposeStage>();
  ctx.report(0.0, "voxelise"_text);
  const std::shared_ptr<const PartVoxels> part = input.voxels(ctx.sub(0.0, 0.8));
  const voxel::SolidVoxels& solid = *part->voxels;
  stage->timings.voxelise = part->seconds;
  stage->platform = plateOf(in.choices.platform, solid, input.placed.platform);

  const base::Stopwatch watch;
  const auto pieces = std::make_shared<planar::PlanarDecomposition>(
      planar::flatDecomposition(*input.placed.part, riskRule(in)));
  tellPieces(*pieces, in, *stage);
  const planar::UniformMisses misses = planar::uniformMisses(solid);
  project::DecompositionReport& r = stage->report;
  r.voxelMm = solid.grid.pitch;
  r.voxels = solid.count;
  r.missedVoxels = r.missedAfterSupports = misses.count;
  if (misses.count > 0)
    stage->findings.push_back(uniformMissesFinding(misses, solid));
  stage->pieces = pieces;
  stage->timings.decompose = watch.seconds();
  return stage;
}

std::string sliceKey(const ModeChoices& in) {
  return fmt::format("{}bead width {}\n", heightsText(in.process), in.process.beadWidthMm) +
         parameterText({"adaptiveLayers", "cuspMm", "supports"}, in.values);
}

std::string flatLayersKey(const ModeChoices& in) {
  return sliceKey(in) + planesKey("planes", in.values.text("layerPlanes"));
}

std::shared_ptr<const LayersStage> layersFrom(planar::SliceResult sliced) {
  auto stage = std::make_shared<LayersStage>();
  stage->report = reportOf(sliced.statistics);
  stage->findings = std::move(sliced.findings);
  stage->supportVolumeMm3 = sliced.supportVolumeMm3;
  stage->timings.extract = sliced.seconds.extract;
  stage->layers = std::make_shared<layers::LayerStack>(std::move(sliced.stack));
  return stage;
}

std::shared_ptr<const LayersStage> planarLayers(const DecomposeStage& decomposed,
                                                const geometry::TriangleMesh&,
                                                const ModeChoices& in,
                                                const base::RunContext& ctx) {
  return layersFrom(planar::slicePieces(decomposed.pieces->pieces,
                                        sliceOptions(in, decomposed.platform.polygon), ctx));
}

std::shared_ptr<const LayersStage> flatLayers(const DecomposeStage& decomposed,
                                              const geometry::TriangleMesh& part,
                                              const ModeChoices& in, const base::RunContext& ctx) {
  const std::string planes = in.values.text("layerPlanes");
  if (planes.empty())
    return planarLayers(decomposed, part, in, ctx);
  return layersFrom(planar::sliceByPlanes(part,
                                          planar::readUserPlanes(planesText(planes), "layerPlanes"),
                                          sliceOptions(in, decomposed.platform.polygon), ctx));
}

} // namespace

Mode planarMode() {
  Mode mode{"planar", "Planar pieces"_text, planarKey, sliceKey, decomposePlanar, planarLayers};
  mode.parameters = {"overhangAngle",  "pieceMaterials", "cutPlanes",
                     "planarScheme",   "pieceClusters",  "pieceRoot",
                     "adaptiveLayers", "cuspMm",         "supports"};
  return mode;
}

Mode flatMode() {
  Mode mode{"flat", "Flat layers"_text, flatKey, flatLayersKey, decomposeFlat, flatLayers};
  mode.parameters = {"overhangAngle", "pieceMaterials", "adaptiveLayers",
                     "cuspMm",        "supports",       "layerPlanes"};
  return mode;
}

base::ParameterTable planarModeParameters() {
  base::ParameterTable table({
      base::numberParameter("overhangAngle", "deg", 45.0, 0.0, 80.0, "Layers"_text,
                            "overhang angle"_text,
                            "How far a face may lean over from the upright without support, in "
                            "every mode but curved."_text,
                            true),
      base::textParameter(
          "pieceMaterials", "Pieces"_text, "materials of pieces"_text,
          "Mode planar: a material or filament for each piece, separated by commas; from "
          "the first again where there are more pieces. Empty: the process's."_text),
      base::textParameter(
          "cutPlanes", "Pieces"_text, "cutting planes"_text,
          "Mode planar: a JSON file, or its text, with a point and a normal for each "
          "plane that cuts the part, in turn. Empty: they are searched for."_text),
      base::booleanParameter("adaptiveLayers", false, "Layers"_text, "adaptive layers"_text,
                             "Modes planar and flat: thinner layers where the surface leans, "
                             "within the process's limits."_text),
      base::numberParameter("cuspMm", "mm", 0.3, 0.05, 2.0, "Layers"_text, "step height"_text,
                            "Adaptive layers: how far the edges of layers may stand out of the "
                            "surface."_text),
      base::textParameter(
          "layerPlanes", "Layers"_text, "planes of layers"_text,
          "Mode flat: a JSON file, or its text, with the plane or quadrilateral of each "
          "layer. Empty: layers along z."_text),
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
  const std::size_t first = value.find_first_not_of(" \t\r\n");
  return first != std::string::npos && value[first] == '[' ? value : base::readFile(value);
}

} // namespace voluta::modes
