#include "window/unrolled/unrolled_picture.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>

namespace voluta::window {

namespace {
constexpr double kMinLine = 1.2, kShareOfBead = 0.82; // Leave a gap between neighbours
constexpr double kMinStep = 0.4;                      // Minimum distance [pixels] of drawn points
constexpr int kFaint = 55;                            // Of 255
constexpr int kMaxRepeats = 64;

class Drawer {
public:
  Drawer(const UnrolledContent& content, const UnrolledFrame& frame, const UnrolledLook& look,
         const base::RunContext& ctx)
      : content_(content), layer_(*content.layer), frame_(frame), look_(look), ctx_(ctx) {}

  void draw(QPainter& painter) {
    painter.fillRect(QRectF(QPointF(0, 0), frame_.size), look_.beside);
    const double period = layer_.periodMm;
    int first = 0, last = 0;
    if (period > 0.0) {
      const double left = frame_.mmAt({0.0, 0.0}).x();
      const double right = frame_.mmAt({frame_.size.width(), 0.0}).x();
      first = static_cast<int>(std::floor((left + 0.5 * period) / period));
      last = static_cast<int>(std::floor((right + 0.5 * period) / period));
      last = std::min(last, first + kMaxRepeats);
    }
    if (first <= 0 && last >= 0)
      drawSheet(painter);
    for (const bool printed : {false, true})
      for (int repeat = first; repeat <= last; ++repeat)
        drawStretches(painter, repeat * period, printed, false);
    if (content_.path)
      for (int repeat = first; repeat <= last; ++repeat)
        drawStretches(painter, repeat * period, true, true);
    for (int repeat = first; repeat <= last; ++repeat)
      drawOutline(painter, repeat * period);
    if (period > 0.0)
      drawSeams(painter, first, last);
  }

private:
  void drawSheet(QPainter& painter) const {
    const QPointF a = frame_.pixelOf(layer_.area.topLeft());
    const QPointF b = frame_.pixelOf(layer_.area.bottomRight());
    painter.fillRect(QRectF(a, b).normalized(), look_.sheet);
  }

  // The printed part of a stretch is at its beginning.
  std::size_t printedCount(const UnrolledLayer::Stretch& s) const {
    const auto from = layer_.waypoint.begin() + static_cast<std::ptrdiff_t>(s.first);
    return static_cast<std::size_t>(std::lower_bound(from,
                                                     from + static_cast<std::ptrdiff_t>(s.count),
                                                     content_.unprintedFrom) -
                                    from);
  }

  void drawStretches(QPainter& painter, double shiftMm, bool printed, bool chosenOnly) {
    painter.setBrush(Qt::NoBrush);
    for (const UnrolledLayer::Stretch& s : layer_.stretches) {
      if (chosenOnly && s.path != *content_.path)
        continue;
      if ((&s - layer_.stretches.data()) % 64 == 0)
        ctx_.checkpoint();
      const std::size_t done = printedCount(s);
      std::size_t first = printed ? 0 : std::max<std::size_t>(done, 1) - 1;
      std::size_t count = printed ? done : s.count - first;
      if (chosenOnly) {
        first = 0;
        count = s.count;
      }
      if (count < 2)
        continue;
      QColor colour = look_.kinds[std::min(static_cast<std::size_t>(s.kind), plan::kPathKinds - 1)];
      if (!printed)
        colour.setAlpha(kFaint);
      const double bead =
          kShareOfBead * double(layer_.widthMm[s.first + first]) * frame_.pixelsPerMm;
      const double width = std::max(kMinLine, bead);
      if (chosenOnly) {
        colour = look_.chosen;
        painter.setPen(
            QPen(colour, std::max(2.0, 0.35 * width), Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
      } else {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::FlatCap,
                            width > 3.0 ? Qt::RoundJoin : Qt::BevelJoin));
      }
      drawLine(painter, s.first + first, count, shiftMm, width);
    }
  }

  // Draws only the visible portions.
  void drawLine(QPainter& painter, std::size_t first, std::size_t count, double shiftMm,
                double width) {
    const QRectF sight(-width, -width, frame_.size.width() + 2 * width,
                       frame_.size.height() + 2 * width);
    QPolygonF line;
    QRectF box;
    const auto flush = [&] {
      if (line.size() > 1 && box.intersects(sight))
        painter.drawPolyline(line);
      line.clear();
    };
    constexpr int kPortion = 64;
    for (std::size_t i = first; i < first + count; ++i) {
      const QPointF p = frame_.pixelOf(layer_.points[i] + QPointF(shiftMm, 0.0));
      if (line.isEmpty()) {
        box = QRectF(p, QSizeF(1e-3, 1e-3));
      } else {
        const QPointF off = p - line.back();
        if (i + 1 < first + count && std::abs(off.x()) + std::abs(off.y()) < kMinStep)
          continue;
        box = box.united(QRectF(p, QSizeF(1e-3, 1e-3)));
      }
      line.push_back(p);
      if (line.size() == kPortion) {
        flush();
        line.push_back(p);
        box = QRectF(p, QSizeF(1e-3, 1e-3));
      }
    }
    flush();
  }

  void drawOutline(QPainter& painter, double shiftMm) const {
    painter.setPen(QPen(look_.outline, 1.0));
    QList<QLineF> lines;
    for (const QLineF& line : layer_.outline)
      lines.push_back({frame_.pixelOf(line.p1() + QPointF(shiftMm, 0.0)),
                       frame_.pixelOf(line.p2() + QPointF(shiftMm, 0.0))});
    painter.drawLines(lines);
  }

  void drawSeams(QPainter& painter, int first, int last) const {
    painter.setPen(QPen(look_.seam, 1.5, Qt::DashLine));
    for (int i = first; i <= last + 1; ++i) {
      const double x = frame_.pixelOf({(i - 0.5) * layer_.periodMm, 0.0}).x();
      painter.drawLine(QPointF(x, 0.0), QPointF(x, frame_.size.height()));
    }
  }

  const UnrolledContent& content_;
  const UnrolledLayer& layer_;
  const UnrolledFrame& frame_;
  const UnrolledLook& look_;
  const base::RunContext& ctx_;
};
} // namespace

QImage unrolledPicture(const UnrolledContent& content, const UnrolledFrame& frame,
                       const UnrolledLook& look, const base::RunContext& ctx) {
  QImage image((frame.size * frame.pixelRatio).toSize().expandedTo({1, 1}), QImage::Format_RGB32);
  image.setDevicePixelRatio(frame.pixelRatio);
  image.fill(look.beside);
  if (!content.layer)
    return image;
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  Drawer(content, frame, look, ctx).draw(painter);
  return image;
}

} // namespace voluta::window
