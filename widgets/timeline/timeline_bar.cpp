#include "timeline/timeline_bar.h"

#include "forms/duration_text.h"
#include "timeline/player.h"
#include "timeline/scrub_slider.h"
#include "timeline/timeline_icons.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QToolButton>
#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::timeline {

namespace {
constexpr std::array<int, 7> kSpeeds{1, 2, 5, 10, 20, 50, 100};
// Moves of a layer have no time here: they are a millimetre apart, so this is about printing speed.
constexpr double kMovesPerSecond = 20.0;
// Shows the growth of a part in about ten seconds.
constexpr double kStepsPerSecond = 12.0;
constexpr int kManySteps = 10;

QToolButton* makeButton(QWidget* parent, BarIcon which) {
  auto* button = new QToolButton(parent);
  button->setIcon(icon(which));
  button->setAutoRaise(true);
  button->setFocusPolicy(Qt::NoFocus);
  return button;
}
} // namespace

TimelineBar::TimelineBar(QWidget* parent) : QWidget(parent), player_(new Player(this)) {
  setFocusPolicy(Qt::StrongFocus);
  buildWidgets();
  connect(player_, &Player::positionChanged, this, &TimelineBar::setPosition);
  connect(player_, &Player::playingChanged, this, [this](bool playing) {
    play_->setIcon(icon(playing ? BarIcon::Pause : BarIcon::Play));
    retranslate();
    emit playingChanged(playing);
  });
  retranslate();
  enterMode();
}

void TimelineBar::buildWidgets() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 2, 6, 2);
  row->setSpacing(2);
  previousLayer_ = makeButton(this, BarIcon::PreviousLayer);
  previousMove_ = makeButton(this, BarIcon::PreviousMove);
  play_ = makeButton(this, BarIcon::Play);
  nextMove_ = makeButton(this, BarIcon::NextMove);
  nextLayer_ = makeButton(this, BarIcon::NextLayer);
  for (QToolButton* button : {previousLayer_, previousMove_, play_, nextMove_, nextLayer_})
    row->addWidget(button);
  row->addSpacing(4);
  slider_ = new ScrubSlider(this);
  slider_->setObjectName("scrubSlider");
  slider_->setTextOf([this](double position) {
    return mode_ == BarMode::Time    ? forms::clockText(position, player_->end())
           : mode_ == BarMode::Moves ? tr("move %1").arg(std::llround(position))
                                     : tr("growth step %1").arg(std::llround(position));
  });
  row->addWidget(slider_, 1);
  row->addSpacing(4);
  label_ = new QLabel(this);
  label_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(label_);
  row->addSpacing(4);
  speed_ = new QComboBox(this);
  speed_->setFocusPolicy(Qt::NoFocus);
  for (const int speed : kSpeeds)
    speed_->addItem(QStringLiteral("%1×").arg(speed), speed);
  row->addWidget(speed_);

  connect(previousLayer_, &QToolButton::clicked, this, &TimelineBar::previousLayer);
  connect(previousMove_, &QToolButton::clicked, this, &TimelineBar::previousMove);
  connect(play_, &QToolButton::clicked, this, &TimelineBar::togglePlay);
  connect(nextMove_, &QToolButton::clicked, this, &TimelineBar::nextMove);
  connect(nextLayer_, &QToolButton::clicked, this, &TimelineBar::nextLayer);
  connect(slider_, &ScrubSlider::moved, this, [this](double position) {
    player_->setPosition(mode_ == BarMode::Time ? position : std::round(position));
  });
  connect(slider_, &ScrubSlider::dragging, this, &TimelineBar::dragging);
  connect(slider_, &ScrubSlider::menuAsked, this, [this](double position, const QPoint& global) {
    if (mode_ == BarMode::Time)
      emit menuAsked(position, global);
  });
  connect(speed_, &QComboBox::currentIndexChanged, this,
          [this] { player_->setSpeed(speed_->currentData().toDouble()); });
}

void TimelineBar::retranslate() {
  const auto name = [](QWidget* widget, const QString& text, const QString& keys) {
    widget->setToolTip(keys.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, keys));
    widget->setAccessibleName(text);
  };
  const auto keys = [](QKeyCombination combination) {
    return QKeySequence(combination).toString(QKeySequence::NativeText);
  };
  const bool steps = mode_ == BarMode::Steps;
  name(previousLayer_, steps ? tr("Ten steps back") : tr("Previous layer"),
       keys(Qt::CTRL | Qt::Key_Left));
  name(previousMove_, steps ? tr("Previous growth step") : tr("Previous move"), keys(Qt::Key_Left));
  name(play_, playing() ? tr("Pause") : tr("Play"), keys(Qt::Key_Space));
  name(nextMove_, steps ? tr("Next growth step") : tr("Next move"), keys(Qt::Key_Right));
  name(nextLayer_, steps ? tr("Ten steps forward") : tr("Next layer"),
       keys(Qt::CTRL | Qt::Key_Right));
  name(speed_, tr("Playback speed"), {});
  setAccessibleName(tr("Time-line"));
  label_->setToolTip(mode_ == BarMode::Time ? tr("Printing time so far / planned time")
                                            : QString());
  slider_->setAccessibleName(mode_ == BarMode::Time ? tr("Time")
                             : steps                ? tr("Growth steps")
                                                    : tr("Moves of the layer"));
}

