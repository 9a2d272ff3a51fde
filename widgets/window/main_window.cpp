#include "window/main_window.h"

#include "forms/tab_order.h"
#include "language/words.h"
#include "modes/mode_table.h"
#include "panels/findings_panel.h"
#include "panels/object_tree.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/data_labels.h"
#include "window/dialog_fit.h"
#include "window/film/film_dialog.h"
#include "window/flow_bar.h"
#include "window/log_dialog.h"
#include "window/manual/manual_window.h"
#include "window/object_menus.h"
#include "window/palette/palette_entries.h"
#include "window/presenters/findings_presenter.h"
#include "window/quote/quote_dialog.h"
#include "window/shared_keys.h"
#include "window/shell_commands.h"
#include "window/shortcuts_dialog.h"
#include "window/status_line.h"
#include "window/view_tools.h"
#include "window/welcome.h"
#include "window/window_icons.h"

#include <QApplication>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTimer>
#include <QToolBar>
#include <QUndoStack>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
constexpr QSize kUsualSize(1280, 800);
constexpr int kPanelWidth = 340, kTreeWidth = 300;
constexpr int kTreeHeight = 200, kFindingsHeight = 400;
// Shares of the column's height; kUnrolledShare includes the unrolled layer.
constexpr int kTreeShare = 150, kFindingsShare = 130, kUnrolledShare = 460;
constexpr int kLayoutVersion = 1;
constexpr int kMaxPanelShare = 3; // Fraction of the window's width: a third

// Returns the width that the pages need without being cut off, including the scroll bar.
int neededWidth(const QStackedWidget& pages) {
  int needed = 0;
  for (const QScrollArea* area : pages.findChildren<QScrollArea*>(kPageArea))
    needed = std::max(needed, area->widget()->minimumSizeHint().width() +
                                  area->verticalScrollBar()->sizeHint().width());
  return needed;
}

QString sizeText(const Eigen::Vector3d& v) {
  const QLocale locale;
  return QString::fromUtf8("%1 × %2 × %3 mm")
      .arg(locale.toString(v.x(), 'f', 1), locale.toString(v.y(), 'f', 1),
           locale.toString(v.z(), 'f', 1));
}

QDockWidget* dock(const char* name, QWidget* content, QMainWindow& window,
                  Qt::DockWidgetArea area) {
  auto* made = new QDockWidget(&window);
  made->setObjectName(name);
  made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  made->setWidget(content);
  window.addDockWidget(area, made);
  return made;
}
} // namespace

MainWindow::MainWindow(Appearance appearance, QWidget* parent)
    : QMainWindow(parent), planning_(document_), live_(document_, planning_), comparing_(document_),
      files_(document_, planning_, *this),
      runs_(document_, planning_, live_, comparing_, files_.opening()),
      log_(document::logFile(), document_, planning_, files_.opening()), appearance_(appearance),
      area_(new PictureArea(appearance, this)),
      presenter_(new Presenter(document_, area_->viewport(), this)), status_(new StatusLine(this)),
      tree_(new panels::ObjectTree(this)), findings_(new panels::FindingsPanel(this)),
      unrolled_(new UnrolledDock(document_, *presenter_, area_->layers(), this)),
      headline_(new QLabel(this)), summary_(new QLabel(this)),
      findingsPresenter_(std::make_unique<FindingsPresenter>(document_, planning_, live_,
                                                             *findings_, area_->timeline())),
      commands_(new CommandTable(*this)) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  pages_ = std::make_unique<PageStack>(
      WorkspaceParts{document_, planning_, live_, files_.opening(), comparing_, viewport(),
                     area_->layers(), area_->timeline(), *tree_, *presenter_, picture_},
      area_, area_->legend(), area_->badge(), *unrolled_, this);
  setCentralWidget(pages_->centres());
  setStatusBar(status_);
  buildDocks();
  buildCommands();
  menus_ = new ObjectMenus(
      {document_, *pages_, *tree_, *commands_, area_->layers(), picture_, viewport(), *presenter_},
      *findings_, this);
  new SharedKeys(*this, viewport());
  new DialogFit(this);
  new ManualKey(*this);
  listen();
  forms::tabInReadingOrder({pages_->flow(), tree_, findings_, pages_->centres(), pages_->sides()});
  retranslate();
  pages_->show(pages_->page());
  // With its frame the window would not fit on a small screen: the status line would be off the
  // screen.
  const QSize room = screen()->availableSize();
  resize(kUsualSize.boundedTo(room));
  if (room.width() <= kUsualSize.width() || room.height() <= kUsualSize.height())
    setWindowState(Qt::WindowMaximized);
  const QSettings settings;
  restoreGeometry(settings.value("window/geometry").toByteArray());
  restoreState(settings.value("window/state").toByteArray(), kLayoutVersion);
}

