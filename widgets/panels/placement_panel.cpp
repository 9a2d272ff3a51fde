#include "panels/placement_panel.h"

#include "base/units.h"
#include "forms/value_boxes.h"
#include "geometry/turn_angles.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

namespace voluta::panels {

namespace {
constexpr double kFarthestMm = 5000.0;
constexpr double kLargestFactor = 10000.0, kSmallestFactor = 0.0001;
constexpr double kSmallestSize = 0.001, kLargestSize = 100000.0;
constexpr double kInchMm = 25.4;
constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"};

void showQuietly(forms::NumberBox* box, double value) {
  const QSignalBlocker quiet(box);
  box->setValue(value);
}
} // namespace

PlacementPanel::PlacementPanel(QWidget* parent) : QWidget(parent) {
  build();
  retranslate();
  showPlacement();
  showScale();
}

void PlacementPanel::build() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 6, 6, 6);
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(2, 1);

  moveLabel_ = new QLabel(this);
  rotationLabel_ = new QLabel(this);
  grid->addWidget(moveLabel_, 0, 1);
  grid->addWidget(rotationLabel_, 0, 2, 1, 3);
  for (int axis = 0; axis < 3; ++axis)
    buildAxis(axis, *grid);
  buildScale(*grid);
  buildSize(*grid);
  buildButtons(*grid);
  listenToButtons();
}

void PlacementPanel::buildAxis(int axis, QGridLayout& grid) {
  const auto at = static_cast<std::size_t>(axis);
  const QString name = QLatin1String(kAxes[at]);
  axis_[at] = new QLabel(name, this);
  move_[at] = new forms::NumberBox(this);
  move_[at]->setObjectName(QStringLiteral("move") + name);
  move_[at]->setUnit(QStringLiteral("mm"));
  move_[at]->setDecimals(3);
  move_[at]->setRange(axis == 2 ? 0.0 : -kFarthestMm, kFarthestMm);
  connect(move_[at], &QDoubleSpinBox::valueChanged, this,
          [this, axis](double mm) { moved(axis, mm); });
  rotation_[at] = new forms::NumberBox(this);
  rotation_[at]->setObjectName(QStringLiteral("turn") + name);
  rotation_[at]->setUnit(QStringLiteral("°"));
  rotation_[at]->setDecimals(3);
  rotation_[at]->setRange(-360.0, 360.0);
  rotation_[at]->setSingleStep(5.0);
  connect(rotation_[at], &QDoubleSpinBox::valueChanged, this,
          [this, axis](double angle) { turned(axis, angle); });
  const auto quarter = [&](const QString& text, double angle) {
    auto* button = new QToolButton(this);
    button->setText(text);
    connect(button, &QToolButton::clicked, this, [this, axis, angle] { rotateBy(axis, angle); });
    return button;
  };
  less_[at] = quarter(QStringLiteral("−90"), -90.0);
  less_[at]->setObjectName(QStringLiteral("less") + name);
  more_[at] = quarter(QStringLiteral("+90"), 90.0);
  more_[at]->setObjectName(QStringLiteral("more") + name);
  for (forms::NumberBox* box : {move_[at], rotation_[at]})
    box->setMinimumWidth(fontMetrics().averageCharWidth() * 8);
  grid.addWidget(axis_[at], axis + 1, 0);
  grid.addWidget(move_[at], axis + 1, 1);
  grid.addWidget(rotation_[at], axis + 1, 2);
  grid.addWidget(less_[at], axis + 1, 3);
  grid.addWidget(more_[at], axis + 1, 4);
}

void PlacementPanel::buildScale(QGridLayout& grid) {
  percentLabel_ = new QLabel(this);
  percent_ = new forms::NumberBox(this);
  percent_->setObjectName(QStringLiteral("percent"));
  percent_->setUnit(QStringLiteral("%"));
  percent_->setDecimals(2);
  percent_->setRange(kSmallestFactor * 100.0, kLargestFactor * 100.0);
  percent_->setSingleStep(5.0);
  connect(percent_, &QDoubleSpinBox::valueChanged, this, [this](double percent) {
    setScale(QString::number(percent / 100.0, 'g', 8), percent / 100.0);
    emit scaleChanged(scaleText_);
  });
  scale_ = new forms::NumberBox(this);
  scale_->setObjectName(QStringLiteral("factor"));
  scale_->setPrefix(QStringLiteral("× "));
  scale_->setRange(kSmallestFactor, kLargestFactor);
  scale_->setSingleStep(0.1);
  connect(scale_, &QDoubleSpinBox::valueChanged, this, [this](double factor) {
    setScale(QString::number(factor, 'g', 8), factor);
    emit scaleChanged(scaleText_);
  });
  fit_ = new QPushButton(this);
  fit_->setObjectName(QStringLiteral("fit"));
  fit_->setCheckable(true);
  connect(fit_, &QPushButton::clicked, this, [this](bool fit) {
    setScale(fit ? QStringLiteral("fit") : QString::number(factor_, 'g', 8), factor_);
    emit scaleChanged(scaleText_);
  });
  auto* scaleRow = new QHBoxLayout;
  scaleRow->setSpacing(4);
  for (forms::NumberBox* box : {percent_, scale_})
    box->setMinimumWidth(fontMetrics().averageCharWidth() * 8);
  scaleRow->addWidget(percent_, 1);
  scaleRow->addWidget(scale_, 1);
  grid.addWidget(percentLabel_, 4, 0, 1, 5);
  grid.addLayout(scaleRow, 5, 0, 1, 5);
  grid.addWidget(fit_, 6, 0, 1, 5);
}

