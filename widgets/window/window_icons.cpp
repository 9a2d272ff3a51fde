#include "window/window_icons.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

namespace voluta::window {

namespace {
// Draws at any requested size and pixel ratio, so that icons are sharp on every screen.
class LineIconEngine : public QIconEngine {
public:
  LineIconEngine(QByteArray svg, QColor normal, QColor disabled)
      : svg_(std::move(svg)), normal_(normal), disabled_(disabled) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    QByteArray coloured = svg_;
    coloured.replace("currentColor",
                     (mode == QIcon::Disabled ? disabled_ : normal_).name().toLatin1());
    QSvgRenderer renderer(coloured);
    renderer.render(painter, QRectF(rect));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap drawn(size);
    drawn.fill(Qt::transparent);
    QPainter painter(&drawn);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return drawn;
  }
  QIconEngine* clone() const override { return new LineIconEngine(*this); }

private:
  QByteArray svg_;
  QColor normal_, disabled_;
};
} // namespace

QIcon icon(const QString& name, const QPalette& palette) {
  QFile file(":/icons/" + name + ".svg");
  if (!file.open(QIODevice::ReadOnly))
    return {};
  return QIcon(new LineIconEngine(file.readAll(), palette.color(QPalette::ButtonText),
                                  palette.color(QPalette::Disabled, QPalette::ButtonText)));
}

} // namespace voluta::window
