#include "viewer/viewport.h"

#include "base/units.h"
#include "viewer/view_cube.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyleHints>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>
#include <vtkRenderer.h>

namespace voluta::viewer {

namespace {
constexpr int kMargin = 10;
constexpr int kSettleMs = 180; // Delay after the last wheel step until full detail is restored
constexpr int kRestMs = 120;   // Delay after which the cursor counts as resting
constexpr std::size_t kCardTriangles = 3'000'000; // that any card draws in a frame
constexpr double kWheelFactor = 1.15, kKeyOrbitPixels = 30.0;
} // namespace

// The handles, drawn by Qt over VTK's image: always on top and sharp.
class Viewport::Overlay : public QWidget {
public:
  explicit Overlay(Viewport* parent) : QWidget(parent), viewport_(*parent) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
  }

protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!viewport_.marks_.empty())
      paintMarks(painter);
    if (viewport_.band_)
      paintBand(painter);
    if (!hasHandles(viewport_.gizmo_.tool()))
      return;
    viewport_.gizmo_.paint(
        painter, [this](const Eigen::Vector3d& p) { return viewport_.projected(p); },
        viewport_.gizmoMmPerPixel(), palette());
    if (viewport_.gizmoText_.isEmpty())
      return;
    const QRectF text = painter.boundingRect(QRectF(), Qt::AlignLeft, viewport_.gizmoText_);
    const QRectF box = text.translated(viewport_.gizmoTextAt_ + QPointF(18, 10) - text.topLeft());
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().toolTipBase());
    painter.drawRoundedRect(box.adjusted(-6, -3, 6, 3), 4, 4);
    painter.setPen(palette().toolTipText().color());
    painter.drawText(box, Qt::AlignCenter, viewport_.gizmoText_);
  }

private:
  void paintBand(QPainter& painter) const {
    QColor inside = palette().highlight().color();
    inside.setAlphaF(0.15F);
    painter.setPen(QPen(palette().highlight().color(), 1.0, Qt::DashLine));
    painter.setBrush(inside);
    painter.drawRect(viewport_.band_->normalized());
  }

  // Twice, so that they are seen on every ground.
  void paintMarks(QPainter& painter) const {
    constexpr double kDot = 4.0, kLine = 2.0, kRim = 2.0;
    QPolygonF line;
    for (const Eigen::Vector3d& place : viewport_.marks_)
      line << viewport_.projected(place);
    for (const bool isRim : {true, false}) {
      const QColor colour = isRim ? palette().window().color() : palette().windowText().color();
      const double more = isRim ? kRim : 0.0;
      painter.setPen(QPen(colour, kLine + 2.0 * more, Qt::SolidLine, Qt::RoundCap));
      painter.setBrush(Qt::NoBrush);
      painter.drawPolyline(line);
      painter.setPen(Qt::NoPen);
      painter.setBrush(colour);
      for (const QPointF& at : line)
        painter.drawEllipse(at, kDot + more, kDot + more);
    }
  }

  Viewport& viewport_;
};

namespace {
class OnResize : public QObject {
public:
  OnResize(QObject* parent, std::function<void()> does) : QObject(parent), does_(std::move(does)) {}
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Resize)
      does_();
    return QObject::eventFilter(watched, event);
  }

private:
  std::function<void()> does_;
};
} // namespace

