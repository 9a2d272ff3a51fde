// Menus of the right button on tree, view and findings; the Plan button that becomes Export; the
// summary and the quote.
#include "base/data_files.h"
#include "base/files.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/object_tree.h"
#include "pipeline/plan_result.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/film/film_dialog.h"
#include "window/presenters/presenter.h"
#include "window/quote/quote_dialog.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QToolBar>
#include <QTreeWidget>

namespace voluta::test {
namespace {

using panels::SceneItem;
using project::Stage;

class ObjectMenusTest : public WindowTest {
protected:
  void planFlat() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {24, 18, 6})));
    chooseFlat();
    ASSERT_TRUE(planned(Stage::Load));
    clickToolBar("plan");
    ASSERT_TRUE(planned(Stage::Replay));
  }
  panels::ObjectTree& tree() { return *find<panels::ObjectTree>("tree"); }
  // The menu of a row of the tree.
  QMenu* menuOf(int row) {
    const QTreeWidgetItem* item = tree().topLevelItem(row);
    emit tree().customContextMenuRequested(tree().visualItemRect(item).center());
    return openMenu();
  }
  QMenu* openMenu() {
    QMenu* menu = nullptr;
    EXPECT_TRUE(waitFor(
        [&] { return (menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) != nullptr; },
        5000));
    return menu;
  }
  static QStringList texts(const QMenu* menu) {
    QStringList all;
    for (const QAction* action : menu->actions())
      if (!action->isSeparator())
        all << action->text().remove('&');
    return all;
  }
  // Clicks an entry; false if there is none.
  static bool choose(QMenu* menu, const QString& text) {
    for (QAction* action : menu->actions())
      if (action->text().remove('&') == text) {
        QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
        return true;
      }
    return false;
  }
};

TEST_F(ObjectMenusTest, APartIsHiddenShownAloneSetAndExported) {
  openPart(writePart("plinth.stl", box({0, 0, 0}, {24, 18, 6})));
  QMenu* menu = menuOf(0);
  ASSERT_NE(menu, nullptr);
  const QStringList entries = texts(menu);
  for (const char* wanted : {"Hide", "Show only this", "Settings", "Remove part", "Export…"})
    EXPECT_TRUE(entries.contains(wanted)) << wanted << " in " << entries.join(", ").toStdString();
  keepPicture(window(), "tree_menu");
  ASSERT_TRUE(choose(menu, "Hide"));
  EXPECT_FALSE(tree().isShown(SceneItem::Part));
  ASSERT_TRUE(choose(menuOf(0), "Show"));
  ASSERT_TRUE(choose(menuOf(0), "Show only this"));
  EXPECT_TRUE(tree().isShown(SceneItem::Part));
  EXPECT_FALSE(tree().isShown(SceneItem::Platform));
  EXPECT_FALSE(tree().isShown(SceneItem::Robot));
  ASSERT_TRUE(choose(menuOf(0), "Show everything"));
  EXPECT_TRUE(tree().isShown(SceneItem::Robot));
  ASSERT_TRUE(choose(menuOf(0), "Export…"));
  EXPECT_EQ(page(), Page::Export);
  ASSERT_TRUE(choose(menuOf(0), "Settings"));
  EXPECT_EQ(page(), Page::Prepare);
  EXPECT_TRUE(texts(menuOf(2)).contains("Edit cell…"));
  openMenu()->close();
  ASSERT_TRUE(choose(menuOf(0), "Remove part"));
  EXPECT_EQ(document().source(), nullptr);
}

TEST_F(ObjectMenusTest, ABeadOffersItsLayerAndItsMoment) {
  planFlat();
  choosePage(Page::Layers);
  auto* layers = find<timeline::LayerRangeSlider>("layerSlider");
  ASSERT_TRUE(waitFor([&] { return layers->layerCount() > 3; }));
  viewer::Viewport& view = window().viewport();
  view.viewFrom({0, 0, 1});
  picture();
  const auto askAtPart = [&] {
    QTest::mouseClick(&view, Qt::RightButton, {}, view.rect().center());
    return openMenu();
  };
  QMenu* menu = askAtPart();
  ASSERT_NE(menu, nullptr);
  const QString alone = QString("Show only layer %1").arg(layers->layerCount());
  EXPECT_TRUE(texts(menu).contains("Hide beads of this kind"))
      << texts(menu).join(", ").toStdString();
  keepPicture(window(), "bead_menu");
  ASSERT_TRUE(choose(menu, alone)) << texts(menu).join(", ").toStdString();
  EXPECT_EQ(layers->first(), layers->last());
  picture();
  ASSERT_TRUE(choose(askAtPart(), "Hide beads of this kind"));
  EXPECT_NE(view.view().hiddenKinds, 0U);
  layers->setRange(0, layers->layerCount() - 1);
  picture();
  ASSERT_TRUE(choose(askAtPart(), "Show all beads"));
  EXPECT_EQ(view.view().hiddenKinds, 0U);
  picture();
  ASSERT_TRUE(choose(askAtPart(), "Go to this moment"));
  EXPECT_EQ(page(), Page::Simulate);
  EXPECT_GT(find<timeline::TimelineBar>("timeline")->timeS(), 0.0);
}

TEST_F(ObjectMenusTest, PlanBecomesExportWhenThereIsNothingToPlan) {
  planFlat();
  auto* plan = find<QAction>("plan");
  EXPECT_EQ(plan->text().remove('&'), "Export…");
  keepPicture(window(), "plan_is_export");
  choosePage(Page::Layers);
  clickToolBar("plan");
  EXPECT_EQ(page(), Page::Export);
  EXPECT_FALSE(window().planning().running());
  project::Choices choices = document().choices();
  choices.parameters["walls"] = "3";
  document().setChoices(choices, "walls");
  EXPECT_EQ(plan->text().remove('&'), "Plan");
  clickToolBar("plan");
  EXPECT_TRUE(window().planning().running());
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_EQ(plan->text().remove('&'), "Export…");
}

