// Events before layers on the pages Simulate and Layers.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "timeline/scrub_slider.h"
#include "timeline/timeline_bar.h"
#include "window/layer_event_dialog.h"
#include "window/presenters/presenter.h"

#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QUndoStack>

namespace voluta::test {
namespace {

using project::Stage;

class EventMarksTest : public WindowTest {
protected:
  timeline::TimelineBar* bar() { return find<timeline::TimelineBar>("timeline"); }
  timeline::ScrubSlider* slider() { return find<timeline::ScrubSlider>("scrubSlider"); }
  std::string setting(const char* key) {
    const auto& all = document().choices().item().parameters;
    const auto at = all.find(key);
    return at == all.end() ? std::string() : at->second;
  }
  window::LayerEventDialog* dialog() {
    window::LayerEventDialog* shown = nullptr;
    EXPECT_TRUE(waitFor(
        [&] {
          shown = window().findChild<window::LayerEventDialog*>();
          return shown && shown->isVisible();
        },
        10000));
    return shown;
  }
  void chooseKind(const char* kind) {
    auto* combo = find<QComboBox>("eventKind");
    combo->setCurrentIndex(combo->findData(QString(kind)));
  }
  void planPlinth() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {24, 18, 6})));
    chooseFlat();
    clickToolBar("plan");
    ASSERT_TRUE(planned(Stage::Replay));
  }
};

TEST_F(EventMarksTest, EventsAreAddedAtTheShownLayerAndMarkedAfterThePlan) {
  planPlinth();
  choosePage(Page::Simulate);
  EXPECT_TRUE(bar()->events().empty());
  bar()->setTimeS(0.5 * bar()->clock()->durationS());
  const int layer = bar()->clock()->layerAt(bar()->timeS()) + 1;
  ASSERT_GT(layer, 1);
  const std::string at = std::to_string(layer);
  // The button asks for the event.
  QTest::mouseClick(find<QPushButton>("simulateAddEvent"), Qt::LeftButton);
  auto* box = dialog();
  ASSERT_NE(box, nullptr);
  QTest::keyClicks(find<QLineEdit>("eventText"), "Put in the nut");
  keepPicture(*box, "event_dialog");
  QTest::mouseClick(find<QPushButton>("eventOk"), Qt::LeftButton);
  EXPECT_EQ(setting("layerEvents"), at + " pause Put in the nut");
  ASSERT_TRUE(waitFor([&] { return !window().findChild<window::LayerEventDialog*>(); }, 10000));
  // One on the page Layers too, behind the first; an incomplete one is refused there.
  choosePage(Page::Layers);
  QTest::mouseClick(find<QPushButton>("layersAddEvent"), Qt::LeftButton);
  box = dialog();
  ASSERT_NE(box, nullptr);
  chooseKind("statement");
  QTest::mouseClick(find<QPushButton>("eventOk"), Qt::LeftButton);
  EXPECT_TRUE(find<QLabel>("eventProblem")->isVisible());
  keepPicture(*box, "event_problem");
  chooseKind("output");
  QTest::mouseClick(find<QPushButton>("eventOk"), Qt::LeftButton);
  const std::string both = setting("layerEvents");
  EXPECT_EQ(both.substr(0, both.find(';')), at + " pause Put in the nut");
  EXPECT_NE(both.find(" output 0 on"), std::string::npos);
  document().undoStack()->undo();
  EXPECT_EQ(setting("layerEvents"), at + " pause Put in the nut");
  // The plan has them as marks; a click on one jumps there.
  document().setParameter("layerEvents",
                          QString::fromStdString("2 output 3 on; " + at + " pause Put in the nut"));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  choosePage(Page::Simulate);
  ASSERT_TRUE(waitFor([&] { return bar()->events().size() == 2; }, 20000));
  EXPECT_TRUE(bar()->events()[0].text.contains("layer 2: Output 3 on"))
      << bar()->events()[0].text.toStdString();
  EXPECT_TRUE(bar()->events()[1].text.contains("Put in the nut"));
  const double timeS = bar()->events()[1].timeS;
  EXPECT_EQ(bar()->clock()->layerAt(timeS) + 2, layer) << "behind the layer before";
  picture();
  keepPicture(window(), "event_marks");
  const int x =
      8 + static_cast<int>(timeS / bar()->clock()->durationS() * (slider()->width() - 16));
  QTest::mouseClick(slider(), Qt::LeftButton, {}, {x + 2, slider()->height() / 2});
  EXPECT_NEAR(bar()->timeS(), timeS, 1e-6);
}

// A photo has its output and its pulse; an output that the format lacks is named while it is typed.
TEST_F(EventMarksTest, AnOutputThatTheFormatLacksIsNamedWhileItIsTyped) {
  planPlinth();
  choosePage(Page::Simulate);
  bar()->setTimeS(0.5 * bar()->clock()->durationS());
  QTest::mouseClick(find<QPushButton>("simulateAddEvent"), Qt::LeftButton);
  auto* box = dialog();
  ASSERT_NE(box, nullptr);
  chooseKind("photo");
  EXPECT_FALSE(find<QWidget>("eventSeconds")->isVisible());
  EXPECT_TRUE(find<QWidget>("eventPulse")->isVisible());
  const auto type = [&](const char* number) {
    auto* output = find<QSpinBox>("eventOutput");
    output->setFocus();
    output->selectAll();
    QTest::keyClicks(output, number);
  };
  type("4000");
  const auto* problem = find<QLabel>("eventProblem");
  EXPECT_TRUE(problem->isVisible());
  EXPECT_TRUE(problem->text().contains("4,000")) << problem->text().toStdString();
  keepPicture(*box, "event_photo_problem");
  type("4");
  EXPECT_FALSE(problem->isVisible()) << problem->text().toStdString();
  keepPicture(*box, "event_photo");
  chooseKind("statement");
  EXPECT_FALSE(problem->isVisible()) << "nothing is typed yet";
  QTest::keyClicks(find<QLineEdit>("eventStatement"), "movej(p)");
  EXPECT_TRUE(problem->isVisible());
  chooseKind("photo");
  EXPECT_FALSE(problem->isVisible());
  QTest::mouseClick(find<QPushButton>("eventOk"), Qt::LeftButton);
  EXPECT_TRUE(setting("layerEvents").ends_with(" photo 4 0.5")) << setting("layerEvents");
}

TEST_F(EventMarksTest, TheMenuOfTheTimeLinePausesThere) {
  planPlinth();
  choosePage(Page::Simulate);
  const auto choose = [&](const char* name) {
    const QPoint place(7 * slider()->width() / 16, slider()->height() / 2); // of 8 layers
    QContextMenuEvent asks(QContextMenuEvent::Mouse, place, slider()->mapToGlobal(place));
    QApplication::sendEvent(slider(), &asks);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    ASSERT_NE(menu, nullptr);
    keepPicture(*menu, "event_menu");
    auto* action = menu->findChild<QAction*>(name);
    ASSERT_NE(action, nullptr);
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
  };
  choose("pauseHere");
  const int layer = bar()->clock()->layerAt(bar()->timeS()) + 1;
  EXPECT_EQ(setting("pauseLayers"), std::to_string(layer));
  choose("pauseHere");
  EXPECT_EQ(setting("pauseLayers"), "");
  document().undoStack()->undo();
  EXPECT_EQ(setting("pauseLayers"), std::to_string(layer));
}

} // namespace
} // namespace voluta::test
