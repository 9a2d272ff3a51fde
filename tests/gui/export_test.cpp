// The Export page at work: a format's own options, the size of a program, the places where its
// controller is slow, its text in step with the time-line; and a print that is resumed.
#include "forms/parameter_row.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/export_panel.h"
#include "panels/format_list.h"
#include "panels/text_preview.h"
#include "pipeline/checked_program.h"
#include "pipeline/plan_verdict.h"
#include "program/dialect.h"
#include "timeline/timeline_bar.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QUndoStack>

namespace voluta::test {
namespace {

using project::Stage;

class ExportTest : public WindowTest {
protected:
  void planPlinth() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {20.0, 18.0, 4.0})));
    clickToolBar("plan");
    ASSERT_TRUE(planned(Stage::Replay));
    choosePage(Page::Export);
    // The lines of its motions are known.
    ASSERT_TRUE(waitFor([&] { return preview()->currentLine() > 0; }, 5000));
  }
  panels::ExportPanel* panel() { return find<panels::ExportPanel>("export"); }
  panels::TextPreview* preview() { return panel()->findChild<panels::TextPreview*>("preview"); }
  panels::FormatList* formats() { return panel()->findChild<panels::FormatList*>("formats"); }
  timeline::TimelineBar* bar() { return window().findChild<timeline::TimelineBar*>(); }
  forms::ParameterRow* option(const char* key) {
    for (auto* row : panel()->findChildren<forms::ParameterRow*>(key))
      if (row->isVisible())
        return row;
    return nullptr;
  }
  void chooseFormat(const char* id) {
    for (int i = 0; i < formats()->topLevelItemCount(); ++i)
      if (auto* item = formats()->topLevelItem(i); item->data(0, Qt::UserRole).toString() == id) {
        formats()->scrollToItem(item);
        QTest::mouseClick(formats()->viewport(), Qt::LeftButton, {},
                          formats()->visualItemRect(item).center() + QPoint(40, 0));
      }
    EXPECT_EQ(formats()->currentId(), id);
  }
  // Sets off a line of the text by the mouse; the one of a motion that prints.
  std::size_t clickPrintedLine(double share) {
    const auto& lines = preview()->lines();
    auto line = static_cast<std::size_t>(share * static_cast<double>(lines.count()));
    while (lines.line(line).find("movel(") == std::string_view::npos)
      ++line;
    preview()->showLine(line + 1);
    preview()->setFocus();
    QTest::keyClick(preview(), Qt::Key_Up);
    QTest::keyClick(preview(), Qt::Key_Down);
    return preview()->currentLine();
  }
  // Presses Export; the files come later.
  void exportInto(const QString& path) {
    auto* folder = panel()->findChild<QLineEdit*>("folder");
    folder->setFocus();
    folder->selectAll();
    QTest::keyClicks(folder, path);
    QTest::mouseClick(button(panel(), "export"), Qt::LeftButton);
  }
  QPushButton* button(QWidget* in, const char* name) {
    auto* found = in->findChild<QPushButton*>(name);
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
};

TEST_F(ExportTest, AFormatBringsItsOptionsAndTheyAreEdits) {
  planPlinth();
  chooseFormat("urscript");
  ASSERT_TRUE(waitFor([&] { return option("urscriptForm") != nullptr; }, 5000));
  EXPECT_EQ(option("rapidModules"), nullptr);
  auto* form = qobject_cast<QComboBox*>(option("urscriptForm")->editor());
  ASSERT_NE(form, nullptr);
  form->setFocus();
  QTest::keyClick(form, Qt::Key_Down);
  EXPECT_EQ(document().choices().parameters.at("urscriptForm"), "port");
  EXPECT_FALSE(document().upToDate(Stage::Replay));
  EXPECT_TRUE(document().upToDate(Stage::Motion));
  EXPECT_FALSE(button(panel(), "export")->isEnabled());
  document().undoStack()->undo();
  EXPECT_TRUE(document().upToDate(Stage::Replay));
  EXPECT_EQ(form->currentIndex(), 0);
  chooseFormat("rapid");
  ASSERT_TRUE(waitFor([&] { return option("rapidModules") != nullptr; }, 5000));
  EXPECT_EQ(option("urscriptForm"), nullptr);
  chooseFormat("csv");
  EXPECT_EQ(option("motionsPerFile"), nullptr);
  // An option that none of the chosen formats has leaves the programs as they are.
  chooseFormat("rapid");
  ASSERT_TRUE(waitFor([&] { return option("rapidModules") != nullptr; }, 5000));
  auto* modules = qobject_cast<QComboBox*>(option("rapidModules")->editor());
  modules->setFocus();
  QTest::keyClick(modules, Qt::Key_Down);
  EXPECT_TRUE(document().upToDate(Stage::Replay));
}

