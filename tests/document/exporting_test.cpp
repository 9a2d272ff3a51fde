#include "document/exporting.h"
#include "pipeline/checked_program.h"

#include "document/parts.h"
#include "document/planning.h"
#include "pipeline/proof.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <gtest/gtest.h>

namespace voluta::document {
namespace {

class ExportingTest : public testing::Test {
protected:
  void SetUp() override {
    document_.openPart(test::boxPart(), {}, true);
    project::Choices choices = document_.choices();
    choices.formats = {"urscript", "gcode-extended", "csv"};
    document_.setChoices(choices, "formats");
    QSignalSpy finished(&planning_, &Planning::finished);
    planning_.plan();
    ASSERT_TRUE(finished.wait(120000));
    plan_ = document_.result(project::Stage::Replay);
    ASSERT_FALSE(plan_->checked.empty());
  }
  pipeline::Programs programs(const std::vector<std::string>& formats) const {
    return pipeline::chosenPrograms(*plan_, formats, true);
  }
  void write(const pipeline::Programs& programs, const QString& folder) {
    QSignalSpy written(&exporting_, &Exporting::written);
    exporting_.write(folder, plan_, programs);
    ASSERT_TRUE(written.wait(10000));
  }
  QByteArray contents(const QString& name) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(name);
    return file.readAll();
  }

  QTemporaryDir folder_;
  Document document_;
  Planning planning_{document_};
  Exporting exporting_;
  std::shared_ptr<const pipeline::PlanResult> plan_;
};

TEST_F(ExportingTest, LeavesTheProgramsAndAReportOfThemAndNothingElse) {
  const pipeline::Programs csv = programs({"csv"});
  ASSERT_EQ(csv.size(), 1u);
  write(csv, folder_.filePath("out"));
  const QString program =
      QString::fromStdString(pipeline::writtenName(*csv[0], csv[0]->program.files[0]));
  QStringList expected{"pedestal.dxf", "pedestal.stl", "report.json", program};
  for (const std::string& proof : pipeline::proofNames(*plan_, csv))
    expected << QString::fromStdString(proof);
  expected.sort();
  QStringList there = QDir(folder_.filePath("out")).entryList(QDir::Files | QDir::Hidden);
  there.sort();
  EXPECT_EQ(there, expected) << "the platform is made for the part";
  EXPECT_EQ(contents("out/" + program).toStdString(), csv[0]->program.files[0].text);
  const QByteArray report = contents("out/report.json");
  EXPECT_TRUE(report.contains("\"csv\""));
  EXPECT_FALSE(report.contains("\"gcode-extended\"")) << "it is not beside it";
}

TEST_F(ExportingTest, NamesTheFilesItWouldReplace) {
  const pipeline::Programs csv = programs({"csv"});
  EXPECT_TRUE(Exporting::conflictingFiles(folder_.path(), *plan_, csv).isEmpty());
  write(csv, folder_.path());
  const QStringList names = Exporting::conflictingFiles(folder_.path(), *plan_, csv);
  const std::vector<std::string> proofs = pipeline::proofNames(*plan_, csv);
  EXPECT_EQ(names.size(), 4 + static_cast<qsizetype>(proofs.size()));
  EXPECT_TRUE(names.contains("report.json"));
  EXPECT_EQ(names.front().toStdString(),
            pipeline::writtenName(*csv.front(), csv.front()->program.files.front()))
      << "what would run on a robot";
  QStringList shared{"pedestal.dxf", "pedestal.stl"};
  if (!proofs.empty()) // the mesh of the part as printed is of the plan
    shared << QString::fromStdString(proofs.back());
  EXPECT_EQ(Exporting::conflictingFiles(folder_.path(), *plan_, programs({"gcode-extended"})),
            shared << "report.json");
}

TEST_F(ExportingTest, FailureToCreateAFolderIsSignalled) {
  QFile file(folder_.filePath("file"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  QSignalSpy failed(&exporting_, &Exporting::failed);
  exporting_.write(folder_.filePath("file/under"), plan_, programs({"csv"}));
  ASSERT_TRUE(failed.wait(10000));
  EXPECT_FALSE(failed[0][0].toString().contains('\n'));
}

} // namespace
} // namespace voluta::document
