#include "timeline/machine_lanes.h"

#include "forms/colours.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

namespace voluta::timeline {

namespace {
constexpr int kLane = 18, kGap = 4, kMargin = 6;
constexpr double kHandle = 2.0, kMinWait = 2.0; // pixels
} // namespace

MachineLanes::MachineLanes(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void MachineLanes::setLanes(std::vector<Lane> lanes, double endS) {
  lanes_ = std::move(lanes);
  endS_ = endS;
  timeS_ = std::min(timeS_, endS_);
  collisions_.clear();
  updateGeometry();
  update();
}

void MachineLanes::setCollisions(std::vector<double> timesS) {
  collisions_ = std::move(timesS);
  update();
}

void MachineLanes::setTimeS(double timeS) {
  timeS_ = std::clamp(timeS, 0.0, endS_);
  update();
}

QSize MachineLanes::sizeHint() const {
  const int lanes = std::max<int>(1, static_cast<int>(lanes_.size()));
  return {400, 2 * kMargin + lanes * (kLane + kGap) - kGap};
}
QSize MachineLanes::minimumSizeHint() const {
  return {160, sizeHint().height()};
}

int MachineLanes::nameWidth() const {
  int width = 0;
  for (const Lane& lane : lanes_)
    width = std::max(width, fontMetrics().horizontalAdvance(lane.name));
  return width + 2 * kMargin;
}

double MachineLanes::xOf(double timeS) const {
  const double from = nameWidth(), to = width() - kMargin;
  return endS_ > 0.0 ? from + timeS / endS_ * (to - from) : from;
}
double MachineLanes::timeAt(double x) const {
  const double from = nameWidth(), to = width() - kMargin;
  return to > from ? std::clamp((x - from) / (to - from), 0.0, 1.0) * endS_ : 0.0;
}

QRectF MachineLanes::laneRect(std::size_t lane) const {
  const double top = kMargin + static_cast<double>(lane) * (kLane + kGap);
  return {xOf(0.0), top, xOf(endS_) - xOf(0.0), static_cast<double>(kLane)};
}

void MachineLanes::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t k = 0; k < lanes_.size(); ++k) {
    const Lane& lane = lanes_[k];
    const QRectF all = laneRect(k);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(kMargin, all.top(), all.left() - kMargin, all.height()),
                     Qt::AlignLeft | Qt::AlignVCenter, lane.name);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::AlternateBase));
    painter.drawRect(all);
    painter.setBrush(lane.colour);
    painter.drawRect(QRectF(QPointF(all.left(), all.top()), QPointF(xOf(lane.endS), all.bottom())));
    for (const LaneWait& wait : lane.waits) {
      const double from = xOf(wait.fromS), to = std::max(xOf(wait.toS), from + kMinWait);
      const QRectF span(QPointF(from, all.top()), QPointF(to, all.bottom()));
      painter.setBrush(palette().color(QPalette::Window));
      painter.drawRect(span);
      painter.setBrush(QBrush(lane.colour, Qt::BDiagPattern));
      painter.drawRect(span);
    }
  }
  painter.setPen(QPen(forms::blockedColour(palette()), 2.0));
  for (const double timeS : collisions_)
    painter.drawLine(QPointF(xOf(timeS), 0.0), QPointF(xOf(timeS), height()));
  if (!lanes_.empty()) {
    painter.setPen(QPen(palette().color(QPalette::WindowText), kHandle));
    painter.drawLine(QPointF(xOf(timeS_), 1.0), QPointF(xOf(timeS_), height() - 1.0));
  }
}

void MachineLanes::follow(double x) {
  if (lanes_.empty())
    return;
  setTimeS(timeAt(x));
  emit moved(timeS_);
}

void MachineLanes::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    follow(event->position().x());
}
void MachineLanes::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    follow(event->position().x());
}

bool MachineLanes::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip || lanes_.empty())
    return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QString text = textOf_ ? textOf_(timeAt(help->pos().x())) : QString();
  for (std::size_t k = 0; k < lanes_.size(); ++k)
    if (laneRect(k).contains(help->pos()))
      for (const LaneWait& wait : lanes_[k].waits)
        if (help->pos().x() >= xOf(wait.fromS) - kMinWait &&
            help->pos().x() <= xOf(wait.toS) + kMinWait)
          text = wait.text;
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

} // namespace voluta::timeline