void PlacementPanel::buildSize(QGridLayout& grid) {
  sizeLabel_ = new QLabel(this);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (int axis = 0; axis < 3; ++axis) {
    auto* box = new forms::NumberBox(this);
    size_[static_cast<std::size_t>(axis)] = box;
    box->setObjectName(QStringLiteral("size") +
                       QLatin1String(kAxes[static_cast<std::size_t>(axis)]));
    box->setDecimals(3);
    box->setRange(kSmallestSize, kLargestSize);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setMinimumWidth(fontMetrics().averageCharWidth() * 7);
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, axis](double shown) { resizeTo(axis, shown); });
    row->addWidget(box, 1);
  }
  unit_ = new QComboBox(this);
  unit_->setObjectName(QStringLiteral("sizeUnit"));
  unit_->addItems({QStringLiteral("mm"), QStringLiteral("in")});
  connect(unit_, &QComboBox::activated, this, &PlacementPanel::showSize);
  row->addWidget(unit_);
  grid.addWidget(sizeLabel_, 7, 0, 1, 5);
  grid.addLayout(row, 8, 0, 1, 5);
}

double PlacementPanel::unitMm() const {
  return unit_->currentIndex() == 1 ? kInchMm : 1.0;
}

void PlacementPanel::resizeTo(int axis, double shown) {
  if (sizeMm_[axis] <= 0.0)
    return;
  const double factor = factor_ * shown * unitMm() / sizeMm_[axis];
  if (factor < kSmallestFactor || factor > kLargestFactor) {
    showSize();
    return;
  }
  sizeMm_ *= factor / factor_;
  setScale(QString::number(factor, 'g', 8), factor);
  showSize();
  emit scaleChanged(scaleText_);
}

void PlacementPanel::buildButtons(QGridLayout& grid) {
  const auto button = [this](const char* name) {
    auto* made = new QPushButton(this);
    made->setObjectName(QLatin1String(name));
    made->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    return made;
  };
  drop_ = button("drop");
  centre_ = button("centre");
  layOnFace_ = button("layOnFace");
  layOnFace_->setCheckable(true);
  reset_ = button("reset");
  auto* buttons = new QGridLayout;
  buttons->setSpacing(4);
  buttons->addWidget(drop_, 0, 0);
  buttons->addWidget(layOnFace_, 0, 1);
  buttons->addWidget(centre_, 1, 0);
  buttons->addWidget(reset_, 1, 1);
  grid.addLayout(buttons, 9, 0, 1, 5);
}

void PlacementPanel::listenToButtons() {
  connect(drop_, &QPushButton::clicked, this, [this] {
    geometry::Placement next = placement_;
    next.liftMm = 0.0;
    change(next, tr("Drop to plate"));
  });
  connect(centre_, &QPushButton::clicked, this, [this] {
    geometry::Placement next = placement_;
    next.centreMm.setZero();
    change(next, tr("Centre"));
  });
  connect(reset_, &QPushButton::clicked, this, [this] {
    angles_.setZero();
    change({}, tr("Reset placement"));
    if (scaleText_ != QLatin1String("1")) {
      setScale(QStringLiteral("1"), 1.0);
      emit scaleChanged(scaleText_);
    }
  });
  connect(layOnFace_, &QPushButton::toggled, this, &PlacementPanel::layOnFaceToggled);
}

void PlacementPanel::setPlacement(const geometry::Placement& placement) {
  placement_ = placement;
  angles_ = geometry::anglesOf(placement.rotation, angles_);
  showPlacement();
}

void PlacementPanel::setScale(const QString& text, double factor) {
  scaleText_ = text;
  if (factor > 0.0)
    factor_ = factor;
  showScale();
}

void PlacementPanel::setSizeMm(const Eigen::Vector3d& sizeMm) {
  sizeMm_ = sizeMm;
  showSize();
}

