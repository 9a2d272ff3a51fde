// Presets of printing on the Prepare page: chosen, changed, saved, compared, exported, imported and
// deleted, by hand.
#include "base/files.h"
#include "forms/parameter_row.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "pipeline/presets/chosen_preset.h"
#include "pipeline/stage_options.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <functional>

namespace voluta::test {
namespace {

using project::Stage;

class PresetsTest : public WindowTest {
protected:
  void openFlat(const QString& name = "plinth.stl") {
    openPart(writePart(name, box({0, 0, 0}, {20, 20, 6})));
    chooseFlat();
    ASSERT_TRUE(waitFor([&] {
      return document().upToDate(Stage::Load) && !window().planning().running() &&
             !window().presenter().busy();
    }));
  }
  QComboBox* combo() { return find<QComboBox>("preset"); }
  QString shown() { return combo()->currentText(); }
  QStringList listed() {
    QStringList all;
    for (int i = 0; i < combo()->count(); ++i)
      all << combo()->itemText(i);
    return all;
  }
  forms::ParameterRow* row(const char* key) { return find<forms::ParameterRow>(key); }
  bool isMarked(const char* key) {
    return row(key)->findChild<QLabel*>()->text().contains(QChar(0x2022)); // the dot
  }
  std::string value(const char* key) {
    return base::formatParameter(pipeline::parameterValues(document().choices()).table().find(key)
                                     ? row(key)->value()
                                     : base::ParameterValue());
  }
  // Opens the list by a click and takes an entry with Enter.
  void choose(const QString& label) {
    QTest::mouseClick(combo(), Qt::LeftButton);
    QAbstractItemView* view = combo()->view();
    ASSERT_TRUE(waitFor([&] { return view->isVisible(); }, 5000));
    const int at = combo()->findText(label);
    ASSERT_GE(at, 0) << label.toStdString() << " of " << listed().join(", ").toStdString();
    view->setCurrentIndex(combo()->model()->index(at, 0));
    QTest::keyClick(view, Qt::Key_Return);
    QTest::qWait(20); // it is chosen after the list's own signal
  }
  void type(const char* key, const QString& text, bool enter = true) {
    auto* box = row(key)->findChild<QAbstractSpinBox*>("editor");
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
    if (enter)
      QTest::keyClick(box, Qt::Key_Return);
  }
  // Clicks an entry of the preset's menu.
  void ask(const char* action) {
    auto* menu = find<QMenu>("presetMenu");
    auto* entry = menu->findChild<QAction*>(action);
    ASSERT_NE(entry, nullptr) << action;
    ASSERT_TRUE(entry->isEnabled()) << action;
    QTest::mouseClick(find<QToolButton>("presetMenuButton"), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return menu->isVisible(); }, 5000));
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
  }
  bool canAsk(const char* action) {
    return find<QMenu>("presetMenu")->findChild<QAction*>(action)->isEnabled();
  }
  // Works the dialog of that name once it is up.
  void inDialog(const char* name, const std::function<void(QDialog&)>& work) {
    auto* timer = new QTimer(&window());
    QObject::connect(timer, &QTimer::timeout, timer, [timer, name, work] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (!dialog || dialog->objectName() != name || !dialog->isVisible())
        return;
      timer->stop();
      timer->deleteLater();
      dialog->activateWindow(); // there may be no window manager to do it
      const QPointer<QDialog> worked = dialog;
      work(*dialog);
      if (worked && worked->isVisible())
        worked->reject(); // a test that has failed goes on
    });
    timer->start(30);
  }
  void saveAs(const QString& name) {
    inDialog("presetName", [name](QDialog& dialog) {
      auto* field = dialog.findChild<QLineEdit*>("presetNameField");
      field->selectAll();
      QTest::keyClicks(field, name);
      auto* accept = dialog.findChild<QPushButton*>("presetNameAccept");
      ASSERT_TRUE(accept->isEnabled());
      QTest::keyClick(field, Qt::Key_Return);
    });
    ask("savePresetAs");
  }
  void saveProject(const QString& name) {
    answerFileDialog(path(name));
    clickMenu("fileMenu", "saveAs");
    EXPECT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
  }
  QString presetFile(const QString& id) const { return path("presets/" + id + ".json"); }
};

