#include "gui/monkey.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QEventLoop>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>
#include <array>
#include <csignal>
#include <cstring>
#include <unistd.h>
#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/common_interface_defs.h>
#endif

namespace voluta::test {

namespace {
constexpr int kPauseMs = 2;
constexpr int kStepsInModal = 25;

// The last steps, where a dying program can still get at them.
constexpr std::size_t kKept = 30, kLine = 160;
std::array<std::array<char, kLine>, kKept> keptSteps{};
std::size_t stepCount = 0;
std::array<char, kLine> head{};

void keep(std::array<char, kLine>& line, const QString& text) {
  const QByteArray bytes = text.toUtf8().left(kLine - 2) + '\n';
  line.fill(0);
  std::memcpy(line.data(), bytes.data(), static_cast<std::size_t>(bytes.size()));
}

void print(const std::array<char, kLine>& line) {
  if (write(STDERR_FILENO, line.data(), std::strlen(line.data())) < 0)
    return;
}

void printSteps() {
  print(head);
  for (std::size_t i = stepCount > kKept ? stepCount - kKept : 0; i < stepCount; ++i)
    print(keptSteps[i % kKept]);
}

void die(int signal) {
  printSteps();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void printWhenItDies() {
#if defined(__SANITIZE_ADDRESS__)
  __sanitizer_set_death_callback(printSteps);
  std::signal(SIGABRT, die);
#else
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT})
    std::signal(signal, die);
#endif
}

bool isInteresting(const QWidget* widget) {
  return widget->focusPolicy() != Qt::NoFocus || qobject_cast<const QAbstractButton*>(widget) ||
         qobject_cast<const QMenuBar*>(widget) || qobject_cast<const QMenu*>(widget);
}

bool isFor(const QWidget* widget, bool typing) {
  const bool text = qobject_cast<const QAbstractSpinBox*>(widget) ||
                    qobject_cast<const QLineEdit*>(widget) ||
                    qobject_cast<const QPlainTextEdit*>(widget);
  return text == typing;
}
} // namespace

Monkey::Monkey(std::function<QWidget*()> window, unsigned seed, MonkeyFiles files)
    : window_(std::move(window)), random_(seed), files_(std::move(files)) {
  keep(head, QString("monkey with VOLUTA_MONKEY_SEED=%1, its last steps:").arg(seed));
  stepCount = 0;
  printWhenItDies();
}

Monkey::~Monkey() = default;

QString Monkey::lastSteps() {
  QString all = QString::fromUtf8(head.data());
  for (std::size_t i = stepCount > kKept ? stepCount - kKept : 0; i < stepCount; ++i)
    all += QString::fromUtf8(keptSteps[i % kKept].data());
  return all;
}

std::size_t Monkey::below(std::size_t n) {
  return random_() % n; // the same with every library
}

void Monkey::note(const QString& what, const QWidget* target) {
  keep(keptSteps[stepCount++ % kKept],
       QString("%1: %2 %3 '%4'")
           .arg(steps_)
           .arg(what, target ? target->metaObject()->className() : "",
                target ? target->objectName() : QString()));
}

void Monkey::run(const std::function<bool()>& enough, const std::function<void()>& afterStep) {
  QEventLoop loop;
  enough_ = enough;
  afterStep_ = afterStep;
  done_ = [&loop] { loop.quit(); };
  leaving_ = false;
  next();
  loop.exec();
}

// Each step schedules the next one first: a dialog that a click opens runs a loop of its own within
// that click, and the next step is then taken there.
void Monkey::next() {
  QTimer::singleShot(kPauseMs, this, &Monkey::step);
}

void Monkey::step() {
  leaving_ = leaving_ || enough_();
  QWidget* modal = QApplication::activePopupWidget();
  if (!modal)
    modal = QApplication::activeModalWidget();
  if (leaving_ && !modal && within_ == 0) {
    done_();
    return;
  }
  if (within_ == 0 && !leaving_)
    afterStep_(); // may wait, and no step is taken meanwhile
  next();
  inModal_ = modal == modal_ ? inModal_ + 1 : 0;
  modal_ = modal;
  QWidget* top = modal ? modal : window_();
  if (!top->isVisible() || (leaving_ && !modal))
    return;
  ++steps_;
  ++within_;
  if (auto* dialog = qobject_cast<QFileDialog*>(modal))
    answer(dialog);
  else if (auto* box = qobject_cast<QMessageBox*>(modal))
    answer(box);
  else if (modal && (leaving_ || inModal_ > kStepsInModal))
    leave(modal);
  else
    act(top);
  --within_;
}

