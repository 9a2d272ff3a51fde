#include "window/compare_view.h"

#include "base/data_files.h"
#include "curved/growth_row.h"
#include "forms/colours.h"
#include "forms/duration_text.h"
#include "language/words.h"
#include "modes/mode_table.h"
#include "panels/findings_model.h"
#include "pictures/job_picture.h"
#include "plan/finding_kinds.h"
#include "planar/planar_decomposition.h"
#include "window/data_labels.h"

#include <QCoreApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::window {

namespace {
// Twice the size shown in the table, for high-density screens.
constexpr int kPictureWidth = 184, kPictureHeight = 138;

QImage pictureOf(const project::Job& job, bool dark) {
  const auto image = base::outcomeOf([&] {
    pictures::PictureOptions look;
    look.show = job.item().layers ? "layers" : pictures::furthestPicture(job);
    look.width = kPictureWidth;
    look.height = kPictureHeight;
    look.colour = job.item().pieces() && job.item().pieces()->pieces.size() > 1 ? "group" : "layer";
    look.legend = false;
    look.dark = dark;
    return pictures::jobPicture(job, look);
  });
  const auto* made = std::get_if<scene::Image>(&image);
  if (!made)
    return {}; // The figures are useful without a picture
  return QImage(made->rgb.data(), made->width, made->height, 3 * made->width, QImage::Format_RGB888)
      .copy();
}

std::vector<QString> textsOf(base::Text pipeline::Figure::*text) {
  std::vector<QString> texts;
  for (const pipeline::Figure& figure : pipeline::figures())
    texts.push_back(language::heading(figure.*text));
  return texts;
}

QString valueText(const pipeline::Figure& figure, const pipeline::CompareRow& row) {
  const std::optional<double> value = figure.of(row);
  const QLocale locale;
  if (!value)
    return QStringLiteral("–");
  if (figure.unit == "s")
    return forms::durationText(*value);
  if (figure.unit == "%")
    return locale.toString(100.0 * *value, 'f', *value < 1.0 ? 2 : 0);
  return locale.toString(*value, 'f', figure.unit.empty() || *value == 0.0 ? 0 : 1);
}

QString modeLabel(const std::string& id) {
  for (const modes::Mode& mode : modes::modeTable())
    if (mode.id == id)
      return language::words(mode.label);
  return QString::fromStdString(id);
}

QString strategyText(const pipeline::Combination& combination) {
  QStringList parts{modeLabel(combination.mode)};
  if (combination.growth)
    parts << language::words(combination.growth->row().label);
  parts << language::words(combination.platform.shown());
  if (!combination.cell.empty())
    parts << cellLabel(combination.cell);
  return parts.join(QStringLiteral(", "));
}
// Returns why a row is blocked; empty if it is not.
QString whyText(const pipeline::CompareRow& row) {
  if (!row.error.empty())
    return language::words(row.error);
  for (const plan::Finding& f : row.report.findings)
    if (f.blocking)
      return QStringLiteral("%1: %2").arg(language::words(plan::stageLabel(plan::stageOf(f))),
                                          language::words(plan::reasonOf(f)));
  return {};
}
} // namespace

CompareView::CompareView(document::Document& document, document::Comparing& comparing,
                         QWidget* parent)
    : QWidget(parent), document_(document), comparing_(comparing) {
  build();
  listen();
  retranslate();
}

