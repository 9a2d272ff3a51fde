// Choices of one part of a job, as an editor sees them, and their way back into the job.
#pragma once

#include "project/choices.h"

#include <cstddef>
#include <string>

namespace voluta::document {

// Returns `job` with the choices of one item replaced by `edited`, an edit of
// project::onlyItem(job, item). A change of the platform is made in every item that can have it.
// Precondition: `edited` has one item.
project::Choices withItem(const project::Choices& job, std::size_t item,
                          const project::Choices& edited);

// Returns `job` with another item, built as `item` is: with its mode, growth and platform, the
// settings of the job's preset, and otherwise the choices of a new part, `usual`.
project::Choices withNewItem(const project::Choices& job, std::size_t item,
                             const project::ItemChoices& usual);

// Returns the choices with a preset and its settings (pipeline::withPreset()); unchanged if it
// cannot be read.
project::Choices withPresetOr(const project::Choices& choices, const std::string& preset);

} // namespace voluta::document
