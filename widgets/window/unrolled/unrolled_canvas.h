// An unrolled layer with axes, zoom and hit testing.
#pragma once

#include "window/unrolled/unrolled_drawing.h"
#include "window/unrolled/unrolled_picture.h"

#include <QWidget>
#include <optional>

namespace voluta::window {

// The wheel zooms around the pointer, dragging moves the sheet, a double click or Home shows all of
// it; plus and minus zoom, arrows move. Pictures are drawn in the background: until the next one is
// ready, the last one is shown, moved and scaled.
class UnrolledCanvas : public QWidget {
  Q_OBJECT

public:
  explicit UnrolledCanvas(QWidget* parent = nullptr);
  ~UnrolledCanvas() override;

  // A layer of different dimensions is shown whole; otherwise the view is kept.
  void setContent(const UnrolledContent& content);
  const UnrolledContent& content() const { return content_; }
  // The waypoint is marked in the picture.
  void setChosen(std::optional<std::size_t> waypoint);
  // Shown instead of a layer.
  void setHint(const QString& hint);

  void showAll();
  double pixelsPerMm() const { return frame_.pixelsPerMm; }
  // Converts to and from widget coordinates.
  QPointF pixelOf(const QPointF& mm) const;
  QPointF mmAt(const QPointF& pixel) const;
  // Returns whether the picture is up to date.
  bool settled() const { return drawing_.settled(); }
  const QImage& picture() const { return drawing_.picture(); }

  QSize sizeHint() const override { return {280, 420}; }
  QSize minimumSizeHint() const override { return {150, 140}; }

signals:
  // nullopt: beside all paths.
  void clicked(const std::optional<voluta::window::UnrolledHit>& hit);
  // Position of the pointer; nullopt: it has left the widget.
  void hovered(const std::optional<QPointF>& mm,
               const std::optional<voluta::window::UnrolledHit>& hit);

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  QRectF plot() const;
  void setFrame(const QPointF& centreMm, double pixelsPerMm);
  void zoomAbout(const QPointF& pixel, double factor);
  void redraw();
  void paintLayer(QPainter& painter) const;
  void paintMarks(QPainter& painter) const;
  std::optional<UnrolledHit> hitAt(const QPointF& pixel) const;

  UnrolledDrawing drawing_;
  UnrolledContent content_;
  UnrolledFrame frame_;
  std::optional<QPointF> chosenMm_;
  QString hint_;
  bool whole_ = true; // The layer is shown whole, also after resizing
  QPointF pressedAt_, last_;
  bool pressed_ = false, moved_ = false;
  int wheelRest_ = 0;
};

} // namespace voluta::window
