#include "pipeline/shaped_paths.h"

#include "base/error.h"
#include "modes/platform_body.h"
#include "pipeline/cell_plate.h"
#include "pipeline/given_paths.h"
#include "pipeline/path_parameters.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "pipeline/stages.h"

#include <utility>

namespace voluta::pipeline {

ShapedPart shapedPart(std::shared_ptr<const project::LoadedPart> loaded, const Resolved& resolved,
                      const base::RunContext& ctx) {
  if (!takesGivenPaths(*loaded, resolved.values))
    return {std::move(loaded), nullptr};
  const sliced::PathShape shape = pathShape(resolved.values);
  if (shape.changesNothing())
    return {std::move(loaded), nullptr};
  sliced::ShapedPaths made = sliced::shaped(*loaded->toolPaths, *loaded->mesh, shape, ctx);
  auto part = std::make_shared<project::LoadedPart>();
  part->name = loaded->name;
  part->repair = loaded->repair;
  part->units = loaded->units;
  part->source = part->mesh = std::make_shared<geometry::TriangleMesh>(std::move(made.solid));
  part->toolPaths = std::make_shared<plan::ToolPlan>(std::move(made.plan));
  ShapedPart shaped{std::move(part), nullptr};
  if (made.ground && !resolved.choices.item().platform.isBody())
    shaped.ground = std::make_shared<geometry::TriangleMesh>(*std::move(made.ground));
  return shaped;
}

std::shared_ptr<const modes::LoadStage>
loadStageOnGround(const ShapedPart& shaped, const Resolved& resolved, const base::RunContext& ctx) {
  const auto& [choices, values, process] = resolved.modeChoices();
  const auto ground = placedGround(shaped, choices.item().placement);
  Resolved own = resolved;
  own.choices.item().placement = modes::placementBy(
      *shaped.part->mesh, 1.0, modes::motionOf(*shaped.ground, 1.0, choices.item().placement));
  auto stage = std::make_shared<modes::LoadStage>(*loadStage(*shaped.part, own, ctx));
  if (choices.item().platform.isOfCell())
    stage->platform =
        cellPlate(fittingCell(choices, process), *ground, plateNeeds({choices, values, process}));
  else if (choices.item().platform.marginMm())
    stage->platform = footOf(*ground);
  return stage;
}

std::shared_ptr<const geometry::TriangleMesh> placedGround(const ShapedPart& shaped,
                                                           const geometry::Placement& own) {
  base::require(shaped.ground != nullptr, "a ground");
  return std::make_shared<geometry::TriangleMesh>(
      modes::moved(*shaped.ground, 1.0, modes::motionOf(*shaped.ground, 1.0, own)));
}

} // namespace voluta::pipeline
