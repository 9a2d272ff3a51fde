#include "timeline/joint_plots.h"

#include "forms/colours.h"
#include "forms/discard.h"
#include "jobs/job_runner.h"
#include "timeline/chart_canvas.h"
#include "timeline/joint_curves.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace voluta::timeline {

namespace {
constexpr int kMinButton = 30;
constexpr double kMinSpanS = 0.5;
constexpr float kPale = 0.35f;
constexpr double kMargin = 0.05; // of the visible values, above and below

// Distinguishable by colour-blind users; none is red, because red means blocked. One row for light
// palettes, one for dark ones.
constexpr std::array<std::array<QRgb, 8>, 2> kJointColours{
    {{0xff0072b2, 0xffc77f00, 0xff00805d, 0xffb3559c, 0xff2fa3dd, 0xff6b5b00, 0xff555555,
      0xff5b3fa8},
     {0xff4aa8e8, 0xffe69f00, 0xff20c496, 0xffe093c4, 0xff9ad6f5, 0xffe8dc50, 0xffb5b5b5,
      0xffa793ee}}};

QColor jointColour(std::size_t joint, const QPalette& palette) {
  const auto& colours = kJointColours[forms::isDark(palette) ? 1 : 0];
  return QColor::fromRgb(colours[joint % colours.size()]);
}

QIcon swatch(const QColor& colour) {
  QPixmap drawn(16, 16);
  drawn.fill(Qt::transparent);
  QPainter painter(&drawn);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(QRectF(1, 4, 14, 8), 3, 3);
  return QIcon(drawn);
}

struct ValueSpan {
  double low, high;
};

// Returns the range that contains the curves of one quantity.
ValueSpan spanOf(const std::vector<ChartCurve>& curves, const std::vector<ValueRange>& ranges,
                 bool withLimits) {
  ValueSpan span{0.0, 0.0};
  bool any = false;
  const auto hold = [&](double value) {
    span = any ? ValueSpan{std::min(span.low, value), std::max(span.high, value)}
               : ValueSpan{value, value};
    any = true;
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    hold(ranges[i].low);
    hold(ranges[i].high);
    if (withLimits && curves[i].low)
      hold(*curves[i].low);
    if (withLimits && curves[i].high)
      hold(*curves[i].high);
  }
  const double margin = std::max(kMargin * (span.high - span.low), 0.5);
  return {span.low - margin, span.high + margin};
}
} // namespace

JointPlots::JointPlots(QWidget* parent) : QWidget(parent), runner_(new jobs::JobRunner(this)) {
  buildWidgets();
  retranslate();
  applyKind();
  refresh();
}

JointPlots::~JointPlots() = default;

void JointPlots::buildWidgets() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->setSpacing(2);
  // In separate rows: a single one would make the panel wider than the parameters.
  jointRow_ = new QHBoxLayout;
  jointRow_->setSpacing(2);
  column->addLayout(jointRow_);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  auto* kinds = new QButtonGroup(this);
  for (int i = 0; i < 4; ++i) {
    auto* button = new QToolButton(this);
    button->setCheckable(true);
    button->setAutoRaise(true);
    kinds->addButton(button, i);
    kindButtons_.push_back(button);
    row->addWidget(button);
  }
  row->addStretch(1);
  limitsButton_ = new QToolButton(this);
  limitsButton_->setCheckable(true);
  limitsButton_->setChecked(true);
  limitsButton_->setAutoRaise(true);
  column->addLayout(row);
  column->addWidget(limitsButton_, 0, Qt::AlignLeft);
  earlierButton_ = new QToolButton(this);
  earlierButton_->setCheckable(true);
  earlierButton_->setAutoRaise(true);
  column->addWidget(earlierButton_, 0, Qt::AlignLeft);
  connect(kinds, &QButtonGroup::idClicked, this,
          [this](int id) { setKind(static_cast<PlotKind>(id)); });
  connect(limitsButton_, &QToolButton::toggled, this, &JointPlots::refresh);
  connect(earlierButton_, &QToolButton::toggled, this, &JointPlots::refresh);

  angle_ = new ChartCanvas(this);
  speed_ = new ChartCanvas(this);
  jerk_ = new ChartCanvas(this);
  for (ChartCanvas* canvas : {angle_, speed_, jerk_}) {
    column->addWidget(canvas, 1);
    connect(canvas, &ChartCanvas::timeClicked, this, &JointPlots::timeClicked);
    connect(canvas, &ChartCanvas::spanWanted, this, &JointPlots::setSpan);
    connect(canvas, &ChartCanvas::allWanted, this,
            [this] { setSpan(0.0, curves_ ? curves_->durationS() : 0.0); });
  }
  // Both have the same width, so one signal suffices.
  connect(angle_, &ChartCanvas::resized, this, &JointPlots::refresh);
  connect(speed_, &ChartCanvas::resized, this, &JointPlots::refresh);
  connect(jerk_, &ChartCanvas::resized, this, &JointPlots::refresh);
}