// While the window is destroyed, its objects must not notify it.
MainWindow::~MainWindow() {
  for (QObject* one : {static_cast<QObject*>(&document_), static_cast<QObject*>(&planning_),
                       static_cast<QObject*>(&live_), static_cast<QObject*>(&comparing_),
                       static_cast<QObject*>(&files_.opening()), static_cast<QObject*>(&files_),
                       static_cast<QObject*>(&runs_), static_cast<QObject*>(document_.undoStack())})
    one->disconnect();
  // A field that is hidden commits what has been typed: while all that takes it is still there.
  hide();
}

void MainWindow::buildDocks() {
  tree_->setObjectName("tree");
  findings_->setObjectName("findings");
  partDock_ = dock("partDock", tree_, *this, Qt::LeftDockWidgetArea);
  findingsDock_ = dock("findingsDock", findings_, *this, Qt::LeftDockWidgetArea);
  auto* side = new QWidget(this);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(pages_->sides(), 1);
  summary_->setObjectName("summary");
  summary_->setWordWrap(true);
  summary_->setContentsMargins(10, 6, 10, 6);
  headline_->setObjectName("headline");
  headline_->setWordWrap(true);
  headline_->setContentsMargins(10, 6, 10, 0);
  QFont bold = headline_->font();
  bold.setBold(true);
  headline_->setFont(bold);
  headline_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(headline_);
  column->addWidget(summary_);
  pageDock_ = dock("pageDock", side, *this, Qt::RightDockWidgetArea);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  addDockWidget(Qt::LeftDockWidgetArea, unrolled_);
  unrolled_->hide();
  // Gets its own share of the column once; then the user decides.
  connect(unrolled_, &UnrolledDock::firstShown, this, [this] {
    resizeDocks({partDock_, findingsDock_, unrolled_}, {kTreeShare, kFindingsShare, kUnrolledShare},
                Qt::Vertical);
  });
  resizeDocks({partDock_, pageDock_}, {kTreeWidth, kPanelWidth}, Qt::Horizontal);
  resizeDocks({partDock_, findingsDock_}, {kTreeHeight, kFindingsHeight}, Qt::Vertical);
}

void MainWindow::buildCommands() {
  commands_->add(files_.commands());
  commands_->add(files_.sampleCommands());
  commands_->add(undoCommands(*document_.undoStack()));
  commands_->add(pages_->commands());
  commands_->add(ownCommands());
  commands_->add(viewCommands(*area_, picture_, *unrolled_, [this] { pages_->showView(); }));
  commands_->add(languageCommands());
  commands_->add(runs_.commands());
  commands_->add(timelineCommands(area_->timeline()));
  for (QDockWidget* one : {partDock_, findingsDock_, pageDock_})
    commands_->add({one->toggleViewAction(), "windowMenu", 1});
  commands_->build(commandMenus(), pages_->flow());
  area_->tools().setGroups({commands_->actionsOf(BarGroup::Parts),
                            commands_->actionsOf(BarGroup::Tools),
                            commands_->actionsOf(BarGroup::Place)});
  files_.setRecentMenu(commands_->menu("recentMenu"));
}

