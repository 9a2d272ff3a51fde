#include "panels/jog_panel.h"

#include "forms/value_boxes.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

namespace voluta::panels {

namespace {
constexpr int kTicks = 10; // of a slider, per degree or mm
constexpr double kWideMm = 1e5, kWideDeg = 360.0;
constexpr const char* kAxes[] = {"X", "Y", "Z", "A", "B", "C"};

bool isLength(int coordinate) {
  return coordinate < 3;
}

forms::NumberBox* numberBox(QWidget* parent, bool length, int decimals) {
  auto* box = new forms::NumberBox(parent);
  box->setUnit(length ? QStringLiteral("mm") : QStringLiteral("°"));
  box->setDecimals(decimals);
  box->setRange(length ? -kWideMm : -kWideDeg, length ? kWideMm : kWideDeg);
  // The limits have fewer digits than the values between them.
  box->setMinimumWidth(box->fontMetrics().horizontalAdvance(QStringLiteral("-000.00° ")) +
                       2 * box->fontMetrics().height());
  return box;
}

// A program's value is no wish of the user.
template <typename Box, typename Value> void setQuietly(Box* box, Value value) {
  const QSignalBlocker quiet(box);
  box->setValue(value);
}
} // namespace

JogPanel::JogPanel(QWidget* parent)
    : QWidget(parent), jointGrid_(new QGridLayout), nozzleGrid_(new QGridLayout),
      stepMm_(numberBox(this, true, 2)), stepDeg_(numberBox(this, false, 2)),
      jointHeading_(new QLabel(this)), nozzleHeading_(new QLabel(this)), step_(new QLabel(this)),
      sign_(new QLabel(this)), message_(new QLabel(this)), end_(new QPushButton(this)) {
  message_->setObjectName(QStringLiteral("jogMessage"));
  message_->setWordWrap(true);
  message_->setTextFormat(Qt::PlainText);
  end_->setObjectName(QStringLiteral("jogEnd"));
  end_->setAutoDefault(false);
  stepMm_->setObjectName(QStringLiteral("jogStepMm"));
  stepMm_->setRange(0.01, 1000.0);
  stepMm_->setValue(10.0);
  stepDeg_->setObjectName(QStringLiteral("jogStepDeg"));
  stepDeg_->setRange(0.01, 90.0);
  stepDeg_->setValue(5.0);
  QFont bold = jointHeading_->font();
  bold.setBold(true);
  for (QLabel* heading : {jointHeading_, nozzleHeading_})
    heading->setFont(bold);

  auto* said = new QHBoxLayout;
  said->addWidget(sign_, 0, Qt::AlignTop);
  said->addWidget(message_, 1);
  auto* steps = new QHBoxLayout;
  steps->addWidget(step_);
  steps->addWidget(stepMm_, 1);
  steps->addWidget(stepDeg_, 1);
  for (QGridLayout* grid : {jointGrid_, nozzleGrid_}) {
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
  }
  jointGrid_->setColumnStretch(1, 1);
  nozzleGrid_->setColumnStretch(3, 1);
  for (int coordinate = 0; coordinate < 6; ++coordinate)
    coordinates_[static_cast<std::size_t>(coordinate)] = addCoordinate(coordinate);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->addLayout(said);
  column->addWidget(end_, 0, Qt::AlignLeft);
  column->addWidget(jointHeading_);
  column->addLayout(jointGrid_);
  column->addWidget(nozzleHeading_);
  column->addLayout(steps);
  column->addLayout(nozzleGrid_);
  column->addStretch(1);
  connect(end_, &QPushButton::clicked, this, &JogPanel::endWished);
  retranslate();
}

JogPanel::JointRow JogPanel::addJoint(int joint, const JogJoint& from) {
  JointRow row{new QLabel(from.name, this), new QSlider(Qt::Horizontal, this),
               numberBox(this, from.slides, 2)};
  row.name->setBuddy(row.box);
  row.slider->setObjectName(QStringLiteral("jogSlider%1").arg(joint + 1));
  row.slider->setRange(static_cast<int>(std::ceil(from.minimum * kTicks)),
                       static_cast<int>(std::floor(from.maximum * kTicks)));
  row.slider->setSingleStep(kTicks);
  row.slider->setPageStep(10 * kTicks);
  forms::tameWheel(row.slider);
  row.box->setObjectName(QStringLiteral("jogJoint%1").arg(joint + 1));
  row.box->setRange(from.minimum, from.maximum);
  jointGrid_->addWidget(row.name, joint, 0);
  jointGrid_->addWidget(row.slider, joint, 1);
  jointGrid_->addWidget(row.box, joint, 2);
  connect(row.slider, &QSlider::valueChanged, this, [this, joint](int ticks) {
    emit jointWished(joint, static_cast<double>(ticks) / kTicks);
  });
  connect(row.box, &QDoubleSpinBox::valueChanged, this,
          [this, joint](double value) { emit jointWished(joint, value); });
  return row;
}

JogPanel::CoordinateRow JogPanel::addCoordinate(int coordinate) {
  const QString axis = QLatin1String(kAxes[coordinate]);
  CoordinateRow row{new QLabel(axis, this), new QToolButton(this), new QToolButton(this),
                    numberBox(this, isLength(coordinate), 2)};
  row.name->setBuddy(row.box);
  row.less->setText(QStringLiteral("−"));
  row.more->setText(QStringLiteral("+"));
  row.less->setObjectName(QStringLiteral("jogLess") + axis);
  row.more->setObjectName(QStringLiteral("jogMore") + axis);
  row.box->setObjectName(QStringLiteral("jog") + axis);
  int column = 0;
  for (QWidget* widget : {static_cast<QWidget*>(row.name), static_cast<QWidget*>(row.less),
                          static_cast<QWidget*>(row.more), static_cast<QWidget*>(row.box)})
    nozzleGrid_->addWidget(widget, coordinate, column++);
  for (const auto& [button, sign] : {std::pair(row.less, -1.0), std::pair(row.more, 1.0)}) {
    button->setAutoRepeat(true);
    button->setFocusPolicy(Qt::TabFocus);
    connect(button, &QToolButton::clicked, this, [this, coordinate, sign = sign] {
      const double step = (isLength(coordinate) ? stepMm_ : stepDeg_)->value();
      emit stepWished(coordinate, sign * step);
    });
  }
  connect(row.box, &QDoubleSpinBox::valueChanged, this,
          [this, coordinate](double value) { emit coordinateWished(coordinate, value); });
  return row;
}

void JogPanel::setJoints(const std::vector<JogJoint>& joints) {
  if (joints == given_)
    return;
  for (const JointRow& row : joints_)
    for (QWidget* widget : {static_cast<QWidget*>(row.name), static_cast<QWidget*>(row.slider),
                            static_cast<QWidget*>(row.box)})
      delete widget;
  joints_.clear();
  given_ = joints;
  QWidget* before = end_;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    joints_.push_back(addJoint(static_cast<int>(i), joints[i]));
    setTabOrder(before, joints_.back().slider);
    setTabOrder(joints_.back().slider, joints_.back().box);
    before = joints_.back().box;
  }
  retranslate();
}

