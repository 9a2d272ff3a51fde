// How long the window's thread works at a stretch: every event that the application delivers is
// timed. Painting a frame (an UpdateRequest to a window, or the viewport when it is resized) is
// kept apart.
#pragma once

#include <QApplication>
#include <QString>
#include <vector>

namespace voluta::test {

class WatchedApplication : public QApplication {
public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override;

  // To be connected to VtkView::framePainted.
  void addFrame(double ms) { framesMs_ += ms; }
  void resetWatch() {
    longestMs_ = longestWorkMs_ = longestFrameMs_ = 0.0;
    longestWhat_.clear();
    longestWork_.clear();
  }
  double longestMs() const { return longestMs_; }
  // The most that the thread itself has worked at a stretch, those that paint a frame left out.
  double longestWorkMs() const { return longestWorkMs_; }
  QString longestWork() const { return longestWork_; }
  QString longestWhat() const { return longestWhat_; }
  // Who is being given a mouse, key, wheel or shortcut event now; the outermost first. More than
  // one: an event that was passed on to parents, or one of a loop inside another.
  const std::vector<QObject*>& inputReceivers() const { return inputReceivers_; }
  // With everything: the viewport, the panels, putting them together.
  double longestFrameMs() const { return longestFrameMs_; }

private:
  bool deliver(QObject* receiver, QEvent* event);

  // An event being delivered by the loop of that level. One that opens a loop of its own (a dialog)
  // waits for the user in it and is not counted; the events of that loop are.
  struct Delivery {
    int loop;
    bool opensLoop = false;
    // A button that is pressed paints itself there and then, and the whole window is put together
    // anew, viewport included: waiting for that is a frame's.
    bool paints = false;
  };
  std::vector<Delivery> under_;
  std::vector<QObject*> inputReceivers_;
  double framesMs_ = 0.0, longestFrameMs_ = 0.0, longestMs_ = 0.0, longestWorkMs_ = 0.0;
  QString longestWhat_, longestWork_;
};

} // namespace voluta::test
