#include "forms/choices_form.h"
#include "forms/parameter_form.h"
#include "forms/parameter_row.h"
#include "forms/platform_editor.h"
#include "forms/value_boxes.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSpinBox>
#include <QStatusTipEvent>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <gtest/gtest.h>

using namespace voluta;

namespace {
base::ParameterTable table() {
  std::vector<base::ParameterSpec> specs{
      base::numberParameter("height", "mm", 0.8, 0.05, 10.0, "Layers"_text, "layer height"_text,
                            "Wanted height."_text, true),
      base::integerParameter("walls", 2, 0, 20, "Beads"_text, "walls"_text,
                             "Beads at the edge."_text, true),
      base::numberParameter("density", "share", 1.0, 0.0, 1.0, "Beads"_text, "density"_text,
                            "Share that is filled."_text, true),
      base::choiceParameter("infill", "zigzag",
                            {{"zigzag", "zigzag"_text}, {"concentric", "concentric"_text}},
                            "Beads"_text, "infill"_text, "How it is filled."_text, true),
      base::booleanParameter("debug", false, "Output"_text, "write all"_text,
                             "For those who look inside."_text),
  };
  for (int i = 0; i < 30; ++i)
    specs.push_back(base::numberParameter("extra" + std::to_string(i), "mm", 1.0, 0.0, 5.0,
                                          "More"_text, "extra"_text, "One more."_text));
  return base::ParameterTable(specs);
}

class ParameterFormTest : public testing::Test {
protected:
  ParameterFormTest() : form(table()), changes(&form, &forms::ParameterForm::changed) {
    form.resize(300, 400);
    form.show();
    (void)QTest::qWaitForWindowExposed(&form);
  }

  forms::ParameterRow* row(const char* key) {
    return form.findChild<forms::ParameterRow*>(QLatin1String(key));
  }
  template <class Box> Box* editor(const char* key) {
    return qobject_cast<Box*>(row(key)->editor());
  }
  QToolButton* reset(const char* key) {
    return row(key)->findChild<QToolButton*>(QStringLiteral("reset"));
  }
  void type(QWidget* box, const QString& text) {
    box->setFocus();
    QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(box, text);
  }

  forms::ParameterForm form;
  QSignalSpy changes;
};
} // namespace

TEST_F(ParameterFormTest, TypingIsCommittedOnceByEnterAndNotByKeystrokes) {
  auto* box = editor<forms::NumberBox>("height");
  type(box, "1.25");
  EXPECT_EQ(changes.size(), 0);
  QTest::keyClick(box, Qt::Key_Return);
  ASSERT_EQ(changes.size(), 1);
  EXPECT_EQ(changes[0][0].toString(), "height");
  EXPECT_EQ(changes[0][1].toString(), "1.25");
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(changes.size(), 1);
}

// Statements of the status line that a box sends.
class StatusTips : public QObject {
public:
  QStringList texts;

  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::StatusTip)
      texts << static_cast<QStatusTipEvent*>(event)->tip();
    return false;
  }
};

TEST_F(ParameterFormTest, AShareIsTypedInPercent) {
  auto* box = editor<forms::NumberBox>("density");
  EXPECT_EQ(box->text(), QStringLiteral("100\u00a0%"));
  for (const auto& [typed, stored] : {std::pair("20", 0.2), std::pair("15", 0.15),
                                      std::pair("0", 0.0), std::pair("7.5", 0.075)}) {
    type(box, typed);
    QTest::keyClick(box, Qt::Key_Return);
    ASSERT_GT(changes.size(), 0);
    EXPECT_DOUBLE_EQ(changes.last()[1].toString().toDouble(), stored) << typed;
    EXPECT_DOUBLE_EQ(box->value(), 100.0 * stored) << typed;
  }
}