Viewport::Viewport(const scene::Theme& theme, QWidget* parent)
    : VtkView(parent), scene_(theme), camera_(scene_.renderer()), overlay_(new Overlay(this)),
      cube_(new ViewCube(this)) {
  setObjectName("viewport");
  setAccessibleName(tr("View"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(200, 160);
  addRenderer(scene_.renderer());
  updateOverlay();
  scene_.standardView(scene::StandardView::Isometric);
  connect(cube_, &ViewCube::viewFrom, this, &Viewport::viewFrom);
  connect(cube_, &ViewCube::orbit, this, [this](double dx, double dy) {
    camera_.orbit(dx, dy);
    turned();
  });
  settle_.setSingleShot(true);
  settle_.setInterval(kSettleMs);
  connect(&settle_, &QTimer::timeout, this, &Viewport::applyDetail);
  rest_.setSingleShot(true);
  rest_.setInterval(kRestMs);
  connect(&rest_, &QTimer::timeout, this, [this] { emit hovered(hitAt(last_)); });
}

Viewport::~Viewport() = default;

void Viewport::initializeGL() {
  VtkView::initializeGL();
  scene_.setPixelRatio(devicePixelRatioF());
}

void Viewport::setView(const scene::ViewState& view) {
  scene::ViewState shown = view;
  setDetail(shown);
  scene_.setView(shown);
  requestFrame();
}

void Viewport::setDetail(scene::ViewState& view) const {
  view.dragging = heldByOthers_ || settle_.isActive() || turning_ || moving_;
  if (!isDrawnByProcessor())
    view.draggedTriangles = kCardTriangles;
  view.ambientOcclusion = ambientOcclusion_ && !(isDrawnByProcessor() && view.dragging);
}

void Viewport::applyDetail() {
  scene::ViewState view = scene_.view();
  setDetail(view);
  if (view.dragging == scene_.view().dragging &&
      view.ambientOcclusion == scene_.view().ambientOcclusion)
    return;
  scene_.setView(view);
  requestFrame();
}

void Viewport::setAmbientOcclusion(bool on) {
  ambientOcclusion_ = on;
  applyDetail();
}

void Viewport::setDragging(bool on) {
  heldByOthers_ = on;
  applyDetail();
}

// A widget over the whole picture is put together with it in every frame, also without content.
void Viewport::updateOverlay() {
  overlay_->setVisible(!marks_.empty() || band_ || hasHandles(gizmo_.tool()));
  overlay_->update();
}

void Viewport::setTool(Tool tool) {
  if (gizmo_.tool() == tool)
    return;
  if (typed_.isActive()) {
    typed_ = {};
    emit gizmoDragged({}, true);
  }
  gizmo_.setTool(tool);
  gizmo_.setCentre(gizmoCentre_);
  gizmo_.setAxes(gizmoAxes_);
  gizmoText_.clear();
  setCursor(takesClicks(tool) ? Qt::CrossCursor : Qt::ArrowCursor);
  updateOverlay();
  emit toolChanged(tool);
}

void Viewport::setGizmoCentre(const Eigen::Vector3d& centre, const Eigen::Matrix3d& axes) {
  gizmoCentre_ = centre;
  gizmoAxes_ = axes;
  if (!gizmo_.dragging()) {
    gizmo_.setCentre(centre);
    gizmo_.setAxes(axes);
  }
  updateOverlay();
}

void Viewport::setMarks(std::vector<Eigen::Vector3d> places) {
  marks_ = std::move(places);
  updateOverlay();
}

double Viewport::mmPerPoint(const Eigen::Vector3d& place) const {
  return camera_.mmPerPixel(place) * devicePixelRatioF();
}

void Viewport::setLegendWidget(QWidget* legend) {
  legend_ = legend;
  legend_->setParent(this);
  legend_->installEventFilter(new OnResize(this, [this] { layOut(); }));
  layOut();
}

void Viewport::setToolsWidget(QWidget* tools) {
  tools_ = tools;
  layOut();
}

void Viewport::layOut() {
  overlay_->setGeometry(rect());
  cube_->move(width() - cube_->width() - kMargin, kMargin);
  if (tools_)
    tools_->move(kMargin, kMargin);
  if (legend_) {
    legend_->adjustSize();
    const int left = kMargin + (tools_ && !tools_->isHidden() ? tools_->width() + kMargin : 0);
    // Below the cube where there is no room beside it.
    const bool isWide = left + legend_->width() + kMargin > cube_->x();
    legend_->move(left, isWide ? cube_->geometry().bottom() + kMargin : kMargin);
  }
}

void Viewport::resizeEvent(QResizeEvent* event) {
  VtkView::resizeEvent(event);
  layOut();
  if (!usersCamera_)
    frameAll();
}

void Viewport::beforeFrame() {
  scene_.setPixelRatio(devicePixelRatioF());
  cube_->setAxes(camera_.axes());
}

void Viewport::moved() {
  usersCamera_ = true;
  turned();
}

void Viewport::turned() {
  scene_.cameraMoved();
  settle_.start();
  applyDetail();
  requestFrame();
  updateOverlay();
  emit cameraMoved();
}

std::vector<Eigen::AlignedBox2d> Viewport::coveredByWidgets() const {
  std::vector<Eigen::AlignedBox2d> covered;
  for (const QWidget* over :
       {static_cast<const QWidget*>(cube_), static_cast<const QWidget*>(legend_),
        static_cast<const QWidget*>(tools_)})
    if (over && !over->isHidden()) {
      const QRectF frame = QRectF(over->geometry()).adjusted(-kMargin, -kMargin, kMargin, kMargin);
      const QPointF low = toDisplay(frame.bottomLeft()), high = toDisplay(frame.topRight());
      covered.emplace_back(Eigen::Vector2d(low.x(), low.y()), Eigen::Vector2d(high.x(), high.y()));
    }
  return covered;
}

void Viewport::frameAll() {
  scene_.setCovered(coveredByWidgets());
  scene_.frameAll();
  turned();
  usersCamera_ = false;
}

void Viewport::framePart() {
  scene_.setCovered(coveredByWidgets());
  scene_.framePart();
  moved();
}

void Viewport::viewFrom(const Eigen::Vector3d& towardsEye) {
  camera_.viewFrom(towardsEye);
  if (usersCamera_)
    turned();
  else
    frameAll();
}

void Viewport::lookAt(const Eigen::Vector3d& pointInWork, double radiusMm) {
  scene_.lookAt(pointInWork, radiusMm);
  moved();
}

void Viewport::follow(const Eigen::Vector3d& pointInWorld) {
  camera_.lookAt(pointInWorld);
  moved();
}

scene::Sight Viewport::lookAtClearly(const Eigen::Vector3d& pointInWork, double radiusMm) {
  const scene::Sight sight = scene::clearSight(scene_, pointInWork, radiusMm);
  camera_.viewFrom(sight.towardsEye);
  lookAt(pointInWork, radiusMm);
  return sight;
}

std::optional<scene::Hit> Viewport::hitAt(const QPointF& place) const {
  const QPointF display = toDisplay(place);
  return scene_.pick(static_cast<int>(display.x()), static_cast<int>(display.y()));
}

// The user measures corners and edges too. Half of the places around an edge lie beside the part.
std::optional<scene::Hit> Viewport::clickedAt(const QPointF& place) const {
  const std::optional<scene::Hit> hit = hitAt(place);
  const auto isPart = [](const std::optional<scene::Hit>& h) {
    return h && h->what == scene::Hit::What::Part;
  };
  if (tool() != Tool::Measure || isPart(hit))
    return hit;
  constexpr int kAround = 8;
  for (const double points : {3.0, 6.0, 9.0})
    for (int k = 0; k < kAround; ++k) {
      const double angle = base::kTwoPi * k / kAround;
      const auto near = hitAt(place + points * QPointF(std::cos(angle), std::sin(angle)));
      if (isPart(near))
        return near;
    }
  return hit;
}

QPointF Viewport::projected(const Eigen::Vector3d& world) const {
  const Eigen::Vector3d display = camera_.project(world);
  return fromDisplay({display.x(), display.y()});
}

double Viewport::gizmoMmPerPixel() const {
  return mmPerPoint(gizmoCentre_);
}

Ray Viewport::rayAt(const QPointF& place) const {
  const QPointF display = toDisplay(place);
  return camera_.rayThrough(display.x(), display.y());
}

bool Viewport::spanRectangle(const QMouseEvent& event) {
  if (event.type() == QEvent::MouseButtonPress) {
    if (tool() != Tool::Paint || event.button() == Qt::MiddleButton)
      return false;
    erasing_ = event.button() == Qt::RightButton || event.modifiers() & Qt::ShiftModifier;
    band_ = QRectF(event.position(), event.position());
    return true;
  }
  if (!band_)
    return false;
  band_->setBottomRight(event.position());
  updateOverlay();
  if (event.type() != QEvent::MouseButtonRelease)
    return true;
  const QRectF rectangle = std::exchange(band_, std::nullopt)->normalized();
  updateOverlay();
  constexpr double kLeast = 3.0; // a click spans nothing
  if (std::min(rectangle.width(), rectangle.height()) >= kLeast)
    emit rectanglePainted({rayAt(rectangle.topLeft()), rayAt(rectangle.topRight()),
                           rayAt(rectangle.bottomRight()), rayAt(rectangle.bottomLeft())},
                          erasing_);
  return true;
}

// A stroke begins on the part; beside it the buttons move the camera.
bool Viewport::paint(const QMouseEvent& event) {
  if (paintsRectangles_ && !painting_)
    return spanRectangle(event);
  if (!painting_ && (event.type() != QEvent::MouseButtonPress || tool() != Tool::Paint ||
                     event.button() == Qt::MiddleButton))
    return false;
  const auto partAt = [this](const QPointF& place) {
    const auto hit = hitAt(place);
    return hit && hit->what == scene::Hit::What::Part ? hit : std::nullopt;
  };
  const bool isLast = event.type() == QEvent::MouseButtonRelease;
  const QPointF to = event.position();
  const auto hit = partAt(to);
  if (!painting_) {
    if (!hit)
      return false;
    painting_ = true;
    erasing_ = event.button() == Qt::RightButton || event.modifiers() & Qt::ShiftModifier;
    strokeAt_ = to;
  }
  // A fast mouse is reported at few places: the stroke is a line between them.
  constexpr double kStep = 4.0;
  const QPointF from = std::exchange(strokeAt_, to);
  const int steps =
      static_cast<int>(std::ceil(std::hypot(to.x() - from.x(), to.y() - from.y()) / kStep));
  for (int i = 1; i < steps; ++i)
    if (const auto between = partAt(from + (to - from) * i / steps))
      emit painted(between, erasing_, false);
  if (isLast)
    painting_ = false;
  emit painted(hit, erasing_, isLast);
  return true;
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  if (button_ != Qt::NoButton)
    return;
  setFocus(Qt::MouseFocusReason);
  button_ = event->button();
  pressedAt_ = last_ = event->position();
  dragged_ = false;
  if (paint(*event))
    return;
  const auto project = [this](const Eigen::Vector3d& p) { return projected(p); };
  if (button_ == Qt::LeftButton && !(event->modifiers() & Qt::ShiftModifier) &&
      gizmo_.hover(last_, project, gizmoMmPerPixel())) {
    gizmo_.begin(last_, rayAt(last_), project, gizmoMmPerPixel());
    emit gizmoStarted();
  }
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  const QPointF d = event->position() - last_;
  last_ = event->position();
  if (painting_ || band_) {
    paint(*event);
    return;
  }
  if (gizmo_.dragging()) {
    const GizmoChange change =
        gizmo_.drag(last_, rayAt(last_), event->modifiers() & Qt::ControlModifier);
    if (typed_.isActive())
      return;
    gizmoText_ = change.text;
    gizmoTextAt_ = last_;
    dragged_ = true;
    updateOverlay();
    emit gizmoDragged(change, false);
    return;
  }
  if (button_ == Qt::NoButton) {
    const bool hot = gizmo_.hover(
        last_, [this](const Eigen::Vector3d& p) { return projected(p); }, gizmoMmPerPixel());
    if (hasHandles(gizmo_.tool())) {
      setCursor(hot ? Qt::OpenHandCursor : Qt::ArrowCursor);
      updateOverlay();
    }
    rest_.start();
    return;
  }
  if (!dragged_ &&
      (last_ - pressedAt_).manhattanLength() < QGuiApplication::styleHints()->startDragDistance())
    return;
  dragged_ = true;
  const double ratio = devicePixelRatioF();
  const bool shift = event->modifiers() & Qt::ShiftModifier;
  moving_ = button_ != Qt::LeftButton || shift;
  turning_ = !moving_;
  if (turning_) {
    camera_.orbit(ratio * d.x(), -ratio * d.y());
    turned();
  } else {
    camera_.pan(ratio * d.x(), -ratio * d.y());
    moved();
  }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != button_)
    return;
  button_ = Qt::NoButton;
  if (paint(*event))
    return;
  if (gizmo_.dragging()) {
    const GizmoChange change = gizmo_.drag(event->position(), rayAt(event->position()),
                                           event->modifiers() & Qt::ControlModifier);
    gizmo_.end();
    if (typed_.isActive())
      return; // The number goes on being typed
    gizmoText_.clear();
    updateOverlay();
    emit gizmoDragged(dragged_ ? change : GizmoChange{}, true);
    return;
  }
  turning_ = moving_ = false;
  applyDetail();
  if (!dragged_ && event->button() == Qt::LeftButton)
    emit clicked(clickedAt(event->position()));
  if (!dragged_ && event->button() == Qt::RightButton)
    emit menuAsked(hitAt(event->position()), event->globalPosition().toPoint());
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  if (const auto hit = hitAt(event->position()); hit && scene_.view().world == scene::World::Work)
    lookAt(hit->point, 15.0);
  else
    frameAll();
}

void Viewport::wheelEvent(QWheelEvent* event) {
  const QPointF display = toDisplay(event->position());
  camera_.zoom(std::pow(kWheelFactor, event->angleDelta().y() / 120.0), display.x(), display.y());
  moved();
  event->accept();
}

// The keys of numbers and axes belong to the handles before they belong to commands.
bool Viewport::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (typed_.takes(*key, gizmo_.tool(), gizmo_.dragging())) {
      event->accept();
      return true;
    }
  }
  return VtkView::event(event);
}

