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
#include "regions/region_uses.h"

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

// The parts on the plate, as they are arranged.
struct PlateContent {
  std::vector<Footprint> parts;
  std::vector<Eigen::Vector2d> centres;
  process::HeadShape head;
  ArrangeOptions options;
};

// Loads the parts of the request that are not loaded yet.
PlateContent loadedContent(PlanRequest& request, const base::RunContext& ctx) {
  base::require(request.items.size() == request.choices.items.size(), "choices for each item");
  PlateContent content;
  content.options.order = request.choices.printOrder;
  for (std::size_t i = 0; i < request.items.size(); ++i) {
    RequestedItem& item = request.item(i);
    if (!item.loaded)
      item.loaded = project::loadPart(item.part, request.choices.item(i).repair, ctx);
    const project::Choices alone = project::onlyItem(request.choices, i);
    const bool isGiven = takesGivenPaths(*item.loaded, parameterValues(alone));
    const Resolved own = resolve(isGiven ? choicesForGivenPaths(alone) : strategyOrFirst(alone));
    const auto& [choices, values, process] = own.modeChoices();
    const auto placed = loadStage(*item.loaded, own, ctx);
    content.parts.push_back(isGiven ? footprintWithWaste(*item.loaded, *placed, own, ctx)
                                    : footprintOf(*placed->part, mayLean(request.choices.item(i))));
    content.centres.push_back(placed->placement.centreMm);
    ArrangeOptions& options = content.options;
    const double beadsMm = std::max(ArrangeOptions{}.spareMm, 2.0 * process.beadWidthMaxMm);
    options.spareMm = std::max(options.spareMm, beadsMm + 2.0 * values.number("brimWidthMm"));
    content.head = process.head;
    if (options.plate.empty() && isOnCellPlate(request.choices.item(i)))
      options.plate = largestPlate(fittingCell(choices, process));
  }
  return content;
}

base::Error noRoomFor(std::size_t parts) {
  return base::Error(base::ErrorCode::UnusableInput,
                     base::message("the plate has no room for {parts} parts"_text, parts), {},
                     "print fewer or smaller parts, or use a cell with a larger plate"_text);
}

void moveParts(PlanRequest& request, const PlateContent& content,
               const std::vector<Eigen::Vector2d>& moves) {
  for (std::size_t i = 0; i < request.items.size(); ++i)
    request.choices.item(i).placement.centreMm = content.centres[i] + moves[i];
}

std::vector<Eigen::Vector2d> plateWithSize(const project::ItemChoices& item) {
  if (!item.platform.isFor(project::PlatformUse::Plate) || item.platform.marginMm())
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the plate is made as large as the parts need"_text, {},
                      "choose a plate with a size, or type the number of copies"_text);
  return item.platform.plateAround({});
}
} // namespace

bool mayLean(const project::ItemChoices& item) {
  return item.automatic || !modes::findMode(item.mode).upright || regions::tiltHead(item.regions);
}

PlanRequest withArrangedParts(PlanRequest request, const base::RunContext& ctx) {
  const PlateContent content = loadedContent(request, ctx);
  const auto moves = arranged(content.parts, content.head, content.options);
  if (!moves)
    throw noRoomFor(content.parts.size());
  moveParts(request, content, *moves);
  return request;
}

PlanRequest withCopies(PlanRequest request, std::size_t item, std::optional<std::size_t> count,
                       const base::RunContext& ctx) {
  base::require(count.value_or(1) > 0, "one copy at least");
  PlateContent content = loadedContent(request, ctx);
  const auto part = request.item(item).loaded;
  const auto isCopy = [&](std::size_t i) { return request.item(i).loaded == part; };
  std::size_t there = 0;
  for (std::size_t i = 0; i < request.items.size(); ++i)
    there += isCopy(i);
  for (std::size_t i = request.items.size(); i-- > 0 && there > count.value_or(kMaxCopies);)
    if (i != item && isCopy(i)) {
      const auto at = static_cast<std::ptrdiff_t>(i);
      request.items.erase(request.items.begin() + at);
      request.choices.items.erase(request.choices.items.begin() + at);
      content.parts.erase(content.parts.begin() + at);
      content.centres.erase(content.centres.begin() + at);
      item -= i < item;
      --there;
    }
  if (!count && content.options.plate.empty())
    content.options.plate = plateWithSize(request.choices.item(item));
  const auto movesWith = [&](std::size_t added) {
    std::vector<Footprint> parts = content.parts;
    parts.insert(parts.end(), added, content.parts[item]);
    return arranged(parts, content.head, content.options);
  };
  std::size_t added = count ? *count - there : 0;
  if (!count) { // Doubles the number, then halves the step
    std::size_t step = 1;
    while (there + added + step <= kMaxCopies && movesWith(added + step)) {
      added += step;
      step *= 2;
    }
    for (; step > 0; step /= 2)
      if (there + added + step <= kMaxCopies && movesWith(added + step))
        added += step;
  }
  const auto moves = movesWith(added);
  if (!moves)
    throw noRoomFor(content.parts.size() + added);
  for (std::size_t i = 0; i < added; ++i) {
    request.items.push_back(request.item(item));
    request.choices.items.push_back(request.choices.item(item));
    content.centres.push_back(content.centres[item]);
  }
  moveParts(request, content, *moves);
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
