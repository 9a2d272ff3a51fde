// Choices of one part of a job, as an editor sees them, and their way back into the job.
#pragma once

#include "project/choices.h"

#include <cstddef>
#include <string>

namespace voluta::document {

// Returns whether a parameter holds for all parts of a job: one of the order of tool-paths, of
// motion or of programs.
bool isOfJob(const std::string& parameter);

// Returns `job` with the choices of one item replaced by `edited`, an edit of
// project::onlyItem(job, item). Changes of job-wide parameters and of the platform are made in
// every item that can have them. Precondition: `edited` has one item.
project::Choices withItem(const project::Choices& job, std::size_t item,
                          const project::Choices& edited);

// Returns `job` with another item, built as `item` is: with its mode, growth, platform and job-wide
// parameters, and otherwise the choices of a new part, `usual`.
project::Choices withNewItem(const project::Choices& job, std::size_t item,
                             const project::ItemChoices& usual);

} // namespace voluta::document