// Moves of a table beyond its range, and a module that reads G-code on the controller. A stream of
// joints for another maker's arm: greyed with a reason, and no click selects it.
TEST_F(ExportTest, UnsuitableFormatIsNotOffered) {
  planPlinth();
  const auto* dialect = &program::dialects().front();
  for (const program::Dialect& one : program::dialects())
    if (one.needsJoints && one.controller == "melfa")
      dialect = &one;
  ASSERT_TRUE(dialect->needsJoints);
  const QString id = QString::fromUtf8(dialect->id.data(), static_cast<int>(dialect->id.size()));
  const QStringList before = panel()->checkedFormats();
  ASSERT_FALSE(before.contains(id));
  chooseFormat(id.toUtf8().constData());
  auto* why = panel()->findChild<QLabel*>("whyNot");
  ASSERT_NE(why, nullptr);
  EXPECT_TRUE(why->isVisible());
  EXPECT_TRUE(why->text().contains("another maker's arm")) << why->text().toStdString();
  QTest::keyClick(formats(), Qt::Key_Space);
  EXPECT_EQ(panel()->checkedFormats(), before);
  for (int i = 0; i < formats()->topLevelItemCount(); ++i)
    if (auto* item = formats()->topLevelItem(i); item->data(0, Qt::UserRole).toString() == id) {
      const QRect row = formats()->visualItemRect(item);
      QTest::mouseClick(formats()->viewport(), Qt::LeftButton, {}, row.topLeft() + QPoint(12, 8));
    }
  EXPECT_EQ(panel()->checkedFormats(), before);
  chooseFormat("urscript");
  EXPECT_FALSE(why->isVisible());
}

// A small island beside a plinth begins in the air: the replay of the programs passes, as little of
// them is unsupported, and nevertheless no part of the window shows the plan as passed.
TEST_F(ExportTest, ABlockedPlanHasNotPassedAnywhere) {
  geometry::TriangleMesh mesh = box({0, 0, 0}, {40, 40, 6});
  append(mesh, box({44, 10, 3}, {49, 15, 6}));
  openPart(writePart("island.stl", mesh));
  project::Choices flat = document().choices();
  flat.item().mode = "flat";
  document().setChoices(flat, "mode");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  choosePage(Page::Export);
  const auto result = document().result(Stage::Replay);
  ASSERT_TRUE(result && result->job.report.replay.passed);
  ASSERT_EQ(pipeline::verdictOf(result->job.report), pipeline::PlanVerdict::NotAsAsked);
  EXPECT_EQ(find<window::FlowBar>("flowBar")->state(Page::Export), window::PageState::Differs);
  keepPicture(window(), "export-not-as-asked");
  EXPECT_TRUE(formats()->currentItem()->toolTip(2).contains("begins in the air"))
      << formats()->currentItem()->toolTip(2).toStdString();
  const QString there = path("blocked");
  answerBox("blockedBox", QMessageBox::RejectRole);
  exportInto(there);
  ASSERT_TRUE(waitFor([&] { return answeredBoxes() == 1; }, 5000));
  EXPECT_FALSE(QDir(there).exists());
  answerBox("blockedBox", QMessageBox::DestructiveRole);
  QTest::mouseClick(button(panel(), "export"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return QFile::exists(QDir(there).filePath("report.json")); }, 60000));
  EXPECT_EQ(answeredBoxes(), 2);
}

// A new plan does not tick formats again that were unticked, the last one included.
TEST_F(ExportTest, NoFormatIsTickedOnceAllAreTakenOff) {
  planPlinth();
  const auto tick = [&](const char* id, Qt::CheckState state) {
    for (int i = 0; i < formats()->topLevelItemCount(); ++i)
      if (auto* item = formats()->topLevelItem(i); item->data(0, Qt::UserRole).toString() == id)
        item->setCheckState(0, state);
  };
  const QStringList before = panel()->checkedFormats();
  ASSERT_FALSE(before.isEmpty());
  for (const QString& id : before)
    tick(id.toUtf8().constData(), Qt::Unchecked);
  document().setParameter("walls", "3");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  choosePage(Page::Export);
  EXPECT_TRUE(panel()->checkedFormats().isEmpty())
      << panel()->checkedFormats().join(' ').toStdString();
  EXPECT_EQ(panel()->findChild<QLabel*>("reason")->text(), "Choose at least one format.");
  tick("urscript", Qt::Checked);
  EXPECT_EQ(panel()->checkedFormats(), QStringList("urscript"));
  EXPECT_EQ(document().choices().formats, std::vector<std::string>{"urscript"});
}

