#include "timeline/player.h"

#include <QTimer>
#include <algorithm>

namespace voluta::timeline {

namespace {
constexpr int kStepMs = 33;
}

Player::Player(QObject* parent) : QObject(parent), timer_(new QTimer(this)) {
  timer_->setInterval(kStepMs);
  timer_->setTimerType(Qt::PreciseTimer);
  connect(timer_, &QTimer::timeout, this, &Player::tick);
}

bool Player::playing() const {
  return timer_->isActive();
}

void Player::setEnd(double end) {
  end_ = std::max(0.0, end);
  setPosition(position_);
}

void Player::setPosition(double position) {
  const double held = std::clamp(position, 0.0, end_);
  if (held == position_)
    return;
  position_ = held;
  emit positionChanged(position_);
}

void Player::setSpeed(double factor) {
  speed_ = factor;
}

void Player::setUnitsPerSecond(double units) {
  unitsPerSecond_ = units;
}

void Player::play() {
  if (playing() || end_ <= 0.0)
    return;
  if (position_ >= end_)
    setPosition(0.0);
  elapsed_.start();
  timer_->start();
  emit playingChanged(true);
}

void Player::pause() {
  if (!playing())
    return;
  timer_->stop();
  emit playingChanged(false);
}

void Player::toggle() {
  playing() ? pause() : play();
}

void Player::advance(double wallSeconds) {
  if (!playing())
    return;
  setPosition(position_ + wallSeconds * speed_ * unitsPerSecond_);
  if (position_ >= end_)
    pause();
}

void Player::tick() {
  // Uses wall time, so that playing keeps up although the window was busy drawing.
  advance(static_cast<double>(elapsed_.restart()) / 1000.0);
}

} // namespace voluta::timeline
