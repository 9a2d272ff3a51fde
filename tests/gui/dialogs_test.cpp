// Every dialog is whole on the screen: its content fits or scrolls, its buttons are in sight. Run
// on several screens (CMakeLists.txt).
#include "base/files.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "pipeline/stage_options.h"
#include "process/library.h"
#include "process/process.h"
#include "project/station.h"
#include "robot/cell_draft.h"
#include "window/cell/arm_import_dialog.h"
#include "window/cell/cell_editor.h"
#include "window/cell/measure_dialog.h"
#include "window/cell/touch_dialog.h"
#include "window/copies_dialog.h"
#include "window/film/film_dialog.h"
#include "window/layer_event_dialog.h"
#include "window/library/compare_items_dialog.h"
#include "window/library/head_numbers_dialog.h"
#include "window/library/library_dialog.h"
#include "window/library/sizes_dialog.h"
#include "window/log_dialog.h"
#include "window/manual/manual_window.h"
#include "window/milling/mill_dialog.h"
#include "window/mnemonics.h"
#include "window/palette/command_palette.h"
#include "window/presets/compare_presets_dialog.h"
#include "window/presets/preset_name_dialog.h"
#include "window/quote/quote_dialog.h"
#include "window/run_dialog.h"
#include "window/shortcuts_dialog.h"
#include "window/together/together_dialog.h"
#include "window/verify_dialog.h"

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QScreen>
#include <QScrollArea>
#include <QTest>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <string>