TEST_F(PresetsTest, AChosenPresetSetsItsSettingsAndIsUndone) {
  openFlat();
  EXPECT_EQ(shown(), "Usual");
  choose("Strong");
  EXPECT_EQ(shown(), "Strong");
  EXPECT_EQ(value("walls"), "4");
  EXPECT_EQ(value("seam"), "spread");
  EXPECT_FALSE(isMarked("walls")) << "it is as the preset has it";
  EXPECT_EQ(pipeline::givenParameters(document().choices()).at("walls"), "4");
  keepPicture(window(), "presets_strong");
  document().undoStack()->undo();
  EXPECT_EQ(shown(), "Usual");
  EXPECT_EQ(value("walls"), "2");
  document().undoStack()->redo();
  EXPECT_EQ(shown(), "Strong");
}

TEST_F(PresetsTest, TheListIsATree) {
  openFlat();
  EXPECT_EQ(listed(), (QStringList{"With the program", "Usual", "Light", "Fast draft",
                                   "Spiral vase", "Strong"}));
  EXPECT_FALSE(combo()->model()->flags(combo()->model()->index(0, 0)).testFlag(Qt::ItemIsEnabled));
  choose("Fast draft");
  saveAs("Quick");
  EXPECT_EQ(shown(), "Quick");
  saveAs("Quicker");
  EXPECT_EQ(listed().mid(6), (QStringList{"Your own", "Quick", "Quicker"}));
  QTest::mouseClick(combo(), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return combo()->view()->isVisible(); }, 5000));
  keepPicture(*combo()->view()->window(), "presets_list");
  combo()->hidePopup();
}

TEST_F(PresetsTest, ChangesAreMarkedAgainstThePreset) {
  openFlat();
  choose("Strong");
  type("walls", "5");
  EXPECT_EQ(shown(), "Strong (changed)");
  EXPECT_TRUE(combo()->font().bold());
  EXPECT_TRUE(isMarked("walls"));
  EXPECT_FALSE(isMarked("brimWidthMm"));
  keepPicture(window(), "presets_changed");
  // The arrow beside the field goes back to the preset, not to the program's default.
  QTest::mouseClick(row("walls")->findChild<QToolButton*>("reset"), Qt::LeftButton);
  EXPECT_EQ(value("walls"), "4");
  EXPECT_EQ(pipeline::givenParameters(document().choices()).at("walls"), "4");
  EXPECT_EQ(shown(), "Strong");
  // The program's default differs from the preset as any other value.
  type("walls", "2");
  EXPECT_EQ(shown(), "Strong (changed)");
  EXPECT_EQ(value("walls"), "2");
  type("walls", "4");
  EXPECT_EQ(shown(), "Strong");
  // A half-typed number does not count yet.
  type("walls", "7", false);
  EXPECT_EQ(shown(), "Strong");
  type("walls", "7");
  ask("discardPresetChanges");
  EXPECT_EQ(shown(), "Strong");
  EXPECT_EQ(value("walls"), "4");
  EXPECT_FALSE(canAsk("discardPresetChanges"));
  // So does the button above all settings.
  type("walls", "7");
  QTest::mouseClick(find<QToolButton>("resetAll"), Qt::LeftButton);
  EXPECT_EQ(shown(), "Strong");
  EXPECT_EQ(value("walls"), "4");
}

