// The library of processes and materials: own ones are made, edited, used in the job, and travel
// with the project.
#include "base/data_files.h"
#include "base/files.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/head_table.h"
#include "panels/item_form.h"
#include "process/library_fields.h"
#include "window/library/library_dialog.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTabBar>
#include <QTableWidget>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <cmath>
#include <functional>

namespace voluta::test {
namespace {

using process::Shelf;
using window::LibraryDialog;

class ProcessEditorTest : public WindowTest {
protected:
  // Works the dialog once it is up, then continues.
  template <typename Dialog> void inDialog(const std::function<void(Dialog&)>& work) {
    QTimer::singleShot(0, &window(), [work] {
      Dialog* dialog = nullptr;
      ASSERT_TRUE(waitFor([&] {
        dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
        return dialog && dialog->isVisible();
      }));
      dialog->activateWindow(); // there may be no window manager to do it
      ASSERT_TRUE(waitFor([&] { return dialog->isActiveWindow(); }, 5000));
      work(*dialog);
    });
  }
  void inLibrary(const std::function<void(LibraryDialog&)>& work) {
    inDialog<LibraryDialog>(work);
    clickMenu("editMenu", "editLibrary");
  }
  void inMaterials(const std::function<void(LibraryDialog&)>& work) {
    inDialog<LibraryDialog>(work);
    QTest::mouseClick(find<QToolButton>("materialLibrary"), Qt::LeftButton);
  }
  static QPushButton* button(QWidget& in, const char* name) {
    auto* found = in.findChild<QPushButton*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  static void press(QWidget& in, const char* name) {
    ASSERT_TRUE(button(in, name)->isEnabled()) << name;
    QTest::mouseClick(button(in, name), Qt::LeftButton);
  }
  static QWidget* row(QWidget& in, const char* key) {
    auto* found = in.findChild<panels::ItemForm*>("libraryForm")->findChild<QWidget*>(key);
    EXPECT_NE(found, nullptr) << key;
    return found;
  }
  static QDoubleSpinBox* field(QWidget& in, const char* key) {
    return row(in, key)->findChild<QDoubleSpinBox*>("editor");
  }
  static void type(QWidget& in, const char* key, const QString& text, bool enter = true) {
    QDoubleSpinBox* box = field(in, key);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, text);
    if (enter)
      QTest::keyClick(box, Qt::Key_Return);
  }
  static QString state(QWidget& in) { return in.findChild<QLabel*>("libraryState")->text(); }
  static QString title(QWidget& in) { return in.findChild<QLabel*>("libraryTitle")->text(); }
  static bool isMarked(QWidget& in, const char* key) {
    return row(in, key)->findChild<QToolButton*>("reset")->isVisible();
  }
};

TEST_F(ProcessEditorTest, FactoryProcessesAreReadAndNotChanged) {
  inLibrary([&](LibraryDialog& dialog) {
    EXPECT_EQ(title(dialog), "fdm-1.0") << "the process of the job";
    EXPECT_LE(dialog.height(), 720);
    EXPECT_LE(dialog.width(), 1280);
    EXPECT_TRUE(field(dialog, "beadWidthMm.default")->isReadOnly());
    for (const char* locked : {"librarySave", "libraryRename", "libraryDelete", "headMeshOpen"})
      EXPECT_FALSE(button(dialog, locked)->isEnabled()) << locked;
    for (const char* open : {"libraryDuplicate", "libraryExport", "libraryUse"})
      EXPECT_TRUE(button(dialog, open)->isEnabled()) << open;
    EXPECT_EQ(dialog.findChild<QListWidget*>("libraryList")->count(),
              static_cast<int>(process::libraryIds(Shelf::Processes).size()));
    keepPicture(dialog, "library_factory");
    dialog.reject();
  });
  EXPECT_FALSE(document().undoStack()->canUndo());
}

TEST_F(ProcessEditorTest, ADuplicateIsEditedSavedAndUsed) {
  openPart(writePart("block.stl", box({-8, -8, 0}, {8, 8, 4})));
  inLibrary([&](LibraryDialog& dialog) {
    press(dialog, "libraryDuplicate");
    EXPECT_EQ(title(dialog), "fdm-1.0-own");
    EXPECT_FALSE(button(dialog, "librarySave")->isEnabled()) << "nothing to save";
    // Half typed: the number counts when the field is left.
    type(dialog, "beadWidthMm.default", "1.5", false);
    EXPECT_FALSE(isMarked(dialog, "beadWidthMm.default"));
    field(dialog, "stepMm")->setFocus();
    EXPECT_TRUE(isMarked(dialog, "beadWidthMm.default"));
    EXPECT_FALSE(isMarked(dialog, "stepMm"));
    EXPECT_EQ(state(dialog), "Not saved yet.");
    // A contradiction is shown beside its field and cannot be saved.
    type(dialog, "beadWidthMm.max", "1.4");
    EXPECT_FALSE(button(dialog, "librarySave")->isEnabled());
    EXPECT_FALSE(button(dialog, "libraryUse")->isEnabled());
    EXPECT_TRUE(state(dialog).contains("Bead width")) << state(dialog).toStdString();
    EXPECT_FALSE(state(dialog).contains('\n'));
    keepPicture(dialog, "library_contradiction");
    QTest::mouseClick(row(dialog, "beadWidthMm.max")->findChild<QToolButton*>("reset"),
                      Qt::LeftButton);
    EXPECT_EQ(field(dialog, "beadWidthMm.max")->value(), 2.0);
    EXPECT_TRUE(button(dialog, "librarySave")->isEnabled());
    press(dialog, "librarySave");
    EXPECT_FALSE(button(dialog, "librarySave")->isEnabled());
    EXPECT_TRUE(isMarked(dialog, "beadWidthMm.default")) << "differs from the factory's";
    keepPicture(dialog, "library_own");
    press(dialog, "libraryUse");
    dialog.reject();
  });
  const std::string stored = document().choices().tool().process;
  ASSERT_TRUE(base::isDataText(stored)) << "the project needs no file of the user's";
  EXPECT_EQ(process::loadProcess(stored).beadWidthMm, 1.5);
  auto* combo = find<QComboBox>("process");
  EXPECT_EQ(combo->currentData(), "fdm-1.0-own");
  EXPECT_EQ(combo->currentIndex(), combo->findText(combo->currentText())) << "listed once";
  document().undoStack()->undo();
  EXPECT_EQ(document().choices().tool().process, "fdm-1.0");
  document().undoStack()->redo();
  EXPECT_EQ(document().choices().tool().process, stored);
}

TEST_F(ProcessEditorTest, TheProjectKeepsAnOwnProcessOnAnotherMachine) {
  openPart(writePart("block.stl", box({-8, -8, 0}, {8, 8, 3})));
  project::Choices flat = document().choices();
  flat.item().automatic = false;
  flat.item().mode = "flat";
  document().setChoices(flat, "way of building");
  inLibrary([&](LibraryDialog& dialog) {
    press(dialog, "libraryDuplicate");
    type(dialog, "beadWidthMm.default", "1.4");
    EXPECT_EQ(button(dialog, "libraryUse")->text(), "Save and use in this job");
    press(dialog, "libraryUse");
    EXPECT_FALSE(button(dialog, "librarySave")->isEnabled());
    dialog.reject();
  });
  clickToolBar("plan");
  ASSERT_TRUE(planned(project::Stage::Replay));
  EXPECT_EQ(process::loadProcess(document().lastResult()->job.choices.tool().process).beadWidthMm,
            1.4);
  ASSERT_TRUE(document().lastResult()->job.toolPlan);
  answerFileDialog(path("own.voluta"));
  clickMenu("fileMenu", "saveAs");
  ASSERT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
  process::removeOwn(Shelf::Processes, "fdm-1.0-own");
  openWindow();
  window().open(path("own.voluta"));
  ASSERT_TRUE(waitFor([&] { return base::isDataText(document().choices().tool().process); }));
  EXPECT_EQ(process::loadProcess(document().choices().tool().process).beadWidthMm, 1.4);
  EXPECT_TRUE(find<QComboBox>("process")->currentText().endsWith("(fdm-1.0-own)"));
  inLibrary([&](LibraryDialog& dialog) {
    EXPECT_EQ(title(dialog), "fdm-1.0-own");
    EXPECT_EQ(dialog.shown().at(dialog.current()).origin, window::ItemOrigin::Job);
    EXPECT_FALSE(button(dialog, "libraryDelete")->isEnabled());
    keepPicture(dialog, "library_of_job");
    press(dialog, "libraryDuplicate"); // keeps it in the library
    EXPECT_EQ(field(dialog, "beadWidthMm.default")->value(), 1.4);
    dialog.reject();
  });
}

TEST_F(ProcessEditorTest, TheHeadIsEditedAsATableFromNumbersAndFromAMesh) {
  const auto block = box({-10, -10, 0}, {10, 10, 40});
  const QString file = writePart("head.stl", block);
  inLibrary([&](LibraryDialog& dialog) {
    press(dialog, "libraryDuplicate");
    auto* table = dialog.findChild<QTableWidget*>("headTable");
    const auto& sections = [&]() -> const std::vector<process::HeadSection>& {
      return dialog.shown().at(dialog.current()).draft.process()->head.sections;
    };
    ASSERT_EQ(table->rowCount(), 6);
    table->item(2, 0)->setData(Qt::EditRole, 11.0); // below the row before it
    EXPECT_FALSE(button(dialog, "librarySave")->isEnabled());
    EXPECT_TRUE(dialog.findChild<QLabel*>("headProblem")->isVisible());
    table->item(2, 0)->setData(Qt::EditRole, 13.0);
    EXPECT_FALSE(dialog.findChild<QLabel*>("headProblem")->isVisible());
    EXPECT_TRUE(button(dialog, "librarySave")->isEnabled());
    EXPECT_EQ(sections()[2].zMm, 13.0);
    QTest::mouseClick(dialog.findChild<QToolButton*>("headReset"), Qt::LeftButton);
    EXPECT_EQ(sections()[2].zMm, 12.0);
    table->setCurrentCell(5, 0);
    QTest::mouseClick(dialog.findChild<QToolButton*>("headAdd"), Qt::LeftButton);
    EXPECT_EQ(sections().size(), 7u);
    QTest::mouseClick(dialog.findChild<QToolButton*>("headRemove"), Qt::LeftButton);
    EXPECT_EQ(sections().size(), 6u);

    inDialog<QDialog>([](QDialog& numbers) {
      EXPECT_EQ(numbers.objectName(), "headNumbers");
      auto* width = numbers.findChild<QDoubleSpinBox*>("headWidth");
      width->setValue(2.0);
      EXPECT_FALSE(button(numbers, "headNumbersUse")->isEnabled()) << "narrower than the cone";
      EXPECT_FALSE(numbers.findChild<QLabel*>("headNumbersProblem")->text().isEmpty());
      width->setValue(30.0);
      keepPicture(numbers, "head_numbers");
      press(numbers, "headNumbersUse");
    });
    press(dialog, "headNumbersOpen");
    ASSERT_EQ(sections().size(), 4u);
    EXPECT_NEAR(sections().back().radiusMm, 30.0 / std::sqrt(2.0), 1e-9);

    answerFileDialog(file);
    press(dialog, "headMeshOpen");
    ASSERT_EQ(sections().size(), 2u);
    EXPECT_NEAR(sections().back().radiusMm, 10.0 * std::sqrt(2.0), 1e-5);
    EXPECT_NEAR(sections().back().zMm, 40.0, 0.02);
    press(dialog, "libraryRevert");
    EXPECT_EQ(sections().size(), 6u);
    dialog.reject();
  });
}

// A drawing with the nozzle up: a message box comes up, and a head that is used as drawn stays
// marked.
TEST_F(ProcessEditorTest, HeadDrawnUpsideDownNeedsConfirmation) {
  geometry::TriangleMesh drawn = box({-10, -10, 0}, {10, 10, 30});
  append(drawn, box({-0.5, -0.5, 30}, {0.5, 0.5, 40}));
  const QString file = writePart("nozzle up.stl", drawn);
  inLibrary([&](LibraryDialog& dialog) {
    press(dialog, "libraryDuplicate");
    const auto tip = [&] {
      return dialog.shown().at(dialog.current()).draft.process()->head.sections.front().radiusMm;
    };
    const double before = tip();
    const auto import = [&](QMessageBox::ButtonRole answer) {
      answerFileDialog(file);
      answerBox("headUpsideDownBox", answer);
      press(dialog, "headMeshOpen");
    };
    import(QMessageBox::RejectRole);
    EXPECT_EQ(answeredBoxes(), 1);
    EXPECT_EQ(tip(), before) << "cancelled";
    import(QMessageBox::AcceptRole);
    EXPECT_NEAR(tip(), 0.5 * std::sqrt(2.0), 0.02);
    EXPECT_EQ(state(dialog), "Not saved yet.");
    import(QMessageBox::DestructiveRole);
    EXPECT_NEAR(tip(), 10.0 * std::sqrt(2.0), 0.02);
    EXPECT_TRUE(state(dialog).startsWith("The head is 28.3 mm wide at its tip"))
        << state(dialog).toStdString();
    keepPicture(dialog, "library_upside_down");
    press(dialog, "librarySave");
    EXPECT_TRUE(state(dialog).contains("point away from the part"));
    dialog.reject();
  });
  EXPECT_EQ(answeredBoxes(), 3);
}

TEST_F(ProcessEditorTest, OwnItemsFollowTheOneThatTheyInheritFrom) {
  inLibrary([&](LibraryDialog& dialog) {
    press(dialog, "libraryDuplicate");
    press(dialog, "libraryDuplicate");
    EXPECT_EQ(title(dialog), "fdm-1.0-own-own");
    type(dialog, "stepMm", "2");
    press(dialog, "librarySave");
    const auto* list = dialog.findChild<QListWidget*>("libraryList");
    EXPECT_EQ(list->currentRow(), 1) << "below its parent";
    EXPECT_TRUE(list->currentItem()->text().startsWith("  "));
    EXPECT_TRUE(dialog.findChild<QLabel*>("libraryAbout")->text().contains("follows fdm-1.0-own"));
    keepPicture(dialog, "library_inherits");

    dialog.select("fdm-1.0-own");
    type(dialog, "beadWidthMm.default", "1.5");
    type(dialog, "stepMm", "3");
    press(dialog, "librarySave");
    dialog.select("fdm-1.0-own-own");
    EXPECT_EQ(field(dialog, "beadWidthMm.default")->value(), 1.5);
    EXPECT_FALSE(isMarked(dialog, "beadWidthMm.default"));
    EXPECT_EQ(field(dialog, "stepMm")->value(), 2.0) << "its own";
    EXPECT_TRUE(isMarked(dialog, "stepMm"));
    // Without its parent it keeps all values.
    dialog.select("fdm-1.0-own");
    answerBox("", QMessageBox::YesRole);
    press(dialog, "libraryDelete");
    dialog.select("fdm-1.0-own-own");
    EXPECT_EQ(field(dialog, "beadWidthMm.default")->value(), 1.5);
    EXPECT_TRUE(isMarked(dialog, "beadWidthMm.default")) << "against the factory's now";
    EXPECT_FALSE(list->currentItem()->text().startsWith("  "));
    dialog.reject();
  });
}

TEST_F(ProcessEditorTest, OwnItemsAreRenamedExportedImportedAndDeleted) {
  inLibrary([&](LibraryDialog& dialog) {
    press(dialog, "libraryDuplicate");
    const auto rename = [&](const char* id) {
      inDialog<QInputDialog>([id](QInputDialog& asked) {
        asked.setTextValue(id);
        asked.accept();
      });
      press(dialog, "libraryRename");
    };
    rename("my-process");
    EXPECT_EQ(title(dialog), "my-process");
    answerBox("", QMessageBox::AcceptRole);
    rename("fdm-0.4");
    EXPECT_EQ(title(dialog), "my-process") << "that comes with the program";
    EXPECT_EQ(answeredBoxes(), 1);
    answerFileDialog(path("mine.json"));
    press(dialog, "libraryExport");
    EXPECT_EQ(process::readProcess(path("mine.json").toStdString()).id, "my-process");
    answerBox("", QMessageBox::YesRole);
    press(dialog, "libraryDelete");
    EXPECT_EQ(title(dialog), "fdm-1.0") << "the one it was based on";
    EXPECT_LT(dialog.shown().indexOf("my-process"), 0);
    answerFileDialog(path("mine.json"));
    press(dialog, "libraryImport");
    EXPECT_EQ(title(dialog), "my-process");
    base::writeFile(path("broken.json").toStdString(), R"({"id": "broken"})");
    answerFileDialog(path("broken.json"));
    answerBox("", QMessageBox::AcceptRole);
    press(dialog, "libraryImport");
    EXPECT_EQ(title(dialog), "my-process");
    EXPECT_EQ(answeredBoxes(), 3);
    dialog.reject();
  });
  auto* combo = find<QComboBox>("process");
  ASSERT_GE(combo->findData("my-process"), 0) << "there to be chosen";
  const int entries = combo->count();
  combo->setCurrentIndex(combo->findData("my-process"));
  EXPECT_TRUE(base::isDataText(document().choices().tool().process));
  EXPECT_EQ(combo->currentData(), "my-process");
  EXPECT_EQ(combo->count(), entries) << "not listed twice";
}

TEST_F(ProcessEditorTest, AnUnreadableFileIsListedAndCanBeDeleted) {
  QDir(folder_.path()).mkpath("processes");
  base::writeFile(path("processes/torn.json").toStdString(), R"({"id": "torn", "label": )");
  inLibrary([&](LibraryDialog& dialog) {
    dialog.select("torn");
    EXPECT_EQ(title(dialog), "torn");
    EXPECT_TRUE(state(dialog).contains("torn.json")) << state(dialog).toStdString();
    for (const char* no : {"librarySave", "libraryUse", "libraryDuplicate", "libraryExport"})
      EXPECT_FALSE(button(dialog, no)->isEnabled()) << no;
    answerBox("", QMessageBox::YesRole);
    press(dialog, "libraryDelete");
    EXPECT_LT(dialog.shown().indexOf("torn"), 0);
    dialog.reject();
  });
}

TEST_F(ProcessEditorTest, AJobKeepsTheVersionThatItUsesUntilItIsUsedAgain) {
  inLibrary([&](LibraryDialog& dialog) {
    press(dialog, "libraryDuplicate");
    press(dialog, "libraryUse");
    EXPECT_EQ(state(dialog), QString());
    type(dialog, "speedMmPerS", "24");
    press(dialog, "librarySave");
    EXPECT_TRUE(state(dialog).contains("another version")) << state(dialog).toStdString();
    press(dialog, "libraryUse");
    EXPECT_EQ(state(dialog), QString());
    dialog.reject();
  });
  EXPECT_EQ(process::loadProcess(document().choices().tool().process).speedMmPerS, 24.0);
}

TEST_F(ProcessEditorTest, OnlyDifferingFieldsAreCompared) {
  inLibrary([&](LibraryDialog& dialog) {
    press(dialog, "libraryDuplicate");
    type(dialog, "speedMmPerS", "25");
    inDialog<QDialog>([](QDialog& compared) {
      EXPECT_EQ(compared.objectName(), "compareItems");
      auto* table = compared.findChild<QTableWidget*>("compareFields");
      ASSERT_EQ(table->rowCount(), 2) << "label and speed";
      EXPECT_EQ(table->item(1, 0)->text(), "Print speed");
      EXPECT_EQ(table->item(1, 1)->text(), "25 mm/s");
      EXPECT_EQ(table->item(1, 2)->text(), "20 mm/s");
      auto* second = compared.findChild<QComboBox*>("compareSecond");
      second->setCurrentText("pellet-4");
      EXPECT_GT(table->rowCount(), 8);
      keepPicture(compared, "library_compare");
      compared.reject();
    });
    press(dialog, "libraryCompare");
    answerBox("", QMessageBox::DestructiveRole);
    dialog.reject();
    EXPECT_FALSE(dialog.isVisible());
  });
}

TEST_F(ProcessEditorTest, AnOwnMaterialIsUsedInTheJob) {
  inMaterials([&](LibraryDialog& dialog) {
    EXPECT_EQ(title(dialog), "pla");
    press(dialog, "libraryDuplicate");
    type(dialog, "nozzleC.default", "225");
    type(dialog, "bedC", "-1");
    EXPECT_EQ(field(dialog, "bedC")->text(), "unknown");
    type(dialog, "fan", "0.4");
    keepPicture(dialog, "library_material");
    press(dialog, "libraryUse");
    dialog.reject();
  });
  const process::Process used = process::loadProcess(document().choices().tool().process);
  EXPECT_EQ(used.material.id, "pla-own");
  EXPECT_EQ(used.material.nozzleC, 225);
  EXPECT_FALSE(used.material.bedC);
  EXPECT_EQ(used.material.fan, 0.4);
  document().undoStack()->undo();
  EXPECT_EQ(document().choices().tool().process, "fdm-1.0");
}

} // namespace
} // namespace voluta::test
