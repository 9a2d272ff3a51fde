#include "panels/cut_panel.h"

#include "base/units.h"
#include "forms/icons.h"
#include "forms/value_boxes.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::panels {

namespace {
using planar::Joint;
constexpr double kMaxSizeMm = 500.0, kMaxClearanceMm = 5.0;
constexpr int kMaxPins = 12;

bool hasPins(Joint::Kind kind) {
  return kind == Joint::Kind::Dowels || kind == Joint::Kind::Pegs;
}

void setQuietly(QDoubleSpinBox* box, double value) {
  const QSignalBlocker quiet(box);
  box->setValue(value);
}
} // namespace

Eigen::Vector3d cutNormal(const CutChoices& choices) {
  const double a = base::degreesToRadians(choices.tiltDeg[0]);
  const double b = base::degreesToRadians(choices.tiltDeg[1]);
  Eigen::Vector3d normal;
  normal[choices.axis] = std::cos(a) * std::cos(b);
  normal[(choices.axis + 1) % 3] = std::cos(a) * std::sin(b);
  normal[(choices.axis + 2) % 3] = -std::sin(a);
  return normal.normalized();
}

std::array<double, 2> cutTiltDeg(const Eigen::Vector3d& normal, int axis) {
  return {base::radiansToDegrees(-std::asin(std::clamp(normal[(axis + 2) % 3], -1.0, 1.0))),
          base::radiansToDegrees(std::atan2(normal[(axis + 1) % 3], normal[axis]))};
}

CutPanel::CutPanel(QWidget* parent) : QWidget(parent) {
  build();
  retranslate();
  showChoices();
}

QLabel* CutPanel::addRow(QGridLayout& grid, QWidget* field) {
  auto* label = new QLabel(this);
  label->setBuddy(field);
  const int row = grid.rowCount();
  grid.addWidget(label, row, 0);
  grid.addWidget(field, row, 1);
  return label;
}

forms::NumberBox* CutPanel::number(const char* name, const char* unit, double low, double high,
                                   std::function<void(double)> takes) {
  auto* box = new forms::NumberBox(this);
  box->setObjectName(QLatin1String(name));
  box->setUnit(QString::fromUtf8(unit));
  box->setDecimals(3);
  box->setRange(low, high);
  connect(box, &QDoubleSpinBox::valueChanged, this, [this, takes = std::move(takes)](double value) {
    takes(value);
    emit changed();
  });
  return box;
}

void CutPanel::build() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 6, 6, 6);
  grid->setSpacing(4);
  grid->setColumnStretch(1, 1);
  title_ = new QLabel(this);
  title_->setObjectName(QStringLiteral("cutTitle"));
  title_->setTextFormat(Qt::PlainText);
  QFont bold = font();
  bold.setBold(true);
  title_->setFont(bold);
  title_->setWordWrap(true);
  grid->addWidget(title_, 0, 0, 1, 2);
  buildPlane(*grid);
  buildJoint(*grid);
  buildButtons(*grid);
  grid->setRowStretch(grid->rowCount(), 1);
}

void CutPanel::buildPlane(QGridLayout& grid) {
  axis_ = forms::makeCombo(this);
  axis_->setObjectName(QStringLiteral("cutAxis"));
  axis_->addItems({QStringLiteral("X"), QStringLiteral("Y"), QStringLiteral("Z")});
  connect(axis_, &QComboBox::activated, this, [this](int axis) {
    choices_.axis = axis;
    choices_.tiltDeg = {};
    retranslate(); // the tilts name their axes
    emit axisChosen();
  });
  position_ =
      number("cutPosition", "mm", 0.0, 1.0, [this](double mm) { choices_.positionMm = mm; });
  for (std::size_t k = 0; k < 2; ++k)
    tilt_[k] =
        number(k == 0 ? "cutTilt1" : "cutTilt2", "°", k == 0 ? -90.0 : -180.0,
               k == 0 ? 90.0 : 180.0, [this, k](double degrees) { choices_.tiltDeg[k] = degrees; });
  face_ = new QPushButton(this);
  face_->setObjectName(QStringLiteral("cutFace"));
  face_->setCheckable(true);
  connect(face_, &QPushButton::toggled, this, &CutPanel::facePicking);
  keep_ = forms::makeCombo(this);
  keep_->setObjectName(QStringLiteral("cutKeep"));
  keep_->addItems({{}, {}, {}});
  connect(keep_, &QComboBox::activated, this, [this](int keep) {
    choices_.keep = static_cast<CutChoices::Keep>(keep);
    emit changed();
  });
  axisLabel_ = addRow(grid, axis_);
  positionLabel_ = addRow(grid, position_);
  for (std::size_t k = 0; k < 2; ++k)
    tiltLabel_[k] = addRow(grid, tilt_[k]);
  grid.addWidget(face_, grid.rowCount(), 1);
  keepLabel_ = addRow(grid, keep_);
}

