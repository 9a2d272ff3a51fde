#include "panels/verdict_table.h"

#include "base/shown_number.h"
#include "forms/colours.h"
#include "forms/duration_text.h"
#include "forms/icons.h"
#include "language/numbers.h"
#include "project/shown_figures.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>
#include <cmath>

namespace voluta::panels {

std::vector<VerdictMeasure> verdictMeasures(const project::ReplayReport& report,
                                            const VerdictFacts& facts) {
  const project::ReplayReport r = project::shownFigures(report);
  const QLocale locale;
  const auto percent = [&](double share) {
    return locale.toString(100.0 * share, 'f', 2) + QStringLiteral(" %");
  };
  const auto shortPercent = [&](double share) {
    return language::numberText(100.0 * share, 4) + QStringLiteral(" %");
  };
  const auto atLeast = [](const QString& limit) { return QStringLiteral("≥ ") + limit; };
  const auto atMost = [](const QString& limit) { return QStringLiteral("≤ ") + limit; };
  const auto whole = [&](std::size_t n) { return locale.toString(static_cast<qulonglong>(n)); };
  const auto mm = [&](double value) {
    return locale.toString(value, 'f', 3) + QStringLiteral(" mm");
  };
  const auto shortMm = [](double value) {
    return language::numberText(value, 4) + QStringLiteral(" mm");
  };
  const auto& limits = r.thresholds;
  const double massError = std::abs(r.massRatio - 1.0);
  return {
      {VerdictTable::tr("Coverage"), percent(r.coveredFraction),
       atLeast(shortPercent(limits.covered)), r.coveredFraction >= limits.covered, false},
      {VerdictTable::tr("Thin and open"), percent(r.thinFraction),
       atMost(shortPercent(limits.thin)), r.thinFraction <= limits.thin, false},
      {VerdictTable::tr("Unsupported"), percent(r.unsupportedFraction),
       atMost(shortPercent(limits.unsupported)), r.unsupportedFraction <= limits.unsupported,
       false},
      {VerdictTable::tr("Less than half supported"), percent(r.halfCarriedFraction), {}, true},
      {VerdictTable::tr("Longest unsupported run"),
       mm(base::roundedBeyond(r.longestUnsupportedMm, facts.bridgeMm, 3)),
       facts.bridgeMm > 0.0 ? atMost(shortMm(facts.bridgeMm)) : QString(),
       r.longestUnsupportedMm <= facts.bridgeMm, false},
      {VerdictTable::tr("Overfill"), percent(r.overfillFraction),
       atMost(shortPercent(limits.overfill)), r.overfillFraction <= limits.overfill, false},
      {VerdictTable::tr("Mass error"), percent(massError), atMost(shortPercent(limits.mass)),
       massError <= limits.mass, false},
      {VerdictTable::tr("Collisions"), whole(r.collisions), atMost(whole(limits.collisions)),
       r.collisions <= limits.collisions},
      {VerdictTable::tr("Limit violations"), whole(r.limitViolations),
       atMost(whole(limits.limitViolations)), r.limitViolations <= limits.limitViolations},
      {VerdictTable::tr("Path deviation"), mm(r.maxDeviationMm),
       atMost(shortMm(limits.deviationMm)), r.maxDeviationMm <= limits.deviationMm},
      {VerdictTable::tr("Differences from the plan"), whole(facts.deviations), atMost(whole(0)),
       facts.deviations == 0},
      {VerdictTable::tr("Flow error"), percent(r.flowErrorFraction),
       atMost(shortPercent(limits.flowError)), r.flowErrorFraction <= limits.flowError},
      {VerdictTable::tr("Time on the controller"),
       forms::durationText(r.controllerDurationS),
       {},
       true},
  };
}

VerdictTable::VerdictTable(QWidget* parent) : QTableWidget(0, 4, parent) {
  setSelectionMode(QAbstractItemView::NoSelection);
  setEditTriggers(QAbstractItemView::NoEditTriggers);
  setFocusPolicy(Qt::NoFocus);
  setShowGrid(false);
  setAlternatingRowColors(true);
  setWordWrap(false);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  verticalHeader()->hide();
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
  QHeaderView* head = horizontalHeader();
  head->setHighlightSections(false);
  head->setSectionsClickable(false);
  head->setMinimumSectionSize(fontMetrics().height());
  head->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  head->setSectionResizeMode(QHeaderView::ResizeToContents);
  head->setSectionResizeMode(0, QHeaderView::Stretch);
  retranslate();
}

void VerdictTable::setReport(std::optional<project::ReplayReport> report, bool outOfDate,
                             const VerdictFacts& facts) {
  facts_ = facts;
  report_ = std::move(report);
  outOfDate_ = outOfDate;
  retranslate();
}

QSize VerdictTable::sizeHint() const {
  const int rows = static_cast<int>(verdictMeasures({}).size());
  return {fontMetrics().averageCharWidth() * 40, horizontalHeader()->sizeHint().height() +
                                                     rows * verticalHeader()->defaultSectionSize() +
                                                     2 * frameWidth()};
}

QSize VerdictTable::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 20, sizeHint().height()};
}

void VerdictTable::retranslate() {
  setHorizontalHeaderLabels({tr("Measure"), tr("Value"), tr("Limit"), QString()});
  for (const int column : {1, 2})
    horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  const std::vector<VerdictMeasure> measures =
      verdictMeasures(report_.value_or(project::ReplayReport{}), facts_);
  setRowCount(static_cast<int>(measures.size()));
  for (int row = 0; row < rowCount(); ++row) {
    const VerdictMeasure& m = measures[static_cast<std::size_t>(row)];
    const auto put = [&](int column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(text);
      if (outOfDate_)
        item->setForeground(forms::mutedColour(palette()));
      if (column == 1 || column == 2)
        item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      setItem(row, column, item);
    };
    const QString none = QStringLiteral("–");
    put(0, m.label);
    put(1, report_ ? m.value : none);
    put(2, report_ && !m.limit.isEmpty() ? m.limit : none);
    put(3, {});
    if (!report_ || m.limit.isEmpty())
      continue;
    const QString kept = outOfDate_ ? tr("Not checked since the change")
                         : m.passed ? tr("Within limit")
                         : m.blocks ? tr("Outside limit")
                                    : tr("Outside limit, not refused");
    item(row, 3)->setIcon(forms::icon(outOfDate_ ? forms::Icon::Pending
                                      : m.passed ? forms::Icon::Good
                                      : m.blocks ? forms::Icon::Blocked
                                                 : forms::Icon::Warning));
    item(row, 3)->setToolTip(kept);
    item(row, 3)->setData(Qt::AccessibleTextRole, kept);
  }
}

void VerdictTable::changeEvent(QEvent* event) {
  QTableWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange)
    retranslate();
}

} // namespace voluta::panels
