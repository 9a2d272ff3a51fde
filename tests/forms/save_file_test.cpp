// The dialog for a file to write: the ending comes before the question about an existing file.
#include "forms/save_file.h"

#include "base/files.h"
#include "helpers/temporary_folder.h"

#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

using namespace voluta;

namespace {

class SaveFileTest : public testing::Test {
protected:
  // Types the names in turn, leaves the dialog after them, and answers each question.
  QString chosen(QStringList names, QMessageBox::StandardButton answer,
                 const QString& filters = "Films (*.webm)", const QString& filter = {}) {
    asked = 0;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
      QWidget* modal = QApplication::activeModalWidget();
      if (auto* box = qobject_cast<QMessageBox*>(modal)) {
        ++asked;
        question = box->text();
        QTest::mouseClick(box->button(answer), Qt::LeftButton);
      } else if (auto* dialog = qobject_cast<QFileDialog*>(modal)) {
        if (names.isEmpty())
          return dialog->reject();
        if (!filter.isEmpty())
          dialog->selectNameFilter(filter);
        auto* line = dialog->findChild<QLineEdit*>("fileNameEdit");
        line->setText(path(names.takeFirst()));
        QTest::keyClick(line, Qt::Key_Return);
      }
    });
    timer.start(20);
    const QString file = forms::saveFile(nullptr, "Save", path("proposed.webm"), filters);
    return QFileInfo(file).fileName();
  }
  QString path(const QString& name) const {
    return QString::fromStdString((folder_ / name.toStdString()).string());
  }

  const test::TemporaryFolder folder_;
  int asked = 0;
  QString question;
};

TEST_F(SaveFileTest, ANameWithoutAnEndingGetsItBeforeTheQuestion) {
  base::writeFile(folder_ / "foo.webm", "kept");
  EXPECT_EQ(chosen({"foo"}, QMessageBox::No), "") << "left after the answer No";
  EXPECT_EQ(asked, 1);
  EXPECT_TRUE(question.contains("foo.webm")) << question.toStdString();
  EXPECT_EQ(chosen({"foo"}, QMessageBox::Yes), "foo.webm");
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(chosen({"foo.webm", "bar"}, QMessageBox::No), "bar.webm") << "another name after No";
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(chosen({"new"}, QMessageBox::No), "new.webm");
  EXPECT_EQ(chosen({"new.mov"}, QMessageBox::No), "new.mov") << "an ending of the user's own";
  EXPECT_EQ(chosen({}, QMessageBox::No), "");
  EXPECT_EQ(asked, 0);
}

TEST_F(SaveFileTest, TheEndingIsThatOfTheChosenFilter) {
  const QString two = "PDF (*.pdf);;HTML (*.html *.htm)";
  EXPECT_EQ(chosen({"page"}, QMessageBox::No, two), "page.pdf");
  EXPECT_EQ(chosen({"page"}, QMessageBox::No, two, "HTML (*.html *.htm)"), "page.html");
}

} // namespace
