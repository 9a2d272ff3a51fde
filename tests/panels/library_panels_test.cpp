// Form, head table and head drawing of the library of processes and materials.
#include "base/data_files.h"
#include "language/words.h"
#include "long_translator.h"
#include "panels/head_drawing.h"
#include "panels/head_table.h"
#include "panels/item_form.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;

namespace {
using process::LibraryItem;
using process::Shelf;

LibraryItem factory(const char* id = "fdm-1.0") {
  return process::loadItem(Shelf::Processes, id);
}

QDoubleSpinBox* fieldOf(panels::ItemForm& form, const char* key) {
  auto* row = form.findChild<QWidget*>(key);
  return row ? row->findChild<QDoubleSpinBox*>("editor") : nullptr;
}

QToolButton* resetOf(panels::ItemForm& form, const char* key) {
  return form.findChild<QWidget*>(key)->findChild<QToolButton*>("reset");
}

QImage drawn(panels::HeadDrawing& drawing, const process::Process& process) {
  drawing.setProcess(process);
  return drawing.grab().toImage();
}

TEST(ItemForm, MarksFieldsThatDifferAndResetsThem) {
  panels::ItemForm form;
  LibraryItem last = factory();
  QObject::connect(&form, &panels::ItemForm::edited, &form,
                   [&](const LibraryItem& item) { last = item; });
  form.setItem(factory(), factory(), false);
  form.show();
  EXPECT_EQ(form.changedFields(), 0);
  QDoubleSpinBox* width = fieldOf(form, "beadWidthMm.default");
  ASSERT_NE(width, nullptr);
  width->setValue(1.6);
  EXPECT_EQ(last.process()->beadWidthMm, 1.6);
  EXPECT_EQ(form.changedFields(), 1);
  EXPECT_TRUE(resetOf(form, "beadWidthMm.default")->isVisible());
  resetOf(form, "beadWidthMm.default")->click();
  EXPECT_EQ(last.process()->beadWidthMm, 1.2);
  EXPECT_EQ(form.changedFields(), 0);
}

TEST(ItemForm, HasARowForEveryFieldOfEveryItem) {
  panels::ItemForm form;
  for (const Shelf shelf : {Shelf::Processes, Shelf::Materials})
    for (const std::string& id : process::libraryIds(shelf)) {
      const LibraryItem item = process::loadItem(shelf, id);
      form.setItem(item, item, true);
      EXPECT_EQ(form.changedFields(), 0) << id;
      for (const process::LibraryField& field : process::libraryFields(item)) {
        auto* row = form.findChild<QWidget*>(QString::fromStdString(field.spec.key));
        ASSERT_NE(row, nullptr) << id << ' ' << field.spec.key;
        EXPECT_EQ(form.labelOf(field.spec.key), language::heading(field.spec.label));
        if (auto* box = row->findChild<QDoubleSpinBox*>("editor")) {
          EXPECT_TRUE(box->isReadOnly());
          EXPECT_NEAR(box->value(), std::get<double>(field.get(item)), 1e-4) << field.spec.key;
        }
      }
    }
}

TEST(ItemForm, ShowsAProblemBesideItsField) {
  panels::ItemForm form;
  form.setItem(factory(), factory(), false);
  form.show();
  LibraryItem item = factory();
  std::get<process::Process>(item.data).beadWidthMm = 9.0;
  form.setProblem(process::problemOf(item));
  const auto texts = [&](const char* key) {
    QString all;
    for (const QLabel* label : form.findChild<QWidget*>(key)->findChildren<QLabel*>())
      all += label->isVisible() ? label->text() : QString();
    return all;
  };
  EXPECT_TRUE(texts("beadWidthMm.default").contains("'max'"));
  EXPECT_FALSE(texts("beadWidthMm.max").contains("'max'"));
  form.setProblem(std::nullopt);
  EXPECT_FALSE(texts("beadWidthMm.default").contains("'max'"));
}

TEST(ItemForm, ShowsUnknownForAMissingValue) {
  panels::ItemForm form;
  LibraryItem item = process::loadItem(Shelf::Materials, "petg");
  std::get<process::Material>(item.data).bedC.reset();
  form.setItem(item, item, false);
  EXPECT_EQ(fieldOf(form, "bedC")->text(), "unknown");
}

TEST(ItemForm, ShowsTheColourOfAMaterial) {
  panels::ItemForm form;
  LibraryItem item = process::loadItem(Shelf::Materials, "petg");
  const auto swatch = [&] {
    form.setItem(item, item, false);
    auto* line = form.findChild<QWidget*>("colour")->findChild<QLineEdit*>("editor");
    return line->actions().front()->icon().pixmap(8, 8).toImage().pixelColor(4, 4);
  };
  std::get<process::Material>(item.data).colour = "#1234AB";
  EXPECT_EQ(swatch(), QColor("#1234AB"));
  std::get<process::Material>(item.data).colour = "#12"; // half typed
  EXPECT_EQ(swatch().alpha(), 0);
}

TEST(HeadTable, EditsAddsAndRemovesSections) {
  panels::HeadTable table;
  process::HeadShape last = factory().process()->head;
  QObject::connect(&table, &panels::HeadTable::headChanged, &table,
                   [&](const process::HeadShape& head) { last = head; });
  table.setReference(last);
  table.setHead(last);
  table.show();
  auto* rows = table.findChild<QTableWidget*>("headTable");
  auto* reset = table.findChild<QToolButton*>("headReset");
  ASSERT_EQ(rows->rowCount(), 6);
  EXPECT_FALSE(reset->isVisible());
  rows->item(5, 0)->setData(Qt::EditRole, 120.0);
  EXPECT_EQ(last.sections.back().zMm, 120.0);
  EXPECT_TRUE(reset->isVisible());
  rows->setCurrentCell(0, 0);
  table.findChild<QToolButton*>("headAdd")->click();
  ASSERT_EQ(last.sections.size(), 7u);
  EXPECT_EQ(last.sections[1].zMm, 6.0) << "between its neighbours";
  table.findChild<QToolButton*>("headRemove")->click();
  EXPECT_EQ(last.sections.size(), 6u);
  reset->click();
  EXPECT_EQ(last.sections.back().zMm, 110.0);
  table.setReadOnly(true);
  EXPECT_FALSE(table.findChild<QToolButton*>("headAdd")->isEnabled());
  EXPECT_EQ(rows->editTriggers(), QAbstractItemView::NoEditTriggers);
}

TEST(HeadDrawing, ShowsHeadAndBeadOfEveryProcess) {
  panels::HeadDrawing drawing;
  drawing.resize(340, 260);
  for (const std::string& id : process::processIds()) {
    process::Process p = process::loadProcess(id);
    const QImage picture = drawn(drawing, p);
    p.beadWidthMm *= 1.3;
    EXPECT_NE(drawn(drawing, p), picture) << id << ": the bead is to scale";
    p.beadWidthMm /= 1.3;
    p.head.sections.back().radiusMm *= 1.3;
    EXPECT_NE(drawn(drawing, p), picture) << id << ": the head is to scale";
  }
}

// Half-typed heads and sizes are drawn or left out.
TEST(HeadDrawing, DrawsAnyTypedValues) {
  panels::HeadDrawing drawing;
  drawing.resize(340, 260);
  std::mt19937_64 random(4);
  const std::vector<double> values{0.0, 1e-6, 0.4, 3.0, 1e5};
  const auto any = [&] { return values[random() % values.size()]; };
  for (int n = 0; n < 200; ++n) {
    process::Process p;
    p.beadWidthMm = any();
    p.layerHeightMm = any();
    p.nozzleDiameterMm = any();
    for (std::size_t i = 0; i < random() % 5; ++i)
      p.head.sections.push_back({any(), any()});
    EXPECT_FALSE(drawn(drawing, p).isNull());
  }
}

TEST(LibraryPanels, FollowAChangeOfLanguage) {
  panels::HeadTable table;
  panels::ItemForm form;
  form.setItem(factory(), factory(), false);
  gallery::LongTranslator translator;
  QApplication::installTranslator(&translator);
  QApplication::processEvents();
  EXPECT_TRUE(table.findChild<QToolButton*>("headAdd")->text().startsWith(QChar(0x00ab)));
  EXPECT_TRUE(form.labelOf("stepMm").startsWith(QChar(0x00ab)));
  QApplication::removeTranslator(&translator);
  QApplication::processEvents();
  EXPECT_EQ(table.findChild<QToolButton*>("headAdd")->text(), "Add row");
}
} // namespace
