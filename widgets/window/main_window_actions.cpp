// Menus, tool bar and keys.
#include "forms/parameter_form.h"
#include "panels/placement_panel.h"
#include "project/version.h"
#include "timeline/timeline_bar.h"
#include "window/compare_page.h"
#include "window/icons.h"
#include "window/language.h"
#include "window/legend_view.h"
#include "window/main_window.h"
#include "window/shortcuts_dialog.h"

#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

namespace voluta::window {

using project::Stage;

QAction* MainWindow::command(QMenu* menu, const char* id, const char* text, const char* tip,
                             const QKeySequence& keys, const QString& iconName,
                             std::function<void()> does) {
  auto* action = new QAction(this);
  action->setObjectName(id);
  action->setShortcut(shortcutOf(id, keys));
  action->setProperty("defaultShortcut", keys);
  if (menu)
    menu->addAction(action);
  // Keys that lists, buttons and sliders have a use for belong to the viewport alone; its bars have
  // them too.
  const int key = keys.isEmpty() ? 0 : keys[0].toCombined();
  if (key == Qt::Key_Space || key == Qt::Key_Home || key == Qt::Key_PageUp ||
      key == Qt::Key_PageDown) {
    action->setShortcutContext(Qt::WidgetShortcut);
    viewport_->addAction(action);
  } else {
    addAction(action); // so that its key works while the menu is closed
  }
  connect(action, &QAction::triggered, this, [does = std::move(does)] { does(); });
  commands_.push_back({action, text, tip, iconName});
  return action;
}

void MainWindow::buildMenus() {
  const auto menu = [this](const char* name, const char* text) {
    QMenu* made = menuBar()->addMenu(QString());
    made->setObjectName(name);
    made->setToolTipsVisible(true);
    menus_.emplace_back(made, text);
    return made;
  };

  QMenu* file = menu("fileMenu", QT_TR_NOOP("&File"));
  command(file, "new", QT_TR_NOOP("&New project"), QT_TR_NOOP("Begin without a part"),
          QKeySequence::New, {}, [this] { newProject(); });
  command(file, "open", QT_TR_NOOP("&Open…"), QT_TR_NOOP("Open a mesh or a project"),
          QKeySequence::Open, "open", [this] { chooseFile(); });
  recentMenu_ = file->addMenu(QString());
  recentMenu_->setObjectName("recentMenu");
  menus_.emplace_back(recentMenu_, QT_TR_NOOP("Open &recent"));
  QMenu* samples = file->addMenu(QString());
  samples->setObjectName("samplesMenu");
  menus_.emplace_back(samples, QT_TR_NOOP("Sa&mples"));
  command(samples, "sampleVase", QT_TR_NOOP("Vase"), QT_TR_NOOP("A fluted vase, 60 mm high"), {},
          {}, [this] { open("sample:vase"); });
  file->addSeparator();
  command(file, "save", QT_TR_NOOP("&Save"), QT_TR_NOOP("Save the project"), QKeySequence::Save,
          "save", [this] { save(); });
  command(file, "saveAs", QT_TR_NOOP("Save &as…"), QT_TR_NOOP("Save the project under a name"),
          QKeySequence("Ctrl+Shift+S"), {}, [this] { saveAs(); });
  file->addSeparator();
  command(file, "quit", QT_TR_NOOP("&Quit"), QT_TR_NOOP("Close the window"), QKeySequence("Ctrl+Q"),
          {}, [this] { close(); });

  QMenu* edit = menu("editMenu", QT_TR_NOOP("&Edit"));
  undo_ = new QAction(this);
  undo_->setObjectName("undo");
  undo_->setShortcut(QKeySequence::Undo);
  redo_ = new QAction(this);
  redo_->setObjectName("redo");
  redo_->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
  edit->addActions({undo_, redo_});
  QUndoStack* stack = document_.undoStack();
  connect(undo_, &QAction::triggered, stack, &QUndoStack::undo);
  connect(redo_, &QAction::triggered, stack, &QUndoStack::redo);
  connect(stack, &QUndoStack::indexChanged, this, [this] { retranslateUndo(); });
  edit->addSeparator();
  tools_ = new QActionGroup(this);
  tools_->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
  const auto tool = [&](const char* id, const char* text, const char* tip, const char* keys,
                        const char* iconName, viewer::Tool which) {
    QAction* action = command(edit, id, text, tip, QKeySequence(keys), iconName, [] {});
    action->setCheckable(true);
    action->setData(static_cast<int>(which));
    tools_->addAction(action);
    connect(action, &QAction::toggled, this, [this, which](bool on) {
      if (on)
        setTool(which);
      else if (viewport_->tool() == which)
        setTool(viewer::Tool::None);
    });
  };
  tool("toolMove", QT_TR_NOOP("&Move"), QT_TR_NOOP("Move the part with handles"), "M", "move",
       viewer::Tool::Move);
  tool("toolTurn", QT_TR_NOOP("&Turn"), QT_TR_NOOP("Turn the part with handles"), "R", "turn",
       viewer::Tool::Turn);
  tool("toolScale", QT_TR_NOOP("&Scale"), QT_TR_NOOP("Scale the part with handles"), "S", "scale",
       viewer::Tool::Scale);
  tool("toolLayFlat", QT_TR_NOOP("&Lay on face"), QT_TR_NOOP("Click the face to lie on the plate"),
       "F", "lay-flat", viewer::Tool::LayFlat);
  edit->addSeparator();
  command(edit, "dropToPlate", QT_TR_NOOP("&Drop to plate"),
          QT_TR_NOOP("Lowest point on the plate"), QKeySequence("D"), "drop", [this] {
            geometry::Placement p = placed();
            p.liftMm = 0.0;
            document_.place(p, tr("drop to plate"));
          });
  command(edit, "centrePart", QT_TR_NOOP("&Centre"),
          QT_TR_NOOP("Middle of the part over the plate's"), QKeySequence("C"), "centre", [this] {
            geometry::Placement p = placed();
            p.centreMm.setZero();
            document_.place(p, tr("centre"));
          });
  command(edit, "touchedPoints", QT_TR_NOOP("Place on touched &points…"),
          QT_TR_NOOP("Moves the part to a cylinder found by touching it"), {}, {},
          [this] { placeOnTouchedPoints(); });
  command(edit, "resetParameters", QT_TR_NOOP("Reset all &parameters"),
          QT_TR_NOOP("Every parameter back to its default"), {}, "reset",
          [this] { document_.resetParameters(); });
  edit->addSeparator();
  command(edit, "shortcuts", QT_TR_NOOP("&Keys…"), QT_TR_NOOP("See and change the keys"), {}, {},
          [this] { editShortcuts(); });

  QMenu* view = menu("viewMenu", QT_TR_NOOP("&View"));
  command(view, "frameAll", QT_TR_NOOP("Show &everything"), QT_TR_NOOP("Everything in sight"),
          QKeySequence("Home"), "frame", [this] { viewport_->frameAll(); });
  struct Side {
    const char *id, *text, *keys;
    Eigen::Vector3d from;
  };
  static const Side kSides[] = {
      {"viewFront", QT_TR_NOOP("&Front"), "1", {0, -1, 0}},
      {"viewBack", QT_TR_NOOP("&Back"), "Ctrl+1", {0, 1, 0}},
      {"viewRight", QT_TR_NOOP("&Right"), "3", {1, 0, 0}},
      {"viewLeft", QT_TR_NOOP("&Left"), "Ctrl+3", {-1, 0, 0}},
      {"viewTop", QT_TR_NOOP("&Top"), "7", {0, 0, 1}},
      {"viewBottom", QT_TR_NOOP("B&ottom"), "Ctrl+7", {0, 0, -1}},
      {"viewOblique", QT_TR_NOOP("&Oblique"), "0", {0.55, -0.7, 0.45}},
  };
  for (const Side& side : kSides)
    command(view, side.id, side.text, QT_TR_NOOP("Look from there"), QKeySequence(side.keys), {},
            [this, from = side.from] { viewport_->viewFrom(from); });
  view->addSeparator();
  command(view, "toggleSection", QT_TR_NOOP("&Section plane"), QT_TR_NOOP("Cut the picture open"),
          QKeySequence("X"), "section", [this] {
            ViewChoices choices = options_->choices();
            choices.section = !choices.section;
            options_->setChoices(choices);
            showView();
          });
  QAction* legend =
      command(view, "toggleLegend", QT_TR_NOOP("&Legend"),
              QT_TR_NOOP("What the colours of the picture say"), QKeySequence("L"), {}, [] {});
  legend->setCheckable(true);
  legend->setChecked(QSettings().value("view/legend", true).toBool());
  legend_->setWanted(legend->isChecked());
  connect(legend, &QAction::toggled, this, [this](bool on) {
    QSettings().setValue("view/legend", on);
    legend_->setWanted(on);
  });
  addUnrolledAction(command(view, "toggleUnrolled", QT_TR_NOOP("&Unrolled layer"),
                            QT_TR_NOOP("Layers around an axis laid flat, beside the picture"),
                            QKeySequence("U"), {}, [] {}));
  view->addSeparator();
  QAction* dark = command(
      view, "dark", QT_TR_NOOP("&Dark"), QT_TR_NOOP("Light text on dark ground"), {}, {}, [this] {
        switchAppearance(appearance_ == Appearance::Dark ? Appearance::Light : Appearance::Dark);
      });
  dark->setCheckable(true);
  dark->setChecked(appearance_ == Appearance::Dark);
  QMenu* languages = view->addMenu(QString());
  languages->setObjectName("languageMenu");
  menus_.emplace_back(languages, QT_TR_NOOP("&Language"));
  auto* group = new QActionGroup(this);
  for (const Language& language : languagesThere()) {
    QAction* action = languages->addAction(language.name); // in itself, not translated
    action->setObjectName("language_" + language.code);
    action->setCheckable(true);
    action->setChecked(language.code == chosenLanguage());
    group->addAction(action);
    connect(action, &QAction::triggered, this,
            [this, code = language.code] { switchLanguage(code); });
  }

  QMenu* run = menu("runMenu", QT_TR_NOOP("&Run"));
  plan_ = command(run, "plan", QT_TR_NOOP("&Plan"),
                  QT_TR_NOOP("From the part to checked robot programs"), QKeySequence("Ctrl+R"),
                  "plan", [this] { plan(); });
  command(run, "planLayers", QT_TR_NOOP("Plan as far as the &layers"),
          QT_TR_NOOP("Stops before tool-paths and motion"), QKeySequence("Ctrl+L"), {}, [this] {
            setPage(Page::Layers);
            planning_.plan(Stage::Layers);
          });
  cancel_ = command(run, "cancel", QT_TR_NOOP("&Cancel"),
                    QT_TR_NOOP("Stop; the last results stay on show"), QKeySequence("Ctrl+."),
                    "cancel", [this] { cancel(); });
  QAction* live = command(
      run, "livePreview", QT_TR_NOOP("&Update voxels while editing"),
      QT_TR_NOOP("Once planned, voxels follow the settings; layers and paths wait for Plan"), {},
      {}, [] {});
  live->setCheckable(true);
  live->setChecked(live_.enabled());
  connect(live, &QAction::toggled, this, &MainWindow::setLivePreview);
  run->addSeparator();
  command(run, "play", QT_TR_NOOP("Play or pause"), QT_TR_NOOP("Runs the time-line"),
          QKeySequence("Space"), {}, [this] { timeline_->togglePlay(); });
  command(run, "nextMove", QT_TR_NOOP("Next move"), QT_TR_NOOP("One move on"), QKeySequence("."),
          {}, [this] { timeline_->nextMove(); });
  command(run, "previousMove", QT_TR_NOOP("Previous move"), QT_TR_NOOP("One move back"),
          QKeySequence(","), {}, [this] { timeline_->previousMove(); });
  command(run, "nextLayer", QT_TR_NOOP("Next layer"), QT_TR_NOOP("One layer on"),
          QKeySequence("PgUp"), {}, [this] { timeline_->nextLayer(); });
  command(run, "previousLayer", QT_TR_NOOP("Previous layer"), QT_TR_NOOP("One layer back"),
          QKeySequence("PgDown"), {}, [this] { timeline_->previousLayer(); });

  QMenu* exportMenu = menu("exportMenu", QT_TR_NOOP("E&xport"));
  command(exportMenu, "exportPrograms", QT_TR_NOOP("Robot &programs…"),
          QT_TR_NOOP("Write the chosen programs into a folder"), QKeySequence("Ctrl+E"), "export",
          [this] { setPage(Page::Export); });
  command(exportMenu, "exportPicture", QT_TR_NOOP("P&icture…"),
          QT_TR_NOOP("Save the viewport as a PNG"), {}, {}, [this] { chooseExportedFile(); });

  QMenu* window = menu("windowMenu", QT_TR_NOOP("&Window"));
  static const std::pair<const char*, Page> kPages[] = {{QT_TR_NOOP("&Prepare"), Page::Prepare},
                                                        {QT_TR_NOOP("&Layers"), Page::Layers},
                                                        {QT_TR_NOOP("&Simulate"), Page::Simulate},
                                                        {QT_TR_NOOP("&Export"), Page::Export},
                                                        {QT_TR_NOOP("&Compare"), Page::Compare}};
  for (const auto& [text, page] : kPages)
    command(window, ("page" + std::to_string(static_cast<int>(page))).c_str(), text,
            QT_TR_NOOP("Go to this page"),
            QKeySequence(QString("F%1").arg(5 + static_cast<int>(page))), {},
            [this, page = page] { setPage(page); });
  window->addSeparator();
  for (QDockWidget* dock : {partDock_, findingsDock_, pageDock_})
    window->addAction(dock->toggleViewAction());
  command(window, "fullScreen", QT_TR_NOOP("&Full screen"), QT_TR_NOOP("The whole screen"),
          QKeySequence("F11"), {},
          [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });

  QMenu* help = menu("helpMenu", QT_TR_NOOP("&Help"));
  command(help, "helpKeys", QT_TR_NOOP("&Keys"), QT_TR_NOOP("All keys at a glance"),
          QKeySequence("F1"), {}, [this] { editShortcuts(); });
  command(help, "about", QT_TR_NOOP("&About Voluta"), QT_TR_NOOP("Version and licence"), {}, {},
          [this] { showAbout(); });

  connect(&recent_, &document::RecentFiles::changed, this, &MainWindow::showRecent);
  showRecent();
}

void MainWindow::buildToolBar() {
  auto* bar = new QToolBar(this);
  bar->setObjectName("toolBar");
  bar->setMovable(false);
  bar->setIconSize({20, 20});
  addToolBar(bar);
  const auto action = [this](const char* id) { return findChild<QAction*>(id); };
  bar->addAction(action("open"));
  bar->addAction(action("save"));
  bar->addSeparator();
  bar->addAction(undo_);
  bar->addAction(redo_);
  bar->addSeparator();
  for (QAction* tool : tools_->actions())
    bar->addAction(tool);
  const auto space = [&] {
    auto* filler = new QWidget(bar);
    filler->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(filler);
  };
  space();
  flow_ = new FlowBar(bar);
  bar->addWidget(flow_);
  space();
  bar->addAction(action("frameAll"));
  bar->addAction(action("toggleSection"));
  bar->addSeparator();
  bar->addAction(plan_);
  bar->addAction(cancel_);
  for (QAction* wide : {plan_, cancel_})
    if (auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(wide)))
      button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setContextMenuPolicy(Qt::NoContextMenu); // a tool bar hidden by mistake is hard to find again
  redrawIcons();
}

