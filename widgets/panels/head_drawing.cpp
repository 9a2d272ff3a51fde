#include "panels/head_drawing.h"

#include "forms/colours.h"
#include "language/numbers.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace voluta::panels {

namespace {
constexpr int kMargin = 8;
constexpr double kHeadShare = 0.5;  // Of the width; the rest is for the tip
constexpr double kTipBeads = 2.6;   // Width of the tip's view in bead widths or tip diameters
constexpr double kBeadsBelow = 2.2; // Layers shown below the tip
constexpr double kBarShare = 0.45;  // Longest scale bar, of the view's width
const QColor kMaterial(0xE0, 0x8A, 0x3C);

// Pixels of a point in head coordinates [mm].
struct View {
  QPointF tip;
  double perMm = 1.0;
  QPointF at(double xMm, double zMm) const {
    return {tip.x() + perMm * xMm, tip.y() - perMm * zMm};
  }
};

QPainterPath profileOf(const process::HeadShape& head, const View& view) {
  QPainterPath path;
  const auto& sections = head.sections;
  path.moveTo(view.at(sections.front().radiusMm, sections.front().zMm));
  for (const process::HeadSection& s : sections)
    path.lineTo(view.at(s.radiusMm, s.zMm));
  for (auto s = sections.rbegin(); s != sections.rend(); ++s)
    path.lineTo(view.at(-s->radiusMm, s->zMm));
  path.closeSubpath();
  return path;
}

// Returns 1, 2 or 5 times a power of ten, at most `maxMm`.
double roundLength(double maxMm) {
  const double power = std::pow(10.0, std::floor(std::log10(maxMm)));
  return (maxMm >= 5.0 * power ? 5.0 : maxMm >= 2.0 * power ? 2.0 : 1.0) * power;
}

void drawScaleBar(QPainter& painter, const QRectF& area, double perMm, const QColor& colour) {
  const double mm = roundLength(kBarShare * area.width() / perMm);
  const double y = area.bottom() - 2.0, x = area.left();
  painter.setPen(QPen(colour, 1.0));
  painter.drawLine(QPointF(x, y), QPointF(x + mm * perMm, y));
  for (const double end : {x, x + mm * perMm})
    painter.drawLine(QPointF(end, y - 3.0), QPointF(end, y + 1.0));
  painter.drawText(QPointF(x + 3.0, y - 4.0),
                   HeadDrawing::tr("%1 mm").arg(language::numberText(mm, 3)));
}

bool canDraw(const process::HeadShape& head) {
  if (head.sections.size() < 2 || !(head.sections.back().zMm > 0.0))
    return false;
  return std::ranges::is_sorted(head.sections, {}, &process::HeadSection::zMm) &&
         std::ranges::any_of(head.sections, [](const auto& s) { return s.radiusMm > 0.0; });
}

double widest(const process::HeadShape& head) {
  return std::ranges::max(head.sections, {}, &process::HeadSection::radiusMm).radiusMm;
}

void drawHead(QPainter& painter, const QRectF& area, const process::HeadShape& head,
              const QPalette& palette) {
  const double line = painter.fontMetrics().height();
  const QRectF room = area.adjusted(0.0, line, 0.0, -line - 6.0);
  View view;
  view.perMm =
      std::min(room.width() / (2.0 * widest(head)), room.height() / head.sections.back().zMm);
  view.tip = {room.center().x(), room.bottom()};
  const QColor text = palette.color(QPalette::Text);
  painter.setPen(QPen(forms::mixed(palette.color(QPalette::Base), text, 0.7), 1.0));
  painter.setBrush(forms::mixed(palette.color(QPalette::Base), text, 0.22));
  painter.drawPath(profileOf(head, view));
  painter.setPen(QPen(forms::mutedColour(palette), 1.0, Qt::DashDotLine));
  painter.drawLine(view.at(0.0, 0.0), view.at(0.0, head.sections.back().zMm));
  painter.setPen(text);
  painter.drawText(QRectF(area.left(), area.top(), area.width(), line), Qt::AlignHCenter,
                   HeadDrawing::tr("Head, %1 × ⌀ %2 mm")
                       .arg(language::numberText(head.sections.back().zMm, 4),
                            language::numberText(2.0 * widest(head), 4)));
  drawScaleBar(painter, area, view.perMm, text);
}

// The bead being printed is below the tip, on beads of the layer before it.
void drawTip(QPainter& painter, const QRectF& area, const process::Process& p,
             const QPalette& palette) {
  const double line = painter.fontMetrics().height();
  const double bead = p.beadWidthMm, height = p.layerHeightMm;
  const double across = kTipBeads * std::max(bead, 2.0 * p.head.sections.front().radiusMm);
  View view;
  view.perMm = area.width() / across;
  const double belowPx = kBeadsBelow * height * view.perMm;
  const double room = area.height() - 3.0 * line;
  if (belowPx > 0.6 * room)
    view.perMm *= 0.6 * room / belowPx;
  view.tip = {area.center().x(), area.bottom() - line - 6.0 - kBeadsBelow * height * view.perMm};
  const QColor text = palette.color(QPalette::Text), base = palette.color(QPalette::Base);
  painter.save();
  painter.setClipRect(area.adjusted(0.0, line, 0.0, -line - 4.0));
  painter.setPen(QPen(forms::mixed(base, text, 0.7), 1.0));
  painter.setBrush(forms::mixed(base, text, 0.22));
  painter.drawPath(profileOf(p.head, view));
  const double bore = std::min(0.5 * p.nozzleDiameterMm, p.head.sections.front().radiusMm);
  painter.setPen(Qt::NoPen);
  painter.setBrush(forms::mixed(base, kMaterial, 0.55));
  painter.drawRect(QRectF(view.at(-bore, p.head.sections.back().zMm), view.at(bore, 0.0)));
  painter.setPen(QPen(forms::mixed(kMaterial, text, 0.5), 1.0));
  const auto drawBead = [&](double xMm, double topMm, const QColor& fill) {
    painter.setBrush(fill);
    const double round = 0.5 * std::min(height, bead) * view.perMm;
    painter.drawRoundedRect(
        QRectF(view.at(xMm - 0.5 * bead, topMm), view.at(xMm + 0.5 * bead, topMm - height)), round,
        round);
  };
  for (const int k : {-2, -1, 0, 1, 2})
    drawBead(k * bead, -height, forms::mixed(base, kMaterial, 0.45));
  drawBead(-bead, 0.0, forms::mixed(base, kMaterial, 0.45));
  drawBead(0.0, 0.0, forms::mixed(base, kMaterial, 0.9));
  painter.restore();
  painter.setPen(text);
  painter.drawText(QRectF(area.left(), area.top(), area.width(), line), Qt::AlignHCenter,
                   HeadDrawing::tr("Bead, %1 × %2 mm")
                       .arg(language::numberText(bead, 4), language::numberText(height, 4)));
  drawScaleBar(painter, area, view.perMm, text);
}
} // namespace