TEST_F(ParameterFormTest, RejectedInputShowsAStatusTip) {
  for (const char* key : {"density", "walls"}) {
    auto* box = qobject_cast<QAbstractSpinBox*>(row(key)->editor());
    StatusTips tips;
    box->installEventFilter(&tips);
    type(box, "3");
    QTest::keyClick(box, Qt::Key_Return);
    EXPECT_TRUE(tips.texts.isEmpty()) << tips.texts.join(' ').toStdString();
    type(box, "3x");
    EXPECT_EQ(tips.texts.size(), 1);
    QTest::keyClick(box, Qt::Key_Return);
    tips.texts.clear();
    type(box, "200"); // beyond the range
    QTest::keyClick(box, Qt::Key_Return);
    ASSERT_EQ(tips.texts.size(), 1);
    EXPECT_TRUE(tips.texts[0].contains("200 is not possible")) << tips.texts[0].toStdString();
    box->removeEventFilter(&tips);
  }
  EXPECT_DOUBLE_EQ(editor<forms::NumberBox>("density")->value(), 100.0);
  EXPECT_EQ(editor<QSpinBox>("walls")->value(), 20);
}

TEST_F(ParameterFormTest, ACommaIsADecimalPoint) {
  auto* height = editor<forms::NumberBox>("height");
  type(height, "0,6");
  QTest::keyClick(height, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(height->value(), 0.6);
  auto* walls = editor<QSpinBox>("walls");
  for (const char* typed : {"3,4", "3.4"}) {
    walls->setValue(1);
    type(walls, typed);
    QTest::keyClick(walls, Qt::Key_Return);
    EXPECT_EQ(walls->value(), 3) << typed;
  }
}

TEST_F(ParameterFormTest, ABoxWithoutANumberKeepsItsValue) {
  for (const char* key : {"height", "walls"}) {
    auto* box = qobject_cast<QAbstractSpinBox*>(row(key)->editor());
    const QString before = box->text();
    type(box, "");
    QTest::keyClick(box, Qt::Key_Delete);
    QTest::keyClick(box, Qt::Key_Return);
    EXPECT_EQ(box->text(), before) << key;
  }
  EXPECT_EQ(changes.size(), 0);
}

TEST_F(ParameterFormTest, StepAndChoiceAndCheckBoxCommitAtOnce) {
  auto* walls = editor<QSpinBox>("walls");
  QTest::keyClick(walls, Qt::Key_Up);
  auto* infill = editor<QComboBox>("infill");
  QTest::keyClick(infill, Qt::Key_Down);
  form.setShowAll(true);
  editor<QCheckBox>("debug")->click();
  ASSERT_EQ(changes.size(), 3);
  EXPECT_EQ(changes[0][1].toString(), "3");
  EXPECT_EQ(changes[1][1].toString(), "concentric");
  EXPECT_EQ(changes[2][1].toString(), "true");
}

TEST_F(ParameterFormTest, EveryEmittedTextIsOneThatTheTableTakes) {
  auto* box = editor<forms::NumberBox>("height");
  for (const char* typed : {"3", "0.0001", "99999", "0.123456"}) {
    type(box, typed);
    QTest::keyClick(box, Qt::Key_Return);
  }
  ASSERT_GT(changes.size(), 0);
  for (const auto& change : changes)
    EXPECT_NO_THROW(
        base::parseParameter(*table().find("height"), change[1].toString().toStdString()))
        << qPrintable(change[1].toString());
}

TEST_F(ParameterFormTest, SetValuesEmitsNothingMarksAndUnmarks) {
  form.setValues({{"height", "0.6"}, {"walls", "many"}, {"nobody", "1"}});
  EXPECT_EQ(changes.size(), 0);
  EXPECT_DOUBLE_EQ(editor<forms::NumberBox>("height")->value(), 0.6);
  EXPECT_TRUE(row("height")->isChanged());
  EXPECT_TRUE(reset("height")->isVisible());
  EXPECT_TRUE(row("height")->findChild<QLabel*>()->text().contains("<b>"));
  EXPECT_EQ(editor<QSpinBox>("walls")->value(), 2);
  EXPECT_FALSE(row("walls")->isChanged());
  form.setValues({});
  EXPECT_FALSE(row("height")->isChanged());
  EXPECT_FALSE(reset("height")->isVisible());
  EXPECT_EQ(changes.size(), 0);
}

TEST_F(ParameterFormTest, AValueFinerThanTheBoxShowsStaysAsItIs) {
  form.setValues({{"height", "0.123456789"}});
  auto* box = editor<forms::NumberBox>("height");
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Return);
  form.setFocus();
  EXPECT_EQ(changes.size(), 0);
}

