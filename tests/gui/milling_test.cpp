// A part milled from a block in the window: from the menu to the G-code.
#include "base/files.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "window/milling/mill_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTest>

namespace voluta::test {
namespace {

class MillingTest : public WindowTest {
protected:
  window::MillDialog* openDialog() {
    clickMenu("exportMenu", "millPart");
    window::MillDialog* dialog = nullptr;
    waitFor([&] {
      dialog = window().findChild<window::MillDialog*>("millDialog");
      return dialog && dialog->isVisible();
    });
    return dialog;
  }
  static void press(QWidget& in, const char* button) {
    auto* found = in.findChild<QPushButton*>(button);
    ASSERT_NE(found, nullptr) << button;
    ASSERT_TRUE(found->isEnabled()) << button;
    QTest::mouseClick(found, Qt::LeftButton);
  }
  static QString figures(QWidget& in) { return in.findChild<QLabel*>("millFigures")->text(); }
  static void type(QWidget& in, const char* box, double value) {
    auto* field = in.findChild<QDoubleSpinBox*>(box);
    ASSERT_NE(field, nullptr) << box;
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, field->locale().toString(value, 'g', 8));
    QTest::keyClick(field, Qt::Key_Return);
  }
};

TEST_F(MillingTest, FromThePartToTheProgram) {
  openPart(writePart("wedge.stl", box({0, 0, 0}, {6.0, 12.0, 18.0})));
  window::MillDialog* dialog = openDialog();
  ASSERT_NE(dialog, nullptr);
  EXPECT_FALSE(dialog->findChild<QPushButton*>("millSave")->isEnabled());
  auto* material = dialog->findChild<QComboBox*>("millMaterial");
  material->setCurrentIndex(material->findData("soft-plastic"));
  EXPECT_TRUE(dialog->findChild<QLabel*>("millRates")->text().contains("323.85"))
      << dialog->findChild<QLabel*>("millRates")->text().toStdString();
  press(*dialog, "millCompute");
  ASSERT_TRUE(waitFor([&] { return dialog->settled(); }));
  EXPECT_TRUE(figures(*dialog).startsWith("Passed")) << figures(*dialog).toStdString();
  // On its side: 18 x 12 x 6 mm and the block around it.
  EXPECT_TRUE(figures(*dialog).contains("34 × 20 × 8 mm")) << figures(*dialog).toStdString();
  for (const char* lines : {"millShowFineA", "millShowContour", "millShowRapid"})
    dialog->findChild<QCheckBox*>(lines)->setChecked(true);
  keepPicture(*dialog, "milling");
  const QString file = path("wedge.nc");
  answerFileDialog(file);
  press(*dialog, "millSave");
  ASSERT_TRUE(waitFor([&] { return QFile::exists(file); }));
  EXPECT_NE(base::readFile(file.toStdString()).find("S8500 M3"), std::string::npos);

  // A value changes: the program is no longer that of the form.
  type(*dialog, "millCutter", 2.0);
  EXPECT_FALSE(dialog->findChild<QPushButton*>("millSave")->isEnabled());
  type(*dialog, "millAcross", 1.0);
  press(*dialog, "millCompute");
  ASSERT_TRUE(waitFor([&] { return dialog->settled(); }));
  EXPECT_TRUE(figures(*dialog).contains("wider")) << figures(*dialog).toStdString();
  EXPECT_FALSE(dialog->findChild<QPushButton*>("millSave")->isEnabled());
  dialog->close();
}

TEST_F(MillingTest, IsCancelled) {
  openPart(writePart("plate.stl", box({0, 0, 0}, {60.0, 60.0, 20.0})));
  window::MillDialog* dialog = openDialog();
  ASSERT_NE(dialog, nullptr);
  type(*dialog, "millLine", 0.1);
  press(*dialog, "millCompute");
  ASSERT_FALSE(dialog->settled());
  press(*dialog, "millCompute"); // now it cancels
  EXPECT_TRUE(dialog->settled());
  EXPECT_EQ(figures(*dialog), "Cancelled.");
  EXPECT_FALSE(dialog->findChild<QPushButton*>("millSave")->isEnabled());
  dialog->close();
}

} // namespace
} // namespace voluta::test
