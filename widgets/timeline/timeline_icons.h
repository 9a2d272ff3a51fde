// Icons of the time-line, sharp at any scale, in the application's text colour.
#pragma once

#include <QIcon>

namespace voluta::timeline {

enum class BarIcon { Play, Pause, NextMove, PreviousMove, NextLayer, PreviousLayer };

// Drawn with the current QGuiApplication::palette() each time it is shown.
QIcon icon(BarIcon which);

} // namespace voluta::timeline
