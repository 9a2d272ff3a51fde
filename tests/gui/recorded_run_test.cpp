// Compare with a recorded run, on arms of other makers and an imported one: a whole record, one
// that is cut off, and the first millimetres alone.
#include "base/files.h"
#include "base/units.h"
#include "cells/arm_import.h"
#include "forms/icons.h"
#include "gui/cell_fixture.h"
#include "helpers/shapes.h"
#include "robot/cell.h"
#include "robot/urdf_arms.h"

#include <QDialogButtonBox>
#include <QListWidget>
#include <QPushButton>
#include <fmt/format.h>

namespace voluta::test {
namespace {

using project::Stage;
using robot::JointVector;

class RecordedRunTest : public CellWindowTest, public testing::WithParamInterface<const char*> {
protected:
  void SetUp() override {
    CellWindowTest::SetUp();
    if (std::string(GetParam()) == "imported-moving")
      import();
    openPart(writePart("box.stl", box({-6, -6, 0}, {6, 6, 3})));
    project::Choices choices = document().choices();
    choices.cell = GetParam();
    choices.item().automatic = false;
    choices.item().mode = "flat";
    document().setChoices(choices, "job");
    window().planning().plan(Stage::Motion);
    ASSERT_TRUE(planned(Stage::Motion));
  }
  void import() {
    base::writeFile(path("arm.urdf").toStdString(), urdfOf(irb1200()));
    robot::UrdfOptions options;
    options.id = "imported";
    cells::writeImport(cells::importArm(path("arm.urdf").toStdString(), options,
                                        robot::Mount::Flange, process::loadProcess("fdm-1.0"),
                                        base::RunContext{}),
                       base::userDataFolder());
  }
  // The joints of the planned motion at 50 Hz, until that share of its beads is printed.
  QString record(double share) {
    const auto plan = document().result(Stage::Motion);
    const plan::Trajectory& t = *plan->job.trajectory;
    const robot::Cell& cell = *plan->cell;
    const auto jointsAt = [&](std::size_t i) -> JointVector {
      return Eigen::Map<const Eigen::VectorXd>(t.at(i), t.dof);
    };
    std::vector<double> printedMm(t.pointCount(), 0.0);
    for (std::size_t i = 1; i < t.pointCount(); ++i) {
      const double distance = (cell.work_T_tool(jointsAt(i)).translation() -
                               cell.work_T_tool(jointsAt(i - 1)).translation())
                                  .norm();
      printedMm[i] = printedMm[i - 1] + (t.move[i] == plan::MoveKind::Print ? distance : 0.0);
    }
    std::string text = "time_s";
    for (int k = 1; k <= t.dof; ++k)
      text += fmt::format(",j{}_deg", k);
    text += '\n';
    constexpr double kCycleS = 0.02;
    std::size_t i = 1;
    for (double timeS = 0.0; timeS <= t.timeS.back(); timeS += kCycleS) {
      while (i + 1 < t.pointCount() && t.timeS[i] < timeS)
        ++i;
      if (printedMm[i] > share * printedMm.back())
        break;
      const double span = t.timeS[i] - t.timeS[i - 1];
      const double part = span > 0.0 ? std::min(1.0, (timeS - t.timeS[i - 1]) / span) : 1.0;
      const JointVector q = jointsAt(i - 1) + part * (jointsAt(i) - jointsAt(i - 1));
      text += fmt::format("{:.4f}", timeS);
      for (const double value : q)
        text += fmt::format(",{:.6f}", base::radiansToDegrees(value));
      text += '\n';
    }
    const QString file = path(QStringLiteral("run%1.csv").arg(share));
    base::writeFile(file.toStdString(), text);
    return file;
  }
  // By the menu; the sentence that the dialog begins with and its sign.
  struct Reported {
    QString sentence;
    bool isBlocked = false;
  };
  Reported compared(const QString& file, const char* name) {
    answerFileDialog(file);
    clickMenu("runMenu", "compareRun");
    Reported reported;
    auto* dialog = window().findChild<QDialog*>("runDialog");
    EXPECT_NE(dialog, nullptr);
    if (!dialog)
      return reported;
    auto* buttons = dialog->findChild<QDialogButtonBox*>();
    EXPECT_TRUE(waitFor([&] { return buttons->button(QDialogButtonBox::Close) != nullptr; }));
    keepPicture(*dialog, name);
    reported.sentence = dialog->findChild<QLabel*>("runFigures")->text().section('\n', 0, 0);
    const QImage sign = dialog->findChild<QLabel*>("runSign")->pixmap().toImage();
    reported.isBlocked = sign == forms::icon(forms::Icon::Blocked).pixmap(sign.size()).toImage();
    QTest::mouseClick(buttons->button(QDialogButtonBox::Close), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return !window().findChild<QDialog*>("runDialog"); }));
    return reported;
  }
};

TEST_P(RecordedRunTest, LessThanNineTenthsIsIncompleteAndLessThanAHundredthNoRecord) {
  const Reported whole = compared(record(1.0), "run_whole");
  EXPECT_FALSE(whole.isBlocked) << whole.sentence.toStdString();
  const Reported maximum = compared(record(0.95), "run_most");
  EXPECT_FALSE(maximum.isBlocked) << maximum.sentence.toStdString();
  const Reported half = compared(record(0.5), "run_half");
  EXPECT_TRUE(half.isBlocked);
  EXPECT_TRUE(half.sentence.startsWith("Only ") && half.sentence.endsWith("of beads are recorded"))
      << half.sentence.toStdString();
  const Reported begin = compared(record(0.005), "run_begin");
  EXPECT_TRUE(begin.isBlocked);
  EXPECT_TRUE(begin.sentence.startsWith("This is no record of this job"))
      << begin.sentence.toStdString();
}

INSTANTIATE_TEST_SUITE_P(Arms, RecordedRunTest,
                         testing::Values("kr6-r900-moving", "imported-moving"),
                         [](const auto& row) {
                           std::string name = row.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

} // namespace
} // namespace voluta::test
