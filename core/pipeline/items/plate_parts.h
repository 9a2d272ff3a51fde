// The parts of a request as they are placed on the common plate.
#pragma once

#include "base/run_context.h"
#include "pipeline/items/print_sequence.h"
#include "pipeline/plan_result.h"
#include "plan/finding.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace voluta::pipeline {

// Returns the request with all parts loaded and moved to places beside each other (arranged()), on
// the cell's largest plate if a part is printed on the cell's plate. Keeps rotations and lifts.
// Throws Error{UnusableInput} if the plate has no room for all of them; as planPart for a part that
// cannot be loaded.
PlanRequest withArrangedParts(PlanRequest request, const base::RunContext& ctx);

inline constexpr std::size_t kMaxCopies = 500; // of one part

// Returns the request with that many items like `item` in all, added behind the others or taken off
// from behind, and all parts arranged as above; nullopt: as many as the plate has room for beside
// the other parts, at most kMaxCopies. The items are those with the same loaded part. Throws
// Error{UnusableInput} if the plate has no room for them, or for nullopt if it has no size.
PlanRequest withCopies(PlanRequest request, std::size_t item, std::optional<std::size_t> count,
                       const base::RunContext& ctx);

// Returns whether the layers of the item may tilt the head.
bool mayLean(const project::ItemChoices& item);

// Sets the item of findings without one to the item whose part has their place alone in its box,
// widened by `marginMm`. Precondition: all items are placed.
void nameItems(std::span<plan::Finding> findings, const std::vector<project::JobItem>& items,
               double marginMm);

// Returns the order in which parts are printed one after another. `parts`: the placed meshes, as
// the items of `choices`.
PrintSequence printSequence(const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& parts,
                            const project::Choices& choices, const process::Process& process);

// Returns a blocking finding for each pair of parts that overlap; if there is none, a finding for
// the pair that blocks printSequence(). `parts`: as there.
plan::Findings
findingsBetween(const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& parts,
                const project::Choices& choices, const process::Process& process,
                const std::vector<std::string>& names);

} // namespace voluta::pipeline