TEST_F(PresetsTest, AnotherPresetTakesOrDropsTheChangesOrIsNotChosen) {
  openFlat();
  choose("Strong");
  type("brimWidthMm", "5");
  answerBox("presetChanges", QMessageBox::RejectRole);
  choose("Light");
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 1; }, 5000));
  EXPECT_EQ(shown(), "Strong (changed)");
  EXPECT_EQ(value("walls"), "4");

  answerBox("presetChanges", QMessageBox::AcceptRole);
  choose("Light");
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 2; }, 5000));
  EXPECT_EQ(shown(), "Light (changed)");
  EXPECT_EQ(value("brimWidthMm"), "5");
  EXPECT_EQ(value("walls"), "2");
  EXPECT_EQ(value("infillDensity"), "0.2");
  EXPECT_TRUE(isMarked("brimWidthMm"));
  EXPECT_FALSE(isMarked("infillDensity"));

  answerBox("presetChanges", QMessageBox::DestructiveRole);
  choose("Strong");
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 3; }, 5000));
  EXPECT_EQ(shown(), "Strong");
  EXPECT_EQ(value("brimWidthMm"), "0");
  document().undoStack()->undo();
  EXPECT_EQ(shown(), "Light (changed)");
  EXPECT_EQ(value("brimWidthMm"), "5");
}

TEST_F(PresetsTest, AnOwnOneIsSavedRenamedAndDeleted) {
  openFlat();
  EXPECT_FALSE(canAsk("savePreset")) << "presets of the program are read-only";
  for (const char* closed : {"renamePreset", "deletePreset"})
    EXPECT_FALSE(canAsk(closed)) << closed;
  choose("Strong");
  type("brimWidthMm", "5");
  saveAs("My brim");
  EXPECT_EQ(shown(), "My brim");
  EXPECT_FALSE(isMarked("brimWidthMm"));
  const auto saved = [&] { return pipeline::loadPreset("my-brim"); };
  EXPECT_EQ(saved().parent, "strong");
  EXPECT_EQ(saved().settings, (pipeline::Settings{{"brimWidthMm", "5"}}));
  EXPECT_FALSE(canAsk("savePreset")) << "nothing was changed";

  type("walls", "6");
  EXPECT_EQ(shown(), "My brim (changed)");
  ask("savePreset");
  EXPECT_EQ(shown(), "My brim");
  EXPECT_EQ(saved().settings, (pipeline::Settings{{"brimWidthMm", "5"}, {"walls", "6"}}));

  inDialog("presetName", [](QDialog& dialog) {
    auto* field = dialog.findChild<QLineEdit*>("presetNameField");
    field->selectAll();
    QTest::keyClicks(field, "Wide brim");
    QTest::keyClick(field, Qt::Key_Return);
  });
  ask("renamePreset");
  EXPECT_EQ(shown(), "Wide brim");
  EXPECT_FALSE(listed().contains("My brim"));

  answerBox("", QMessageBox::YesRole);
  ask("deletePreset");
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 1; }, 5000));
  EXPECT_FALSE(QFile::exists(presetFile("my-brim")));
  EXPECT_EQ(shown(), "Strong (changed)") << "the settings of the project stay";
  EXPECT_EQ(value("brimWidthMm"), "5");
  document().undoStack()->undo();
  EXPECT_EQ(shown(), "Wide brim") << "as this project has it";
  EXPECT_TRUE(listed().contains("In this project"));
  EXPECT_FALSE(canAsk("savePreset"));
  saveAs("Wide brim");
  EXPECT_EQ(pipeline::loadPreset("wide-brim").parent, "strong");
  EXPECT_EQ(shown(), "Wide brim");
  EXPECT_FALSE(listed().contains("In this project"));
}