void CompareView::build() {
  panel_ = new panels::ComparePanel;
  panel_->setObjectName("comparePanel");
  panel_->setPlatformTexts([](const QString& platform) {
    return language::words(project::Platform(platform.toStdString()).shown());
  });
  panel_->setPlatform(QString::fromStdString(document_.choices().item().platform.text()));
  table_ = new panels::CompareTable(this);
  table_->setObjectName("compareTable");
  empty_ = new QLabel(this);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setMargin(24);
  verdict_ = new QLabel(this);
  verdict_->setObjectName("compareVerdict");
  verdict_->setWordWrap(true);
  adopt_ = new QPushButton(this);
  adopt_->setObjectName("adopt");
  auto* bottom = new QHBoxLayout;
  bottom->setContentsMargins(10, 6, 10, 6);
  bottom->addWidget(verdict_, 1);
  bottom->addWidget(adopt_);
  shown_ = new QStackedLayout;
  shown_->addWidget(empty_);
  shown_->addWidget(table_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(shown_, 1);
  column->addLayout(bottom);
}

void CompareView::listen() {
  connect(panel_, &panels::ComparePanel::changed, this, &CompareView::showCount);
  connect(panel_, &panels::ComparePanel::weightsChanged, this,
          [this] { comparing_.setWeights(panel_->weights()); });
  connect(panel_, &panels::ComparePanel::runAsked, this, &CompareView::run);
  connect(panel_, &panels::ComparePanel::cancelAsked, &comparing_, &document::Comparing::cancel);
  connect(table_, &panels::CompareTable::rowActivated, this, &CompareView::adopt);
  connect(table_, &panels::CompareTable::rowSelected, this, &CompareView::showState);
  connect(adopt_, &QPushButton::clicked, this, [this] { adopt(table_->selectedRow()); });
  connect(&comparing_, &document::Comparing::rowsChanged, this, &CompareView::showAll);
  connect(&comparing_, &document::Comparing::rowChanged, this, &CompareView::showRow);
  connect(&comparing_, &document::Comparing::rankingChanged, this, &CompareView::showRanking);
  connect(&comparing_, &document::Comparing::started, this, &CompareView::showRanking);
  connect(&comparing_, &document::Comparing::ended, this, [this] {
    showRanking();
    showState();
  });
  connect(&document_, &document::Document::choicesChanged, this, [this] {
    panel_->setPlatform(QString::fromStdString(document_.choices().item().platform.text()));
    showModes();
    showCount();
    showRanking();
  });
  connect(&document_, &document::Document::sourceChanged, this, &CompareView::showRanking);
}

void CompareView::setLists(const std::vector<forms::ChoiceItem>& modes,
                           const std::vector<forms::ChoiceItem>& growths,
                           const std::vector<forms::ChoiceItem>& cells) {
  panel_->setCells(cells);
  modes_ = modes;
  growths_ = growths;
  listed_.clear();
  showModes();
  showCount();
}

// Shows the modes that can build the part in the chosen cell on the chosen platform.
void CompareView::showModes() {
  const modes::Mode& chosen = modes::findMode(document_.choices().item().mode);
  std::vector<forms::ChoiceItem> fitting;
  QStringList ids;
  for (const forms::ChoiceItem& item : modes_) {
    if (!modes::printAlike(modes::findMode(item.id.toStdString()), chosen))
      continue;
    fitting.push_back(item);
    ids << item.id;
  }
  if (ids == listed_)
    return;
  listed_ = ids;
  panel_->setLists(fitting, growths_);
}

document::ComparedWays CompareView::ways() const {
  return {panel_->modes(), panel_->growths(), panel_->platforms(), panel_->until(),
          panel_->cells()};
}

void CompareView::run() {
  if (!document_.source() || !document_.sourceReady())
    return;
  comparing_.setPictures(
      [dark = forms::isDark(palette())](const project::Job& job) { return pictureOf(job, dark); });
  comparing_.run(ways());
}

void CompareView::adopt(int row) {
  if (row < 0 || row >= static_cast<int>(comparing_.rows().size()))
    return;
  const document::Comparing::Row& chosen = comparing_.rows()[static_cast<std::size_t>(row)];
  document_.setChoices(pipeline::choicesOf(chosen.combination, document_.choices()),
                       tr("way of building"));
  emit adopted(strategyText(chosen.combination), chosen.result);
}

panels::CompareEntry CompareView::entryOf(std::size_t index) const {
  const document::Comparing::Row& row = comparing_.rows()[index];
  const pipeline::Ranking& ranking = comparing_.ranking();
  panels::CompareEntry entry;
  entry.strategy = modeLabel(row.combination.mode);
  if (!row.combination.cell.empty())
    entry.strategy += QStringLiteral(", ") + cellLabel(row.combination.cell);
  if (row.combination.growth)
    entry.growth = language::words(row.combination.growth->row().label);
  entry.platform = language::words(row.combination.platform.shown());
  entry.inUse = pipeline::choicesOf(row.combination, document_.choices()).item().growth ==
                    document_.choices().item().growth &&
                row.combination.mode == document_.choices().item().mode &&
                row.combination.platform == document_.choices().item().platform &&
                (row.combination.cell.empty() || row.combination.cell == document_.choices().cell);
  entry.tip = strategyText(row.combination);
  if (!row.compared) {
    const bool running = comparing_.current() == index;
    entry.state = running ? panels::CompareState::Running : panels::CompareState::Waiting;
    entry.verdict = running                ? tr("Planning")
                    : comparing_.running() ? tr("Waiting")
                                           : tr("Not planned");
    entry.figures.assign(pipeline::figures().size(), QString());
    return entry;
  }
  const pipeline::CompareRow& compared = *row.compared;
  for (const pipeline::Figure& figure : pipeline::figures())
    entry.figures.push_back(valueText(figure, compared));
  switch (compared.state()) {
  case pipeline::RowState::Clear:
    entry.state = panels::CompareState::Clear;
    entry.verdict =
        compared.reached == project::Stage::Replay ? tr("Passed") : tr("No blocking findings");
    break;
  case pipeline::RowState::Blocked:
    entry.state = panels::CompareState::Blocked;
    entry.verdict = tr("Blocked: %1").arg(compared.blocking());
    break;
  case pipeline::RowState::Failed:
    entry.state = panels::CompareState::Failed;
    entry.verdict = tr("Cannot be planned");
    break;
  }
  if (const QString why = whyText(compared); !why.isEmpty())
    entry.tip += QStringLiteral("\n") + why;
  entry.tip +=
      QStringLiteral("\n") + tr("Planned in %1").arg(forms::durationText(compared.seconds));
  entry.picture = row.picture;
  entry.score = ranking.score[index];
  const auto place = std::find(ranking.order.begin(), ranking.order.end(), index);
  if (place != ranking.order.end())
    entry.place = static_cast<int>(place - ranking.order.begin()) + 1;
  entry.best = ranking.best == index;
  return entry;
}

std::vector<panels::CompareEntry> CompareView::entries() const {
  std::vector<panels::CompareEntry> all;
  for (std::size_t i = 0; i < comparing_.rows().size(); ++i)
    all.push_back(entryOf(i));
  return all;
}

void CompareView::showAll() {
  table_->setEntries(entries());
  shown_->setCurrentIndex(comparing_.rows().empty() ? 0 : 1);
  showState();
}

void CompareView::showRow(int row) {
  if (row < static_cast<int>(table_->entries().size()))
    table_->setEntry(row, entryOf(static_cast<std::size_t>(row)));
  showState();
}

void CompareView::showRanking() {
  if (table_->entries().size() == comparing_.rows().size())
    table_->updateEntries(entries());
  showState();
}

void CompareView::showState() {
  const pipeline::Ranking& ranking = comparing_.ranking();
  const auto& rows = comparing_.rows();
  QString text;
  if (!rows.empty() && !comparing_.upToDate())
    text = tr("Out of date: the part or its settings have changed since.");
  else if (ranking.best) {
    text = tr("Best: %1.").arg(strategyText(rows[*ranking.best].combination));
    if (!ranking.tied.empty())
      text += QStringLiteral(" ") + tr("As good: %1.").arg(ranking.tied.size());
  } else if (!ranking.order.empty() && !comparing_.running())
    text = tr("None is best: all of them are blocked.");
  // Once a way is best, its cell is the answer.
  if (comparing_.upToDate() && !ranking.best && !comparing_.advice().empty())
    text += QStringLiteral("\n") + language::words(comparing_.advice());
  const int selected = table_->selectedRow();
  if (selected >= 0 && selected < static_cast<int>(rows.size()))
    if (const auto& row = rows[static_cast<std::size_t>(selected)]; row.compared)
      if (const QString why = whyText(*row.compared); !why.isEmpty())
        text += QStringLiteral("\n") +
                QStringLiteral("%1: %2").arg(modeLabel(row.combination.mode), why);
  verdict_->setText(text);
  adopt_->setEnabled(selected >= 0);
  panel_->setState(document_.source() && document_.sourceReady(), comparing_.running());
}

void CompareView::showCount() {
  int count = 0;
  const document::ComparedWays chosen = ways();
  if (!chosen.modes.empty()) {
    pipeline::CompareOptions options;
    options.plan.choices = document_.choices();
    options.modes = chosen.modes;
    options.growths = chosen.growths;
    options.platforms = chosen.platforms;
    options.cells = chosen.cells;
    const auto all = base::outcomeOf([&] { return pipeline::combinations(options).size(); });
    if (const auto* size = std::get_if<std::size_t>(&all))
      count = static_cast<int>(*size);
  }
  panel_->setCount(count);
}

void CompareView::retranslate() {
  empty_->setText(tr("Which way of building suits this part?\nTick the ways to compare at the "
                     "right, then press Compare."));
  adopt_->setText(tr("Adopt this way"));
  adopt_->setToolTip(tr("Builds the part as in the selected row; can be undone"));
  table_->setFigures(textsOf(&pipeline::Figure::head));
  panel_->setFigures(textsOf(&pipeline::Figure::loss));
  showRanking();
}

void CompareView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::window
