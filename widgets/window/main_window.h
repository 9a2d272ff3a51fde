// The main window: a shell of docks, flow bar, status line and menus around one view
// (docs/design.md, Window). Its functions belong to its pages (pages/); files, runs and findings
// have separate objects.
#pragma once

#include "document/comparing.h"
#include "document/document.h"
#include "document/live_preview.h"
#include "document/planning.h"
#include "document/session_log.h"
#include "window/pages/page_stack.h"
#include "window/picture.h"
#include "window/picture_area.h"
#include "window/presenters/presenter.h"
#include "window/project_files.h"
#include "window/runs.h"
#include "window/window_commands.h"
#include "window/window_theme.h"

#include <QMainWindow>
#include <memory>

class QDockWidget;
class QLabel;

namespace voluta::panels {
class FindingsPanel;
}

namespace voluta::window {

class FindingsPresenter;
class ObjectMenus;
class StatusLine;

class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  explicit MainWindow(Appearance appearance, QWidget* parent = nullptr);
  ~MainWindow() override;

  // A part, a project or "sample:NAME".
  void open(const QString& path) { files_.open(path); }
  // Offers to restore files left after a crash, if there are any.
  void offerRecovered() { files_.offerRecovered(); }
  PageStack& pages() { return *pages_; }

  document::Document& document() { return document_; }
  document::Planning& planning() { return planning_; }
  document::LivePreview& livePreview() { return live_; }
  document::Comparing& comparing() { return comparing_; }
  viewer::Viewport& viewport() { return area_->viewport(); }
  Presenter& presenter() { return *presenter_; }

protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void buildDocks();
  void buildCommands();
  std::vector<Command> ownCommands();
  void listen();
  void showStates();
  void showObjects(); // Updates part, platform and cell in tree and status line
  void plan(project::Stage until);
  void setAppearance(Appearance appearance);
  void editShortcuts();
  void openPalette();
  void openFilm();
  void openQuote();
  void showMessage(const QString& title, const QString& message);
  void retranslate();
  void fitToolBar();
  void fitPageDock();

  QDockWidget *partDock_ = nullptr, *findingsDock_ = nullptr, *pageDock_ = nullptr;
  document::Document document_;
  document::Planning planning_;
  document::LivePreview live_;
  document::Comparing comparing_;
  ProjectFiles files_;
  Runs runs_;
  document::SessionLog log_;
  Picture picture_;
  Appearance appearance_;
  PictureArea* area_;
  Presenter* presenter_;
  StatusLine* status_;
  panels::ObjectTree* tree_;
  panels::FindingsPanel* findings_;
  UnrolledDock* unrolled_;
  QLabel *headline_, *summary_;
  ObjectMenus* menus_ = nullptr;
  std::unique_ptr<FindingsPresenter> findingsPresenter_;
  std::unique_ptr<PageStack> pages_;
  CommandTable* commands_;
  std::string shownCell_; // with its label, which stands in its file
  QString cellLabel_;
  const Page* pageShown_ = nullptr;
  bool closing_ = false;
};

} // namespace voluta::window