bool Viewport::type(const QKeyEvent& event) {
  if (!typed_.takes(event, gizmo_.tool(), gizmo_.dragging()))
    return false;
  if (!typed_.isActive()) {
    gizmoTextAt_ = gizmo_.dragging() ? last_ : projected(gizmoCentre_);
    if (!gizmo_.dragging())
      emit gizmoStarted();
    typed_.begin(gizmo_.draggedAxis());
  }
  const TypedChange::Step step = typed_.press(event, gizmo_.tool());
  const GizmoChange change = step == TypedChange::Step::Cancelled
                                 ? GizmoChange{}
                                 : typed_.change(gizmo_.tool(), gizmoAxes_);
  gizmoText_ = change.text;
  const bool finished = step != TypedChange::Step::Edited;
  if (finished) {
    typed_ = {};
    gizmo_.end();
    gizmo_.setCentre(gizmoCentre_);
    gizmoText_.clear();
  } else if (gizmo_.tool() == Tool::Move) {
    gizmo_.setCentre(gizmoCentre_ + change.moveMm);
  }
  updateOverlay();
  emit gizmoDragged(change, finished);
  return true;
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  if (type(*event))
    return;
  const double step = kKeyOrbitPixels * devicePixelRatioF();
  const QPointF middle = toDisplay(QPointF(0.5 * width(), 0.5 * height()));
  switch (event->key()) {
  case Qt::Key_Left:
    camera_.orbit(-step, 0.0);
    break;
  case Qt::Key_Right:
    camera_.orbit(step, 0.0);
    break;
  case Qt::Key_Up:
    camera_.orbit(0.0, step);
    break;
  case Qt::Key_Down:
    camera_.orbit(0.0, -step);
    break;
  case Qt::Key_Plus:
    camera_.zoom(kWheelFactor, middle.x(), middle.y());
    moved();
    return;
  case Qt::Key_Minus:
    camera_.zoom(1.0 / kWheelFactor, middle.x(), middle.y());
    moved();
    return;
  case Qt::Key_Escape:
    setTool(Tool::None);
    return;
  default:
    VtkView::keyPressEvent(event);
    return;
  }
  turned();
}

void Viewport::leaveEvent(QEvent* event) {
  rest_.stop();
  emit hovered(std::nullopt);
  VtkView::leaveEvent(event);
}

} // namespace voluta::viewer
