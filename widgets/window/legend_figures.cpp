#include "window/legend_figures.h"

#include "forms/duration_text.h"

#include <QCoreApplication>
#include <QLocale>

namespace voluta::window {

namespace {
QString words(const char* text) {
  return QCoreApplication::translate("LegendFigures", text);
}

QStringList cells(const KindFigures& figures, const KindFigures& total, bool timed) {
  const QLocale locale;
  const double whole = timed ? total.timeS : total.massG,
               part = timed ? figures.timeS : figures.massG;
  QStringList texts;
  if (timed)
    texts << forms::durationText(figures.timeS);
  texts << QStringLiteral("%1 %").arg(
      locale.toString(whole > 0.0 ? 100.0 * part / whole : 0.0, 'f', 1));
  for (const auto& [value, unit] : {std::pair(1e-3 * figures.lengthMm, "m"), {figures.massG, "g"}})
    texts << (value > 0.0
                  ? QStringLiteral("%1 %2").arg(locale.toString(value, 'f', 2), QLatin1String(unit))
                  : QString());
  return texts;
}
} // namespace

LegendFigures legendFigures(const KindStatistics& statistics, const QString& name,
                            std::uint32_t hidden) {
  LegendFigures figures;
  figures.hidden = hidden;
  const KindFigures total = statistics.total();
  if (statistics.timed)
    figures.heads << words(QT_TRANSLATE_NOOP("LegendFigures", "Time"));
  figures.heads << words(QT_TRANSLATE_NOOP("LegendFigures", "Share"))
                << words(QT_TRANSLATE_NOOP("LegendFigures", "Length"))
                << words(QT_TRANSLATE_NOOP("LegendFigures", "Mass"));
  for (std::size_t kind = 0; kind < statistics.kinds.size(); ++kind)
    figures.rows[static_cast<int>(kind)] = cells(statistics.kinds[kind], total, statistics.timed);
  if (statistics.travelS > 0.0)
    figures.totals.emplace_back(words(QT_TRANSLATE_NOOP("LegendFigures", "Travel and waits")),
                                cells({statistics.travelS, 0.0, 0.0}, total, statistics.timed));
  figures.totals.emplace_back(name, cells(total, total, statistics.timed));
  return figures;
}

} // namespace voluta::window