void MainWindow::redrawIcons() {
  for (const Command& c : commands_)
    if (!c.icon.isEmpty())
      c.action->setIcon(icon(c.icon, palette()));
  undo_->setIcon(icon("undo", palette()));
  redo_->setIcon(icon("redo", palette()));
}

void MainWindow::retranslateUndo() {
  const QUndoStack* stack = document_.undoStack();
  undo_->setEnabled(stack->canUndo());
  redo_->setEnabled(stack->canRedo());
  undo_->setText(stack->canUndo() ? tr("Undo %1").arg(stack->undoText()) : tr("Undo"));
  redo_->setText(stack->canRedo() ? tr("Redo %1").arg(stack->redoText()) : tr("Redo"));
}

void MainWindow::showRecent() {
  recentMenu_->clear();
  for (const QString& file : recent_.files()) {
    QString shown = QFileInfo(file).fileName();
    shown.replace('&', "&&");
    QAction* action = recentMenu_->addAction(shown);
    action->setToolTip(file);
    connect(action, &QAction::triggered, this, [this, file] {
      if (recent_.check(file))
        open(file);
    });
  }
  recentMenu_->setEnabled(!recentMenu_->isEmpty());
}

void MainWindow::chooseFile() {
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open"), QSettings().value("open/folder").toString(),
                                   tr("Parts and projects (*.stl *.obj *.ply *.off *.3mf *.txt "
                                      "*.voxels *.voluta);;All files (*)"));
  if (file.isEmpty())
    return;
  QSettings().setValue("open/folder", QFileInfo(file).absolutePath());
  open(file);
}

