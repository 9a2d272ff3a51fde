// Playback: a position that advances with the wall clock.
#pragma once

#include <QElapsedTimer>
#include <QObject>

class QTimer;

namespace voluta::timeline {

// A position in [0, end] that advances by speed() times its units per second, at up to 30 steps per
// second. Stops at the end; play() from the end starts over.
class Player : public QObject {
  Q_OBJECT

public:
  explicit Player(QObject* parent = nullptr);

  double position() const { return position_; }
  double end() const { return end_; }
  double speed() const { return speed_; }
  bool playing() const;

  // `end` >= 0; the position is clamped.
  void setEnd(double end);
  void setPosition(double position);
  // > 0.
  void setSpeed(double factor);
  void setUnitsPerSecond(double units);

  void play();
  void pause();
  void toggle();
  // Advances as if that many seconds of wall time had passed. No effect while not playing.
  void advance(double wallSeconds);

signals:
  void positionChanged(double position);
  void playingChanged(bool playing);

private:
  void tick();

  QTimer* timer_;
  QElapsedTimer elapsed_;
  double position_ = 0.0, end_ = 0.0, speed_ = 1.0, unitsPerSecond_ = 1.0;
};

} // namespace voluta::timeline
