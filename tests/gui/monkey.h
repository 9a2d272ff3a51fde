// Hands that do anything at random in a window: clicks, drags, wheel, keys, typing, sliders, undo,
// pages, files. Boxes and file dialogs are answered. Its actions follow from its seed; when the
// program dies, the seed and the last steps are printed.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <functional>
#include <random>

class QFileDialog;
class QMessageBox;
class QWidget;

namespace voluta::test {

struct MonkeyFiles {
  QStringList toOpen; // parts and projects, such as are none among them
  QString folder;     // where things are saved
};

class Monkey : public QObject {
public:
  // `window` is called at each step: it may be another one after a restart.
  Monkey(std::function<QWidget*()> window, unsigned seed, MonkeyFiles files);
  ~Monkey() override;

  // Works until `enough`, then leaves all dialogs. `afterStep` is called between steps, outside of
  // any event of a widget.
  void run(const std::function<bool()>& enough, const std::function<void()>& afterStep);
  int steps() const { return steps_; }
  static QString lastSteps();

private:
  void next();
  void step();
  void act(QWidget* top);
  void leave(QWidget* modal);
  void answer(QFileDialog* dialog);
  void answer(QMessageBox* box);
  void press(QWidget* target, bool twice);
  void drag(QWidget* target);
  void wheel(QWidget* target);
  void key(QWidget* target);
  void type(QWidget* target);

  std::size_t below(std::size_t n);
  QPoint placeIn(const QWidget* widget);
  QWidget* someWidget(QWidget* top);
  QString someText();
  void note(const QString& what, const QWidget* target);

  std::function<QWidget*()> window_;
  std::mt19937 random_;
  MonkeyFiles files_;
  std::function<bool()> enough_;
  std::function<void()> afterStep_;
  std::function<void()> done_;
  QPointer<QWidget> modal_; // that it has been in for inModal_ steps
  int inModal_ = 0, within_ = 0, steps_ = 0;
  bool leaving_ = false;
};

} // namespace voluta::test
