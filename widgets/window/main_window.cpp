#include "window/main_window.h"

#include "curved/decompose.h"
#include "forms/choices_form.h"
#include "forms/parameter_form.h"
#include "modes/mode_table.h"
#include "panels/export_panel.h"
#include "panels/findings_panel.h"
#include "panels/layer_info.h"
#include "panels/mesh_panel.h"
#include "panels/pieces_panel.h"
#include "panels/placement_panel.h"
#include "process/process.h"
#include "robot/cell.h"
#include "timeline/joint_plots.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/compare_page.h"
#include "window/core_texts.h"
#include "window/legend_view.h"
#include "window/program_preview.h"
#include "window/spacing_view.h"
#include "window/status_line.h"
#include "window/welcome.h"

#include <QDockWidget>
#include <QLabel>
#include <QLocale>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr int kPanelWidth = 340, kTreeWidth = 300;
constexpr int kLayoutVersion = 1;
constexpr const char* kPageArea = "pageArea";
constexpr int kMostPanelShare = 3; // of the window's width: a third

scene::Theme sceneTheme(Appearance appearance) {
  return appearance == Appearance::Dark ? scene::darkTheme() : scene::lightTheme();
}

// What the pages have to have for nothing to be cut off, the bar that scrolls them included.
int neededWidth(const QStackedWidget& pages) {
  int needed = 0;
  for (const QScrollArea* area : pages.findChildren<QScrollArea*>(kPageArea))
    needed = std::max(needed, area->widget()->minimumSizeHint().width() +
                                  area->verticalScrollBar()->sizeHint().width());
  return needed;
}

forms::ChoiceItem item(std::string_view id, std::string_view label = {}) {
  const QString name = QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()));
  return {name, label.empty() ? coreLabel(id) : coreLabel(label), {}};
}

forms::ChoiceLists choiceLists() {
  forms::ChoiceLists lists;
  for (const modes::Mode& mode : modes::modeTable()) {
    lists.modes.push_back(item(mode.id, mode.label));
    lists.platforms[lists.modes.back().id] = mode.platforms;
  }
  for (const curved::GrowthScheme& growth : curved::growthSchemes())
    lists.growths.push_back({QString::fromStdString(growth.id()), coreLabel(growth.row().label),
                             coreLabel(growth.row().help)});
  for (const std::string& cell : robot::cellIds())
    lists.cells.push_back(item(cell));
  for (const std::string& process : process::processIds())
    lists.processes.push_back(item(process));
  return lists;
}
} // namespace

MainWindow::MainWindow(Appearance appearance, QWidget* parent)
    : QMainWindow(parent), planning_(document_), live_(document_, planning_),
      opening_(document_, planning_), saving_(document_), comparing_(document_),
      autosave_(std::make_unique<document::Autosave>(document_)), appearance_(appearance) {
  setObjectName("mainWindow");
  setAcceptDrops(true);
  planning_.setStartsOver(true);
  live_.setEnabled(QSettings().value("plan/livePreview", true).toBool());
  buildCentre();
  presenter_ = new Presenter(document_, *viewport_, this);
  preview_ = new ProgramPreview(this);
  buildPages();
  buildDocks();
  status_ = new StatusLine(this);
  setStatusBar(status_);
  buildMenus();
  buildToolBar();
  connectDocument();
  connectPages();
  connectGrowth();
  connectPieces();
  connectModes();
  retranslate();
  showChoices();
  showPart();
  showStates();
  setPage(Page::Prepare);
  resize(QSize(1280, 800).boundedTo(screen()->availableSize()));
  const QSettings settings;
  restoreGeometry(settings.value("window/geometry").toByteArray());
  restoreState(settings.value("window/state").toByteArray(), kLayoutVersion);
}

MainWindow::~MainWindow() = default;

void MainWindow::buildCentre() {
  viewport_ = new viewer::Viewport(sceneTheme(appearance_), this);
  legend_ = new LegendView(viewport_);
  viewport_->setLegendWidget(legend_);
  welcome_ = new Welcome(viewport_);
  layers_ = new timeline::LayerRangeSlider(this);
  layers_->setObjectName("layerSlider");
  timeline_ = new timeline::TimelineBar(this);
  timeline_->setObjectName("timeline");
  auto* centre = new QWidget(this);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setSpacing(0);
  row->addWidget(viewport_, 1);
  row->addWidget(layers_);
  column->addLayout(row, 1);
  column->addWidget(timeline_);
  centre_ = new QStackedWidget(this);
  centre_->addWidget(centre);
  setCentralWidget(centre_);
}

QScrollArea* MainWindow::scrolled(QWidget* content) {
  auto* area = new QScrollArea(this);
  area->setObjectName(kPageArea);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(content);
  return area;
}

