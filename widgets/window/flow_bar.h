// Bar with the pages of a workflow and their progress, and beside them the pages that are not steps
// of it.
#pragma once

#include "window/page_state.h"

#include <QString>
#include <QWidget>
#include <vector>

namespace voluta::window {

struct FlowStep {
  QString id, title;
  bool separate = false; // Not a step of the flow; these come last
};

class FlowBar : public QWidget {
  Q_OBJECT

public:
  explicit FlowBar(QWidget* parent = nullptr);

  // Keeps page and states of steps that still exist. Emits nothing.
  void setSteps(const std::vector<FlowStep>& steps);
  // Emits nothing. Ignores an unknown id.
  void setPage(const QString& id);
  void setState(const QString& id, PageState state);
  // Returns Nothing for an unknown id.
  PageState state(const QString& id) const;
  // Narrower spacing around the labels.
  void setCompact(bool compact);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return sizeHint(); }
  // In widget coordinates; for tests and tool tips.
  QRect segment(const QString& id) const;

signals:
  void pageChosen(const QString& id);

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;

private:
  struct Segment {
    FlowStep step;
    PageState state = PageState::Nothing;
  };
  int indexOf(const QString& id) const; // -1: unknown
  int segmentWidth(const Segment& segment) const;
  int padding() const;
  int gap() const;
  QRect rectOf(int index) const;
  void paintSegment(QPainter& painter, int index) const;
  void choose(int index);

  std::vector<Segment> segments_;
  int page_ = 0;
  bool compact_ = false;
};

} // namespace voluta::window
