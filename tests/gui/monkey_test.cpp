// Clicks, drags, wheels and keys at random (fixed seed). VOLUTA_MONKEY_S: for how long.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "timeline/layer_range_slider.h"

#include <QElapsedTimer>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <random>

namespace voluta::test {
namespace {

constexpr int kDefaultSeconds = 8;
constexpr unsigned kSeed = 20240601;

// Dialogs that reach for the user's disk would make a run differ from the next.
bool mayBeTouched(const QWidget* widget) {
  for (const QWidget* w = widget; w; w = w->parentWidget())
    if (w->inherits("QFileDialog"))
      return false;
  return true;
}

class Monkey {
public:
  explicit Monkey(window::MainWindow& window) : window_(window), random_(kSeed) {}

  void act() {
    QWidget* target = someWidget();
    if (!target)
      return;
    const QPoint place(static_cast<int>(below(std::max(1, target->width()))),
                       static_cast<int>(below(std::max(1, target->height()))));
    switch (below(10)) {
    case 0:
    case 1:
    case 2:
    case 3:
      QTest::mouseClick(target, Qt::LeftButton, {}, place);
      break;
    case 4: {
      QTest::mousePress(target, below(3) ? Qt::LeftButton : Qt::MiddleButton, {}, place);
      for (int i = 0; i < 4; ++i)
        QTest::mouseMove(target, place + QPoint(static_cast<int>(below(120)) - 60,
                                                static_cast<int>(below(120)) - 60));
      QTest::mouseRelease(target, Qt::LeftButton, {}, place);
      QTest::mouseRelease(target, Qt::MiddleButton, {}, place);
      break;
    }
    case 5: {
      QWheelEvent wheel(place, target->mapToGlobal(QPointF(place)), {}, {0, below(2) ? 120 : -120},
                        Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(target, &wheel);
      break;
    }
    default: {
      static const int kKeys[] = {Qt::Key_Up,     Qt::Key_Down,    Qt::Key_Left,   Qt::Key_Right,
                                  Qt::Key_Tab,    Qt::Key_Home,    Qt::Key_End,    Qt::Key_Space,
                                  Qt::Key_Escape, Qt::Key_M,       Qt::Key_R,      Qt::Key_S,
                                  Qt::Key_F,      Qt::Key_X,       Qt::Key_F5,     Qt::Key_F6,
                                  Qt::Key_F7,     Qt::Key_F8,      Qt::Key_1,      Qt::Key_9,
                                  Qt::Key_Z,      Qt::Key_Y,       Qt::Key_Period, Qt::Key_Return,
                                  Qt::Key_PageUp, Qt::Key_PageDown};
      const int key = kKeys[below(std::size(kKeys))];
      const bool control =
          (key == Qt::Key_Z || key == Qt::Key_Y || key == Qt::Key_R || key == Qt::Key_Period) &&
          below(2);
      QTest::keyClick(target, static_cast<Qt::Key>(key),
                      control ? Qt::ControlModifier : Qt::NoModifier);
    }
    }
  }

  // A dialog in the way is left as a user would leave it.
  static void leaveDialogs() {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (widget->isVisible() && widget->inherits("QDialog"))
        QTest::keyClick(widget, Qt::Key_Escape);
    if (QWidget* popup = QApplication::activePopupWidget())
      popup->close();
  }

private:
  std::size_t below(std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_);
  }
  QWidget* someWidget() {
    QWidget* top = QApplication::activePopupWidget();
    if (!top)
      top = QApplication::activeModalWidget();
    if (!top)
      top = &window_;
    QList<QWidget*> there;
    for (QWidget* widget : top->findChildren<QWidget*>())
      if (widget->isVisible() && widget->isEnabled() && mayBeTouched(widget))
        there << widget;
    if (top->isVisible() && mayBeTouched(top))
      there << top;
    return there.isEmpty()
               ? nullptr
               : there[static_cast<qsizetype>(below(static_cast<std::size_t>(there.size())))];
  }

  window::MainWindow& window_;
  std::mt19937 random_;
};

TEST_F(WindowTest, RandomClicksAndKeysBreakNothing) {
  const int seconds = qEnvironmentVariableIsSet("VOLUTA_MONKEY_S")
                          ? qEnvironmentVariableIntValue("VOLUTA_MONKEY_S")
                          : kDefaultSeconds;
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  Monkey monkey(window());
  // Modal dialogs run their own loop inside a click; this leaves them.
  QTimer leave;
  QObject::connect(&leave, &QTimer::timeout, [] { Monkey::leaveDialogs(); });
  leave.start(700);
  QElapsedTimer timer;
  timer.start();
  long long actions = 0;
  while (timer.elapsed() < 1000LL * seconds) {
    monkey.act();
    ++actions;
    QTest::qWait(3);
    if (!window().isVisible())
      window().show(); // Quit was found
    const auto* layers = window().findChild<timeline::LayerRangeSlider*>("layerSlider");
    ASSERT_LE(layers->first(), layers->last());
    ASSERT_LT(layers->last(), std::max(1, layers->layerCount()));
    const scene::ViewState& view = window().viewport().view();
    ASSERT_TRUE(view.sectionOrigin.allFinite());
    ASSERT_TRUE(document().choices().placement.rotation.coeffs().allFinite());
  }
  leave.stop();
  Monkey::leaveDialogs();
  window().planning().cancel();
  // Still sound: a part opens and is planned.
  document().undoStack()->setClean();
  std::cout << actions << " random actions\n";
  document().clear();
  openPart(writePart("after.stl", box({0, 0, 0}, {9, 9, 5})));
  window().planning().plan(project::Stage::Layers);
  EXPECT_TRUE(planned(project::Stage::Layers));
}

} // namespace
} // namespace voluta::test
