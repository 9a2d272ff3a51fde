#include "panels/ways_list.h"

#include "base/error.h"
#include "forms/colours.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace voluta::panels {

namespace {
constexpr int kColumns = 2;
}

WaysList::WaysList(QWidget* parent) : QWidget(parent) {
  title_ = new QLabel(this);
  QFont bold = font();
  bold.setBold(true);
  title_->setFont(bold);
  state_ = new QLabel(this);
  state_->setObjectName(QStringLiteral("waysState"));
  auto* heading = new QHBoxLayout;
  heading->addWidget(title_);
  heading->addWidget(state_, 1, Qt::AlignRight);
  grid_ = new QGridLayout;
  grid_->setSpacing(4);
  for (int column = 0; column < kColumns; ++column)
    grid_->setColumnStretch(column, 1);
  for (std::size_t n = 0; n < kMax; ++n)
    addCard(static_cast<int>(n));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 6, 6, 6);
  column->setSpacing(4);
  column->addLayout(heading);
  column->addLayout(grid_);
  retranslate();
}

void WaysList::addCard(int n) {
  auto* card = new WayCard(this);
  card->setObjectName(QStringLiteral("way%1").arg(n));
  card->hide();
  connect(card, &QAbstractButton::clicked, this, [this, n] {
    showState(); // a click checks nothing; the check mark follows the part's orientation
    emit chosen(n);
  });
  grid_->addWidget(card, n / kColumns, n % kColumns);
  cards_[static_cast<std::size_t>(n)] = card;
}

QSize WaysList::pictureSize() {
  return 3 * WayCard::kPicture;
}

void WaysList::setWays(const std::vector<ShownOrientation>& ways) {
  base::require(ways.size() <= kMax, "WaysList: at most kMax ways");
  count_ = ways.size();
  for (std::size_t n = 0; n < kMax; ++n)
    cards_[n]->setVisible(n < count_);
  for (std::size_t n = 0; n < ways.size(); ++n)
    cards_[n]->setOrientation(ways[n]);
  setNow(std::nullopt);
}

void WaysList::setNow(std::optional<std::size_t> orientation) {
  now_ = orientation;
  showState();
}

void WaysList::setLooking(bool looking) {
  looking_ = looking;
  showState();
}

void WaysList::showState() {
  for (std::size_t n = 0; n < cards_.size(); ++n)
    cards_[n]->setChecked(now_ == n);
  QPalette muted = palette();
  muted.setColor(QPalette::WindowText, forms::mutedColour(palette()));
  state_->setPalette(muted);
  state_->setText(looking_      ? tr("Calculating…")
                  : count_ == 0 ? tr("none found")
                  : !now_       ? tr("custom orientation")
                                : QString());
}

void WaysList::retranslate() {
  title_->setText(tr("Orientations"));
  title_->setToolTip(tr("Click one to orient the part that way"));
  showState();
}

void WaysList::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  if (event->type() == QEvent::PaletteChange)
    showState();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