void MainWindow::chooseExportedFile() {
  QString file = QFileDialog::getSaveFileName(this, tr("Save the picture"),
                                              document_.name() + ".png", tr("Pictures (*.png)"));
  if (file.isEmpty())
    return;
  if (QFileInfo(file).suffix().isEmpty())
    file += ".png";
  if (!viewport_->grabFrame().save(file, "PNG"))
    tell(tr("Save the picture"), tr("%1 cannot be written. Choose another folder.").arg(file));
}

void MainWindow::newProject() {
  afterSaved([this] {
    planning_.cancel();
    opening_.cancel();
    document_.clear();
    setPage(Page::Prepare);
  });
}

void MainWindow::save() {
  if (document_.projectFile().isEmpty())
    saveAs();
  else
    saving_.save();
}

void MainWindow::saveAs() {
  QSettings settings;
  const QString folder = settings.value("save/folder").toString();
  const QString file = QFileDialog::getSaveFileName(this, tr("Save the project"),
                                                    (folder.isEmpty() ? QString() : folder + '/') +
                                                        document_.name() + ".voluta",
                                                    tr("Voluta projects (*.voluta)"));
  if (file.isEmpty()) {
    afterSave_ = nullptr;
    return;
  }
  settings.setValue("save/folder", QFileInfo(file).absolutePath());
  saving_.saveAs(file);
}

