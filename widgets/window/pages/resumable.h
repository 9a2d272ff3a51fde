// Where the shown print can be resumed; shared by the pages that offer it.
#pragma once

#include "plan/trajectory.h"
#include "window/pages/page.h"

#include <QString>
#include <cstddef>
#include <functional>
#include <optional>

namespace voluta::window {

// Returns the point that `find` returns for the shown motion, if that is up to date with the
// choices. Returns nullopt if there is no such motion, nothing is printed after the point, or it
// precedes the shown rest of a print.
std::optional<std::size_t>
resumableAt(const Workspace& work,
            const std::function<std::optional<std::size_t>(const plan::Trajectory&)>& find);

// Returns a text such as "Bead 12 of 340". Precondition: a point of resumableAt.
QString placeOfPoint(const Workspace& work, std::size_t point);

} // namespace voluta::window
