#include "gui/window_fixture.h"

#include "base/files.h"

#include "window/view_tools.h"

#include <QAbstractItemView>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTabBar>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cstring>
#include <string>

namespace voluta::test {

WatchedApplication& application() {
  return *static_cast<WatchedApplication*>(QCoreApplication::instance());
}

GivenFiles::GivenFiles() {
  QDesktopServices::setUrlHandler("file", this, "take");
}

GivenFiles::~GivenFiles() {
  QDesktopServices::unsetUrlHandler("file");
}

void WindowTest::SetUp() {
  qputenv("VOLUTA_STATE_DIR", folder_.path().toUtf8());
  qputenv("VOLUTA_DATA", folder_.path().toUtf8()); // No own files but the test's
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
  QSettings().clear();
  openWindow();
}

void WindowTest::openWindow() {
  window_.reset();
  window_ = std::make_unique<window::MainWindow>(window::Appearance::Light);
  QObject::connect(&window_->viewport(), &viewer::VtkView::framePainted, &window(),
                   [](double ms) { application().addFrame(ms); });
  window_->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  window_->activateWindow(); // there may be no window manager to do it
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get()));
  ASSERT_TRUE(waitFor([&] { return window().viewport().lastFrameMs() > 0.0; }));
}

void WindowTest::TearDown() {
  window_.reset();
  QCoreApplication::processEvents();
  qunsetenv("VOLUTA_DATA");
}

QString WindowTest::writePart(const QString& name, const geometry::TriangleMesh& mesh) const {
  std::string bytes(80, ' ');
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i)
      put(0.0F);
    for (const int v : t)
      for (int axis = 0; axis < 3; ++axis)
        put(static_cast<float>(mesh.vertices[static_cast<std::size_t>(v)][axis]));
    put(std::uint16_t{0});
  }
  base::writeFile(path(name).toStdString(), bytes);
  return path(name);
}

bool WindowTest::waitFor(const std::function<bool()>& condition, int ms) {
  return QTest::qWaitFor(condition, ms);
}

bool WindowTest::planned(project::Stage stage) {
  return waitFor([&] {
    return !window().planning().running() && document().upToDate(stage) &&
           !window().presenter().busy();
  });
}

void WindowTest::openPart(const QString& file) {
  window().open(file);
  ASSERT_TRUE(waitFor([&] {
    return document().source() && document().sourceReady() &&
           document().upToDate(project::Stage::Load) && !window().planning().running() &&
           !window().presenter().busy();
  }));
}

void WindowTest::chooseFlat(const std::string& platform) {
  project::Choices choices = document().choices();
  choices.item().automatic = false;
  choices.item().mode = "flat";
  if (!platform.empty())
    choices.item().platform = project::Platform(platform);
  document().setChoices(choices, "flat");
}

void WindowTest::clickMenu(const char* menuName, const char* actionName) {
  auto* menu = find<QMenu>(menuName);
  auto* action = find<QAction>(actionName);
  QMenuBar* bar = window().menuBar();
  QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(menu->menuAction()).center());
  ASSERT_TRUE(waitFor([&] { return menu->isVisible(); }, 5000));
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
}

void WindowTest::clickToolBar(const char* actionName) {
  auto* bar = find<QToolBar>("toolBar");
  const auto* action = find<QAction>(actionName);
  QWidget* button = bar->widgetForAction(const_cast<QAction*>(action));
  if (!button)
    button = find<window::ViewTools>("viewTools")->button(action);
  ASSERT_NE(button, nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
}

void WindowTest::choosePage(const char* page) {
  auto* flow = find<window::FlowBar>("flowBar");
  QTest::mouseClick(flow, Qt::LeftButton, {}, flow->segment(page).center());
  EXPECT_EQ(this->page(), page);
}

void WindowTest::answerBox(const char* name, QMessageBox::ButtonRole role) {
  auto* timer = new QTimer(window_.get());
  QObject::connect(timer, &QTimer::timeout, timer, [this, timer, name, role] {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      auto* box = qobject_cast<QMessageBox*>(widget);
      if (!box || !box->isVisible() || (*name && box->objectName() != name))
        continue;
      for (QAbstractButton* button : box->buttons())
        if (box->buttonRole(button) == role) {
          timer->stop();
          const QPointer<QMessageBox> clicked = box;
          QTest::mouseClick(button, Qt::LeftButton);
          // A box that is not laid out yet misses the click.
          if (clicked && clicked->isVisible()) {
            timer->start();
          } else {
            timer->deleteLater();
            ++answeredBoxes_;
          }
          return;
        }
    }
  });
  timer->start(30);
}

