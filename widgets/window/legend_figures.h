// Figures beside the entries of the legend: the statistics of the beads by kind.
#pragma once

#include "window/kind_statistics.h"

#include <QString>
#include <QStringList>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace voluta::window {

struct LegendFigures {
  QStringList heads;                                   // Of the columns beside the names
  std::map<int, QStringList> rows;                     // By the value of an entry
  std::vector<std::pair<QString, QStringList>> totals; // Below the entries, the last one in bold
  std::uint32_t hidden = 0;                            // Bit k: the entry of value k is crossed out
};

// Time, share of it (without times: of the mass), length and mass of each kind of bead, of travel
// and of everything, named `name`.
LegendFigures legendFigures(const KindStatistics& statistics, const QString& name,
                            std::uint32_t hidden);

} // namespace voluta::window
