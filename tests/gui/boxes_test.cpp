// Every box of every page ticked, unticked and ticked again, with a planned job of each mode. The
// boxes are found, not named: new ones are tried too.
#include "gui/planned_jobs.h"
#include "gui/rebuild_watch.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QCheckBox>
#include <QPersistentModelIndex>
#include <QPointer>
#include <QScrollArea>
#include <QStyle>
#include <QStyleOptionViewItem>
#include <QTabWidget>
#include <QTest>
#include <QTimer>

namespace voluta::test {
namespace {

constexpr const char* kPages[] = {Page::Prepare, Page::Layers, Page::Simulate, Page::Export,
                                  Page::Compare};

// The position of the check box in the view's delegate: the style decides it, queried as the
// delegate does.
QPoint boxIn(const QAbstractItemView& view, const QModelIndex& index) {
  QStyleOptionViewItem option;
  option.initFrom(&view);
  option.rect = view.visualRect(index);
  option.features = QStyleOptionViewItem::HasCheckIndicator;
  option.widget = &view;
  return view.style()
      ->subElementRect(QStyle::SE_ItemViewItemCheckIndicator, &option, &view)
      .center();
}

bool hasBox(const QModelIndex& index) {
  return index.isValid() && index.data(Qt::CheckStateRole).isValid() &&
         index.flags().testFlags(Qt::ItemIsUserCheckable | Qt::ItemIsEnabled);
}

void bringIntoSight(QWidget* widget) {
  for (QWidget* at = widget->parentWidget(); at; at = at->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(at))
      area->ensureWidgetVisible(widget);
}

class EveryBoxTest : public PlannedJobTest {
protected:
  void clickRowsOf(QAbstractItemView* view, const QModelIndex& parent = {}) {
    const QAbstractItemModel* model = view->model();
    for (int row = 0; row < model->rowCount(parent); ++row)
      for (int column = 0; column < model->columnCount(parent); ++column) {
        const QPersistentModelIndex index = model->index(row, column, parent);
        for (int n = 0; n < 3 && hasBox(index); ++n) {
          const QVariant before = index.data(Qt::CheckStateRole);
          bringIntoSight(view);
          view->scrollTo(index);
          QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, boxIn(*view, index));
          ++clicks_;
          watch_.watchAll();
          QCoreApplication::processEvents();
          ASSERT_TRUE(index.isValid()) << "the row is gone";
          EXPECT_NE(index.data(Qt::CheckStateRole), before)
              << view->objectName().toStdString() << " "
              << model->index(row, 0, parent).data().toString().toStdString() << ", click "
              << n + 1;
        }
        if (index.isValid() && column == 0 && model->hasChildren(index))
          clickRowsOf(view, index);
      }
  }
  void clickThreeTimes(QAbstractButton* box) {
    for (int n = 0; n < 3 && box->isVisible() && box->isEnabled(); ++n) {
      const bool before = box->isChecked();
      bringIntoSight(box);
      // Beside the word, which may be long: on the indicator.
      QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
      ++clicks_;
      watch_.watchAll();
      QCoreApplication::processEvents();
      if (qobject_cast<QCheckBox*>(box)) {
        EXPECT_NE(box->isChecked(), before)
            << box->objectName().toStdString() << " " << box->text().toStdString();
      }
    }
  }
  void clickAll() {
    QList<QPointer<QAbstractItemView>> views;
    QList<QPointer<QAbstractButton>> boxes;
    for (QWidget* widget : window().findChildren<QWidget*>())
      if (auto* view = qobject_cast<QAbstractItemView*>(widget); view && view->isVisible())
        views << view;
      else if (auto* box = qobject_cast<QAbstractButton*>(widget);
               box && box->isVisible() && box->isCheckable())
        boxes << box;
    for (const auto& view : views)
      if (view && view->isVisible())
        clickRowsOf(view);
    for (const auto& box : boxes)
      if (box)
        clickThreeTimes(box);
  }

  RebuildWatch watch_;
  int clicks_ = 0;
};

TEST_P(EveryBoxTest, IsClickedThreeTimes) {
  planJob(GetParam());
  // A box that opens a dialog has it cancelled.
  QTimer leave;
  QObject::connect(&leave, &QTimer::timeout, [] {
    if (QWidget* modal = QApplication::activeModalWidget())
      QTest::keyClick(modal, Qt::Key_Escape);
  });
  leave.start(200);
  watch_.watchAll();
  for (const char* page : kPages) {
    choosePage(page);
    clickAll();
    for (auto* tabs : window().findChildren<QTabWidget*>())
      for (int i = 0; tabs->isVisible() && i < tabs->count(); ++i) {
        tabs->setCurrentIndex(i);
        clickAll();
      }
    EXPECT_EQ(this->page(), page);
  }
  EXPECT_GT(clicks_, 60);
  window().planning().cancel();
  EXPECT_TRUE(settled());
}

INSTANTIATE_TEST_SUITE_P(Modes, EveryBoxTest, everyMode(), modeOf);

} // namespace
} // namespace voluta::test
