// Icons of the time-line, drawn sharp at any scale in the colour of the application's text.
#pragma once

#include <QIcon>

namespace voluta::timeline {

enum class BarIcon { Play, Pause, NextMove, PreviousMove, NextLayer, PreviousLayer };

// Drawn anew with QGuiApplication::palette() each time it is shown.
QIcon icon(BarIcon which);

} // namespace voluta::timeline