void JointPlots::retranslate() {
  const bool slides = std::any_of(limits_.begin(), limits_.end(), [](const auto& limit) {
    return limit.kind == robot::JointKind::Sliding;
  });
  angle_->setAxisTitle(slides ? tr("Angle (°), position (mm)") : tr("Angle (°)"));
  speed_->setAxisTitle(slides ? tr("Speed (°/s, mm/s)") : tr("Speed (°/s)"));
  jerk_->setAxisTitle(slides ? tr("Jerk (rad/s³, mm/s³)") : tr("Jerk (rad/s³)"));
  for (ChartCanvas* canvas : {angle_, speed_, jerk_})
    canvas->setTimeTitle(tr("Time (s)"));
  const std::array<QString, 4> kinds{tr("Angle"), tr("Speed"), tr("Both"), tr("Jerk")};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    kindButtons_[i]->setText(kinds[i]);
  limitsButton_->setText(tr("Limits"));
  limitsButton_->setToolTip(tr("Show the limits of the joints as dashed lines"));
  earlierButton_->setText(tr("Earlier motion"));
  earlierButton_->setToolTip(
      tr("Show the jerk of the motion planned before, in pale colours, to compare"));
  for (std::size_t i = 0; i < jointButtons_.size(); ++i)
    if (const robot::ExternalAxis* axis = externalAxis(i))
      jointButtons_[i]->setToolTip(tr("Show axis %1").arg(QString::fromStdString(axis->name)));
    else
      jointButtons_[i]->setToolTip(tr("Show joint %1").arg(i + 1));
}

void JointPlots::setTrajectory(std::shared_ptr<const plan::Trajectory> trajectory,
                               std::vector<robot::JointLimits> limits,
                               std::vector<robot::ExternalAxis> externalAxes) {
  limits_ = std::move(limits);
  externalAxes_ = std::move(externalAxes);
  if (curves_)
    earlier_ = std::exchange(curves_, nullptr);
  retranslate();
  if (!trajectory || trajectory->pointCount() == 0) {
    earlier_.reset();
    runner_->cancel();
    for (QToolButton* button : jointButtons_)
      button->hide();
    refresh();
    return;
  }
  refresh();
  runner_->run(
      [trajectory = std::move(trajectory),
       kinds = robot::kindsOf(limits_)](const base::RunContext& ctx) {
        return std::make_shared<const JointCurves>(trajectory, kinds, ctx);
      },
      [this](base::Outcome<std::shared_ptr<const JointCurves>> outcome) {
        auto* curves = std::get_if<std::shared_ptr<const JointCurves>>(&outcome);
        if (!curves)
          return;
        curves_ = std::move(*curves);
        fromS_ = 0.0;
        toS_ = std::max(curves_->durationS(), kMinSpanS);
        makeJointButtons();
        refresh();
        emit ready();
      },
      1);
}

// null: a joint of the robot.
const robot::ExternalAxis* JointPlots::externalAxis(std::size_t joint) const {
  const std::size_t after = shown_.size() - std::min(shown_.size(), joint); // including it
  return after <= externalAxes_.size() && after > 0 ? &externalAxes_[externalAxes_.size() - after]
                                                    : nullptr;
}

void JointPlots::makeJointButtons() {
  const std::size_t count = static_cast<std::size_t>(curves_->dof());
  if (jointButtons_.size() != count) {
    for (QToolButton* button : jointButtons_)
      forms::discard(button);
    jointButtons_.clear();
    shown_.assign(count, true);
    for (std::size_t i = 0; i < count; ++i) {
      auto* button = new QToolButton(this);
      button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
      // Seven of them still fit into a panel.
      button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
      button->setMinimumWidth(kMinButton);
      button->setCheckable(true);
      const robot::ExternalAxis* axis = externalAxis(i);
      shown_[i] = !axis || !axis->runsOn;
      button->setChecked(shown_[i]);
      button->setAutoRaise(true);
      connect(button, &QToolButton::toggled, this,
              [this, i](bool on) { setJointShown(static_cast<int>(i), on); });
      jointRow_->addWidget(button);
      jointButtons_.push_back(button);
    }
    retranslate();
  }
  for (QToolButton* button : jointButtons_)
    button->show();
  colourJointButtons();
}

void JointPlots::colourJointButtons() {
  for (std::size_t i = 0; i < jointButtons_.size(); ++i) {
    const robot::ExternalAxis* axis = externalAxis(i);
    jointButtons_[i]->setText(axis ? QString::fromStdString(axis->name)
                                   : QStringLiteral("J%1").arg(i + 1));
  }
  for (std::size_t i = 0; i < jointButtons_.size(); ++i)
    jointButtons_[i]->setIcon(swatch(jointColour(i, palette())));
}

void JointPlots::setKind(PlotKind kind) {
  kind_ = kind;
  applyKind();
  refresh();
}

