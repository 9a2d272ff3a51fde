// A real window with settings and recovery of its own, and hands to work it with.
#pragma once

#include "geometry/triangle_mesh.h"
#include "gui/watchdog.h"
#include "window/flow_bar.h"
#include "window/main_window.h"

#include <QImage>
#include <QMessageBox>
#include <QString>
#include <QTemporaryDir>
#include <QUrl>
#include <functional>
#include <gtest/gtest.h>
#include <memory>

class QAction;
class QToolBar;

namespace voluta::test {

WatchedApplication& application();

// Takes the files that the window gives to other programs: a test starts none.
class GivenFiles : public QObject {
  Q_OBJECT

public:
  GivenFiles();
  ~GivenFiles() override;
  Q_INVOKABLE void take(const QUrl& url) { files_ << url.toLocalFile(); }
  const QStringList& files() const { return files_; }

private:
  QStringList files_;
};

// Ids of the pages.
struct Page {
  static constexpr const char* Prepare = "prepare";
  static constexpr const char* Layers = "layers";
  static constexpr const char* Simulate = "simulate";
  static constexpr const char* Export = "export";
  static constexpr const char* Compare = "compare";
};

class WindowTest : public testing::Test {
protected:
  void SetUp() override;
  void TearDown() override;

  // A new one, as when the program is started again.
  void openWindow();
  window::MainWindow& window() { return *window_; }
  document::Document& document() { return window_->document(); }
  QString path(const QString& name) const { return folder_.filePath(name); }
  // Writes a binary STL into the test's folder and gives its path.
  QString writePart(const QString& name, const geometry::TriangleMesh& mesh) const;

  // Waits while events are served; false when it didn't come true in time.
  static bool waitFor(const std::function<bool()>& condition, int ms = 180000);
  // All stages of the present choices are done and drawn.
  bool planned(project::Stage stage);
  // Opens a part and waits until it is on the plate.
  void openPart(const QString& file);
  // Flat layers instead of mode auto, which would plan several ways. `platform`: "" keeps it.
  void chooseFlat(const std::string& platform = {});
  // By the mouse: menu bar, then the entry.
  void clickMenu(const char* menu, const char* action);
  void clickToolBar(const char* action);
  void choosePage(const char* page);
  QString page() const { return window_->pages().page().id(); }
  // Once a box of that name ("": any) is up, clicks its button of that role.
  void answerBox(const char* name, QMessageBox::ButtonRole role);
  int answeredBoxes() const { return answeredBoxes_; }
  // Once a file dialog is up, enters the file.
  void answerFileDialog(const QString& file);
  // A property of the test: the longest stretch of the window's thread since its last reset.
  static void recordLongestStretch();
  // The viewport as shown, after a frame in full detail.
  QImage picture();
  template <typename T> T* find(const char* name) {
    auto* found = window_->findChild<T*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }

  QTemporaryDir folder_;
  GivenFiles given_;
  std::unique_ptr<window::MainWindow> window_;

private:
  int answeredBoxes_ = 0;
};

// For who wants to see it: VOLUTA_TEST_PICTURES names a folder.
void keepPicture(QWidget& of, const char* name);

// Fields and buttons on show in `top` that a screen reader cannot name.
QStringList withoutName(const QWidget& top);

// Share of pixels that differ between two pictures of one size.
double differingShare(const QImage& a, const QImage& b);

} // namespace voluta::test