void TimelineBar::redrawIcons() {
  for (QToolButton* button : {previousLayer_, previousMove_, play_, nextMove_, nextLayer_})
    button->update();
}

bool TimelineBar::playing() const {
  return player_->playing();
}

double TimelineBar::speed() const {
  return player_->speed();
}

void TimelineBar::setMode(BarMode mode) {
  if (mode == mode_)
    return;
  player_->pause();
  mode_ = mode;
  enterMode();
  showMarks();
  retranslate();
}

double TimelineBar::endOfMode() const {
  return mode_ == BarMode::Time    ? (clock_ ? clock_->durationS() : 0.0)
         : mode_ == BarMode::Moves ? moveCount_
                                   : stepCount_;
}

double TimelineBar::positionOfMode() const {
  return mode_ == BarMode::Time ? timeS_ : mode_ == BarMode::Moves ? move_ : step_;
}

// Sets the player to the current mode; the positions of the other modes are unchanged.
void TimelineBar::enterMode() {
  const double end = endOfMode();
  {
    const QSignalBlocker quiet(player_);
    player_->setUnitsPerSecond(mode_ == BarMode::Time    ? 1.0
                               : mode_ == BarMode::Moves ? kMovesPerSecond
                                                         : kStepsPerSecond);
    player_->setEnd(end);
    player_->setPosition(positionOfMode());
  }
  slider_->setEnd(end);
  const bool alive = end > 0.0;
  for (QWidget* widget : {static_cast<QWidget*>(previousMove_), static_cast<QWidget*>(play_),
                          static_cast<QWidget*>(nextMove_), static_cast<QWidget*>(slider_)})
    widget->setEnabled(alive);
  for (QToolButton* button : {previousLayer_, nextLayer_})
    button->setEnabled(alive || mode_ == BarMode::Moves);
  setPosition(player_->position());
  showPosition();
}

void TimelineBar::setClock(std::shared_ptr<const Clock> clock) {
  clock_ = clock && !clock->empty() ? std::move(clock) : nullptr;
  if (mode_ == BarMode::Time) {
    player_->pause();
    enterMode();
  } else {
    timeS_ = std::min(timeS_, clock_ ? clock_->durationS() : 0.0);
  }
  showMarks();
}

void TimelineBar::setMoveCount(int moves) {
  const bool changed = moves != moveCount_ || move_ != moves;
  moveCount_ = std::max(0, moves);
  if (mode_ == BarMode::Moves)
    player_->pause();
  if (!changed)
    return;
  move_ = moveCount_;
  if (mode_ == BarMode::Moves) {
    enterMode();
    emit moveChanged(move_);
  }
}

void TimelineBar::setStepCount(int steps) {
  if (steps == stepCount_)
    return;
  stepCount_ = std::max(0, steps);
  step_ = stepCount_;
  if (mode_ == BarMode::Steps) {
    player_->pause();
    enterMode();
    emit stepChanged(step_);
  }
}

void TimelineBar::setMarks(std::vector<Mark> marks) {
  marks_ = std::move(marks);
  showMarks();
}

void TimelineBar::setEvents(std::vector<EventMark> events) {
  events_ = std::move(events);
  showMarks();
}

void TimelineBar::setSpans(std::vector<Span> spans) {
  spans_ = std::move(spans);
  showMarks();
}

void TimelineBar::showMarks() {
  std::vector<ScrubSlider::SliderMark> shown;
  using Kind = ScrubSlider::MarkKind;
  if (mode_ == BarMode::Time) {
    for (const EventMark& event : events_)
      shown.push_back({event.timeS, Kind::Event, event.text});
    for (const Mark& mark : marks_)
      shown.push_back({mark.timeS, mark.blocking ? Kind::Blocking : Kind::Warning, mark.text});
  }
  slider_->setMarks(std::move(shown));
  std::vector<ScrubSlider::SliderSpan> spans;
  if (mode_ == BarMode::Time)
    for (const Span& span : spans_)
      spans.push_back({span.fromS, span.toS, span.text});
  if (mode_ == BarMode::Time && clock_)
    for (const Clock::Wait& wait : clock_->waits())
      spans.push_back({wait.fromS, wait.toS,
                       tr("Wait: %1 s").arg(QLocale().toString(wait.toS - wait.fromS, 'f', 1))});
  slider_->setSpans(std::move(spans));
}

