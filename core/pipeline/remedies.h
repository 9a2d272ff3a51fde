// Remedies of findings as edits of the choices, one row per remedy.
#pragma once

#include "plan/finding.h"
#include "plan/finding_kinds.h"
#include "project/job.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

struct Remedy {
  plan::RemedyId id;
  std::string_view name; // "addSupports"
  base::Text label;      // "Add supports"; may have placeholders for values of the finding
  base::Text help;
  // Returns the changed choices; nullopt if nothing would change or the remedy cannot be applied.
  // Precondition: the kind of the finding lists this remedy among its cures.
  std::optional<project::Choices> (*cure)(const plan::Finding&, const project::Choices&);
  bool ofJob = false; // changes no item: applies to findings about several of them
};

// Returns one row per RemedyId, in the order in which they are offered: smallest change of the part
// first.
std::span<const Remedy> remedies();

struct RemedyAction {
  const Remedy* remedy = nullptr;
  base::Message label;
  project::Choices choices;
};
// Returns the remedies that apply to a finding of a plan with these choices. Of several items, they
// change the finding's item.
std::vector<RemedyAction> remediesFor(const plan::Finding& finding,
                                      const project::Choices& choices);

} // namespace voluta::pipeline
