#include "pipeline/items/plate_parts.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/meshes_meet.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/cell_plate.h"
#include "pipeline/given_paths.h"
#include "pipeline/items/part_arrangement.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "project/loaded_part.h"

#include <algorithm>

namespace voluta::pipeline {

namespace {
bool isOnCellPlate(const project::ItemChoices& item) {
  return item.platform.isOfCell() || (item.automatic && !item.platformStays);
}

// Returns the footprint of a part with its own tool-paths, with the skirts among them.
Footprint footprintWithWaste(const project::LoadedPart& loaded, const modes::LoadStage& placed,
                             const Resolved& own, const base::RunContext& ctx) {
  const auto stage = givenToolpathStage(loaded, placed, own.tooling, ctx);
  const plan::ToolPlan& plan = *stage->toolPlan;
  geometry::TriangleMesh all = *placed.part;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; plan::isWaste(path.kind) && i < path.first + path.count; ++i)
      all.vertices.push_back(plan.position[i]);
  return footprintOf(all, mayLean(own.choices.item()));
}
} // namespace

bool mayLean(const project::ItemChoices& item) {
  return item.automatic || !modes::findMode(item.mode).upright;
}

PlanRequest withArrangedParts(PlanRequest request, const base::RunContext& ctx) {
  base::require(request.items.size() == request.choices.items.size(), "choices for each item");
  std::vector<Footprint> parts;
  std::vector<Eigen::Vector2d> centres;
  process::HeadShape head;
  ArrangeOptions options;
  options.order = request.choices.printOrder;
  for (std::size_t i = 0; i < request.items.size(); ++i) {
    RequestedItem& item = request.item(i);
    if (!item.loaded)
      item.loaded = project::loadPart(item.part, request.choices.item(i).repair, ctx);
    const project::Choices alone = project::onlyItem(request.choices, i);
    const bool isGiven = takesGivenPaths(*item.loaded, parameterValues(alone));
    const Resolved own = resolve(isGiven ? choicesForGivenPaths(alone) : strategyOrFirst(alone));
    const auto& [choices, values, process] = own.modeChoices();
    const auto placed = loadStage(*item.loaded, own, ctx);
    parts.push_back(isGiven ? footprintWithWaste(*item.loaded, *placed, own, ctx)
                            : footprintOf(*placed->part, mayLean(request.choices.item(i))));
    centres.push_back(placed->placement.centreMm);
    options.spareMm = std::max(options.spareMm, 2.0 * process.beadWidthMaxMm) +
                      2.0 * values.number("brimWidthMm");
    head = process.head;
    if (options.plate.empty() && isOnCellPlate(request.choices.item(i)))
      options.plate = largestPlate(fittingCell(choices, process));
  }
  const auto moves = arranged(parts, head, options);
  if (!moves)
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("the plate has no room for {parts} parts"_text, parts.size()),
                      {}, "print fewer or smaller parts, or use a cell with a larger plate"_text);
  for (std::size_t i = 0; i < parts.size(); ++i)
    request.choices.item(i).placement.centreMm = centres[i] + (*moves)[i];
  return request;
}

void nameItems(std::span<plan::Finding> findings, const std::vector<project::JobItem>& items,
               double marginMm) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const project::JobItem& item : items) {
    Eigen::AlignedBox3d box = geometry::bounds(*item.part);
    box.min().array() -= marginMm;
    box.max().array() += marginMm;
    boxes.push_back(box);
  }
  for (plan::Finding& finding : findings) {
    const auto isThere = [&](const Eigen::AlignedBox3d& box) {
      return box.contains(*finding.where);
    };
    if (finding.item < 0 && finding.where && std::ranges::count_if(boxes, isThere) == 1)
      finding.item = static_cast<int>(std::ranges::find_if(boxes, isThere) - boxes.begin());
  }
}

PrintSequence printSequence(const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& parts,
                            const project::Choices& choices, const process::Process& process) {
  std::vector<Footprint> footprints;
  for (std::size_t i = 0; i < parts.size(); ++i)
    footprints.push_back(footprintOf(*parts[i], mayLean(choices.item(i))));
  return printSequence(footprints, process::erodedHead(process.head, process.contactToleranceMm));
}

plan::Findings
findingsBetween(const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& parts,
                const project::Choices& choices, const process::Process& process,
                const std::vector<std::string>& names) {
  constexpr double kTouchMm = 0.02; // parts that touch share less
  plan::Findings findings;
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = a + 1; b < parts.size(); ++b)
      if (const auto where = geometry::sharedPoint(*parts[a], *parts[b], kTouchMm))
        findings.push_back(plan::makeFinding(plan::FindingKind::PartsOverlap,
                                             {{"first", names[a]}, {"second", names[b]}}, *where));
  if (!findings.empty() || choices.printOrder != layers::PrintOrder::OneAfterAnother)
    return findings;
  if (const auto blocked = printSequence(parts, choices, process).blocked) {
    const double gapMm = geometry::distanceBetween(*parts[blocked->first], *parts[blocked->second]);
    findings.push_back(plan::makeFinding(plan::FindingKind::PartsBlock,
                                         {{"first", names[blocked->first]},
                                          {"second", names[blocked->second]},
                                          {"gap", base::mm(gapMm)},
                                          {"needed", base::mm(blocked->neededMm)}}));
  }
  return findings;
}

} // namespace voluta::pipeline
