// A chart over time, cached as a picture, with a cursor that moves without redrawing it.
#pragma once

#include <QColor>
#include <QList>
#include <QPixmap>
#include <QPointF>
#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::timeline {

struct ChartCurve {
  QList<QPointF> points;
  QColor colour;
  std::optional<double> low, high; // limits, drawn dashed
};

class ChartCanvas : public QWidget {
  Q_OBJECT

public:
  explicit ChartCanvas(QWidget* parent = nullptr);

  // Title of the vertical axis, with its unit.
  void setAxisTitle(const QString& title);
  void setTimeTitle(const QString& title);
  // Visible values: [low, high], low < high.
  void setContent(std::vector<ChartCurve> curves, double fromS, double toS, double low,
                  double high);
  // Shown instead of curves; empty: none.
  void setHint(const QString& hint);
  void setTimeS(double timeS);

  // Returns the number of pixel columns to which curves should be reduced.
  int columns() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

signals:
  void timeClicked(double timeS);
  void spanWanted(double fromS, double toS);
  void allWanted();
  void resized();

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

private:
  QRectF plotArea() const;
  double xOf(double timeS) const;
  double timeAt(double x) const;
  void drawPicture();
  void drawAxes(QPainter& painter) const;
  void drawCurves(QPainter& painter) const;

  QString timeTitle_, valueTitle_;
  std::vector<ChartCurve> curves_;
  QString hint_;
  double fromS_ = 0.0, toS_ = 1.0, timeS_ = 0.0, low_ = 0.0, high_ = 1.0;
  QPixmap picture_;
  bool stale_ = true;
  std::optional<double> pressedX_;
  double draggedFromS_ = 0.0;
  bool moved_ = false;
};

} // namespace voluta::timeline