void PlacementPanel::setLayOnFace(bool waiting) {
  const QSignalBlocker quiet(layOnFace_);
  layOnFace_->setChecked(waiting);
}

void PlacementPanel::showPlacement() {
  showQuietly(move_[0], placement_.centreMm.x());
  showQuietly(move_[1], placement_.centreMm.y());
  showQuietly(move_[2], placement_.liftMm);
  for (int axis = 0; axis < 3; ++axis)
    showQuietly(rotation_[static_cast<std::size_t>(axis)], base::radiansToDegrees(angles_[axis]));
}

void PlacementPanel::showScale() {
  fit_->setChecked(scaleText_ == QLatin1String("fit"));
  showQuietly(percent_, 100.0 * factor_);
  showQuietly(scale_, factor_);
}

void PlacementPanel::setOnPlate(bool onPlate) {
  const QSignalBlocker quiet(move_[2]);
  move_[2]->setMinimum(onPlate ? 0.0 : -kFarthestMm);
  drop_->setEnabled(onPlate);
}

void PlacementPanel::showSize() {
  for (int axis = 0; axis < 3; ++axis) {
    forms::NumberBox* box = size_[static_cast<std::size_t>(axis)];
    box->setEnabled(sizeMm_[axis] > 0.0);
    showQuietly(box, sizeMm_[axis] / unitMm());
  }
}

void PlacementPanel::moved(int axis, double mm) {
  geometry::Placement next = placement_;
  if (axis == 2)
    next.liftMm = mm;
  else
    next.centreMm[axis] = mm;
  change(next, tr("Move"));
}

void PlacementPanel::turned(int axis, double angle) {
  geometry::Placement next = placement_;
  angles_[axis] = base::degreesToRadians(angle);
  next.rotation = geometry::rotationOf(angles_);
  change(next, tr("Turn"));
}

void PlacementPanel::rotateBy(int axis, double angle) {
  geometry::Placement next = placement_;
  next.rotation = Eigen::AngleAxisd(base::degreesToRadians(angle), Eigen::Vector3d::Unit(axis)) *
                  placement_.rotation.normalized();
  change(next, tr("Turn"));
}

void PlacementPanel::change(const geometry::Placement& placement, const QString& editName) {
  setPlacement(placement);
  emit placementChanged(placement_, editName);
}

void PlacementPanel::retranslate() {
  moveLabel_->setText(tr("Move"));
  rotationLabel_->setText(tr("Turn"));
  rotationLabel_->setToolTip(tr("About the fixed axes: first X, then Y, then Z"));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QString name = QLatin1String(kAxes[axis]);
    move_[axis]->setToolTip(axis == 2 ? tr("Height of the lowest point above the plate")
                                      : tr("Centre of the part along %1").arg(name));
    move_[axis]->setAccessibleName(tr("Move %1").arg(name));
    rotation_[axis]->setToolTip(
        tr("Rotate about the fixed axis %1; X comes first, then Y, then Z").arg(name));
    rotation_[axis]->setAccessibleName(tr("Rotate %1").arg(name));
    less_[axis]->setToolTip(tr("Rotate by -90° about %1, from the present orientation").arg(name));
    more_[axis]->setToolTip(tr("Rotate by 90° about %1, from the present orientation").arg(name));
    for (QWidget* quarter :
         {static_cast<QWidget*>(less_[axis]), static_cast<QWidget*>(more_[axis])})
      quarter->setAccessibleName(quarter->toolTip());
  }
  percentLabel_->setText(tr("Scale"));
  percent_->setAccessibleName(tr("Scale in percent"));
  scale_->setAccessibleName(tr("Scale as a factor"));
  fit_->setText(tr("Fit to reach"));
  fit_->setToolTip(tr("Scale down, if necessary, to the size that the arm reaches everywhere"));
  sizeLabel_->setText(tr("Size"));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QString name = QLatin1String(kAxes[axis]);
    size_[axis]->setToolTip(tr("Size along %1. A new size scales the part as a whole.").arg(name));
    size_[axis]->setAccessibleName(tr("Size along %1").arg(name));
  }
  unit_->setToolTip(tr("Millimetres or inches"));
  unit_->setAccessibleName(tr("Unit of the size"));
  drop_->setText(tr("Drop to plate"));
  layOnFace_->setText(tr("Lay on face"));
  layOnFace_->setToolTip(tr("Then click the face to place on the plate"));
  centre_->setText(tr("Centre"));
  centre_->setToolTip(tr("Put the centre of the part over the centre of the plate"));
  reset_->setText(tr("Reset"));
  reset_->setToolTip(tr("Position and size as in the file"));
  showSize();
}

void PlacementPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
