// The groove of the time-line: a handle at the position, marks at findings.
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

namespace voluta::timeline {

// A position in [0, end] with pixel resolution.
class ScrubSlider : public QWidget {
  Q_OBJECT

public:
  // The later ones are drawn on top.
  enum class MarkKind { Event, Warning, Blocking };
  struct SliderMark {
    double position;
    MarkKind kind;
    QString text;
  };

  struct SliderSpan {
    double from, to;
    QString text; // tool tip
  };

  explicit ScrubSlider(QWidget* parent = nullptr);

  void setEnd(double end);
  void setPosition(double position); // does not emit
  double position() const { return position_; }
  void setMarks(std::vector<SliderMark> marks);
  // Spans marked below the groove, in order.
  void setSpans(std::vector<SliderSpan> spans);
  // Provides the tool tip for a position.
  void setTextOf(std::function<QString(double)> textOf) { textOf_ = std::move(textOf); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

signals:
  void moved(double position); // by the user
  void dragging(bool on);
  void menuAsked(double position, const QPoint& global); // by the right button

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  QRectF groove() const;
  double xOf(double position) const;
  double positionAt(double x) const;
  const SliderMark* markAt(double x) const;
  const SliderSpan* spanAt(double x) const;
  void follow(double x);
  void paintSpans(QPainter& painter) const;
  void paintMark(QPainter& painter, const SliderMark& mark) const;

  double end_ = 0.0, position_ = 0.0;
  std::vector<SliderMark> marks_;
  std::vector<SliderSpan> spans_;
  std::function<QString(double)> textOf_;
  bool held_ = false;
};

} // namespace voluta::timeline
