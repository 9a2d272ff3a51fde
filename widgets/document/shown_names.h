// Names of the parts of a job, as the user sees them.
#pragma once

#include "project/loaded_part.h"

#include <QStringList>
#include <memory>
#include <span>

namespace voluta::document {

// Returns the names of the parts without folder and ending; equal names are numbered: "kitten",
// "kitten (2)".
QStringList shownNames(std::span<const std::shared_ptr<const project::LoadedPart>> parts);

} // namespace voluta::document