namespace voluta::test {
namespace {

using project::Stage;

class DialogsTest : public WindowTest {
protected:
  using Makers = std::map<std::string, std::function<QDialog*(QWidget*)>>;
  // By class, one for each that the window can open.
  Makers makers() {
    const process::Process process = process::loadProcess("fdm-1.0");
    const std::shared_ptr<const pipeline::PlanResult> plan = document().lastResult();
    const QString missing = path("missing.script");
    const auto part = std::make_shared<const geometry::TriangleMesh>(box({0, 0, 0}, {20, 20, 6}));
    const auto item = [](const char* id) {
      return process::loadItem(process::Shelf::Processes, id);
    };
    return {
        {"LibraryDialog",
         [](QWidget* w) {
           return new window::LibraryDialog("fdm-1.0", process::Shelf::Processes, w);
         }},
        {"HeadNumbersDialog",
         [process](QWidget* w) { return new window::HeadNumbersDialog(process, w); }},
        {"SizesDialog", [process](QWidget* w) { return new window::SizesDialog(process, w); }},
        {"CompareItemsDialog",
         [item](QWidget* w) {
           return new window::CompareItemsDialog({item("fdm-1.0"), item("pellet-4")}, 0, 1, w);
         }},
        {"TogetherDialog", [](QWidget* w) { return new window::TogetherDialog({}, w); }},
        {"LayerEventDialog", [](QWidget* w) { return new window::LayerEventDialog(3, 2, w); }},
        {"ManualWindow", [](QWidget* w) { return new window::ManualWindow(w); }},
        {"LogDialog", [this](QWidget* w) { return new window::LogDialog(path("voluta.log"), w); }},
        {"ShortcutsDialog",
         [this](QWidget* w) {
           std::vector<QAction*> actions;
           for (QAction* action : window().findChildren<QAction*>())
             if (action->property("defaultShortcut").isValid())
               actions.push_back(action);
           return new window::ShortcutsDialog(actions, w);
         }},
        {"VerifyDialog", [=](QWidget* w) { return new window::VerifyDialog(missing, plan, w); }},
        {"MillDialog", [=](QWidget* w) { return new window::MillDialog(part, "part", w); }},
        {"CellEditor",
         [process](QWidget* w) {
           return new window::CellEditor(robot::draftOfCell("ur5-fixed"), process, 0.1, w);
         }},
        {"TouchDialog",
         [](QWidget* w) { return new window::TouchDialog(Eigen::Vector2d(0.0, 0.0), w); }},
        {"MeasureDialog",
         [](QWidget* w) {
           return window::MeasureDialog::ofFrame("table", "in the robot's base", w);
         }},
        {"ArmImportDialog",
         [this](QWidget* w) {
           return new window::ArmImportDialog(path("missing.urdf"), folder_.path(), w);
         }},
        {"CommandPalette",
         [](QWidget* w) {
           return new window::CommandPalette({{"Open", "File"}, {"Walls", "Prepare"}}, w);
         }},
        {"QuoteDialog",
         [plan](QWidget* w) { return new window::QuoteDialog(plan, "part", "9 × 9 × 5 mm", w); }},
        {"FilmDialog",
         [plan](QWidget* w) { return new window::FilmDialog(plan, "part", false, w); }},
        {"PresetNameDialog",
         [](QWidget* w) { return new window::PresetNameDialog("Save preset as", "Usual", {}, w); }},
        {"ComparePresetsDialog",
         [](QWidget* w) {
           return new window::ComparePresetsDialog(
               {{"Present settings", {{"walls", "4"}}}, {"Usual", {}}}, pipeline::allParameters(),
               0, 1, w);
         }},
        {"CopiesDialog", [](QWidget* w) { return new window::CopiesDialog(3, w); }},
        {"RunDialog", [=](QWidget* w) { return new window::RunDialog(missing, plan, w); }},
    };
  }
  // Whether the widget scrolls, or is part of one that lays out its own inside.
  static bool isWithinScrolled(const QWidget* widget, const QDialog* dialog) {
    for (const QWidget* at = widget->parentWidget(); at && at != dialog; at = at->parentWidget())
      if (qobject_cast<const QAbstractScrollArea*>(at) || qobject_cast<const QComboBox*>(at))
        return true;
    return false;
  }
  static void expectWhole(QDialog& dialog, const std::string& name) {
    const QRect screen = dialog.screen()->availableGeometry();
    EXPECT_TRUE(screen.contains(dialog.frameGeometry()))
        << name << ": " << dialog.frameGeometry().width() << " x "
        << dialog.frameGeometry().height() << " on " << screen.width() << " x " << screen.height();
    for (const QWidget* widget : dialog.findChildren<QWidget*>()) {
      if (!widget->isVisible() || widget->isWindow() || isWithinScrolled(widget, &dialog))
        continue;
      if (const auto* area = qobject_cast<const QScrollArea*>(widget);
          area && area->widget() && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff) {
        EXPECT_LE(area->widget()->width(), area->viewport()->width())
            << name << ": " << widget->objectName().toStdString() << " is cut off";
      }
      const QRect place(widget->mapTo(&dialog, QPoint(0, 0)), widget->size());
      EXPECT_TRUE(dialog.rect().contains(place))
          << name << ": " << widget->metaObject()->className() << " "
          << widget->objectName().toStdString();
      if (const auto* button = qobject_cast<const QAbstractButton*>(widget);
          button && !button->text().isEmpty()) {
        EXPECT_GE(button->width(), button->minimumSizeHint().width())
            << name << ": " << button->text().toStdString();
      }
    }
  }
};

// Every button with words and every field with a label is reached by Alt and a letter.
void expectMnemonics(const QDialog& dialog) {
  for (const QAbstractButton* button : dialog.findChildren<QAbstractButton*>())
    if (button->isVisible() && !button->text().isEmpty() && button->text() != u"…") {
      EXPECT_FALSE(QKeySequence::mnemonic(button->text()).isEmpty())
          << button->text().toStdString();
    }
  for (const QLabel* label : dialog.findChildren<QLabel*>())
    if (label->isVisible() && label->buddy() && label->buddy()->focusPolicy() != Qt::NoFocus &&
        label->textFormat() != Qt::RichText) {
      EXPECT_FALSE(QKeySequence::mnemonic(label->text()).isEmpty()) << label->text().toStdString();
    }
}

// The widget that Alt and a letter reach: the button itself, or the field of a label.
QWidget* reachedBy(QWidget* widget) {
  const auto* label = qobject_cast<const QLabel*>(widget);
  return label ? label->buddy() : widget;
}

// By letter, those on show in the dialog; of tabs only the current one is.
std::map<char, std::vector<QWidget*>> byMnemonic(const QDialog& dialog) {
  std::map<char, std::vector<QWidget*>> found;
  for (QWidget* widget : dialog.findChildren<QWidget*>()) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const auto* label = qobject_cast<const QLabel*>(widget);
    if (!widget->isVisible() || widget->window() != &dialog || (!button && !label) ||
        (label && (!label->buddy() || label->textFormat() == Qt::RichText)))
      continue;
    const QString text = button ? button->text() : label->text();
    const QString keys = QKeySequence::mnemonic(text).toString();
    if (!keys.isEmpty())
      found[keys.back().toLatin1()].push_back(widget);
  }
  return found;
}

// No letter stands for two, unless there are more widgets than letters, and each that stands for
// one field that can be used gives it the focus.
void expectLettersReach(QDialog& dialog) {
  const auto all = byMnemonic(dialog);
  std::size_t widgets = 0;
  for (const auto& [letter, group] : all)
    widgets += group.size();
  constexpr std::size_t kFew = 18; // a short text may have no free letter beyond
  for (const auto& [letter, group] : all) {
    QStringList texts;
    for (const QWidget* widget : group)
      texts << (qobject_cast<const QLabel*>(widget)
                    ? static_cast<const QLabel*>(widget)->text()
                    : static_cast<const QAbstractButton*>(widget)->text());
    EXPECT_TRUE(group.size() == 1 || widgets > kFew)
        << widgets << ", " << letter << ": " << texts.join(" | ").toStdString();
    QWidget* field = reachedBy(group.front());
    if (group.size() > 1 || !qobject_cast<const QLabel*>(group.front()) || !field->isEnabled() ||
        !field->isVisible())
      continue;
    dialog.setFocus();
    QTest::keyClick(&dialog, letter, Qt::AltModifier);
    const QWidget* focus = dialog.focusWidget();
    EXPECT_TRUE(focus == field || (focus && field->isAncestorOf(focus)) ||
                (field->focusProxy() && focus == field->focusProxy()))
        << letter << ": " << texts.join(" | ").toStdString();
  }
}

TEST_F(DialogsTest, EveryDialogIsWholeOnTheScreen) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {9, 9, 5})));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  window().showMaximized();
  for (const auto& [name, make] : makers()) {
    SCOPED_TRACE(name);
    std::unique_ptr<QDialog> dialog(make(&window()));
    dialog->setAttribute(Qt::WA_DeleteOnClose, false);
    dialog->open();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog.get()));
    QTest::qWait(150);
    expectWhole(*dialog, name);
    keepPicture(*dialog, ("dialog_" + name).c_str());
    EXPECT_FALSE(dialog->windowTitle().isEmpty());
    EXPECT_EQ(withoutName(*dialog).join("\n").toStdString(), "");
    expectMnemonics(*dialog);
    expectLettersReach(*dialog);
    dialog->hide();
  }
}

