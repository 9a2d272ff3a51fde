#include "viewer/machines_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <cmath>

namespace voluta::viewer {

namespace {
constexpr double kWheelFactor = 1.15, kRadius = 11.0;
} // namespace

// Drawn by Qt over VTK's image: always on top and sharp.
class MachinesView::Numbers : public QWidget {
public:
  explicit Numbers(MachinesView* parent) : QWidget(parent), view_(*parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
  }

protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    for (std::size_t k = 0; k < view_.scene_.machineCount(); ++k) {
      const Eigen::Vector3d display = view_.camera_.project(view_.scene_.placeOfNumber(k));
      if (display.z() < 0.0)
        continue;
      const QPointF at = view_.fromDisplay({display.x(), display.y()});
      const scene::Colour c = scene::MachinesScene::colourOf(k);
      painter.setPen(QPen(Qt::white, 2.0));
      painter.setBrush(QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                                        static_cast<float>(c[2])));
      painter.drawEllipse(at, kRadius, kRadius);
      const double luminance = 0.3 * c[0] + 0.59 * c[1] + 0.11 * c[2];
      painter.setPen(luminance > 0.6 ? Qt::black : Qt::white);
      painter.drawText(QRectF(at.x() - kRadius, at.y() - kRadius, 2.0 * kRadius, 2.0 * kRadius),
                       Qt::AlignCenter, QString::number(k + 1));
    }
  }

private:
  MachinesView& view_;
};

MachinesView::MachinesView(const scene::Theme& theme, QWidget* parent)
    : VtkView(parent), scene_(theme), camera_(scene_.renderer()), numbers_(new Numbers(this)) {
  setObjectName("machinesView");
  setAccessibleName(tr("View of the machines"));
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(320, 240);
  addRenderer(scene_.renderer());
  connect(this, &VtkView::framePainted, numbers_, qOverload<>(&QWidget::update));
}

void MachinesView::frameAll() {
  scene_.frameAll();
  isCameraTheUsers_ = false;
  requestFrame();
}

void MachinesView::moved() {
  isCameraTheUsers_ = true;
  requestFrame();
}

void MachinesView::resizeEvent(QResizeEvent* event) {
  VtkView::resizeEvent(event);
  numbers_->setGeometry(rect());
  if (!isCameraTheUsers_)
    scene_.frameAll();
}

void MachinesView::mousePressEvent(QMouseEvent* event) {
  last_ = event->position();
}

void MachinesView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF d = devicePixelRatioF() * (event->position() - last_);
  last_ = event->position();
  const bool pans = (event->buttons() & (Qt::MiddleButton | Qt::RightButton)) ||
                    (event->modifiers() & Qt::ShiftModifier);
  if (pans)
    camera_.pan(d.x(), -d.y());
  else
    camera_.orbit(d.x(), -d.y());
  moved();
}

void MachinesView::mouseDoubleClickEvent(QMouseEvent*) {
  frameAll();
}

void MachinesView::wheelEvent(QWheelEvent* event) {
  const QPointF display = toDisplay(event->position());
  camera_.zoom(std::pow(kWheelFactor, event->angleDelta().y() / 120.0), display.x(), display.y());
  moved();
  event->accept();
}

} // namespace voluta::viewer