std::vector<Command> MainWindow::ownCommands() {
  return {
      {"quit",
       "fileMenu",
       2,
       QT_TRANSLATE_NOOP("Commands", "&Quit"),
       QT_TRANSLATE_NOOP("Commands", "Close the window"),
       {QKeySequence("Ctrl+Q")},
       [this] { close(); }},
      {"shortcuts",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "&Keys…"),
       QT_TRANSLATE_NOOP("Commands", "See and change the keys"),
       {},
       [this] { editShortcuts(); }},
      {"palette",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "&Find a command or setting…"),
       QT_TRANSLATE_NOOP("Commands", "Lists commands and settings while you type"),
       {QKeySequence("Ctrl+K")},
       [this] { openPalette(); }},
      {"light",
       "lookMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Light"),
       QT_TRANSLATE_NOOP("Commands", "Dark text on a light background"),
       {},
       [this] { setAppearance(Appearance::Light); },
       {},
       [this] { return appearance_ == Appearance::Light; }},
      {"dark",
       "lookMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Dark"),
       QT_TRANSLATE_NOOP("Commands", "Light text on a dark background"),
       {},
       [this] { setAppearance(Appearance::Dark); },
       {},
       [this] { return appearance_ == Appearance::Dark; }},
      {"highContrast",
       "lookMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&High contrast"),
       QT_TRANSLATE_NOOP("Commands", "White text on black, with strong outlines"),
       {},
       [this] { setAppearance(Appearance::HighContrast); },
       {},
       [this] { return appearance_ == Appearance::HighContrast; }},
      {"exportPicture",
       "exportMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "P&icture…"),
       QT_TRANSLATE_NOOP("Commands", "Save the viewport as a PNG"),
       {},
       [this] {
         savePicture(*area_, document_.name(), [this](const QString& file) {
           showMessage(tr("Save the picture"),
                       tr("%1 cannot be written. Choose another folder.").arg(file));
         });
       }},
      {"exportFilm",
       "exportMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Film…"),
       QT_TRANSLATE_NOOP("Commands", "Save a film of the robot that prints the part (WebM)"),
       {},
       [this] { openFilm(); },
       [this] {
         const auto plan = document_.presentResult();
         return plan && plan->job.trajectory;
       }},
      {"quote",
       "exportMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "&Quote…"),
       QT_TRANSLATE_NOOP("Commands", "Cost of the print, and its page for a customer"),
       {},
       [this] { openQuote(); },
       [this] { return !runs_.headline().isEmpty(); }},
      {"fullScreen",
       "windowMenu",
       2,
       QT_TRANSLATE_NOOP("Commands", "&Full screen"),
       QT_TRANSLATE_NOOP("Commands", "The whole screen"),
       {QKeySequence("F11")},
       [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); }},
      {"manual",
       "helpMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Manual"),
       QT_TRANSLATE_NOOP("Commands", "The page of the manual about what is shown"),
       {QKeySequence("F1")},
       [this] { openManual(*this, pages_->page().id()); }},
      {"helpKeys",
       "helpMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&Keys"),
       QT_TRANSLATE_NOOP("Commands", "All keys at a glance"),
       {QKeySequence("Shift+F1")},
       [this] { editShortcuts(); }},
      {"showLog",
       "helpMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "Show &log"),
       QT_TRANSLATE_NOOP("Commands", "Files opened, plans, findings and errors"),
       {},
       [this] { (new LogDialog(document::logFile(), this))->open(); },
       [] { return QFileInfo::exists(document::logFile()); }},
      {"about",
       "helpMenu",
       0,
       QT_TRANSLATE_NOOP("Commands", "&About Voluta"),
       QT_TRANSLATE_NOOP("Commands", "Version and licence"),
       {},
       [this] { showAbout(*this); }},
  };
}