void JointPlots::applyKind() {
  angle_->setVisible(kind_ == PlotKind::Angle || kind_ == PlotKind::Both);
  speed_->setVisible(kind_ == PlotKind::Speed || kind_ == PlotKind::Both);
  jerk_->setVisible(kind_ == PlotKind::Jerk);
  limitsButton_->setVisible(kind_ != PlotKind::Jerk);
  earlierButton_->setVisible(kind_ == PlotKind::Jerk);
  kindButtons_[static_cast<std::size_t>(kind_)]->setChecked(true);
}

void JointPlots::setEarlierShown(bool shown) {
  earlierButton_->setChecked(shown);
}

void JointPlots::setJointShown(int joint, bool shown) {
  const auto i = static_cast<std::size_t>(joint);
  if (i >= shown_.size() || shown_[i] == shown)
    return;
  shown_[i] = shown;
  jointButtons_[i]->setChecked(shown);
  refresh();
}

bool JointPlots::jointShown(int joint) const {
  const auto i = static_cast<std::size_t>(joint);
  return i < shown_.size() && shown_[i];
}

void JointPlots::setSpan(double fromS, double toS) {
  const double end = curves_ ? std::max(curves_->durationS(), kMinSpanS) : 0.0;
  const double span = std::clamp(toS - fromS, std::min(kMinSpanS, end), end);
  fromS_ = std::clamp(fromS, 0.0, end - span);
  toS_ = fromS_ + span;
  refresh();
}

void JointPlots::setTimeS(double timeS) {
  angle_->setTimeS(timeS);
  speed_->setTimeS(timeS);
  jerk_->setTimeS(timeS);
}

void JointPlots::refresh() {
  limitsButton_->setEnabled(!limits_.empty());
  earlierButton_->setEnabled(static_cast<bool>(earlier_));
  if (!curves_) {
    const QString hint = runner_->running()
                             ? tr("Preparing the curves…")
                             : tr("Joint curves appear here once the motion is planned.");
    for (ChartCanvas* canvas : {angle_, speed_, jerk_}) {
      canvas->setContent({}, 0.0, 1.0, 0.0, 1.0);
      canvas->setHint(hint);
    }
    return;
  }
  if (!jerk_->isHidden())
    refreshJerk();
  const bool limits = limitsButton_->isChecked();
  for (ChartCanvas* canvas : {angle_, speed_}) {
    if (canvas->isHidden())
      continue;
    std::vector<ChartCurve> curves;
    std::vector<ValueRange> ranges;
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      if (!shown_[i])
        continue;
      const int joint = static_cast<int>(i);
      ChartCurve curve;
      curve.colour = jointColour(i, palette());
      const bool angles = canvas == angle_;
      curve.points = angles ? curves_->angle(joint, fromS_, toS_, canvas->columns())
                            : curves_->speed(joint, fromS_, toS_, canvas->columns());
      // For an endlessly turning axis the limits are only those of its counter.
      const robot::ExternalAxis* axis = externalAxis(i);
      if (limits && i < limits_.size() && !(angles && axis && axis->runsOn)) {
        const robot::JointLimits& l = limits_[i];
        curve.low = robot::shownValue(l.kind, angles ? l.min : -l.velocity);
        curve.high = robot::shownValue(l.kind, angles ? l.max : l.velocity);
      }
      ranges.push_back(angles ? curves_->angleRange(joint) : curves_->speedRange(joint));
      curves.push_back(std::move(curve));
    }
    const ValueSpan span = spanOf(curves, ranges, limits);
    canvas->setHint(curves.empty() ? tr("No joint selected.") : QString());
    canvas->setContent(std::move(curves), fromS_, toS_, span.low, span.high);
  }
}

void JointPlots::refreshJerk() {
  std::vector<ChartCurve> curves;
  std::vector<ValueRange> ranges;
  const auto add = [&](const JointCurves& from, bool pale) {
    for (std::size_t i = 0; i < shown_.size(); ++i) {
      const int joint = static_cast<int>(i);
      if (!shown_[i] || joint >= from.dof())
        continue;
      ChartCurve curve;
      curve.colour = jointColour(i, palette());
      if (pale)
        curve.colour.setAlphaF(kPale);
      curve.points = from.jerk(joint, fromS_, toS_, jerk_->columns());
      ranges.push_back(from.jerkRange(joint));
      curves.push_back(std::move(curve));
    }
  };
  if (earlier_ && earlierButton_->isChecked())
    add(*earlier_, true);
  add(*curves_, false);
  const ValueSpan span = spanOf(curves, ranges, false);
  jerk_->setHint(curves.empty() ? tr("No joint selected.") : QString());
  jerk_->setContent(std::move(curves), fromS_, toS_, span.low, span.high);
}

void JointPlots::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
    refresh();
  }
  if (event->type() == QEvent::PaletteChange) {
    colourJointButtons();
    refresh();
  }
  QWidget::changeEvent(event);
}

} // namespace voluta::timeline