HeadDrawing::HeadDrawing(QWidget* parent) : QWidget(parent) {
  setMinimumSize(260, 150);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  describe();
}

QSize HeadDrawing::sizeHint() const {
  return {340, 220};
}

void HeadDrawing::setProcess(const process::Process& process) {
  process_ = process;
  describe();
  update();
}

void HeadDrawing::describe() {
  setAccessibleName(tr("Head, nozzle and bead, to scale"));
  setToolTip(tr("Left: profile of the head, used for collision checks. Right: its tip with a bead "
                "of the usual width and height."));
}

void HeadDrawing::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    describe();
  QWidget::changeEvent(event);
}

void HeadDrawing::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  const QRectF all = QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin);
  if (!canDraw(process_.head)) {
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(all, Qt::AlignCenter | Qt::TextWordWrap,
                     tr("The head's sections do not rise from the tip."));
    return;
  }
  const double left = kHeadShare * all.width() - 0.5 * kMargin;
  drawHead(painter, QRectF(all.left(), all.top(), left, all.height()), process_.head, palette());
  if (process_.beadWidthMm > 0.0 && process_.layerHeightMm > 0.0)
    drawTip(
        painter,
        QRectF(all.left() + left + kMargin, all.top(), all.width() - left - kMargin, all.height()),
        process_, palette());
}

} // namespace voluta::panels