void MainWindow::listen() {
  connect(&viewport(), &viewer::VtkView::openGlReady, &log_, &document::SessionLog::note);
  const auto title = [this] { setWindowTitle(document_.name() + "[*] – Voluta"); };
  connect(&document_, &document::Document::nameChanged, this, title);
  connect(&document_, &document::Document::dirtyChanged, this,
          [this](bool dirty) { setWindowModified(dirty); });
  title();
  connect(document_.undoStack(), &QUndoStack::indexChanged, commands_, &CommandTable::refresh);
  connect(&document_, &document::Document::choicesChanged, this, &MainWindow::showObjects);
  connect(&document_, &document::Document::sourceChanged, this, &MainWindow::showObjects);
  connect(&document_, &document::Document::resultChanged, this, &MainWindow::showObjects);
  connect(presenter_, &Presenter::partDrawn, this, &MainWindow::showObjects);
  const auto states = [this] { pages_->showStates(); };
  connect(&document_, &document::Document::stateChanged, this, states);
  connect(&runs_, &Runs::changed, this, states);
  connect(&runs_, &Runs::planAsked, this, &MainWindow::plan);
  connect(&runs_, &Runs::progressed, status_, &StatusLine::showProgress);
  connect(&runs_, &Runs::said, status_, &StatusLine::showIdle);
  connect(&runs_, &Runs::messageRaised, this, &MainWindow::showMessage);
  connect(&files_, &ProjectFiles::said, status_, &StatusLine::showIdle);
  connect(&files_, &ProjectFiles::messageRaised, this, &MainWindow::showMessage);
  connect(&files_, &ProjectFiles::opened, this, [this](bool project) {
    picture_.setMarker(std::nullopt);
    if (document_.isRest())
      pages_->showPageOf(Stage::Motion);
    else if (project && document_.result(Stage::Layers))
      pages_->showPageOf(Stage::Layers);
    else
      pages_->showFirst();
  });
  connect(&files_, &ProjectFiles::cleared, pages_.get(), &PageStack::showFirst);
  connect(pages_.get(), &PageStack::statesShown, this, &MainWindow::showStates);
  connect(pages_.get(), &PageStack::addPartAsked, &files_, &ProjectFiles::chooseToAdd);
  connect(pages_.get(), &PageStack::resumeAsked, &files_, &ProjectFiles::resume);
  connect(pages_.get(), &PageStack::said, status_, &StatusLine::showIdle);
  connect(pages_.get(), &PageStack::messageRaised, this, &MainWindow::showMessage);
  connect(findings_, &panels::FindingsPanel::activated, pages_.get(), &PageStack::goTo);
  connect(&area_->welcome(), &Welcome::openRequested, &files_, &ProjectFiles::choose);
  connect(&area_->welcome(), &Welcome::sampleRequested, this, [this] { open("sample:vase"); });
}

void MainWindow::showStates() {
  commands_->refresh();
  area_->tools().setVisible(document_.source() && pages_->page().layout().aboutPart);
  const QString headline = runs_.headline();
  headline_->setText(headline);
  headline_->setVisible(!headline.isEmpty());
  summary_->setText(runs_.summary());
  pageDock_->setWindowTitle(pages_->page().title());
  if (std::exchange(pageShown_, &pages_->page()) != &pages_->page())
    QTimer::singleShot(0, this, &MainWindow::fitPageDock); // Layouts process the change only later
}

void MainWindow::showObjects() {
  using panels::SceneItem;
  const project::Choices& c = document_.choices();
  const auto source = document_.source();
  Welcome& welcome = area_->welcome();
  welcome.setVisible(!source || welcome.hasMessage());
  const Eigen::AlignedBox3d& box = presenter_->partBox();
  const QString size =
      source ? sizeText(box.isEmpty() ? Eigen::Vector3d::Zero().eval() : box.sizes().eval())
             : QString();
  const std::size_t parts = document_.partCount();
  tree_->setText(SceneItem::Part,
                 parts > 1 ? tr("%1 parts").arg(parts)
                 : source  ? QString::fromStdString(source->name)
                           : QString(),
                 {});
  tree_->setText(SceneItem::Platform, {}, language::words(c.item().platform.shown()));
  if (c.cell != shownCell_) {
    shownCell_ = c.cell;
    cellLabel_ = cellLabel(c.cell);
  }
  const QString& cell = cellLabel_;
  tree_->setText(SceneItem::Cell, {}, cell);
  tree_->setText(SceneItem::Plate, modes::findMode(c.item().mode).aroundRod ? tr("Rod") : QString(),
                 {});
  status_->setPart(size);
  status_->setCell(cell);
}

void MainWindow::plan(Stage until) {
  if (!document_.source()) {
    files_.choose();
    return;
  }
  if (document_.unusable())
    return;
  if (until == Stage::Replay && runs_.hasPlanned()) {
    pages_->show(*pages_->find("export"));
    return;
  }
  if (until == Stage::Replay)
    pages_->showResults();
  else
    pages_->showPageOf(until);
  planning_.plan(until);
}