void MainWindow::editShortcuts() {
  std::vector<QAction*> actions;
  for (const Command& c : commands_)
    actions.push_back(c.action);
  ShortcutsDialog dialog(actions, this);
  if (dialog.exec() == QDialog::Accepted)
    retranslate();
}

void MainWindow::showAbout() {
  QMessageBox::about(
      this, tr("About Voluta"),
      tr("<h3>Voluta %1</h3><p>Prints with a robot arm: layers without support, tool-paths, a "
         "motion checked against the part as it grows, and programs that were read back and "
         "replayed.</p><p>Free software under the GNU General Public License, version 3 or "
         "later.</p>")
          .arg(project::kVersion));
}

void MainWindow::switchAppearance(Appearance appearance) {
  appearance_ = appearance;
  applyAppearance(*qobject_cast<QApplication*>(QCoreApplication::instance()), appearance);
  viewport_->scene().setTheme(appearance == Appearance::Dark ? scene::darkTheme()
                                                             : scene::lightTheme());
  compare_->setDark(appearance == Appearance::Dark);
  viewport_->requestFrame();
  QSettings().setValue("window/appearance", appearanceName(appearance));
}

void MainWindow::switchLanguage(const QString& code) {
  QSettings().setValue("window/language", code);
  chooseLanguage(code);
}

} // namespace voluta::window
