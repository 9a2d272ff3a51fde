#include "panels/frame_form.h"

#include "base/units.h"
#include "forms/value_boxes.h"
#include "geometry/turn_angles.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace voluta::panels {

namespace {
constexpr double kFarthestMm = 20000.0, kMinEdgeMm = 0.1;
constexpr std::array<const char*, 3> kAxes{"X", "Y", "Z"};

void showQuietly(const std::array<forms::NumberBox*, 3>& boxes, const Eigen::Vector3d& values) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QSignalBlocker quiet(boxes[axis]);
    boxes[axis]->setValue(values[static_cast<Eigen::Index>(axis)]);
  }
}

Eigen::Vector3d shown(const std::array<forms::NumberBox*, 3>& boxes) {
  return {boxes[0]->value(), boxes[1]->value(), boxes[2]->value()};
}
} // namespace

FrameForm::FrameForm(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  for (int axis = 0; axis < 3; ++axis)
    grid->addWidget(new QLabel(QLatin1String(kAxes[static_cast<std::size_t>(axis)]), this),
                    axis + 1, 0);
  placeLabel_ = new QLabel(this);
  rotationLabel_ = new QLabel(this);
  sizeLabel_ = new QLabel(this);
  grid->addWidget(placeLabel_, 0, 1);
  grid->addWidget(rotationLabel_, 0, 2);
  grid->addWidget(sizeLabel_, 0, 3);
  place_ = addColumn(1, QStringLiteral("place"), QStringLiteral("mm"), -kFarthestMm, kFarthestMm);
  rotation_ = addColumn(2, QStringLiteral("frameTurn"), QStringLiteral("°"), -360.0, 360.0);
  size_ = addColumn(3, QStringLiteral("edge"), QStringLiteral("mm"), kMinEdgeMm, kFarthestMm);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    connect(place_[axis], &QDoubleSpinBox::valueChanged, this, &FrameForm::changed);
    connect(rotation_[axis], &QDoubleSpinBox::valueChanged, this, [this] {
      angles_ = shown(rotation_) * base::degreesToRadians(1.0);
      changed();
    });
    connect(size_[axis], &QDoubleSpinBox::valueChanged, this,
            [this] { emit sizeChanged(shown(size_)); });
    rotation_[axis]->setSingleStep(5.0);
  }
  retranslate();
}

FrameForm::Boxes FrameForm::addColumn(int column, const QString& name, const QString& unit,
                                      double minimum, double maximum) {
  Boxes boxes;
  auto* grid = static_cast<QGridLayout*>(layout());
  for (int axis = 0; axis < 3; ++axis) {
    auto* box = new forms::NumberBox(this);
    box->setObjectName(name + QLatin1String(kAxes[static_cast<std::size_t>(axis)]));
    box->setUnit(unit);
    box->setDecimals(3);
    box->setRange(minimum, maximum);
    grid->addWidget(box, axis + 1, column);
    grid->setColumnStretch(column, 1);
    boxes[static_cast<std::size_t>(axis)] = box;
  }
  return boxes;
}

void FrameForm::setFrame(const Eigen::Isometry3d& frame) {
  angles_ = geometry::anglesOf(Eigen::Quaterniond(frame.linear()), angles_);
  showQuietly(place_, frame.translation());
  showQuietly(rotation_, angles_ * base::radiansToDegrees(1.0));
}

void FrameForm::setRotationVisible(bool visible) {
  rotationLabel_->setVisible(visible);
  for (forms::NumberBox* box : rotation_)
    box->setVisible(visible);
}

void FrameForm::setSizeMm(const std::optional<Eigen::Vector3d>& sizeMm) {
  sizeLabel_->setVisible(sizeMm.has_value());
  for (forms::NumberBox* box : size_)
    box->setVisible(sizeMm.has_value());
  if (sizeMm)
    showQuietly(size_, *sizeMm);
}

void FrameForm::changed() {
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.translation() = shown(place_);
  frame.linear() = geometry::rotationOf(angles_).toRotationMatrix();
  emit frameChanged(frame);
}

void FrameForm::retranslate() {
  placeLabel_->setText(tr("Place"));
  rotationLabel_->setText(tr("Turn"));
  rotationLabel_->setToolTip(tr("About the fixed X, then Y, then Z axis"));
  sizeLabel_->setText(tr("Edges"));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const QString name = QLatin1String(kAxes[axis]);
    place_[axis]->setAccessibleName(tr("Place along %1").arg(name));
    rotation_[axis]->setAccessibleName(tr("Turn about %1").arg(name));
    size_[axis]->setAccessibleName(tr("Edge along %1").arg(name));
  }
}

void FrameForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
