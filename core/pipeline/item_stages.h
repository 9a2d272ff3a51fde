// The stages of one item, Load to Layers, each taken from the cache or made.
#pragma once

#include "pipeline/item_regions.h"
#include "pipeline/resolved.h"
#include "pipeline/shaped_paths.h"
#include "pipeline/stage_context.h"
#include "project/job.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace voluta::base {
class RunContext;
}
namespace voluta::modes {
struct DecomposeStage;
struct LoadStage;
struct Mode;
struct PartVoxels;
} // namespace voluta::modes
namespace voluta::toolpath {
struct ItemLayers;
}

namespace voluta::pipeline {

// What a stage of an item came to, beside its part of the job.
struct ItemOutcome {
  plan::Findings findings;
  project::Timings timings;
  bool continues = true; // is there any use in the next stage
};

class ItemStages {
public:
  // Loads the part. `given`: the job's choices as the user made them; `result`: the job's, with the
  // resolved choices of its items; the stages fill in its item and report of that index. All but
  // `given` outlive it. Throws as planPart.
  ItemStages(const StageContext& context, const project::Choices& given, std::size_t index,
             const RequestedItem& part, PlanResult& result);

  ItemOutcome load();
  ItemOutcome decompose();
  ItemOutcome layers();

  const project::LoadedPart& loaded() const { return *loaded_; }
  // The part as its parameters change the tool-paths of its file.
  const ShapedPart& shaped();
  const modes::LoadStage& placed() const { return *placed_; }
  // Null without forces. Precondition: its layers are made.
  std::shared_ptr<const ItemLoad> forces() const { return regions_ ? regions_->load : nullptr; }
  // Precondition: as forces().
  std::span<const PlacedInsert> inserts() const {
    return regions_ ? std::span<const PlacedInsert>(regions_->inserts)
                    : std::span<const PlacedInsert>();
  }
  const project::Choices& choices() const { return resolved_.choices; }
  const project::StageKeys& keys() const { return keys_; }
  // Precondition: layers() is done.
  toolpath::ItemLayers forToolpaths() const;
  // Is it printed along the tool-paths that its file brought?
  bool hasGivenPaths() const { return hasGivenPaths_; }

private:
  project::JobItem& item() { return result_.job.item(index_); }
  project::ItemReport& report() { return result_.job.report.item(index_); }
  // The cache keeps a few results per slot, so each item has slots of its own.
  std::string slot(const std::string& what) const {
    return index_ == 0 ? what : what + "#" + std::to_string(index_);
  }
  const std::string& keyOf(project::Stage stage) const { return keys_[project::indexOf(stage)]; }

  // Throws Error{Usage} for loads and fields that the stages to come cannot use.
  void requireLoads() const;
  project::ChosenReport chosenReport() const;
  std::vector<base::Message> allRepairs() const;
  plan::Findings decomposeFindings() const;
  plan::Findings startFindings();
  double fileUnitMm() const;
  void makeRegions(std::shared_ptr<const geometry::TriangleMesh> whole);
  std::shared_ptr<const modes::LoadStage> withoutLayeredRegions() const;
  std::shared_ptr<const modes::PartVoxels> voxels(double voxelMm, const base::RunContext& ctx);

  const StageContext& context_;
  const project::Choices given_; // of this item only, as the user made them
  const std::size_t index_;
  PlanResult& result_;
  const Resolved& resolved_; // the choices of this item, in the result
  const modes::Mode& mode_;
  std::shared_ptr<const project::LoadedPart> loaded_;
  ShapedPart shaped_; // Made when first needed
  std::shared_ptr<const modes::LoadStage> placed_;
  std::shared_ptr<const modes::DecomposeStage> decomposed_;
  std::shared_ptr<const RegionStage> regions_; // null without regions
  bool hasGivenPaths_ = false;
  project::StageKeys keys_;
};

} // namespace voluta::pipeline