TEST_F(ParameterFormTest, ResetOfOneAndOfAll) {
  form.setValues({{"height", "0.6"}, {"walls", "5"}});
  QSignalSpy one(&form, &forms::ParameterForm::resetRequested);
  QSignalSpy all(&form, &forms::ParameterForm::resetAllRequested);
  reset("height")->click();
  ASSERT_EQ(one.size(), 1);
  EXPECT_EQ(one[0][0].toString(), "height");
  EXPECT_DOUBLE_EQ(editor<forms::NumberBox>("height")->value(), 0.8);
  auto* resetAll = form.findChild<QToolButton*>(QStringLiteral("resetAll"));
  EXPECT_TRUE(resetAll->isEnabled());
  resetAll->click();
  EXPECT_EQ(all.size(), 1);
  EXPECT_EQ(editor<QSpinBox>("walls")->value(), 2);
  EXPECT_FALSE(resetAll->isEnabled());
  EXPECT_EQ(changes.size(), 0);
}

TEST_F(ParameterFormTest, SimpleShowsSimpleAndChangedOnes) {
  EXPECT_TRUE(row("height")->isVisible());
  EXPECT_FALSE(row("debug")->isVisible());
  form.setValues({{"debug", "true"}});
  EXPECT_TRUE(row("debug")->isVisible());
  form.setValues({});
  EXPECT_FALSE(row("debug")->isVisible());
  form.setShowAll(true);
  EXPECT_TRUE(row("debug")->isVisible());
}

TEST_F(ParameterFormTest, ParametersWithoutEffectAreHidden) {
  form.setValues({{"walls", "5"}});
  form.setApplying({"height", "debug"});
  EXPECT_TRUE(row("height")->isVisible());
  EXPECT_FALSE(row("walls")->isVisible()) << "changed, but for nothing";
  form.setShowAll(true);
  EXPECT_TRUE(row("debug")->isVisible());
  EXPECT_FALSE(row("walls")->isVisible());
  EXPECT_FALSE(form.findChild<QWidget*>(QStringLiteral("Beads"))->isVisible());
  form.setApplying({"height", "walls", "infill"});
  EXPECT_TRUE(row("walls")->isVisible());
}

TEST_F(ParameterFormTest, ProblemIsShownUnderItsRowUntilItIsResolved) {
  form.setProblems({{"debug", "Out of paper."}});
  EXPECT_TRUE(row("debug")->isVisible());
  const auto says = [&] {
    for (const QLabel* label : row("debug")->findChildren<QLabel*>())
      if (label->isVisible() && label->text() == "Out of paper.")
        return true;
    return false;
  };
  EXPECT_TRUE(says());
  form.setProblems({});
  EXPECT_FALSE(says());
  EXPECT_FALSE(row("debug")->isVisible());
}

TEST_F(ParameterFormTest, SearchFiltersAsOneTypesOverLabelKeyAndHelp) {
  auto* search = form.findChild<QLineEdit*>(QStringLiteral("search"));
  QTest::keyClicks(search, "LOOK ins");
  EXPECT_TRUE(row("debug")->isVisible());
  EXPECT_FALSE(row("height")->isVisible());
  search->setText("heig");
  EXPECT_TRUE(row("height")->isVisible());
  EXPECT_TRUE(row("height")->findChild<QLabel*>()->text().contains("background-color"));
  EXPECT_FALSE(row("walls")->isVisible());
  search->clear();
  EXPECT_TRUE(row("walls")->isVisible());
  EXPECT_FALSE(row("height")->findChild<QLabel*>()->text().contains("background-color"));
}