void Monkey::leave(QWidget* modal) {
  note("leave", modal);
  if (auto* dialog = qobject_cast<QDialog*>(modal))
    dialog->reject();
  else
    modal->close();
}

void Monkey::answer(QMessageBox* box) {
  const QList<QAbstractButton*> buttons = box->buttons();
  QAbstractButton* button =
      leaving_ ? box->escapeButton()
               : buttons[static_cast<qsizetype>(below(static_cast<std::size_t>(buttons.size())))];
  note(QString("answer %1 with %2").arg(box->text().left(40), button ? button->text() : "Escape"),
       box);
  if (button)
    button->click();
  else
    box->reject();
}

void Monkey::answer(QFileDialog* dialog) {
  QString file;
  if (!leaving_ && below(3) > 0) {
    if (dialog->fileMode() == QFileDialog::Directory)
      file = files_.folder;
    else if (dialog->acceptMode() == QFileDialog::AcceptSave)
      file = files_.folder + QString("/saved%1.voluta").arg(below(3));
    else
      file = files_.toOpen[static_cast<qsizetype>(
          below(static_cast<std::size_t>(files_.toOpen.size())))];
  }
  note("file dialog: " + file, dialog);
  auto* line = dialog->findChild<QLineEdit*>("fileNameEdit");
  if (file.isEmpty() || !line) {
    dialog->reject();
    return;
  }
  const QPointer<QFileDialog> alive = dialog;
  line->setText(file);
  QTest::keyClick(line, Qt::Key_Return);
  if (alive && alive->isVisible() && alive == QApplication::activeModalWidget())
    alive->reject(); // it does not take that file
}

QWidget* Monkey::someWidget(QWidget* top) {
  QList<QWidget*> there, interesting;
  for (QWidget* widget : top->findChildren<QWidget*>())
    if (widget->isVisible() && widget->isEnabled() && widget->window() == top->window()) {
      there << widget;
      if (isInteresting(widget))
        interesting << widget;
    }
  there << top;
  const QList<QWidget*>& from = interesting.isEmpty() || below(6) == 0 ? there : interesting;
  return from[static_cast<qsizetype>(below(static_cast<std::size_t>(from.size())))];
}

QPoint Monkey::placeIn(const QWidget* widget) {
  // A visible widget counts, however small: scrolled-out widgets are not clicked.
  const QRect seen = widget->visibleRegion().boundingRect();
  const QRect in = seen.isEmpty() ? widget->rect() : seen;
  return in.topLeft() +
         QPoint(static_cast<int>(below(static_cast<std::size_t>(std::max(1, in.width())))),
                static_cast<int>(below(static_cast<std::size_t>(std::max(1, in.height())))));
}

void Monkey::act(QWidget* top) {
  QWidget* target = someWidget(top);
  switch (below(14)) {
  case 0:
  case 1:
  case 2:
  case 3:
    press(target, false);
    break;
  case 4:
    press(target, true);
    break;
  case 5:
  case 6:
    drag(target);
    break;
  case 7:
    wheel(target);
    break;
  case 8:
  case 9:
    type(top);
    break;
  default:
    key(target);
  }
}

void Monkey::press(QWidget* target, bool twice) {
  // On a box's indicator, most of the time: the area right of its word does nothing.
  const QPoint place = qobject_cast<QAbstractButton*>(target) && below(2)
                           ? QPoint(std::min(8, target->width() / 2), target->height() / 2)
                           : placeIn(target);
  static constexpr std::array kButtons{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton,
                                       Qt::LeftButton, Qt::RightButton};
  const Qt::MouseButton button = kButtons[below(kButtons.size())];
  note(QString("%1 %2,%3").arg(twice ? "double click" : "click").arg(place.x()).arg(place.y()),
       target);
  const QPointer<QWidget> alive = target;
  QTest::mousePress(target, button, {}, place);
  if (alive)
    QTest::mouseRelease(target, button, {}, place);
  if (!twice || !alive || !alive->isVisible())
    return;
  QTest::mouseDClick(target, button, {}, place);
}

