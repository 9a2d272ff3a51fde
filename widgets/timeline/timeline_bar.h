// The bar below the viewport: play, step, scrub.
#pragma once

#include "timeline/clock.h"

#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QToolButton;

namespace voluta::timeline {

class Player;
class ScrubSlider;

// A finding on the time-line.
struct Mark {
  double timeS = 0.0;
  bool blocking = true;
  QString text; // tool tip
};

// An event of the program, such as a pause.
struct EventMark {
  double timeS = 0.0;
  QString text; // tool tip
};

// A time span marked below the groove.
struct Span {
  double fromS = 0.0, toS = 0.0;
  QString text; // tool tip
};

// Time: over the whole program, in seconds (Simulate page). Moves: over the moves of the shown
// layer (Layers page); the position is the number of shown moves. Steps: over the growth steps
// (Layers page, voxels); the position is the number of shown steps.
enum class BarMode { Time, Moves, Steps };

// Keys while it has the focus: space plays and pauses, left and right step by a move or a growth
// step, with Ctrl by a layer or ten steps, Home and End move to the ends. The same actions are
// slots, for shortcuts of the whole window.
class TimelineBar : public QWidget {
  Q_OBJECT

public:
  explicit TimelineBar(QWidget* parent = nullptr);

  BarMode mode() const { return mode_; }
  void setMode(BarMode mode);

  // The shown program; null or empty: the bar is disabled in mode Time. The time is kept if it is
  // still inside.
  void setClock(std::shared_ptr<const Clock> clock);
  const std::shared_ptr<const Clock>& clock() const { return clock_; }
  // Number of moves of the shown layer, >= 0; shows all of them.
  void setMoveCount(int moves);
  // Number of growth steps, >= 0; shows all of them if the number changed.
  void setStepCount(int steps);
  void setMarks(std::vector<Mark> marks);
  // Shown in mode Time; a click jumps there.
  void setEvents(std::vector<EventMark> events);
  const std::vector<EventMark>& events() const { return events_; }
  // In order; shown in mode Time.
  void setSpans(std::vector<Span> spans);
  const std::vector<Span>& spans() const { return spans_; }

  double timeS() const { return timeS_; }
  int move() const { return move_; }
  int step() const { return step_; }
  int stepCount() const { return stepCount_; }
  bool playing() const;
  double speed() const;

public slots:
  // Move the bar and everything synchronized with it; signals are emitted only if the value
  // changes.
  void setTimeS(double timeS);
  void setMove(int move);
  void setStep(int step);
  // One of 1, 2, 5, 10, 20, 50, 100; others are ignored.
  void setSpeed(double factor);
  void play();
  void pause();
  void togglePlay();
  void nextMove();
  void previousMove();
  // In mode Moves they emit layerStepRequested instead; in mode Steps they move by ten.
  void nextLayer();
  void previousLayer();

signals:
  void timeChanged(double timeS);
  void moveChanged(int moves);       // [0, moves of the layer]
  void stepChanged(int steps);       // [0, steps of the growth]
  void layerStepRequested(int step); // mode Moves: +1 or -1
  void playingChanged(bool playing);
  void dragging(bool on); // the handle is held; for level of detail
  // A click with the right button on the groove, in mode Time.
  void menuAsked(double timeS, const QPoint& global);

protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void buildWidgets();
  void retranslate();
  void redrawIcons();
  void enterMode();
  void showMarks();
  void showPosition();
  void setPosition(double position);
  double endOfMode() const;
  double positionOfMode() const;
  // The variable that holds the current number of moves or steps.
  int& countedPlace() { return mode_ == BarMode::Steps ? step_ : move_; }

  std::shared_ptr<const Clock> clock_;
  BarMode mode_ = BarMode::Time;
  double timeS_ = 0.0;
  int move_ = 0, moveCount_ = 0, step_ = 0, stepCount_ = 0;
  std::vector<Mark> marks_;
  std::vector<EventMark> events_;
  std::vector<Span> spans_;
  Player* player_;
  ScrubSlider* slider_ = nullptr;
  QToolButton *previousLayer_ = nullptr, *previousMove_ = nullptr, *play_ = nullptr,
              *nextMove_ = nullptr, *nextLayer_ = nullptr;
  QComboBox* speed_ = nullptr;
  QLabel* label_ = nullptr;
};

} // namespace voluta::timeline