void CutPanel::buildJoint(QGridLayout& grid) {
  joint_ = forms::makeCombo(this);
  joint_->setObjectName(QStringLiteral("cutJoint"));
  joint_->addItems({{}, {}, {}, {}});
  connect(joint_, &QComboBox::activated, this, [this](int kind) {
    choices_.joint.kind = static_cast<Joint::Kind>(kind);
    retranslate(); // the size is that of a pin or of a dovetail
    showChoices();
    emit changed();
  });
  Joint& joint = choices_.joint;
  size_ = number("cutSize", "mm", 0.5, kMaxSizeMm, [&joint](double mm) { joint.sizeMm = mm; });
  depth_ = number("cutDepth", "mm", 0.5, kMaxSizeMm, [&joint](double mm) { joint.depthMm = mm; });
  clearance_ = number("cutClearance", "mm", 0.0, kMaxClearanceMm,
                      [&joint](double mm) { joint.clearanceMm = mm; });
  clearance_->setSingleStep(0.05);
  direction_ = number("cutDirection", "°", -180.0, 180.0, [&joint](double degrees) {
    joint.directionRad = base::degreesToRadians(degrees);
  });
  direction_->setSingleStep(15.0);
  count_ = forms::makeIntegerBox(this);
  count_->setObjectName(QStringLiteral("cutCount"));
  count_->setRange(1, kMaxPins);
  connect(count_, &QSpinBox::valueChanged, this, [this](int count) {
    choices_.joint.count = count;
    emit changed();
  });
  jointLabel_ = addRow(grid, joint_);
  sizeLabel_ = addRow(grid, size_);
  depthLabel_ = addRow(grid, depth_);
  clearanceLabel_ = addRow(grid, clearance_);
  countLabel_ = addRow(grid, count_);
  directionLabel_ = addRow(grid, direction_);
}

void CutPanel::buildButtons(QGridLayout& grid) {
  layFlat_ = new QCheckBox(this);
  layFlat_->setObjectName(QStringLiteral("cutLayFlat"));
  connect(layFlat_, &QCheckBox::toggled, this, [this](bool on) { choices_.laysFlat = on; });
  apart_ = new QCheckBox(this);
  apart_->setObjectName(QStringLiteral("cutApart"));
  connect(apart_, &QCheckBox::toggled, this, [this](bool on) {
    choices_.showsApart = on;
    emit changed();
  });
  icon_ = new QLabel(this);
  state_ = new QLabel(this);
  state_->setObjectName(QStringLiteral("cutState"));
  state_->setWordWrap(true);
  cut_ = new QPushButton(this);
  cut_->setObjectName(QStringLiteral("cutApply"));
  close_ = new QPushButton(this);
  close_->setObjectName(QStringLiteral("cutClose"));
  connect(cut_, &QPushButton::clicked, this, &CutPanel::cutRequested);
  connect(close_, &QPushButton::clicked, this, &CutPanel::closeRequested);
  for (QWidget* line : {static_cast<QWidget*>(layFlat_), static_cast<QWidget*>(apart_)})
    grid.addWidget(line, grid.rowCount(), 0, 1, 2);
  auto* said = new QHBoxLayout;
  said->addWidget(icon_, 0, Qt::AlignTop);
  said->addWidget(state_, 1);
  grid.addLayout(said, grid.rowCount(), 0, 1, 2);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(cut_, 1);
  buttons->addWidget(close_, 1);
  grid.addLayout(buttons, grid.rowCount(), 0, 1, 2);
}

void CutPanel::setPart(const QString& name, const Eigen::Vector3d& sizeMm) {
  name_ = name;
  sizeMm_ = sizeMm;
  showChoices();
  retranslate();
}

void CutPanel::setChoices(const CutChoices& choices) {
  choices_ = choices;
  showChoices();
}

void CutPanel::setPickingFace(bool on) {
  const QSignalBlocker quiet(face_);
  face_->setChecked(on);
}

