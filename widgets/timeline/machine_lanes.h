// The common time of several machines: one lane each, which shows when the machine works and when
// it waits, with a handle at the position.
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

namespace voluta::timeline {

struct LaneWait {
  double fromS = 0.0, toS = 0.0;
  QString text; // tool tip
};
struct Lane {
  QString name;
  QColor colour;
  double endS = 0.0;           // the machine works until then, except during its waits
  std::vector<LaneWait> waits; // in order
};

class MachineLanes : public QWidget {
  Q_OBJECT

public:
  explicit MachineLanes(QWidget* parent = nullptr);

  void setLanes(std::vector<Lane> lanes, double endS);
  // Times at which machines collide, marked across all lanes.
  void setCollisions(std::vector<double> timesS);
  void setTimeS(double timeS); // does not emit
  double timeS() const { return timeS_; }
  // Provides the tool tip for a position without a wait.
  void setTextOf(std::function<QString(double)> textOf) { textOf_ = std::move(textOf); }

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

signals:
  void moved(double timeS); // by the user

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;

private:
  int nameWidth() const;
  double xOf(double timeS) const;
  double timeAt(double x) const;
  QRectF laneRect(std::size_t lane) const;
  void follow(double x);

  std::vector<Lane> lanes_;
  std::vector<double> collisions_;
  double endS_ = 0.0, timeS_ = 0.0;
  std::function<QString(double)> textOf_;
};

} // namespace voluta::timeline
