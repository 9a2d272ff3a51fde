#include "document/document.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "document/mode_switch.h"
#include "document/parts.h"
#include "helpers/other_text.h"
#include "helpers/temporary_folder.h"
#include "pipeline/stage_options.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

namespace voluta::document {
namespace {

using project::Stage;

TEST(Document, BeginsCleanAndUntitled) {
  Document document;
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.name(), "Untitled");
  EXPECT_FALSE(document.source());
  for (const Stage stage : {Stage::Load, Stage::Motion, Stage::Replay})
    EXPECT_EQ(document.state(stage), StageState::Nothing);
}

TEST(Document, EveryEditHasAName) {
  Document document;
  document.openPart(test::boxPart(), "/tmp/box.stl", true);
  document.setParameter("voxelMm", "1.5");
  document.setScale("0.5");
  document.resetParameter("voxelMm");
  QStringList names;
  for (int i = 0; i < document.undoStack()->count(); ++i)
    names.append(document.undoStack()->text(i));
  ASSERT_EQ(names.size(), 4);
  EXPECT_EQ(names[0], "Open box.stl");
  EXPECT_TRUE(names[1].startsWith("Change "));
  EXPECT_EQ(names[2], "Scale the part");
  EXPECT_TRUE(names[3].startsWith("Reset "));
}

TEST(Document, UndoBringsBackChoicesAndPart) {
  Document document;
  QSignalSpy choices(&document, &Document::choicesChanged);
  QSignalSpy source(&document, &Document::sourceChanged);
  const auto box = test::boxPart();
  document.openPart(box, {}, true);
  test::setSeed(document, 5);
  const auto other = test::boxPart(5.0, "other.stl");
  document.openPart(other, {}, true);
  EXPECT_EQ(document.source(), other);
  EXPECT_EQ(document.name(), "other");
  EXPECT_EQ(test::seedOf(document), 1);
  document.undoStack()->undo();
  EXPECT_EQ(test::seedOf(document), 5);
  EXPECT_EQ(document.source(), box);
  EXPECT_EQ(document.name(), "box");
  document.undoStack()->undo();
  EXPECT_EQ(test::seedOf(document), 1);
  document.undoStack()->undo();
  EXPECT_FALSE(document.source());
  EXPECT_FALSE(document.dirty());
  document.undoStack()->redo();
  document.undoStack()->redo();
  EXPECT_EQ(test::seedOf(document), 5);
  EXPECT_EQ(source.size(), 5);
  EXPECT_EQ(choices.size(), 5) << "the other part begins with settings of its own";
}

TEST(Document, AnEditThatChangesNothingIsNone) {
  Document document;
  document.openPart(test::boxPart(), {}, true);
  document.setScale("1");
  document.setParameter("voxelMm", "0.8"); // the default
  document.resetParameters();
  EXPECT_EQ(document.undoStack()->count(), 1);
}

TEST(Document, AParameterAtItsDefaultIsUnchanged) {
  Document document;
  document.setParameter("voxelMm", "1.50");
  EXPECT_EQ(document.choices().item().parameters.at("voxelMm"), "1.5");
  document.setParameter("voxelMm", "0.80");
  EXPECT_TRUE(document.choices().item().parameters.empty());
}

TEST(Document, ParametersAreSetAsOnTheCommandLine) {
  const base::ParameterTable table = parametersFor(Document().choices());
  for (const base::ParameterSpec& spec : table.specs()) {
    const std::string text = test::otherText(spec);
    Document document;
    document.setParameter(QString::fromStdString(spec.key), QString::fromStdString(text));
    project::Choices typed = Document().choices();
    pipeline::setParameters(typed, {spec.key + "=" + text});
    EXPECT_EQ(document.choices().parameters, typed.parameters) << spec.key;
    EXPECT_EQ(document.choices().item().parameters, typed.item().parameters) << spec.key;
  }
}

TEST(Document, AFileOfCurvesIsReadWhereItsNameIsTyped) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "curves.txt", "0,0 10,0");
  Document document;
  document.setParameter("fibreCurves", QString::fromStdString((folder / "curves.txt").string()));
  EXPECT_EQ(document.choices().parameters.at("fibreCurves"), "0,0 10,0");
}

// A process of which the filament is retracted 2 mm before travels.
project::Choices retracting(project::Choices choices) {
  std::string text = base::readFile(base::resourceFolder() / "processes" / "fdm-1.0.json");
  text.insert(text.find('{') + 1, "\"retractMm\": 2, ");
  choices.tool().process = text;
  return choices;
}

double retractionOf(const Document& document) {
  const project::Choices& choices = document.choices();
  return pipeline::chosenProcess(choices, pipeline::parameterValues(choices)).retractMm;
}