TEST_F(ObjectMenusTest, TheSummaryBeginsWithTimeMassLengthAndCost) {
  auto* headline = find<QLabel>("headline");
  EXPECT_FALSE(headline->isVisible());
  planFlat();
  const auto quote = window::quoteOf(*document().lastResult(), {});
  ASSERT_TRUE(quote);
  EXPECT_EQ(headline->text(), window::quoteText(*quote));
  EXPECT_TRUE(
      headline->text().contains(QString("%1 g").arg(QLocale().toString(quote->massG(), 'f', 1))));
  EXPECT_TRUE(headline->text().endsWith(window::moneyText(quote->total())));
  EXPECT_NEAR(quote->massG(),
              document().lastResult()->tooling().printedG(*document().lastResult()->job.trajectory),
              1e-6);
  EXPECT_NEAR(quote->materialCost(), quote->massG() * 20.0 / 1000.0, 1e-9) << "PLA costs 20 per kg";
}

TEST_F(ObjectMenusTest, AFilmIsSavedAndACancelledOneIsNot) {
  EXPECT_FALSE(find<QAction>("exportFilm")->isEnabled());
  planFlat();
  const auto film = [&](const char* name) {
    clickMenu("exportMenu", "exportFilm");
    auto* dialog = find<window::FilmDialog>("filmDialog");
    dialog->findChild<QComboBox*>("filmSize")->setCurrentIndex(2);
    auto* length = dialog->findChild<QSpinBox*>("filmLength");
    length->setFocus();
    length->selectAll();
    QTest::keyClicks(length, "1"); // and not left
    answerFileDialog(path(name));
    QTest::mouseClick(dialog->findChild<QPushButton*>("filmSave"), Qt::LeftButton);
    return QPointer<window::FilmDialog>(dialog);
  };
  const QPointer<window::FilmDialog> cancelled = film("cut.webm");
  ASSERT_TRUE(
      waitFor([&] { return cancelled->findChild<QProgressBar*>("filmProgress")->value() > 0; }));
  keepPicture(*cancelled, "film");
  cancelled->reject();
  ASSERT_TRUE(waitFor([&] { return cancelled.isNull(); }));
  const QPointer<window::FilmDialog> saved = film("whole.webm");
  ASSERT_TRUE(waitFor([&] { return saved.isNull(); }));
  EXPECT_TRUE(QFileInfo(path("whole.webm")).size() > 1000);
  EXPECT_TRUE(waitFor([&] { return !QFileInfo::exists(path("cut.webm.part")); }, 10000));
  EXPECT_FALSE(QFileInfo::exists(path("cut.webm")));
}

TEST_F(ObjectMenusTest, AQuoteAddsMachineSetUpAndMarginAndIsSaved) {
  planFlat();
  clickMenu("exportMenu", "quote");
  auto* dialog = find<window::QuoteDialog>("quoteDialog");
  const auto type = [&](const char* name, const char* value) {
    auto* box = dialog->findChild<QDoubleSpinBox*>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, value);
    QTest::keyClick(box, Qt::Key_Return);
  };
  type("quoteMachine", "30");
  type("quoteFixed", "5");
  type("quoteMargin", "20");
  const window::PrintQuote& quote = dialog->quote();
  const double expected = 1.2 * (quote.materialCost() + quote.timeS / 3600.0 * 30.0 + 5.0);
  EXPECT_NEAR(quote.total(), expected, 1e-9);
  EXPECT_EQ(dialog->findChild<QLabel*>("quoteTotal")->text(), window::moneyText(expected));
  EXPECT_EQ(dialog->findChild<QTreeWidget*>("quoteRows")->topLevelItemCount(), 4);
  keepPicture(*dialog, "quote");
  // The price of the machine is that of this cell.
  const std::string cell = base::dataName(document().choices().cell);
  EXPECT_EQ(window::quotePrices(cell).machinePerHour, 30.0);
  EXPECT_EQ(window::quotePrices("another").machinePerHour, 0.0);
  EXPECT_EQ(window::quotePrices("another").fixed, 5.0);
  window::keepQuotePrices({45.0, 5.0, 0.2}, "another");
  EXPECT_EQ(window::quotePrices("another").machinePerHour, 45.0);
  EXPECT_EQ(window::quotePrices(cell).machinePerHour, 30.0);
  const auto save = [&](const char* name) {
    const QString file = path(name);
    answerFileDialog(file);
    QTest::mouseClick(dialog->findChild<QPushButton*>("quoteSave"), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] {
      return dialog->findChild<QLabel*>("quoteState")->text().startsWith("Saved");
    })) << dialog->findChild<QLabel*>("quoteState")->text().toStdString();
    return base::readFile(file.toStdString());
  };
  const QString html = QString::fromStdString(save("quote.html"));
  const qsizetype price = html.indexOf(window::moneyText(expected).toHtmlEscaped());
  ASSERT_GE(price, 0);
  EXPECT_LT(price, html.indexOf("PLA")) << "the price comes first";
  EXPECT_FALSE(html.contains("<h2></h2>"));
  dialog->findChild<QLabel*>("quoteState")->clear();
  EXPECT_TRUE(save("quote.pdf").starts_with("%PDF"));
  dialog->reject();
  // The prices are kept, and are in the summary.
  ASSERT_TRUE(waitFor(
      [&] { return find<QLabel>("headline")->text().endsWith(window::moneyText(expected)); },
      5000));
}

} // namespace
} // namespace voluta::test
