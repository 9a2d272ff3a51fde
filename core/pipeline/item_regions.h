// The regions of an item in its stages.
#pragma once

#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "layers/support_places.h"
#include "layers/support_rules.h"
#include "modes/mode_stages.h"
#include "pipeline/item_inserts.h"
#include "pipeline/item_loads.h"
#include "project/job_stage.h"
#include "regions/part_regions.h"
#include "toolpath/cover_rules.h"
#include "toolpath/order/seam_places.h"

#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct Resolved;

bool hasRegions(const Resolved& resolved);

// Returns the load of a part that is placed but not cut yet; null without forces. `file`: its mesh,
// `unitMm`: of its lengths. Throws as itemLoad() and regions::bodyOf().
std::shared_ptr<const ItemLoad> loadOf(const modes::LoadStage& placed,
                                       const geometry::TriangleMesh& file, const Resolved& resolved,
                                       double unitMm, const base::RunContext& ctx);

// Returns the stage with the part that the cutting regions leave; itself without any. Throws as
// regions::withoutCuts().
std::shared_ptr<const modes::LoadStage>
withCutRegions(std::shared_ptr<const modes::LoadStage> stage, const geometry::TriangleMesh& file,
               const Resolved& resolved, double unitMm, const base::RunContext& ctx);

// The solids of an item's regions, part of the stage Decompose.
struct RegionStage {
  static constexpr project::Stage kStage = project::Stage::Decompose;
  std::shared_ptr<const geometry::TriangleMesh> whole;
  std::shared_ptr<const geometry::TriangleMesh> rest; // has the layers of the item's mode
  std::vector<regions::LayeredRegion> layered;
  // Of every region; empty: no settings by which patches are divided.
  std::vector<geometry::TriangleMesh> bodies;
  layers::SupportPlaces supports;
  std::shared_ptr<const toolpath::SeamPlaces> seams;    // null: none
  std::shared_ptr<const layers::SupportRules> blockers; // null: none of them blocks supports
  std::shared_ptr<const ItemLoad> load;                 // null without forces
  std::vector<PlacedInsert> inserts;
  std::vector<bool> isOutside; // of every region: it has no effect, as a finding says
  plan::Findings findings;
};
// `whole`: the part, without the volume that the ground occupies. Throws as regions::divided().
std::shared_ptr<const RegionStage> regionStage(const modes::LoadStage& placed,
                                               std::shared_ptr<const geometry::TriangleMesh> whole,
                                               const geometry::TriangleMesh& file,
                                               const Resolved& resolved, double unitMm,
                                               const base::RunContext& ctx);

// Returns the layers of the mode followed by those of the regions. Throws as regions::layersOf().
std::shared_ptr<const modes::LayersStage>
withRegionLayers(std::shared_ptr<const modes::LayersStage> stage, const RegionStage& regions,
                 const Resolved& resolved, const base::RunContext& ctx);

// Returns the layers with their patches divided at the regions that have settings of their own, and
// with the tools and the figures of the regions. Throws Cancelled.
std::shared_ptr<const modes::LayersStage>
dividedByRegions(std::shared_ptr<const modes::LayersStage> stage, const RegionStage& regions,
                 const geometry::TriangleMesh& part, const Resolved& resolved,
                 const base::RunContext& ctx);

// Returns how the item and its regions are covered, by Patch::region. `load`: null without any.
// Throws Error{Usage}.
std::vector<toolpath::CoverRules> coverRules(const Resolved& resolved,
                                             const std::shared_ptr<const ItemLoad>& load);

// Returns the findings about fields of the infill that no infill follows.
plan::Findings unusedFields(const Resolved& resolved);
// Throws Error{Usage} for a field that cannot be read, and for an infill along a field without any.
void requireField(const Resolved& resolved);

// Return the inputs of these functions, as text; empty without regions.
std::string cutRegionsKey(const Resolved& resolved);
std::string loadRegionsKey(const Resolved& resolved);
std::string layeredRegionsKey(const Resolved& resolved);
std::string supportRegionsKey(const Resolved& resolved);
std::string regionLayersKey(const Resolved& resolved);
std::string regionRulesKey(const Resolved& resolved);
// Of the places of seams in RegionStage, which layers do not depend on.
std::string seamRegionsKey(const Resolved& resolved);

} // namespace voluta::pipeline