TEST_F(PresetsTest, AHalfTypedNumberIsSavedToo) {
  openFlat();
  type("walls", "7", false);
  saveAs("Seven");
  EXPECT_EQ(shown(), "Seven");
  EXPECT_EQ(pipeline::loadPreset("seven").settings.at("walls"), "7");
  type("walls", "8", false);
  answerBox("presetChanges", QMessageBox::AcceptRole);
  choose("Usual"); // the click leaves the field
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 1; }, 5000));
  EXPECT_EQ(shown(), "Usual (changed)");
  EXPECT_EQ(value("walls"), "8");
  // The name that is proposed next is free.
  saveAs("Usual, own");
  inDialog("presetName", [](QDialog& dialog) {
    EXPECT_TRUE(dialog.findChild<QPushButton*>("presetNameAccept")->isEnabled());
    dialog.reject();
  });
  choose("Usual");
  ask("savePresetAs");
  EXPECT_EQ(shown(), "Usual");
}

TEST_F(PresetsTest, ANameThatIsTakenOrBlankIsRefused) {
  openFlat();
  inDialog("presetName", [](QDialog& dialog) {
    auto* field = dialog.findChild<QLineEdit*>("presetNameField");
    auto* accept = dialog.findChild<QPushButton*>("presetNameAccept");
    auto* problem = dialog.findChild<QLabel*>("presetNameProblem");
    EXPECT_TRUE(accept->isEnabled()) << "a proposal that is possible";
    for (const char* name : {"", "   ", "Strong", " strong "}) {
      field->setText(QString());
      QTest::keyClicks(field, name);
      EXPECT_FALSE(accept->isEnabled()) << name;
      EXPECT_FALSE(problem->text().isEmpty()) << name;
      QTest::keyClick(field, Qt::Key_Return);
      EXPECT_TRUE(dialog.isVisible()) << name;
    }
    keepPicture(dialog, "presets_name");
    QTest::keyClick(&dialog, Qt::Key_Escape);
  });
  ask("savePresetAs");
  EXPECT_EQ(shown(), "Usual");
  EXPECT_FALSE(QDir(path("presets")).exists());
}

TEST_F(PresetsTest, AFolderThatCannotBeWrittenIsReported) {
  openFlat();
  type("walls", "5");
  base::writeFile(path("presets").toStdString(), ""); // a file where the folder should be
  answerBox("presetProblem", QMessageBox::AcceptRole);
  saveAs("Mine");
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 1; }, 5000));
  EXPECT_EQ(shown(), "Usual (changed)");
  EXPECT_EQ(value("walls"), "5");
}

TEST_F(PresetsTest, AreComparedByTheirDifferences) {
  openFlat();
  choose("Strong");
  type("walls", "6");
  int rows = 0;
  inDialog("comparePresetsDialog", [&](QDialog& dialog) {
    auto* table = dialog.findChild<QTableWidget*>("presetDifferences");
    auto* second = dialog.findChild<QComboBox*>("presetSecond");
    EXPECT_EQ(second->currentText(), "Strong");
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 0)->text(), "Walls");
    EXPECT_EQ(table->item(0, 1)->text(), "6");
    EXPECT_EQ(table->item(0, 2)->text(), "4");
    second->setCurrentText("Fast draft");
    rows = table->rowCount();
    keepPicture(dialog, "presets_compare");
    EXPECT_TRUE(withoutName(dialog).isEmpty()) << withoutName(dialog).join(", ").toStdString();
    second->setCurrentIndex(0);
    EXPECT_EQ(table->rowCount(), 0) << "the same in both columns";
    dialog.reject();
  });
  ask("comparePresets");
  EXPECT_EQ(rows, 6) << "walls, density, top, bottom, seam, quality";
}