TEST_F(ExportTest, WindingAndReadersAreOptionsOfTheirFormats) {
  planPlinth();
  chooseFormat("gcode-bc");
  ASSERT_TRUE(waitFor([&] { return option("tableUnwind") != nullptr; }, 5000));
  auto* unwind = qobject_cast<QComboBox*>(option("tableUnwind")->editor());
  ASSERT_NE(unwind, nullptr);
  unwind->setFocus();
  QTest::keyClick(unwind, Qt::Key_Down);
  EXPECT_EQ(document().choices().parameters.at("tableUnwind"), "count");
  // An edit leaves the row on show that was chosen, though nothing of it is written yet.
  QTest::qWait(200);
  EXPECT_EQ(formats()->currentId(), "gcode-bc");
  ASSERT_NE(option("tableUnwind"), nullptr);
  keepPicture(window(), "export_winding");
  chooseFormat("gcode-extended");
  ASSERT_TRUE(waitFor([&] { return option("gcodeRunner") != nullptr; }, 5000));
  EXPECT_EQ(option("tableUnwind"), nullptr);
  keepPicture(window(), "export_reader");
}

TEST_F(ExportTest, ShowsSizeFilesAndTimesOfAProgram) {
  planPlinth();
  chooseFormat("urscript");
  const auto text = [&](const char* name) { return panel()->findChild<QLabel*>(name)->text(); };
  EXPECT_TRUE(text("programSize").contains("in one file")) << text("programSize").toStdString();
  EXPECT_TRUE(text("programTime").startsWith("Time on the controller: "))
      << text("programTime").toStdString();
  EXPECT_TRUE(text("assumptions").contains("8 ms")) << text("assumptions").toStdString();
  auto* spinBox = qobject_cast<QSpinBox*>(option("motionsPerFile")->editor());
  spinBox->setFocus();
  QTest::keyClick(spinBox, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClicks(spinBox, "600");
  QTest::keyClick(spinBox, Qt::Key_Tab);
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  choosePage(Page::Export);
  EXPECT_TRUE(text("programSize").contains(" files")) << text("programSize").toStdString();
  chooseFormat("rapid");
  EXPECT_FALSE(panel()->findChild<QLabel*>("programSize")->isVisible()) << "none is written";
}

TEST_F(ExportTest, TheTimeLineShowsWhereTheControllerIsSlower) {
  planPlinth();
  const auto result = document().result(Stage::Replay);
  for (const auto& checked : result->checked) {
    chooseFormat(checked->program.format.c_str());
    EXPECT_EQ(bar()->spans().size(), checked->slow.size()) << checked->program.format;
  }
  choosePage(Page::Simulate);
  EXPECT_TRUE(bar()->spans().empty());
}

TEST_F(ExportTest, TextAndTimeLineAreInStep) {
  planPlinth();
  chooseFormat("urscript");
  const double before = bar()->timeS();
  const std::size_t line = clickPrintedLine(0.5);
  EXPECT_TRUE(waitFor([&] { return bar()->timeS() != before; }, 5000));
  bar()->nextMove();
  EXPECT_TRUE(waitFor([&] { return preview()->currentLine() > line; }, 5000));
}

TEST_F(ExportTest, APrintIsTakenUpAtALineAsAProjectOfItsOwn) {
  planPlinth();
  chooseFormat("urscript");
  const double whole = document().result(Stage::Motion)->job.report.motion.durationS;
  clickPrintedLine(0.5);
  auto* resume = button(panel(), "resume");
  ASSERT_TRUE(waitFor([&] { return resume->isEnabled(); }, 5000));
  answerFileDialog(path("first.voluta"));
  clickMenu("fileMenu", "saveAs");
  ASSERT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
  // Not without the user's word.
  answerBox("resumeBox", QMessageBox::RejectRole);
  QTest::mouseClick(resume, Qt::LeftButton);
  EXPECT_FALSE(document().isRest());
  answerBox("resumeBox", QMessageBox::AcceptRole);
  QTest::mouseClick(resume, Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return document().isRest(); }));
  EXPECT_TRUE(document().projectFile().isEmpty()) << "the first one stays as it was saved";
  EXPECT_EQ(document().name(), "plinth-rest");
  EXPECT_TRUE(document().dirty());
  EXPECT_FALSE(document().undoStack()->canUndo());
  EXPECT_TRUE(document().upToDate(Stage::Replay));
  EXPECT_LT(document().result(Stage::Motion)->job.report.motion.durationS, 0.8 * whole);
  EXPECT_EQ(page(), Page::Simulate);
  // It can be handed over, and the programs are of the rest.
  choosePage(Page::Export);
  EXPECT_TRUE(button(panel(), "export")->isEnabled());
  const std::string name = document().result(Stage::Replay)->checked.at(0)->program.files[0].name;
  EXPECT_NE(name.find("rest"), std::string::npos) << name;
  // An option writes the programs anew, and the motion stays the rest's.
  chooseFormat("urscript");
  auto* form = qobject_cast<QComboBox*>(option("urscriptForm")->editor());
  form->setFocus();
  QTest::keyClick(form, Qt::Key_Down);
  EXPECT_FALSE(document().upToDate(Stage::Replay));
  EXPECT_TRUE(document().isRest());
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_TRUE(document().isRest());
  EXPECT_TRUE(
      document().result(Stage::Replay)->checked.at(0)->program.files[0].text.ends_with("\nend\n"));
}

