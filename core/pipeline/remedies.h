// What cures a finding, as an edit of the choices: one row a remedy.
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
  base::Text label;      // "Add supports"; may have places for values of the finding
  base::Text help;
  // What the choices become. None where it would change nothing, or where there is nothing to do it
  // with. Precondition: the kind of the finding has this remedy among its cures.
  std::optional<project::Choices> (*cure)(const plan::Finding&, const project::Choices&);
};

// One row a RemedyId, in the order they are offered: what changes least of the part first.
std::span<const Remedy> remedies();

struct RemedyAction {
  const Remedy* remedy = nullptr;
  base::Message label;
  project::Choices choices;
};
// What can be done about a finding of a plan with these choices.
std::vector<RemedyAction> remediesFor(const plan::Finding& finding,
                                      const project::Choices& choices);

} // namespace voluta::pipeline
