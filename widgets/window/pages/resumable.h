// Where a print on show can be taken up again: the same on the pages that offer it.
#pragma once

#include "plan/trajectory.h"
#include "window/pages/page.h"

#include <QString>
#include <cstddef>
#include <functional>
#include <optional>

namespace voluta::window {

// The point that `find` gives of the motion on show, which is that of the choices. None: there is
// no such motion, nothing is printed from there on, or it comes before the rest that is on show.
std::optional<std::size_t>
resumableAt(const Workspace& work,
            const std::function<std::optional<std::size_t>(const plan::Trajectory&)>& find);

// "Bead 12 of 340". Precondition: a point of resumableAt.
QString placeOfPoint(const Workspace& work, std::size_t point);

} // namespace voluta::window