void JogPanel::setState(const JogState& state) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    setQuietly(joints_[i].slider, static_cast<int>(std::lround(state.joints[i] * kTicks)));
    setQuietly(joints_[i].box, state.joints[i]);
  }
  for (std::size_t i = 0; i < coordinates_.size(); ++i) {
    const double value = state.coordinates[i];
    setQuietly(coordinates_[i].box, std::abs(value) < 0.005 ? 0.0 : value); // no "-0"
  }
  sign_->setPixmap(forms::iconBeside(*this, state.sign));
  message_->setText(state.message);
}

void JogPanel::retranslate() {
  jointHeading_->setText(tr("Joints"));
  nozzleHeading_->setText(tr("Nozzle"));
  nozzleHeading_->setToolTip(tr("The tip on the platform, and rotations about X, Y and Z (A, B, C) "
                                "from the upright nozzle"));
  step_->setText(tr("Step"));
  stepMm_->setAccessibleName(tr("Step of X, Y and Z"));
  stepDeg_->setAccessibleName(tr("Step of A, B and C"));
  end_->setText(tr("Back to the plan"));
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const QString name = tr("Joint %1").arg(given_[i].name);
    joints_[i].slider->setAccessibleName(name);
    joints_[i].box->setAccessibleName(name);
  }
  for (std::size_t i = 0; i < coordinates_.size(); ++i) {
    const QString axis = QLatin1String(kAxes[i]);
    coordinates_[i].box->setAccessibleName(axis);
    coordinates_[i].less->setAccessibleName(tr("%1 one step less").arg(axis));
    coordinates_[i].more->setAccessibleName(tr("%1 one step more").arg(axis));
  }
}

void JogPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
