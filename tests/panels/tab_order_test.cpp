#include "forms/tab_order.h"

#include "forms/choices_form.h"
#include "forms/parameter_form.h"
#include "panels/findings_panel.h"
#include "panels/placement_panel.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"

#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QScrollArea>
#include <QTest>
#include <QVBoxLayout>
#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;

namespace {
// The widgets that Tab reaches inside `top`, from its first field on; without scroll areas.
std::vector<QWidget*> tabbed(QWidget* top) {
  std::vector<QWidget*> all;
  QWidget* const first = forms::inReadingOrder(top).front();
  QWidget* at = first;
  do {
    if (top->isAncestorOf(at) && (at->focusPolicy() & Qt::TabFocus) && at->isVisibleTo(top) &&
        !at->focusProxy() && !qobject_cast<QScrollArea*>(at))
      all.push_back(at);
    at = at->nextInFocusChain();
  } while (at != first);
  return all;
}

// Each field is further down than the one before, or further right in the same line.
void expectReadingOrder(QWidget* top) {
  const std::vector<QWidget*> order = tabbed(top);
  ASSERT_GT(order.size(), 3u);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const QPoint before = order[i - 1]->mapTo(top, order[i - 1]->rect().center());
    const QPoint now = order[i]->mapTo(top, order[i]->rect().center());
    const bool sameLine = std::abs(now.y() - before.y()) < order[i]->height() / 2;
    EXPECT_TRUE(sameLine ? now.x() > before.x() : now.y() > before.y())
        << qPrintable(order[i - 1]->objectName()) << " and then "
        << qPrintable(order[i]->objectName());
  }
}

TEST(TabOrder, FollowsTheReadingOrderOfASettingsForm) {
  auto* choices = new forms::ChoicesForm; // made first, shown second
  forms::ParameterForm form(pipeline::allParameters());
  form.setHeader(choices);
  form.setShowAll(true);
  form.resize(320, 3000);
  form.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&form));
  forms::tabInReadingOrder({&form});
  expectReadingOrder(&form);
}

TEST(TabOrder, FollowsTheReadingOrderOfThePlacementPanel) {
  panels::PlacementPanel panel;
  panel.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
  forms::tabInReadingOrder({&panel});
  expectReadingOrder(&panel);
}

// Its buttons come and go with the finding that is chosen.
TEST(TabOrder, VisitsTheRemediesOfAFindingBeforeTheNextPanel) {
  QWidget window;
  auto* column = new QVBoxLayout(&window);
  auto* findings = new panels::FindingsPanel;
  auto* next = new panels::PlacementPanel;
  column->addWidget(findings);
  column->addWidget(next);
  window.resize(260, 900); // one button a line
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  forms::tabInReadingOrder({findings, next});
  findings->setRemedies([](const plan::Finding& finding) {
    std::vector<panels::RemedyButton> buttons{{"turn", "Turn the part", ""}};
    if (plan::englishReason(finding) == "b")
      buttons.push_back({"prop", "Prop it up", ""});
    return buttons;
  });
  findings->setFindings({plan::verbatimFinding(plan::Stage::Layers, "sample", "a", "Do it."),
                         plan::verbatimFinding(plan::Stage::Layers, "sample", "b", "Do it.")});
  auto* list = findings->findChild<QListView*>("list");
  for (const int row : {0, 1, 0}) {
    list->setCurrentIndex(list->model()->index(row, 0));
    QTest::qWait(20);
    const std::vector<QWidget*> order = tabbed(&window);
    const auto place = [&](const char* name) {
      return std::ranges::find(order, QString(name), &QWidget::objectName) - order.begin();
    };
    EXPECT_EQ(place("remedy_turn"), place("list") + 1) << "row " << row;
    expectReadingOrder(&window);
  }
}

TEST(TabOrder, ContinuesFromOnePanelToTheNext) {
  QWidget window;
  auto* column = new QVBoxLayout(&window);
  auto* second = new panels::PlacementPanel; // made in another order than shown
  auto* first = new forms::ChoicesForm;
  column->addWidget(first);
  column->addWidget(second);
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  forms::tabInReadingOrder({first, second});
  expectReadingOrder(&window);
}
} // namespace