void MainWindow::buildPages() {
  placement_ = new panels::PlacementPanel(this);
  placement_->setObjectName("placement");
  mesh_ = new panels::MeshPanel(this);
  choices_ = new forms::ChoicesForm(this);
  choices_->setObjectName("choices");
  parameters_ = new forms::ParameterForm(pipeline::allParameters(), this);
  parameters_->setObjectName("parameters");
  parameters_->setHeader(choices_);
  auto* part = new QWidget(this);
  auto* partColumn = new QVBoxLayout(part);
  partColumn->setContentsMargins(0, 0, 0, 0);
  partColumn->addWidget(placement_);
  partColumn->addWidget(mesh_);
  partColumn->addStretch(1);
  prepareTabs_ = new QTabWidget(this);
  prepareTabs_->setObjectName("prepareTabs");
  prepareTabs_->setDocumentMode(true);
  prepareTabs_->addTab(parameters_, QString());
  prepareTabs_->addTab(scrolled(part), QString());

  options_ = new ViewOptions(this);
  options_->setObjectName("viewOptions");
  layerInfo_ = new panels::LayerInfo(this);
  auto* layerPage = new QWidget(this);
  auto* layerColumn = new QVBoxLayout(layerPage);
  layerColumn->setContentsMargins(0, 0, 0, 0);
  layerColumn->addWidget(options_);
  piecesPanel_ = new panels::PiecesPanel(this);
  piecesPanel_->setObjectName("pieces");
  layerColumn->addWidget(piecesPanel_);
  layerColumn->addWidget(layerInfo_);
  spacing_ = new SpacingView(this);
  layerColumn->addWidget(spacing_);
  layerColumn->addStretch(1);

  plots_ = new timeline::JointPlots(this);
  plots_->setObjectName("plots");
  export_ = new panels::ExportPanel(this);
  export_->setObjectName("export");
  export_->setFolder(QSettings().value("export/folder").toString());

  pages_ = new QStackedWidget(this);
  pages_->addWidget(prepareTabs_);
  pages_->addWidget(scrolled(layerPage));
  QScrollArea* plots = scrolled(plots_);
  plots->setObjectName("plotsArea"); // may be tight: it is scrolled
  pages_->addWidget(plots);
  pages_->addWidget(scrolled(export_));
  buildCompare();
}

void MainWindow::buildDocks() {
  const auto dock = [this](const char* name, QWidget* content, Qt::DockWidgetArea area) {
    auto* made = new QDockWidget(this);
    made->setObjectName(name);
    made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
    made->setWidget(content);
    addDockWidget(area, made);
    return made;
  };
  tree_ = new panels::ObjectTree(this);
  tree_->setObjectName("tree");
  findings_ = new panels::FindingsPanel(this);
  findings_->setObjectName("findings");
  partDock_ = dock("partDock", tree_, Qt::LeftDockWidgetArea);
  findingsDock_ = dock("findingsDock", findings_, Qt::LeftDockWidgetArea);
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(pages_, 1);
  summary_ = new QLabel(page);
  summary_->setObjectName("summary");
  summary_->setWordWrap(true);
  summary_->setContentsMargins(10, 6, 10, 6);
  column->addWidget(summary_);
  pageDock_ = dock("pageDock", page, Qt::RightDockWidgetArea);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  buildUnrolled();
  resizeDocks({partDock_, pageDock_}, {kTreeWidth, kPanelWidth}, Qt::Horizontal);
  resizeDocks({partDock_, findingsDock_}, {200, 400}, Qt::Vertical);
}

void MainWindow::setPage(Page page) {
  lookingAtMissed_ = false;
  flow_->setPage(page);
  pages_->setCurrentIndex(static_cast<int>(page));
  centre_->setCurrentIndex(page == Page::Compare ? 1 : 0);
  layers_->setVisible(page == Page::Layers);
  timeline_->setVisible(page != Page::Prepare && page != Page::Compare);
  timeline_->setMode(page == Page::Layers ? timeline::BarMode::Moves : timeline::BarMode::Time);
  if (page != Page::Prepare)
    setTool(viewer::Tool::None);
  tools_->setEnabled(page == Page::Prepare && document_.source());
  pageDock_->setWindowTitle(pageName(page));
  showMoves();
  showView();
  const bool inCell = page == Page::Simulate || page == Page::Export;
  if (inCell != framedInCell_) {
    framedInCell_ = inCell;
    viewport_->frameAll();
  }
  showExport();
}

void MainWindow::showLists() {
  const forms::ChoiceLists lists = choiceLists();
  choices_->setLists(lists);
  compare_->setLists(lists.modes, lists.growths);
}

void MainWindow::retranslate() {
  setLocale(QLocale()); // of the language: widgets keep the one that they were made with
  showLists();
  partDock_->setWindowTitle(tr("Part and cell"));
  findingsDock_->setWindowTitle(tr("Findings"));
  pageDock_->setWindowTitle(pageName(flow_->page()));
  unrolledDock_->setWindowTitle(tr("Unrolled layer"));
  prepareTabs_->setTabText(0, tr("Settings"));
  prepareTabs_->setTabText(1, tr("Part"));
  for (const auto& [menu, text] : menus_)
    menu->setTitle(tr(text));
  for (const Command& c : commands_) {
    c.action->setText(tr(c.text));
    const QString keys = c.action->shortcut().toString(QKeySequence::NativeText);
    const QString tip = tr(c.tip);
    c.action->setToolTip(keys.isEmpty() ? tip : QString("%1 (%2)").arg(tip, keys));
  }
  retranslateUndo();
  showStates();
  showChoices();
  showExport();
  showView();
  // Longer words get room, where there is some; the layouts know of them only later.
  QTimer::singleShot(0, this, [this] {
    if (const int wide = std::min(neededWidth(*pages_), width() / kMostPanelShare);
        wide > pageDock_->width())
      resizeDocks({pageDock_}, {wide}, Qt::Horizontal);
  });
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && flow_)
    retranslate();
  if (event->type() == QEvent::PaletteChange && flow_)
    redrawIcons();
  QMainWindow::changeEvent(event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!closing_ && document_.dirty()) {
    event->ignore();
    afterSaved([this] {
      closing_ = true;
      close();
    });
    return;
  }
  planning_.cancel();
  live_.cancel();
  comparing_.cancel();
  opening_.cancel();
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  settings.setValue("window/state", saveState(kLayoutVersion));
  autosave_.reset();
  QMainWindow::closeEvent(event);
}

} // namespace voluta::window