TEST_F(ExportTest, FromTheTimeLineAndCancelled) {
  planPlinth();
  choosePage(Page::Simulate);
  auto* side = window().findChild<QWidget*>("plotsArea")->parentWidget();
  auto* resume = button(side, "resume");
  bar()->setTimeS(0.4 * bar()->clock()->durationS());
  ASSERT_TRUE(waitFor([&] { return resume->isEnabled(); }, 5000));
  EXPECT_TRUE(side->findChild<QLabel*>("resumePlace")->text().startsWith("Bead "));
  const auto result = document().result(Stage::Motion);
  ASSERT_TRUE(document().dirty()) << "the part was never saved";
  answerBox("resumeBox", QMessageBox::AcceptRole);
  answerBox("unsavedBox", QMessageBox::RejectRole);
  QTest::mouseClick(resume, Qt::LeftButton);
  QTest::qWait(300);
  EXPECT_EQ(document().result(Stage::Motion), result) << "cancelled";
  bar()->setTimeS(bar()->clock()->durationS());
  EXPECT_TRUE(waitFor([&] { return !resume->isEnabled(); }, 5000)) << "nothing is left to print";
}

TEST_F(ExportTest, AProgramFromDiskIsJudgedByThePlanOnShow) {
  planPlinth();
  const plan::ProgramFile& file =
      document().result(Stage::Replay)->checked.at(0)->program.files.at(0);
  ASSERT_TRUE(file.name.ends_with(".script"));
  const auto write = [&](const QString& name, const std::string& text) {
    QFile out(path(name));
    EXPECT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(text.data(), static_cast<qint64>(text.size()));
    return path(name);
  };
  const auto verified = [&](const QString& program) {
    answerFileDialog(program);
    clickMenu("exportMenu", "verifyProgram");
    auto* dialog = window().findChild<QDialog*>("verifyDialog");
    auto* close = dialog ? dialog->findChild<QDialogButtonBox*>() : nullptr;
    EXPECT_TRUE(close && waitFor([&] { return close->button(QDialogButtonBox::Close); }, 20000));
    return dialog;
  };
  const auto verdict = [](QDialog* dialog) {
    return dialog->findChild<QLabel*>("verifyVerdict")->text();
  };
  const auto shut = [&](QDialog* dialog) {
    const QPointer<QDialog> gone = dialog;
    QTest::keyClick(dialog, Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return !gone; }, 5000));
  };
  QDialog* good = verified(write("good.script", file.text));
  ASSERT_NE(good, nullptr);
  EXPECT_TRUE(verdict(good).contains("passed")) << verdict(good).toStdString();
  EXPECT_FALSE(good->findChild<QListWidget*>("verifyFindings")->isVisible());
  shut(good);

  // A motion is missing.
  std::string other = file.text;
  const std::size_t line = other.rfind('\n', other.find("movel(", other.size() / 2));
  other.erase(line, other.find('\n', line + 1) - line);
  QDialog* bad = verified(write("bad.script", other));
  ASSERT_NE(bad, nullptr);
  EXPECT_TRUE(verdict(bad).contains("refused")) << verdict(bad).toStdString();
  auto* found = bad->findChild<QListWidget*>("verifyFindings");
  ASSERT_GT(found->count(), 0);
  EXPECT_TRUE(found->item(0)->text().contains("line ")) << found->item(0)->text().toStdString();
  keepPicture(*bad, "verify");
  shut(bad);

  // No program at all: an error of one line, and the window still works.
  QDialog* none = verified(write("none.script", "\x7f\x45LF"));
  ASSERT_NE(none, nullptr);
  EXPECT_FALSE(verdict(none).contains("passed"));
  shut(none);

  // Of a plan that is out of date nothing can be judged.
  document().setParameter("walls", "4");
  EXPECT_TRUE(
      waitFor([&] { return !window().findChild<QAction*>("verifyProgram")->isEnabled(); }, 5000));
}

