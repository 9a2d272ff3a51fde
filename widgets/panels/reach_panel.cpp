#include "panels/reach_panel.h"

#include "forms/icons.h"

#include <QCheckBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <cmath>

namespace voluta::panels {

namespace {
// Rounded down, so that only the whole part shows 100.
QString percent(double share) {
  return QLocale().toString(std::floor(100.0 * share), 'f', 0);
}
} // namespace

ReachPanel::ReachPanel(QWidget* parent) : QWidget(parent) {
  title_ = new QLabel(this);
  QFont bold = font();
  bold.setBold(true);
  title_->setFont(bold);
  icon_ = new QLabel(this);
  state_ = new QLabel(this);
  state_->setObjectName(QStringLiteral("reachState"));
  state_->setWordWrap(true);
  map_ = new QCheckBox(this);
  map_->setObjectName(QStringLiteral("reachMap"));
  move_ = new QPushButton(this);
  move_->setObjectName(QStringLiteral("reachMove"));
  connect(map_, &QCheckBox::toggled, this, &ReachPanel::mapToggled);
  connect(move_, &QPushButton::clicked, this, &ReachPanel::moveRequested);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 6, 6, 6);
  grid->setSpacing(4);
  grid->setColumnStretch(1, 1);
  grid->addWidget(title_, 0, 0, 1, 2);
  grid->addWidget(icon_, 1, 0, Qt::AlignTop);
  grid->addWidget(state_, 1, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(map_, 1);
  row->addWidget(move_);
  grid->addLayout(row, 2, 0, 1, 2);
  retranslate();
}

void ReachPanel::setReach(const std::optional<ShownReach>& reach) {
  reach_ = reach;
  showState();
}

void ReachPanel::setLooking(bool looking) {
  looking_ = looking;
  showState();
}

void ReachPanel::showState() {
  icon_->setVisible(reach_.has_value() && !looking_);
  move_->setEnabled(reach_ && !looking_ && reach_->better);
  move_->setToolTip({});
  if (looking_ || !reach_) {
    state_->setText(looking_ ? tr("Calculating…") : tr("No part on a plate."));
    return;
  }
  const bool good = reach_->onPlate && reach_->upright == 1.0;
  icon_->setPixmap(forms::iconBeside(*this, good ? forms::Icon::Good : forms::Icon::Warning));
  QString text = !reach_->onPlate ? tr("The part is off the plate.")
                 : good           ? tr("Fully reachable upright.")
                                  : tr("%1 % reachable upright.").arg(percent(reach_->upright));
  if (reach_->tiltDeg > 0.0)
    text += QLatin1Char(' ') +
            tr("With up to %1° of tilt: %2 %.")
                .arg(QLocale().toString(reach_->tiltDeg, 'f', 0), percent(reach_->tilted));
  state_->setText(text);
  if (reach_->better)
    move_->setToolTip(tr("There %1 % is reachable upright, %2 % tilted")
                          .arg(percent(reach_->betterUpright), percent(reach_->betterTilted)));
}

void ReachPanel::retranslate() {
  title_->setText(tr("Reach"));
  title_->setToolTip(
      tr("Reach of the head over the whole height of the part; collisions with printed "
         "material are not checked"));
  map_->setText(tr("Show on plate"));
  move_->setText(tr("Move to best place"));
  showState();
}

void ReachPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  if (event->type() == QEvent::PaletteChange)
    showState();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