void Monkey::drag(QWidget* target) {
  constexpr int kFar = 120, kMoves = 4;
  const QPoint place = placeIn(target);
  const Qt::MouseButton button = below(3) ? Qt::LeftButton : Qt::MiddleButton;
  note(QString("drag from %1,%2").arg(place.x()).arg(place.y()), target);
  const QPointer<QWidget> alive = target;
  QTest::mousePress(target, button, {}, place);
  QPoint at = place;
  for (int i = 0; i < kMoves && alive; ++i) {
    at = place +
         QPoint(static_cast<int>(below(2 * kFar)) - kFar, static_cast<int>(below(2 * kFar)) - kFar);
    QMouseEvent move(QEvent::MouseMove, at, target->mapToGlobal(QPointF(at)), Qt::NoButton, button,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(target, &move);
  }
  if (alive)
    QTest::mouseRelease(target, button, {}, at);
}

void Monkey::wheel(QWidget* target) {
  const QPoint place = placeIn(target);
  note("wheel", target);
  QWheelEvent event(place, target->mapToGlobal(QPointF(place)), {}, {0, below(2) ? 120 : -120},
                    Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(target, &event);
}

void Monkey::key(QWidget* target) {
  static constexpr std::array kPlain{
      Qt::Key_Up,     Qt::Key_Down,   Qt::Key_Left,   Qt::Key_Right,    Qt::Key_Tab,
      Qt::Key_Home,   Qt::Key_End,    Qt::Key_Space,  Qt::Key_Space,    Qt::Key_Escape,
      Qt::Key_Return, Qt::Key_Delete, Qt::Key_PageUp, Qt::Key_PageDown, Qt::Key_M,
      Qt::Key_R,      Qt::Key_S,      Qt::Key_F,      Qt::Key_X,        Qt::Key_U,
      Qt::Key_L,      Qt::Key_F5,     Qt::Key_F6,     Qt::Key_F7,       Qt::Key_F8,
      Qt::Key_F9,     Qt::Key_1,      Qt::Key_0,      Qt::Key_Period,   Qt::Key_Comma};
  static constexpr std::array kWithControl{Qt::Key_Z, Qt::Key_Z, Qt::Key_Z, Qt::Key_Y,
                                           Qt::Key_Y, Qt::Key_R, Qt::Key_L, Qt::Key_Period,
                                           Qt::Key_O, Qt::Key_N, Qt::Key_S};
  const bool control = below(4) == 0;
  const Qt::Key chosen =
      control ? kWithControl[below(kWithControl.size())] : kPlain[below(kPlain.size())];
  const Qt::KeyboardModifiers with = control ? Qt::ControlModifier : Qt::NoModifier;
  note("key " + QKeySequence(with | chosen).toString(), target);
  // Like a keyboard: the widget with the focus gets it.
  QWidget* focus = QApplication::focusWidget();
  QWidget* to = focus && focus->window() == target->window() && below(3) ? focus : target;
  const QPointer<QWidget> alive = to;
  QTest::keyPress(to, chosen, with);
  if (alive)
    QTest::keyRelease(to, chosen, with);
}

QString Monkey::someText() {
  static const std::array kTexts{"0",  "1",  "0.4", "2",   "3.5", "12",  "45",
                                 "-7", "90", "1e9", "abc", "",    "0.8", "9999999"};
  return kTexts[below(kTexts.size())];
}

void Monkey::type(QWidget* top) {
  QList<QWidget*> fields;
  for (QWidget* widget : top->findChildren<QWidget*>())
    if (widget->isVisible() && widget->isEnabled() && isFor(widget, true) &&
        !qobject_cast<QAbstractSpinBox*>(widget->parentWidget()))
      fields << widget;
  if (fields.isEmpty())
    return;
  QWidget* field = fields[static_cast<qsizetype>(below(static_cast<std::size_t>(fields.size())))];
  const QString text = someText();
  note("type " + text, field);
  const QPointer<QWidget> alive = field;
  field->setFocus();
  QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
  for (const QChar& letter : text)
    if (alive)
      QTest::keyClick(field, letter.toLatin1());
  if (alive && below(3))
    QTest::keyClick(field, below(2) ? Qt::Key_Return : Qt::Key_Tab);
}

} // namespace voluta::test