void WindowTest::answerFileDialog(const QString& file) {
  auto* timer = new QTimer(window_.get());
  QObject::connect(timer, &QTimer::timeout, timer, [timer, file] {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QFileDialog*>(widget); dialog && dialog->isVisible()) {
        timer->deleteLater();
        timer->stop();
        auto* line = dialog->findChild<QLineEdit*>("fileNameEdit");
        line->setText(file);
        QTest::keyClick(line, Qt::Key_Return);
        return;
      }
  });
  timer->start(30);
}

void WindowTest::recordLongestStretch() {
  RecordProperty("longestStretchMs", std::to_string(application().longestMs()));
  RecordProperty("longestWhat", application().longestWhat().toStdString());
}

QImage WindowTest::picture() {
  // A camera that has just moved shows less detail for a moment.
  EXPECT_TRUE(waitFor([&] { return !window().viewport().view().dragging; }, 10000));
  int frames = 0;
  const auto counting = QObject::connect(&window().viewport(), &viewer::VtkView::framePainted,
                                         &window(), [&] { ++frames; });
  window().viewport().requestFrame();
  EXPECT_TRUE(waitFor([&] { return frames > 0; }, 10000));
  QObject::disconnect(counting);
  return window().viewport().grabFrame().convertToFormat(QImage::Format_RGB32);
}

void keepPicture(QWidget& of, const char* name) {
  const QString folder = qEnvironmentVariable("VOLUTA_TEST_PICTURES");
  if (folder.isEmpty())
    return;
  QTest::qWait(500);
  of.screen()->grabWindow(of.winId()).save(folder + "/" + name + ".png");
}

namespace {
// Whether it is a part of another widget, which has the name.
bool isInside(const QWidget& widget) {
  for (const QWidget* at = widget.parentWidget(); at; at = at->parentWidget())
    if (qobject_cast<const QAbstractSpinBox*>(at) || qobject_cast<const QComboBox*>(at) ||
        qobject_cast<const QAbstractItemView*>(at) || qobject_cast<const QTabBar*>(at) ||
        qobject_cast<const QKeySequenceEdit*>(at) || qobject_cast<const QLineEdit*>(at))
      return true;
  return false;
}
} // namespace

QStringList withoutName(const QWidget& top) {
  QStringList unnamed;
  for (QWidget* widget : top.findChildren<QWidget*>()) {
    const bool isUsed =
        widget->focusPolicy() != Qt::NoFocus || qobject_cast<const QAbstractButton*>(widget);
    const bool isFrame =
        qobject_cast<const QScrollArea*>(widget) || qobject_cast<const QScrollBar*>(widget) ||
        qobject_cast<const QTabWidget*>(widget) || qobject_cast<const QTabBar*>(widget) ||
        qobject_cast<const QLabel*>(widget) || widget->isWindow();
    if (!widget->isVisibleTo(&top) || !isUsed || isFrame || isInside(*widget))
      continue;
    QAccessibleInterface* seen = QAccessible::queryAccessibleInterface(widget);
    const QString name = seen ? seen->text(QAccessible::Name) : QString();
    if (std::ranges::none_of(name, [](QChar letter) { return letter.isLetter(); }))
      unnamed << QStringLiteral("%1 %2 in %3 %4")
                     .arg(widget->metaObject()->className(), widget->objectName(),
                          widget->parentWidget()->metaObject()->className(),
                          widget->parentWidget()->objectName());
  }
  return unnamed;
}

double differingShare(const QImage& a, const QImage& b) {
  if (a.size() != b.size())
    return 1.0;
  long long differ = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      differ += a.pixel(x, y) != b.pixel(x, y);
  return static_cast<double>(differ) / (static_cast<double>(a.width()) * a.height());
}

} // namespace voluta::test