void CutPanel::setState(const QString& text, bool isProblem, bool canCut) {
  icon_->setVisible(isProblem);
  icon_->setPixmap(forms::iconBeside(*this, forms::Icon::Warning));
  state_->setText(text);
  cut_->setEnabled(canCut);
}

void CutPanel::showChoices() {
  axis_->setCurrentIndex(choices_.axis);
  {
    const QSignalBlocker quiet(position_);
    position_->setRange(0.0, std::max(1e-3, sizeMm_[choices_.axis]));
  }
  setQuietly(position_, choices_.positionMm);
  for (std::size_t k = 0; k < 2; ++k)
    setQuietly(tilt_[k], choices_.tiltDeg[k]);
  keep_->setCurrentIndex(static_cast<int>(choices_.keep));
  const Joint& joint = choices_.joint;
  joint_->setCurrentIndex(static_cast<int>(joint.kind));
  setQuietly(size_, joint.sizeMm);
  setQuietly(depth_, joint.depthMm);
  setQuietly(clearance_, joint.clearanceMm);
  setQuietly(direction_, base::radiansToDegrees(joint.directionRad));
  {
    const QSignalBlocker quiet(count_);
    count_->setValue(joint.count);
  }
  const bool any = joint.kind != Joint::Kind::None;
  for (QWidget* of : {static_cast<QWidget*>(sizeLabel_), static_cast<QWidget*>(size_),
                      static_cast<QWidget*>(depthLabel_), static_cast<QWidget*>(depth_),
                      static_cast<QWidget*>(clearanceLabel_), static_cast<QWidget*>(clearance_)})
    of->setVisible(any);
  countLabel_->setVisible(hasPins(joint.kind));
  count_->setVisible(hasPins(joint.kind));
  directionLabel_->setVisible(joint.kind == Joint::Kind::Dovetail);
  direction_->setVisible(joint.kind == Joint::Kind::Dovetail);
}

void CutPanel::retranslate() {
  title_->setText(name_.isEmpty() ? tr("Cut") : tr("Cut %1").arg(name_));
  axisLabel_->setText(tr("Perpendicular to"));
  positionLabel_->setText(tr("Position"));
  position_->setToolTip(tr("Distance from the lowest point of the part along the axis"));
  for (int k = 0; k < 2; ++k) {
    const QString axis(QChar(u'X' + (choices_.axis + 1 + k) % 3));
    tiltLabel_[static_cast<std::size_t>(k)]->setText(tr("Tilt about %1").arg(axis));
  }
  face_->setText(tr("Parallel to a face"));
  face_->setToolTip(tr("Then click the face; the plane goes through the clicked point"));
  keepLabel_->setText(tr("Keep"));
  keep_->setItemText(0, tr("Both halves"));
  keep_->setItemText(1, tr("Lower half"));
  keep_->setItemText(2, tr("Upper half"));
  jointLabel_->setText(tr("Joint"));
  joint_->setItemText(0, tr("None"));
  joint_->setItemText(1, tr("Dowels"));
  joint_->setItemText(2, tr("Pegs"));
  joint_->setItemText(3, tr("Dovetail"));
  joint_->setToolTip(tr("Dowels: loose pins in holes of both halves. Pegs: pins of the lower half. "
                        "Dovetail: a tongue of the lower half in a groove."));
  const bool isDovetail = choices_.joint.kind == Joint::Kind::Dovetail;
  sizeLabel_->setText(isDovetail ? tr("Width") : tr("Diameter"));
  depthLabel_->setText(isDovetail ? tr("Height") : tr("Depth"));
  depth_->setToolTip(isDovetail ? tr("Height of the tongue") : tr("Of a pin in each half"));
  clearanceLabel_->setText(tr("Clearance"));
  clearance_->setToolTip(tr("Gap on every side of a pin or of the tongue"));
  countLabel_->setText(tr("Number"));
  count_->setToolTip(tr("Pins in each section, if there is room"));
  directionLabel_->setText(tr("Direction"));
  direction_->setToolTip(tr("In which the dovetail slides, from the horizontal"));
  layFlat_->setText(tr("Lay halves on their cut face"));
  layFlat_->setToolTip(tr("A half with pegs or a tongue keeps its orientation"));
  apart_->setText(tr("Show apart"));
  cut_->setText(tr("Cut"));
  close_->setText(tr("Close"));
}

void CutPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