void TimelineBar::setTimeS(double timeS) {
  if (mode_ == BarMode::Time)
    player_->setPosition(timeS);
  else
    timeS_ = std::clamp(timeS, 0.0, clock_ ? clock_->durationS() : 0.0);
}

void TimelineBar::setMove(int move) {
  if (mode_ == BarMode::Moves)
    player_->setPosition(move);
  else
    move_ = std::clamp(move, 0, moveCount_);
}

void TimelineBar::setStep(int step) {
  if (mode_ == BarMode::Steps)
    player_->setPosition(step);
  else
    step_ = std::clamp(step, 0, stepCount_);
}

void TimelineBar::setPosition(double position) {
  if (mode_ == BarMode::Time) {
    if (position != timeS_) {
      timeS_ = position;
      showPosition();
      emit timeChanged(timeS_);
    }
    return;
  }
  // Playback advances by fractions, but only whole moves and steps are shown.
  const int whole = static_cast<int>(std::floor(position + 1e-6));
  if (whole == countedPlace())
    return;
  countedPlace() = whole;
  showPosition();
  if (mode_ == BarMode::Moves)
    emit moveChanged(whole);
  else
    emit stepChanged(whole);
}

void TimelineBar::showPosition() {
  slider_->setPosition(positionOfMode());
  const double end = player_->end();
  const QLocale locale = this->locale();
  const auto text = [&](double at) {
    return mode_ == BarMode::Time
               ? QStringLiteral("%1 / %2").arg(forms::clockText(at, end), forms::durationText(end))
               : QStringLiteral("%1 / %2").arg(locale.toString(static_cast<int>(at)),
                                               locale.toString(static_cast<int>(endOfMode())));
  };
  label_->setText(text(positionOfMode()));
  // Wide enough for the end, so that the slider's length does not change during playback.
  label_->setMinimumWidth(label_->fontMetrics().horizontalAdvance(text(end).replace(
                              QRegularExpression(QStringLiteral("[0-9]")), QStringLiteral("0"))) +
                          4);
}

void TimelineBar::setSpeed(double factor) {
  const int index = speed_->findData(static_cast<int>(factor));
  if (index >= 0)
    speed_->setCurrentIndex(index);
}

void TimelineBar::play() {
  player_->play();
}

void TimelineBar::pause() {
  player_->pause();
}

void TimelineBar::togglePlay() {
  player_->toggle();
}

void TimelineBar::nextMove() {
  player_->pause();
  if (mode_ != BarMode::Time)
    player_->setPosition(countedPlace() + 1);
  else if (clock_)
    player_->setPosition(clock_->nextMoveS(timeS_));
}

void TimelineBar::previousMove() {
  player_->pause();
  if (mode_ != BarMode::Time)
    player_->setPosition(countedPlace() - 1);
  else if (clock_)
    player_->setPosition(clock_->previousMoveS(timeS_));
}

void TimelineBar::nextLayer() {
  player_->pause();
  if (mode_ == BarMode::Moves)
    emit layerStepRequested(1);
  else if (mode_ == BarMode::Steps)
    player_->setPosition(step_ + kManySteps);
  else if (clock_)
    player_->setPosition(clock_->nextLayerS(timeS_));
}

void TimelineBar::previousLayer() {
  player_->pause();
  if (mode_ == BarMode::Moves)
    emit layerStepRequested(-1);
  else if (mode_ == BarMode::Steps)
    player_->setPosition(step_ - kManySteps);
  else if (clock_)
    player_->setPosition(clock_->previousLayerS(timeS_));
}

void TimelineBar::keyPressEvent(QKeyEvent* event) {
  const bool layer = event->modifiers().testFlag(Qt::ControlModifier);
  switch (event->key()) {
  case Qt::Key_Space:
    togglePlay();
    break;
  case Qt::Key_Right:
    layer ? nextLayer() : nextMove();
    break;
  case Qt::Key_Left:
    layer ? previousLayer() : previousMove();
    break;
  case Qt::Key_Home:
    player_->setPosition(0.0);
    break;
  case Qt::Key_End:
    player_->setPosition(player_->end());
    break;
  default:
    QWidget::keyPressEvent(event);
  }
}

void TimelineBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  if (event->type() == QEvent::PaletteChange)
    redrawIcons();
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange ||
      event->type() == QEvent::FontChange)
    showPosition();
  QWidget::changeEvent(event);
}

} // namespace voluta::timeline