TEST(Mnemonics, AreDifferentLettersThatBeginWords) {
  QString used;
  EXPECT_EQ(window::withMnemonic("&Close", used), "&Close");
  EXPECT_EQ(window::withMnemonic("Copies", used), "C&opies") << "C is used";
  EXPECT_EQ(window::withMnemonic("Open the cell", used), "Open &the cell");
  EXPECT_EQ(window::withMnemonic("Tc", used), "&Tc") << "shared with another";
  EXPECT_EQ(window::withMnemonic(QStringLiteral("材料"), used), QStringLiteral("材料(&A)"));
}

// A dialog that is added is shown by the test above too.
TEST_F(DialogsTest, NoDialogIsLeftOut) {
  const std::filesystem::path folder = std::filesystem::path(VOLUTA_SOURCE_DIR) / "widgets";
  const std::regex declaration("class (\\w+) : public QDialog");
  std::set<std::string> declared, shown;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".h") {
      const std::string text = base::readFile(entry.path());
      for (std::sregex_iterator at(text.begin(), text.end(), declaration), end; at != end; ++at)
        declared.insert((*at)[1]);
    }
  for (const auto& [name, make] : makers())
    shown.insert(name);
  EXPECT_EQ(declared, shown);
}

TEST_F(DialogsTest, WindowAndDialogsKeepTheirSizes) {
  const QSize room = window().screen()->availableSize();
  const QSize size(room.width() - 60, room.height() - 60);
  window().setWindowState(Qt::WindowNoState);
  window().resize(size);
  QTest::qWait(100);
  const QSize shown = window().size();
  const QSize small(room.width() / 2, room.height() / 2);
  find<QAction>("showLog")->trigger();
  auto* log = find<QDialog>("logDialog");
  log->resize(small);
  QTest::qWait(50);
  const QSize given = log->size();
  log->close();
  window().close();
  openWindow();
  EXPECT_EQ(window().size(), shown);
  find<QAction>("showLog")->trigger();
  EXPECT_EQ(find<QDialog>("logDialog")->size(), given);
}

} // namespace
} // namespace voluta::test
