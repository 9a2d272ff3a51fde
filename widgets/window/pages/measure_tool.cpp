#include "window/pages/measure_tool.h"

#include "base/units.h"
#include "document/document.h"
#include "window/presenters/presenter.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <utility>

namespace voluta::window {

using geometry::MeasuredPoint;
using geometry::RoundShape;
using project::Stage;
using viewer::Tool;

namespace {

constexpr double kSnapPoints = 10.0; // on the screen
constexpr int kMargin = 10;

QString mmText(double mm) {
  return MeasureTool::tr("%1 mm").arg(QLocale().toString(mm, 'f', 2));
}

QString roundText(const RoundShape& round) {
  const QString radius = mmText(round.radiusMm), diameter = mmText(2.0 * round.radiusMm);
  switch (round.of) {
  case RoundShape::Of::Edge:
    return MeasureTool::tr("Round edge: radius %1, diameter %2").arg(radius, diameter);
  case RoundShape::Of::Cylinder:
    return MeasureTool::tr("Round face: radius %1, diameter %2").arg(radius, diameter);
  case RoundShape::Of::Sphere:
    return MeasureTool::tr("Ball: radius %1, diameter %2").arg(radius, diameter);
  }
  return {};
}

QString placeText(const MeasuredPoint& place) {
  if (place.round)
    return roundText(*place.round);
  switch (place.on) {
  case MeasuredPoint::On::Corner:
    return MeasureTool::tr("Corner: X %1, Y %2, Z %3")
        .arg(mmText(place.point.x()), mmText(place.point.y()), mmText(place.point.z()));
  case MeasuredPoint::On::Edge:
    return MeasureTool::tr("Edge");
  case MeasuredPoint::On::Face:
    return MeasureTool::tr("Face");
  }
  return {};
}

QStringList placeLines(const MeasuredPoint& place) {
  QStringList lines{placeText(place)};
  if (place.wallMm)
    lines << MeasureTool::tr("Wall behind the face: %1").arg(mmText(*place.wallMm));
  return lines;
}

QStringList pairLines(const geometry::MeasuredPair& pair) {
  const Eigen::Vector3d& along = pair.alongAxesMm;
  QStringList lines{MeasureTool::tr("Distance: %1").arg(mmText(pair.distanceMm)),
                    MeasureTool::tr("X %1, Y %2, Z %3")
                        .arg(mmText(along.x()), mmText(along.y()), mmText(along.z()))};
  if (pair.planesMm)
    lines << MeasureTool::tr("Distance of the parallel faces: %1").arg(mmText(*pair.planesMm));
  else if (pair.angleRad)
    lines << MeasureTool::tr("Angle: %1\u00b0")
                 .arg(QLocale().toString(base::radiansToDegrees(*pair.angleRad), 'f', 1));
  return lines;
}

} // namespace

MeasureTool::MeasureTool(const Workspace& workspace, const Page& page, QObject* parent)
    : QObject(parent), work_(workspace), page_(page), card_(new QLabel(&workspace.viewport)) {
  card_->setObjectName("measureCard");
  card_->setAutoFillBackground(true);
  card_->setFrameShape(QFrame::StyledPanel);
  card_->setMargin(6);
  card_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  card_->hide();
  work_.viewport.installEventFilter(this);
  connect(&work_.viewport, &viewer::Viewport::toolChanged, this, [this] {
    forget();
    show();
  });
  connect(&work_.presenter, &Presenter::partDrawn, this, &MeasureTool::forgetIfMoved);
  connect(&work_.document, &document::Document::resultChanged, this, &MeasureTool::forgetIfMoved);
}

std::vector<Command> MeasureTool::commands() {
  return {{"toolMeasure",
           "editMenu",
           1,
           QT_TRANSLATE_NOOP("Commands", "M&easure"),
           QT_TRANSLATE_NOOP("Commands", "Click places on the part: radius, wall, distance, angle"),
           {QKeySequence("I")},
           [this] { work_.viewport.setTool(isOn() ? Tool::None : Tool::Measure); },
           [this] { return page_.isShown() && work_.document.source(); },
           [this] { return isOn(); },
           "measure",
           BarGroup::Tools}};
}

MeasureTool::Mesh MeasureTool::placedPart() const {
  const auto placed = work_.document.itemResult(Stage::Load);
  return placed && work_.document.upToDate(Stage::Load) ? placed->job.item().part : nullptr;
}

void MeasureTool::clicked(const std::optional<scene::Hit>& hit) {
  const Mesh part = placedPart();
  if (!isOn() || !hit || hit->what != scene::Hit::What::Part || !part)
    return;
  if (part != part_)
    forget();
  part_ = part;
  const double snapMm = kSnapPoints * work_.viewport.mmPerPoint(hit->point);
  runner_.run(
      [part, known = measuring_, point = hit->point, snapMm](const base::RunContext&) {
        const auto of = known ? known : std::make_shared<const geometry::Measuring>(*part);
        return Found{of, of->at(point, snapMm)};
      },
      [this](const base::Outcome<Found>& outcome) {
        const auto* found = std::get_if<Found>(&outcome);
        if (!found)
          return;
        measuring_ = found->of;
        if (places_.size() == 2)
          places_.clear();
        places_.push_back(found->point);
        show();
      },
      1);
}

void MeasureTool::forget() {
  if (runner_.running())
    runner_.cancel();
  part_ = nullptr;
  measuring_ = nullptr;
  places_.clear();
}

void MeasureTool::forgetIfMoved() {
  if (!part_ || part_ == placedPart())
    return;
  forget();
  show();
}

QStringList MeasureTool::lines() const {
  if (places_.empty())
    return {tr("Click a corner, an edge or a face of the part.")};
  if (places_.size() == 1)
    return placeLines(places_.front()) << tr("Click a second place for distance and angle.");
  QStringList lines;
  for (std::size_t i = 0; i < 2; ++i)
    lines << QStringLiteral("%1. %2").arg(i + 1).arg(placeText(places_[i]));
  return lines << pairLines(geometry::measuredPair(places_[0], places_[1]));
}

void MeasureTool::show() {
  std::vector<Eigen::Vector3d> marks;
  for (const MeasuredPoint& place : places_)
    marks.push_back(place.point);
  work_.viewport.setMarks(std::move(marks));
  card_->setText(lines().join('\n'));
  keepToItsPlace();
  card_->setVisible(isOn());
  card_->raise();
}

// In the middle of the upper edge, between tools and cube.
void MeasureTool::keepToItsPlace() {
  card_->adjustSize();
  card_->move((work_.viewport.width() - card_->width()) / 2, kMargin);
}

bool MeasureTool::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    keepToItsPlace();
  return QObject::eventFilter(watched, event);
}

} // namespace voluta::window