TEST_F(ParameterFormTest, WheelOverAnUnfocusedBoxScrollsTheFormInstead) {
  form.setShowAll(true);
  QTest::qWait(20);
  auto* scroll = form.findChild<QScrollArea*>();
  ASSERT_GT(scroll->verticalScrollBar()->maximum(), 0);
  form.findChild<QLineEdit*>(QStringLiteral("search"))->setFocus();
  auto* box = editor<forms::NumberBox>("height");
  const auto wheel = [&] {
    const QPointF at(5, 5);
    QWheelEvent event(at, box->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    // An event of the program's own would not be handed on to the widgets around the box.
    QSpontaneKeyEvent::setSpontaneous(&event);
    qApp->notify(box, &event);
  };
  wheel();
  EXPECT_DOUBLE_EQ(box->value(), 0.8);
  EXPECT_GT(scroll->verticalScrollBar()->value(), 0);
  form.activateWindow();
  box->setFocus();
  if (box->hasFocus()) {
    wheel();
    EXPECT_LT(box->value(), 0.8);
  }
}

TEST_F(ParameterFormTest, NothingIsWiderThanANarrowPanel) {
  form.setShowAll(true);
  form.setValues({{"height", "0.6"}});
  QTest::qWait(20);
  EXPECT_LE(form.minimumSizeHint().width(), 300);
  auto* scroll = form.findChild<QScrollArea*>();
  EXPECT_LE(scroll->widget()->minimumSizeHint().width(), scroll->viewport()->width());
}

TEST(PlatformEditor, TextRoundTrips) {
  forms::PlatformEditor editor;
  QSignalSpy changed(&editor, &forms::PlatformEditor::changed);
  for (const char* text : {"fit:0", "fit:2.5", "disc:120", "rect:200x80.25", "rod:5x200",
                           "mesh:/some where/half:cylinder.stl"}) {
    editor.setText(text);
    EXPECT_EQ(editor.text(), text);
  }
  editor.setText("fit");
  EXPECT_EQ(editor.text(), "fit:0");
  editor.setText("hexagon:3");
  editor.setText("rect:12");
  editor.setText("rod:5");
  editor.setText("mesh:");
  EXPECT_EQ(editor.text(), "fit:0");
  EXPECT_EQ(changed.size(), 0);
  auto* kind = editor.findChild<QComboBox*>("kind");
  kind->setCurrentIndex(kind->findData("rect"));
  ASSERT_EQ(changed.size(), 1);
  EXPECT_EQ(changed[0][0].toString(), "rect:200x200");
}

TEST(PlatformEditor, OffersOnlyPlatformsOfTheMode) {
  forms::PlatformEditor editor;
  editor.setText("disc:90");
  editor.setUses({project::PlatformUse::Rod, project::PlatformUse::Body});
  editor.setText("rod:6x150");
  auto* kind = editor.findChild<QComboBox*>("kind");
  EXPECT_EQ(kind->count(), 3);
  EXPECT_EQ(kind->itemText(0), "Rod of the cell");
  EXPECT_EQ(editor.text(), "rod:6x150");
  // A kind that the mode does not offer is listed only while it is chosen.
  editor.setText("disc:90");
  EXPECT_EQ(kind->count(), 4);
  editor.setUses({project::PlatformUse::Plate});
  EXPECT_EQ(kind->count(), 4);
  EXPECT_EQ(editor.text(), "disc:90");
}

TEST(PlatformEditor, ARodIsRoundHexagonalOrStepped) {
  forms::PlatformEditor editor;
  editor.setUses({project::PlatformUse::Rod, project::PlatformUse::Body});
  editor.setText("rod:6x150");
  std::vector<forms::RodProfile> reported;
  QObject::connect(&editor, &forms::PlatformEditor::profileChanged,
                   [&](const forms::RodProfile& profile) { reported.push_back(profile); });
  auto* shape = editor.findChild<QComboBox*>("rodShape");
  auto* points = editor.findChild<QLineEdit*>("rodPoints");
  EXPECT_FALSE(shape->isHidden());
  EXPECT_TRUE(points->isHidden());
  shape->setCurrentIndex(1);
  ASSERT_EQ(reported.size(), 1u);
  EXPECT_EQ(reported[0], (forms::RodProfile{6, ""}));
  shape->setCurrentIndex(2);
  EXPECT_EQ(reported.size(), 1u) << "without points there is no profile yet";
  EXPECT_FALSE(points->isHidden());
  QTest::keyClicks(points, "-20,2.5 0,2.5 0,3.5 20,3.5");
  QTest::keyClick(points, Qt::Key_Return);
  ASSERT_EQ(reported.size(), 2u);
  EXPECT_EQ(reported[1], (forms::RodProfile{0, "-20,2.5 0,2.5 0,3.5 20,3.5"}));
  editor.setProfile({8, ""});
  EXPECT_EQ(shape->currentText(), "8 sides, across corners");
  EXPECT_EQ(reported.size(), 2u);
  editor.setText("mesh:a.stl");
  EXPECT_TRUE(shape->isHidden());
  EXPECT_EQ(editor.findChild<QToolButton*>("file")->text(), "a.stl");
}

TEST(ChoicesForm, ANoticeHasOneLineAndAButton) {
  forms::ChoicesForm form;
  QSignalSpy pressed(&form, &forms::ChoicesForm::noticePressed);
  auto* line = form.findChild<QLabel*>("notice");
  auto* button = form.findChild<QPushButton*>("noticeButton");
  EXPECT_TRUE(button->isHidden());
  form.setNotice("the cell has no rod", "Use cell lathe", true);
  EXPECT_EQ(line->text(), "the cell has no rod");
  EXPECT_FALSE(button->isHidden());
  button->click();
  EXPECT_EQ(pressed.size(), 1);
  form.setNotice({}, {}, false);
  EXPECT_TRUE(button->isHidden());
}

// The tip shows an entry's own help where it has one, else the folder of own cells.
TEST(ChoicesForm, TooltipNamesTheFolderOfOwnCells) {
  forms::ChoicesForm form;
  forms::ChoiceLists lists;
  lists.modes = {{"curved", "Curved layers", "All around"}, {"planar", "Planar pieces", ""}};
  lists.cells = {{"ur5-fixed", "", ""}, {"lathe", "", "With a rod"}};
  form.setLists(lists);
  form.setTexts({"curved", "auto", "cell", "ur5-fixed", "fdm-1.0"});
  auto* cell = form.findChild<QComboBox*>("cell");
  auto* mode = form.findChild<QComboBox*>("mode");
  const QString own = cell->toolTip();
  EXPECT_TRUE(own.startsWith("Your own cells")) << qPrintable(own);
  EXPECT_TRUE(mode->toolTip().startsWith("All around\n"));
  QTest::keyClick(cell, Qt::Key_Down);
  EXPECT_EQ(cell->toolTip(), "With a rod\n" + own);
  QTest::keyClick(cell, Qt::Key_Up);
  EXPECT_EQ(cell->toolTip(), own);
  form.setTexts({"planar", "auto", "cell", "lathe", "fdm-1.0"});
  EXPECT_EQ(cell->toolTip(), "With a rod\n" + own);
  EXPECT_FALSE(mode->toolTip().isEmpty());
  QEvent another(QEvent::LanguageChange);
  QApplication::sendEvent(&form, &another);
  EXPECT_EQ(cell->toolTip(), "With a rod\n" + own);
}

TEST(ChoicesForm, SignalsFieldAndTextAndNotProgrammaticChanges) {
  forms::ChoicesForm form;
  QSignalSpy changed(&form, &forms::ChoicesForm::changed);
  forms::ChoiceLists lists;
  lists.modes = {{"curved", "Curved layers", ""}, {"planar", "Planar pieces", ""}};
  lists.growths = {{"auto", "", ""}, {"greedy", "", ""}};
  form.setLists(lists);
  form.setTexts({"planar", "greedy", "disc:90", "own-cell", "fdm-1.0", 7});
  EXPECT_EQ(changed.size(), 0);
  const auto combo = [&](const char* name) {
    return form.findChild<QComboBox*>(QLatin1String(name));
  };
  EXPECT_EQ(combo("mode")->currentText(), "Planar pieces");
  EXPECT_EQ(combo("cell")->currentData().toString(), "own-cell");
  QTest::keyClick(combo("mode"), Qt::Key_Up);
  auto* seed = form.findChild<QSpinBox*>(QStringLiteral("seed"));
  QTest::keyClick(seed, Qt::Key_Up);
  ASSERT_EQ(changed.size(), 2);
  EXPECT_EQ(changed[0][0].toString(), "mode");
  EXPECT_EQ(changed[0][1].toString(), "curved");
  EXPECT_EQ(changed[1][0].toString(), "seed");
  EXPECT_EQ(changed[1][1].toString(), "8");
}
