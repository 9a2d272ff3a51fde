// A window with cells of the user's own in the test's folder, and hands to work the cell editor
// with.
#pragma once

#include "gui/window_fixture.h"
#include "window/cell/cell_editor.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <functional>

namespace voluta::test {

class CellWindowTest : public WindowTest {
protected:
  void SetUp() override {
    qputenv("VOLUTA_DATA", folder_.path().toUtf8());
    WindowTest::SetUp();
  }
  void TearDown() override {
    WindowTest::TearDown();
    qunsetenv("VOLUTA_DATA");
  }
  // Works the editor once it is up, then continues.
  void inEditor(const std::function<void(window::CellEditor&)>& work) {
    QTimer::singleShot(0, &window(), [work] {
      window::CellEditor* editor = nullptr;
      ASSERT_TRUE(waitFor([&] {
        editor = qobject_cast<window::CellEditor*>(QApplication::activeModalWidget());
        return editor && editor->settled();
      }));
      work(*editor);
    });
    clickMenu("editMenu", "editCell");
  }
  static bool settled(window::CellEditor& editor) {
    return waitFor([&] { return editor.settled(); });
  }
  static void type(window::CellEditor& editor, const char* box, double value) {
    auto* field = editor.findChild<QDoubleSpinBox*>(box);
    ASSERT_NE(field, nullptr) << box;
    field->setFocus();
    field->selectAll();
    const QString number = QLocale::c().toString(value, 'g', 8); // no separators of thousands
    QTest::keyClicks(field, number);
    QTest::keyClick(field, Qt::Key_Return);
  }
  static void choose(window::CellEditor& editor, const QString& body) {
    auto* tree = editor.findChild<QTreeWidget*>("cellBodies");
    const auto items = tree->findItems(body, Qt::MatchExactly | Qt::MatchRecursive);
    ASSERT_EQ(items.size(), 1) << body.toStdString();
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {},
                      tree->visualItemRect(items.front()).center());
  }
  static QString faults(window::CellEditor& editor) {
    return editor.findChild<QLabel*>("cellFaults")->text();
  }
};

} // namespace voluta::test
