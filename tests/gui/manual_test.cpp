// F1 opens the manual at the page about what is shown; its search finds pages by their words.
#include "gui/window_fixture.h"
#include "window/manual/manual_pages.h"
#include "window/manual/manual_window.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTimer>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>

namespace voluta::test {
namespace {

QUrl pageNamed(const QString& name) {
  return QUrl("qrc:/docs/manual/" + name + ".md");
}

class ManualTest : public WindowTest {
protected:
  static QTextBrowser* textIn(QWidget& parent) {
    return parent.findChild<QTextBrowser*>("manualText");
  }
  std::string openedPage() {
    QApplication::setActiveWindow(&window()); // there is no window manager that would
    QTest::keyClick(&window(), Qt::Key_F1);
    QTextBrowser* text = textIn(window());
    return text ? QFileInfo(text->source().path()).baseName().toStdString() : "no manual";
  }
  static QStringList shownTitles(const QTreeWidget& contents) {
    QStringList titles;
    for (QTreeWidgetItemIterator it(const_cast<QTreeWidget*>(&contents)); *it; ++it)
      if (!(*it)->isHidden())
        titles << (*it)->text(0);
    return titles;
  }
};

TEST_F(ManualTest, OpensAtThePageThatIsShown) {
  for (const char* page :
       {Page::Prepare, Page::Layers, Page::Simulate, Page::Export, Page::Compare}) {
    choosePage(page);
    ASSERT_EQ(openedPage(), page);
    EXPECT_FALSE(textIn(window())->toPlainText().isEmpty());
    keepPicture(*window().findChild<QDialog*>("manualWindow"),
                ("manual-" + std::string(page)).c_str());
    window().findChild<QDialog*>("manualWindow")->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

TEST_F(ManualTest, OpensInFrontOfADialog) {
  std::string page;
  QTimer::singleShot(300, &window(), [&] {
    QWidget* dialog = QApplication::activeModalWidget();
    ASSERT_NE(dialog, nullptr);
    QTest::keyClick(dialog, Qt::Key_F1);
    if (QTextBrowser* text = textIn(*dialog))
      page = QFileInfo(text->source().path()).baseName().toStdString();
    dialog->close();
  });
  find<QAction>("editLibrary")->trigger();
  QTest::qWait(600);
  EXPECT_EQ(page, "process");
}

TEST_F(ManualTest, FindsPagesBySearchedWords) {
  openedPage();
  auto* contents = window().findChild<QTreeWidget*>("manualContents");
  auto* search = window().findChild<QLineEdit*>("manualSearch");
  ASSERT_TRUE(contents && search);
  const qsizetype all = shownTitles(*contents).size();
  EXPECT_GE(all, 45);
  QTest::keyClicks(search, "emergency stop");
  EXPECT_EQ(shownTitles(*contents), QStringList{"Your own cell"});
  QTest::keyClick(search, Qt::Key_Return);
  EXPECT_EQ(textIn(window())->source(), pageNamed("cell"));
  EXPECT_FALSE(textIn(window())->extraSelections().isEmpty());
  search->clear();
  EXPECT_EQ(shownTitles(*contents).size(), all);
  // A word of a setting, and of a finding.
  QTest::keyClicks(search, "brimWidthMm");
  EXPECT_TRUE(shownTitles(*contents).contains("All settings"));
  search->clear();
  QTest::keyClicks(search, "cannot be removed");
  EXPECT_TRUE(shownTitles(*contents).contains("All findings"));
}

TEST_F(ManualTest, HasEveryPageWithItsLinksAndPictures) {
  openedPage();
  QTextBrowser* text = textIn(window());
  for (const window::ManualChapter& chapter : window::manualChapters())
    for (const window::ManualPage& page : chapter.pages) {
      SCOPED_TRACE(page.url.toString().toStdString());
      text->setSource(page.url, QTextDocument::MarkdownResource);
      EXPECT_GT(text->toPlainText().size(), 100);
      EXPECT_FALSE(text->toPlainText().contains("](")) << "a link that is no link";
      for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next())
        for (auto it = block.begin(); !it.atEnd(); ++it) {
          const QTextCharFormat format = it.fragment().charFormat();
          const QUrl link = page.url.resolved(QUrl(format.anchorHref()));
          if (format.isAnchor() && link.path().startsWith("/docs") && link.path().endsWith(".md")) {
            EXPECT_FALSE(window::manualText(link.adjusted(QUrl::RemoveFragment)).isEmpty())
                << link.toString().toStdString();
          }
          if (format.isImageFormat()) {
            const QString name = format.toImageFormat().name();
            EXPECT_FALSE(
                text->document()->resource(QTextDocument::ImageResource, QUrl(name)).isNull())
                << name.toStdString();
          }
        }
    }
}

TEST_F(ManualTest, MadePagesSpeakTheLanguageOfTheWindow) {
  find<QAction>("language_it")->trigger();
  const QString italian = window::manualText(pageNamed("all_settings"));
  find<QAction>("language_en")->trigger();
  const QString english = window::manualText(pageNamed("all_settings"));
  EXPECT_TRUE(english.contains("Brim width"));
  EXPECT_FALSE(italian.contains("Brim width"));
  EXPECT_EQ(italian.count('\n'), english.count('\n'));
}

} // namespace
} // namespace voluta::test