// The proof and its folder are a click away once they are written.
TEST_F(ExportTest, TheProofIsOpenedFromTheResult) {
  planPlinth();
  auto* open = panel()->findChild<QPushButton*>("openProof");
  auto* show = panel()->findChild<QPushButton*>("showFolder");
  ASSERT_TRUE(open && show);
  EXPECT_FALSE(open->isVisible());
  exportInto(path("handover"));
  ASSERT_TRUE(waitFor([&] { return open->isVisible(); }, 60000));
  EXPECT_TRUE(panel()->findChild<QLabel*>("written")->text().contains("handover"));
  keepPicture(window(), "export_written");
  QTest::mouseClick(open, Qt::LeftButton);
  QTest::mouseClick(show, Qt::LeftButton);
  const QStringList& opened = given_.files();
  ASSERT_EQ(opened.size(), 2);
  EXPECT_TRUE(opened[0].endsWith(".script.proof.pdf")) << opened[0].toStdString();
  QFile proof(opened[0]);
  ASSERT_TRUE(proof.open(QIODevice::ReadOnly));
  EXPECT_TRUE(proof.readAll().startsWith("%PDF-"));
  EXPECT_EQ(QDir(opened[1]), QDir(path("handover")));
}

TEST_F(ExportTest, OneExportAfterTheOther) {
  planPlinth();
  auto* write = button(panel(), "export");
  ASSERT_TRUE(write->isEnabled());
  exportInto(path("handover"));
  EXPECT_FALSE(write->isEnabled());
  EXPECT_EQ(panel()->findChild<QLabel*>("reason")->text(), "The files are being written.");
  ASSERT_TRUE(waitFor([&] { return write->isEnabled(); }, 60000));
  EXPECT_TRUE(panel()->findChild<QLabel*>("written")->isVisible());
  EXPECT_FALSE(panel()->findChild<QLabel*>("written")->text().contains("no pictures"));
  EXPECT_TRUE(panel()->findChild<QLabel*>("reason")->text().isEmpty());
}

// Beside another plan, part or project they would be taken for its files.
TEST_F(ExportTest, SummaryOfWrittenFilesIsShownForItsOwnPlanOnly) {
  planPlinth();
  auto* written = panel()->findChild<QLabel*>("written");
  const auto exported = [&](const char* folder) {
    exportInto(path(folder));
    return waitFor([&] { return written->isVisible(); }, 60000);
  };
  ASSERT_TRUE(exported("first"));
  choosePage(Page::Simulate);
  choosePage(Page::Export);
  EXPECT_TRUE(written->isVisible()) << "the same plan";
  chooseFormat("urscript");
  auto* form = qobject_cast<QComboBox*>(option("urscriptForm")->editor());
  form->setFocus();
  QTest::keyClick(form, Qt::Key_Down);
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_EQ(page(), Page::Export);
  EXPECT_FALSE(written->isVisible()) << "another plan";
  ASSERT_TRUE(exported("second"));
  EXPECT_TRUE(written->text().contains("second"));
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  window().open(writePart("other.stl", box({0, 0, 0}, {12.0, 8.0, 4.0})));
  ASSERT_TRUE(waitFor([&] { return document().name() == "other"; }, 10000));
  choosePage(Page::Export);
  EXPECT_FALSE(written->isVisible()) << "another part";
}

} // namespace
} // namespace voluta::test