TEST_F(PresetsTest, AreExportedAndImported) {
  openFlat();
  choose("Light");
  type("walls", "5");
  saveAs("Base");
  type("brimWidthMm", "3");
  saveAs("Child");
  const QString file = path("exported.json");
  answerFileDialog(file);
  ask("exportPreset");
  ASSERT_TRUE(waitFor([&] { return QFile::exists(file); }, 5000));
  const pipeline::PrintPreset exported = pipeline::loadPreset(file.toStdString());
  EXPECT_EQ(exported.parent, "light") << "without the user's other files";
  EXPECT_EQ(exported.settings, (pipeline::Settings{{"brimWidthMm", "3"}, {"walls", "5"}}));

  for (int i = 0; i < 2; ++i) {
    answerBox("", QMessageBox::YesRole);
    ask("deletePreset");
    ASSERT_TRUE(waitFor([&] { return answeredBoxes() == i + 1; }, 5000));
  }
  choose("Light (changed)"); // no question: it is the chosen one
  ask("discardPresetChanges");
  answerFileDialog(file);
  ask("importPreset");
  ASSERT_TRUE(waitFor([&] { return shown() == "Child"; }, 5000));
  EXPECT_EQ(value("walls"), "5");

  // A broken one: one line, and nothing changes.
  for (const char* broken : {"no JSON", R"({"id": "x", "label": "X", "settings": {"wals": 3}})",
                             R"({"id": "x", "label": "X", "parent": "gone", "settings": {}})",
                             R"({"id": "strong", "label": "Stronger", "settings": {}})"}) {
    base::writeFile(path("broken.json").toStdString(), broken);
    QString line;
    inDialog("presetProblem", [&](QDialog& dialog) {
      line = static_cast<QMessageBox&>(dialog).text();
      dialog.accept();
    });
    answerFileDialog(path("broken.json"));
    ask("importPreset");
    ASSERT_TRUE(waitFor([&] { return !line.isEmpty(); }, 5000)) << broken;
    EXPECT_TRUE(line.contains("broken.json")) << line.toStdString();
    EXPECT_FALSE(line.contains('\n')) << line.toStdString();
    EXPECT_EQ(shown(), "Child");
    EXPECT_EQ(QDir(path("presets")).entryList({"*.json"}).size(), 1);
  }
}

TEST_F(PresetsTest, StayWithTheProjectAndWithTheNextPart) {
  openFlat();
  choose("Light");
  type("walls", "5");
  saveAs("Mine");
  saveProject("one.voluta");
  // The next part is printed with the same preset, without changes that were not saved.
  openPart(writePart("next.stl", box({0, 0, 0}, {15, 15, 5})));
  EXPECT_EQ(shown(), "Mine");
  EXPECT_EQ(value("walls"), "5");
  // The preset is changed there; the first project keeps its settings.
  type("walls", "8");
  ask("savePreset");
  EXPECT_EQ(shown(), "Mine");
  saveProject("two.voluta");
  window().open(path("one.voluta"));
  ASSERT_TRUE(waitFor([&] { return value("walls") == "5"; }, 20000));
  EXPECT_EQ(shown(), "Mine");
  EXPECT_TRUE(listed().contains("In this project"));
  EXPECT_FALSE(canAsk("savePreset"));
  EXPECT_EQ(pipeline::loadPreset("mine").settings.at("walls"), "8");
}

TEST_F(PresetsTest, HoldForAllParts) {
  openFlat();
  choose("Strong");
  document().duplicatePart();
  ASSERT_EQ(document().partCount(), 2u);
  EXPECT_EQ(shown(), "Strong");
  type("layerHeightMm", "0.6"); // of the second part
  EXPECT_EQ(shown(), "Strong (changed)");
  document().setActive(0);
  EXPECT_EQ(value("layerHeightMm"), "0.8");
  EXPECT_EQ(shown(), "Strong (changed)") << "one of the parts differs";
  answerBox("presetChanges", QMessageBox::AcceptRole);
  choose("Light");
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 1; }, 5000));
  EXPECT_EQ(value("walls"), "2");
  EXPECT_EQ(value("layerHeightMm"), "0.8");
  document().setActive(1);
  EXPECT_EQ(value("layerHeightMm"), "0.6");
  EXPECT_EQ(value("infillDensity"), "0.2");
  EXPECT_TRUE(isMarked("layerHeightMm"));
}

} // namespace
} // namespace voluta::test
