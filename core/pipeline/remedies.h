// What cures a finding, as an edit of the choices: one row a remedy.
#pragma once

#include "plan/finding.h"
#include "project/job.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

// What the choices become, and what stands for "%1" in the remedy's label.
struct Cure {
  project::Choices choices;
  std::string value;
};

struct Remedy {
  std::string_view id;                 // "addSupports"
  std::string_view label;              // English: "Add supports"; may hold a "%1"
  std::vector<std::string_view> kinds; // of findings it is for
  // None where it would change nothing, or where there is nothing to do it with. Precondition: the
  // finding is of one of `kinds`.
  std::optional<Cure> (*cure)(const plan::Finding&, const project::Choices&);
};

// In the order they are offered: what changes least of the part first.
const std::vector<Remedy>& remedies();

// Kind of the finding that stands for a run which ended in an error.
inline constexpr std::string_view kStopped = "stopped";

struct Offer {
  std::string_view id, label; // of the remedy
  Cure cure;
};
// What can be done about a finding of a plan with these choices.
std::vector<Offer> remediesFor(const plan::Finding& finding, const project::Choices& choices);

} // namespace voluta::pipeline
