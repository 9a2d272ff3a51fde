#include "window/shell_commands.h"

#include "forms/save_file.h"
#include "project/version.h"
#include "timeline/timeline_bar.h"
#include "viewer/viewport.h"
#include "window/language.h"
#include "window/legend_view.h"
#include "window/picture.h"
#include "window/picture_area.h"
#include "window/unrolled/unrolled_dock.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QSettings>
#include <QUndoStack>

namespace voluta::window {

namespace {
constexpr const char* kLegend = "view/legend";

QString translated(const char* text) {
  return QCoreApplication::translate("Commands", text);
}

// The command applies while the picture area is visible; another page replaces it.
std::function<bool()> whereShown(const PictureArea& area) {
  return [&area] { return !area.isHidden(); };
}

std::vector<Command> sideCommands(PictureArea& area) {
  struct Side {
    const char *id, *text, *keys;
    Eigen::Vector3d from;
  };
  static const Side kSides[] = {
      {"viewFront", QT_TRANSLATE_NOOP("Commands", "&Front"), "1", {0, -1, 0}},
      {"viewBack", QT_TRANSLATE_NOOP("Commands", "&Back"), "Ctrl+1", {0, 1, 0}},
      {"viewRight", QT_TRANSLATE_NOOP("Commands", "&Right"), "3", {1, 0, 0}},
      {"viewLeft", QT_TRANSLATE_NOOP("Commands", "&Left"), "Ctrl+3", {-1, 0, 0}},
      {"viewTop", QT_TRANSLATE_NOOP("Commands", "&Top"), "7", {0, 0, 1}},
      {"viewBottom", QT_TRANSLATE_NOOP("Commands", "B&ottom"), "Ctrl+7", {0, 0, -1}},
      {"viewOblique", QT_TRANSLATE_NOOP("Commands", "&Oblique"), "0", {0.55, -0.7, 0.45}},
  };
  std::vector<Command> commands;
  for (const Side& side : kSides)
    commands.push_back({side.id,
                        "viewMenu",
                        0,
                        side.text,
                        QT_TRANSLATE_NOOP("Commands", "View from this side"),
                        {QKeySequence(side.keys)},
                        [&area, from = side.from] { area.viewport().viewFrom(from); },
                        whereShown(area)});
  return commands;
}
} // namespace

const std::vector<CommandMenu>& commandMenus() {
  static const std::vector<CommandMenu> kMenus{
      {"fileMenu", QT_TRANSLATE_NOOP("Commands", "&File")},
      {"editMenu", QT_TRANSLATE_NOOP("Commands", "&Edit")},
      {"viewMenu", QT_TRANSLATE_NOOP("Commands", "&View")},
      {"runMenu", QT_TRANSLATE_NOOP("Commands", "&Run")},
      {"exportMenu", QT_TRANSLATE_NOOP("Commands", "E&xport")},
      {"windowMenu", QT_TRANSLATE_NOOP("Commands", "&Window")},
      {"helpMenu", QT_TRANSLATE_NOOP("Commands", "&Help")},
      {"recentMenu", QT_TRANSLATE_NOOP("Commands", "Open &recent"), "fileMenu", 0},
      {"samplesMenu", QT_TRANSLATE_NOOP("Commands", "Sa&mples"), "fileMenu", 0},
      {"lookMenu", QT_TRANSLATE_NOOP("Commands", "Loo&k"), "viewMenu", 2},
      {"languageMenu", QT_TRANSLATE_NOOP("Commands", "&Language"), "viewMenu", 2},
  };
  return kMenus;
}

std::vector<Command> undoCommands(QUndoStack& edits) {
  const auto says = [](bool can, const char* one, const char* none, const QString& edit) {
    return can ? translated(one).arg(edit) : translated(none);
  };
  return {
      {"undo",
       "editMenu",
       0,
       nullptr,
       nullptr,
       {QKeySequence::Undo},
       [&edits] { edits.undo(); },
       [&edits] { return edits.canUndo(); },
       {},
       "undo",
       BarGroup::Undo,
       [&edits, says] {
         return says(edits.canUndo(), QT_TRANSLATE_NOOP("Commands", "Undo %1"),
                     QT_TRANSLATE_NOOP("Commands", "Undo"), edits.undoText());
       }},
      {"redo",
       "editMenu",
       0,
       nullptr,
       nullptr,
       {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")},
       [&edits] { edits.redo(); },
       [&edits] { return edits.canRedo(); },
       {},
       "redo",
       BarGroup::Undo,
       [&edits, says] {
         return says(edits.canRedo(), QT_TRANSLATE_NOOP("Commands", "Redo %1"),
                     QT_TRANSLATE_NOOP("Commands", "Redo"), edits.redoText());
       }},
  };
}

std::vector<Command> viewCommands(PictureArea& area, Picture& picture, UnrolledDock& unrolled,
                                  const std::function<void()>& showView) {
  LegendView& legend = area.legend();
  legend.setWanted(QSettings().value(kLegend, true).toBool());
  std::vector<Command> commands{{"frameAll",
                                 "viewMenu",
                                 0,
                                 QT_TRANSLATE_NOOP("Commands", "Show &everything"),
                                 QT_TRANSLATE_NOOP("Commands", "Fit everything into the view"),
                                 {QKeySequence("Home")},
                                 [&area] { area.viewport().frameAll(); },
                                 whereShown(area),
                                 {},
                                 "frame",
                                 BarGroup::View}};
  commands.push_back({"framePart",
                      "viewMenu",
                      0,
                      QT_TRANSLATE_NOOP("Commands", "Show the &part"),
                      QT_TRANSLATE_NOOP("Commands", "Fit the selected part into the view"),
                      {QKeySequence("Z")},
                      [&area] { area.viewport().framePart(); },
                      whereShown(area),
                      {},
                      "frame-part",
                      BarGroup::View});
  for (Command& side : sideCommands(area))
    commands.push_back(std::move(side));
  commands.push_back({"toggleSection",
                      "viewMenu",
                      1,
                      QT_TRANSLATE_NOOP("Commands", "&Section plane"),
                      QT_TRANSLATE_NOOP("Commands", "Cut the view open with a plane"),
                      {QKeySequence("X")},
                      [&picture] {
                        Look look = picture.look();
                        look.section = !look.section;
                        picture.setLook(look);
                      },
                      whereShown(area),
                      {},
                      "section",
                      BarGroup::View});
  commands.push_back(
      {"showArm",
       "viewMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "Show the &arm"),
       QT_TRANSLATE_NOOP("Commands", "On the Prepare page, shows the arm whole instead "
                                     "of dimmed behind the part"),
       {QKeySequence("A")},
       [&picture, &area] {
         Look look = picture.look();
         look.arm = !look.arm;
         picture.setLook(look);
         if (!area.viewport().isCameraTheUsers())
           area.viewport().frameAll();
       },
       whereShown(area),
       [&picture] { return picture.look().arm; },
       "arm",
       BarGroup::View});
  commands.push_back({"toggleLegend",
                      "viewMenu",
                      1,
                      QT_TRANSLATE_NOOP("Commands", "&Legend"),
                      QT_TRANSLATE_NOOP("Commands", "Meaning of the colours in the view"),
                      {QKeySequence("L")},
                      [&legend] {
                        legend.setWanted(!legend.isWanted());
                        QSettings().setValue(kLegend, legend.isWanted());
                      },
                      {},
                      [&legend] { return legend.isWanted(); }});
  commands.push_back({"ambientOcclusion",
                      "viewMenu",
                      1,
                      QT_TRANSLATE_NOOP("Commands", "Darken cor&ners"),
                      QT_TRANSLATE_NOOP("Commands", "Darkens corners and gaps, so that shapes are "
                                                    "clearer; slow without a graphics card"),
                      {},
                      [&area] { area.darkenCorners(!area.viewport().hasAmbientOcclusion()); },
                      {},
                      [&area] { return area.viewport().hasAmbientOcclusion(); }});
  commands.push_back(
      {"toggleUnrolled",
       "viewMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "&Unrolled layer"),
       QT_TRANSLATE_NOOP("Commands", "Shows layers around an axis unrolled, next to the view"),
       {QKeySequence("U")},
       [&unrolled, showView] {
         unrolled.setWanted(!unrolled.wanted());
         showView();
       },
       [&unrolled] { return unrolled.offered(); },
       [&unrolled] { return unrolled.wanted(); }});
  return commands;
}

std::vector<Command> timelineCommands(timeline::TimelineBar& bar) {
  const auto shown = [&bar] { return !bar.isHidden(); };
  return {
      {"play",
       "runMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "Play or pause"),
       QT_TRANSLATE_NOOP("Commands", "Play or pause the time-line"),
       {QKeySequence("Space")},
       [&bar] { bar.togglePlay(); },
       shown},
      {"nextMove",
       "runMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "Next move"),
       QT_TRANSLATE_NOOP("Commands", "One move forward"),
       {QKeySequence(".")},
       [&bar] { bar.nextMove(); },
       shown},
      {"previousMove",
       "runMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "Previous move"),
       QT_TRANSLATE_NOOP("Commands", "One move back"),
       {QKeySequence(",")},
       [&bar] { bar.previousMove(); },
       shown},
      {"nextLayer",
       "runMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "Next layer"),
       QT_TRANSLATE_NOOP("Commands", "One layer forward"),
       {QKeySequence("PgUp")},
       [&bar] { bar.nextLayer(); },
       shown},
      {"previousLayer",
       "runMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "Previous layer"),
       QT_TRANSLATE_NOOP("Commands", "One layer back"),
       {QKeySequence("PgDown")},
       [&bar] { bar.previousLayer(); },
       shown},
  };
}

std::vector<Command> languageCommands() {
  std::vector<Command> commands;
  for (const Language& language : languagesThere()) {
    Command command{"language_" + language.code, "languageMenu"};
    command.does = [code = language.code] {
      QSettings().setValue("window/language", code);
      chooseLanguage(code);
    };
    command.checked = [code = language.code] { return code == chosenLanguage(); };
    command.says = [name = language.name] { return name; }; // In that language, not translated
    commands.push_back(std::move(command));
  }
  return commands;
}

void savePicture(PictureArea& area, const QString& name,
                 const std::function<void(const QString&)>& failed) {
  const QString file =
      forms::saveFile(&area, translated(QT_TRANSLATE_NOOP("Commands", "Save the picture")),
                      name + ".png", translated(QT_TRANSLATE_NOOP("Commands", "Pictures (*.png)")));
  if (file.isEmpty())
    return;
  if (!area.viewport().grabFrame().save(file, "PNG"))
    failed(file);
}

void showAbout(QWidget& window) {
  QMessageBox::about(
      &window, translated(QT_TRANSLATE_NOOP("Commands", "About Voluta")),
      translated(
          QT_TRANSLATE_NOOP("Commands",
                            "<h3>Voluta %1</h3><p>3D printing with robot arms: layers without "
                            "support, tool-paths, motion checked against the growing part, and "
                            "programs verified by replay.</p><p>Free software under the GNU "
                            "General Public License, version 3 or later.</p>"))
          .arg(project::kVersion));
}

} // namespace voluta::window