void MainWindow::setAppearance(Appearance appearance) {
  appearance_ = appearance;
  applyAppearance(*qobject_cast<QApplication*>(QCoreApplication::instance()), appearance_);
  viewport().scene().setTheme(sceneTheme(appearance_));
  viewport().requestFrame();
  QSettings().setValue("window/appearance", appearanceName(appearance_));
}

void MainWindow::editShortcuts() {
  ShortcutsDialog dialog(commands_->actions(), this);
  if (dialog.exec() == QDialog::Accepted)
    commands_->retranslate();
}

void MainWindow::openPalette() {
  commands_->refresh();
  std::vector<PaletteEntry> entries = commandEntries(*commands_);
  for (PaletteEntry& setting : settingEntries(*pages_))
    entries.push_back(std::move(setting));
  (new CommandPalette(std::move(entries), this))->open();
}

void MainWindow::openFilm() {
  auto* dialog = new FilmDialog(document_.presentResult(), document_.name(),
                                appearance_ != Appearance::Light, this);
  connect(dialog, &FilmDialog::saved, this,
          [this](const QString& file) { status_->showIdle(tr("Saved the film %1").arg(file)); });
  dialog->open();
}

void MainWindow::openQuote() {
  const Eigen::AlignedBox3d& box = presenter_->partBox();
  auto* dialog = new QuoteDialog(document_.presentResult(), document_.name(),
                                 box.isEmpty() ? QString() : sizeText(box.sizes()), this);
  connect(dialog, &QDialog::finished, this, &MainWindow::showStates); // The prices may be others
  dialog->open();
}

void MainWindow::showMessage(const QString& title, const QString& message) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, message, QMessageBox::Ok, this);
  box->setObjectName("messageBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

void MainWindow::retranslate() {
  // Sets the locale of the new language: widgets keep the one they were created with
  setLocale(QLocale());
  partDock_->setWindowTitle(tr("Part and cell"));
  findingsDock_->setWindowTitle(tr("Findings"));
  unrolled_->retranslate();
  pages_->retranslate();
  commands_->retranslate();
  showObjects();
  pages_->showStates();
  QTimer::singleShot(0, this, [this] {
    fitToolBar();
    fitPageDock();
  });
}

// Makes room for longer labels and for panels that a small window has squeezed, if possible; until
// another page is shown, the width chosen by the user is kept.
void MainWindow::fitPageDock() {
  if (const int wide = std::min(neededWidth(*pages_->sides()), width() / kMaxPanelShare);
      wide > pageDock_->width())
    resizeDocks({pageDock_}, {wide}, Qt::Horizontal);
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && pageDock_)
    retranslate();
  if (event->type() == QEvent::PaletteChange && pageDock_)
    commands_->redrawIcons();
  QMainWindow::changeEvent(event);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
  QMainWindow::resizeEvent(event);
  if (commands_->toolBar())
    fitToolBar();
  QTimer::singleShot(0, this, &MainWindow::fitPageDock);
}

// Commands that start and stop a run must always be visible.
void MainWindow::fitToolBar() {
  const QToolBar* bar = commands_->toolBar();
  for (const auto& [compact, words] : {std::pair{false, true}, {true, true}, {true, false}}) {
    pages_->flow()->setCompact(compact);
    commands_->setBarWords(words);
    if (bar->sizeHint().width() <= width())
      return;
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!closing_ && document_.dirty()) {
    event->ignore();
    // Queued: a window that is processing a close event ignores another close.
    files_.afterSaved([this] {
      closing_ = true;
      QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
    });
    return;
  }
  runs_.cancelAll();
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  settings.setValue("window/state", saveState(kLayoutVersion));
  files_.end();
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList files;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile())
      files << url.toLocalFile();
  if (files.isEmpty())
    return;
  event->acceptProposedAction();
  // Queued: the source program of the files waits for the end of the drop and must not wait for an
  // answer about unsaved work.
  QMetaObject::invokeMethod(
      this, [this, files] { files_.drop(files); }, Qt::QueuedConnection);
}

} // namespace voluta::window