TEST(Document, DefaultsAreThoseOfTheProcess) {
  Document document;
  document.setChoices(retracting(document.choices()), "Change process");
  const base::ParameterTable table = parametersFor(document.choices());
  const base::ParameterTable core = pipeline::parametersOf(document.choices());
  ASSERT_NE(table.find("retractMm"), nullptr);
  EXPECT_EQ(std::get<double>(table.find("retractMm")->defaultValue), 2.0);
  for (const char* key : {"layerHeightMm", "beadWidthMm", "stepMm", "cuspMm", "primeLengthMm"})
    EXPECT_EQ(table.find(key)->defaultValue, core.find(key)->defaultValue) << key;
}

TEST(Document, RetractionOfAProcessCanBeSetToZero) {
  Document document;
  document.setChoices(retracting(document.choices()), "Change process");
  EXPECT_EQ(retractionOf(document), 2.0);
  document.setParameter("retractMm", "0");
  EXPECT_EQ(document.choices().parameters.at("retractMm"), "0");
  EXPECT_EQ(retractionOf(document), 0.0);
  document.setParameter("retractMm", "2");
  EXPECT_TRUE(document.choices().item().parameters.empty()) << "the process's own value";
}

TEST(Document, WrongParametersChangeNothing) {
  Document document;
  EXPECT_THROW(document.setParameter("voxelMn", "1"), base::Error);
  EXPECT_THROW(document.setParameter("voxelMm", "-3"), base::Error);
  EXPECT_FALSE(document.dirty());
}

TEST(Document, DirtyIsTheUndoStackNotBeingWhereItWasSaved) {
  Document document;
  QSignalSpy dirty(&document, &Document::dirtyChanged), settled(&document, &Document::settled);
  document.openPart(test::boxPart(), {}, true);
  EXPECT_TRUE(document.dirty());
  document.saved("/tmp/a.voluta", document.revision(), document.snapshot());
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(document.name(), "a");
  EXPECT_EQ(settled.size(), 1);
  test::setSeed(document, 5);
  EXPECT_TRUE(document.dirty());
  document.undoStack()->undo();
  EXPECT_FALSE(document.dirty());
  EXPECT_EQ(dirty.size(), 4);
}

TEST(Document, EditsDuringASaveStayUnsaved) {
  Document document;
  document.openPart(test::boxPart(), {}, true);
  const std::uint64_t revision = document.revision();
  test::setSeed(document, 5);
  document.saved("/tmp/a.voluta", revision, document.snapshot());
  EXPECT_TRUE(document.dirty());
  EXPECT_EQ(document.projectFile(), "/tmp/a.voluta");
}

TEST(Document, APartOpenedInASavedProjectBeginsAProjectOfItsOwn) {
  Document document;
  document.openPart(test::boxPart(), {}, true);
  document.setParameter("voxelMm", "1.5");
  document.setScale("0.5");
  document.saved("/tmp/a.voluta", document.revision(), document.snapshot());
  QSignalSpy edited(&document, &Document::edited);
  document.openPart(test::boxPart(5.0, "other.stl"), "/tmp/other.stl", true);
  EXPECT_TRUE(document.projectFile().isEmpty()) << "a save would overwrite it";
  EXPECT_EQ(document.name(), "other");
  EXPECT_TRUE(document.dirty());
  EXPECT_FALSE(document.undoStack()->canUndo());
  EXPECT_TRUE(document.choices().item().parameters.empty()) << "those of the part before";
  EXPECT_EQ(document.choices().item().scale, "1");
  EXPECT_EQ(edited.size(), 1) << "the part is to be laid";
}

TEST(Document, TheNextPartKeepsTheWorkshopAndNoSettings) {
  Document document;
  project::Choices start;
  start.item().automatic = true;
  document.startWith(start);
  project::Choices own = document.choices();
  own.item().parameters["walls"] = "5";
  document.setChoices(own, "before any part"); // meant for the part to come
  document.openPart(test::boxPart(), "/tmp/box.stl", true);
  EXPECT_EQ(document.choices().item().parameters.at("walls"), "5");
  own.tool().process = "fdm-0.35";
  own.formats = {"csv"};
  own.cell = "ur10-moving";
  document.setChoices(own, "own");
  document.openPart(test::boxPart(5.0, "other.stl"), "/tmp/other.stl", true);
  EXPECT_TRUE(document.choices().item().parameters.empty());
  EXPECT_TRUE(document.choices().item().automatic);
  EXPECT_EQ(document.choices().cell, "ur10-moving");
  EXPECT_EQ(document.choices().tool().process, "fdm-0.35");
  EXPECT_EQ(document.choices().formats, std::vector<std::string>{"csv"});
  // The cell of a lathe came along with the way of building.
  project::Choices lathe = document.choices();
  lathe.item().automatic = false;
  lathe.item().mode = "lathe";
  lathe.cell = "lathe";
  lathe.item().platform = project::Platform("rod:5x200");
  document.setChoices(lathe, "lathe");
  document.openPart(test::boxPart(6.0, "third.stl"), "/tmp/third.stl", true);
  EXPECT_EQ(document.choices().cell, start.cell);
  EXPECT_TRUE(document.choices().item().automatic);
  // The same file read again is the same part.
  document.setParameter("walls", "1");
  document.openPart(test::boxPart(7.0, "third.stl"), "/tmp/third.stl", true);
  EXPECT_EQ(document.choices().item().parameters.at("walls"), "1");
}

TEST(Document, UnsavedWorkIsMoreThanAnOpenedPart) {
  Document document;
  EXPECT_FALSE(document.hasUnsavedWork());
  document.openPart(test::boxPart(), {}, true);
  EXPECT_TRUE(document.dirty());
  EXPECT_FALSE(document.hasUnsavedWork());
  test::setSeed(document, 5);
  EXPECT_TRUE(document.hasUnsavedWork());
  document.saved("/tmp/a.voluta", document.revision(), document.snapshot());
  EXPECT_FALSE(document.hasUnsavedWork());
  document.undoStack()->undo();
  EXPECT_TRUE(document.hasUnsavedWork());
}

TEST(Document, SettingsMadeBeforeAPartAreKeptAndNotUnsavedWork) {
  Document document;
  document.setParameter("walls", "5");
  EXPECT_TRUE(document.dirty());
  EXPECT_FALSE(document.hasUnsavedWork());
  document.openPart(test::boxPart(), "/tmp/box.stl", true);
  EXPECT_EQ(document.choices().item().parameters.at("walls"), "5");
}

TEST(Document, SettingsThatAnotherPartWouldTakeAwayAreUnsavedWork) {
  Document document;
  project::Choices start;
  start.item().automatic = true;
  document.startWith(start);
  document.setParameter("walls", "5"); // meant for the part to come
  document.openPart(test::boxPart(), "/tmp/box.stl", true);
  EXPECT_TRUE(document.hasUnsavedWork());
  document.openPart(test::boxPart(5.0, "other.stl"), "/tmp/other.stl", true);
  EXPECT_FALSE(document.hasUnsavedWork());
}

TEST(Document, ACellThatCannotBeReadStaysForTheNextPart) {
  Document document;
  project::Choices start;
  start.item().automatic = true;
  document.startWith(start);
  document.openPart(test::boxPart(), "/tmp/box.stl", true);
  project::Choices own = document.choices();
  own.cell = "a-cell-that-is-not-there";
  own.formats = {"csv"};
  document.setChoices(own, "own");
  document.openPart(test::boxPart(5.0, "other.stl"), "/tmp/other.stl", true);
  EXPECT_EQ(document.choices().cell, own.cell);
  EXPECT_EQ(document.choices().formats, own.formats);
  EXPECT_NE(document.unusable(), nullptr);
}

TEST(Document, TheRepairedPartReachesEveryEdit) {
  Document document;
  const auto asRead = test::boxPart(), repaired = test::boxPart();
  document.openPart(asRead, {}, false);
  EXPECT_FALSE(document.sourceReady());
  document.undoStack()->undo();
  document.replaceSource(asRead, repaired);
  EXPECT_FALSE(document.source());
  document.undoStack()->redo();
  EXPECT_EQ(document.source(), repaired);
  EXPECT_TRUE(document.sourceReady());
}

// Joint values for another maker's arm are left out with the cell that they were chosen for; undo
// brings both back.
TEST(Document, AnotherCellLeavesOutFormatsThatItCannotBeWrittenIn) {
  Document document;
  document.openPart(test::boxPart(), {}, true);
  project::Choices choices = document.choices();
  choices.item().mode = "flat";
  choices.cell = "ur5-moving";
  choices.formats = {"urscript", "urscript-stream", "csv"};
  document.setChoices(choices, "formats");
  choices = document.choices();
  choices.cell = "irb1200-moving";
  document.setChoices(choices, "cell");
  EXPECT_EQ(document.choices().formats, (std::vector<std::string>{"urscript", "csv"}));
  document.undoStack()->undo();
  EXPECT_EQ(document.choices().formats.size(), 3u);
  choices.formats = {"urscript-stream"};
  document.setChoices(choices, "cell");
  EXPECT_TRUE(document.choices().formats.empty()) << "those of the cell";
}

} // namespace
} // namespace voluta::document
