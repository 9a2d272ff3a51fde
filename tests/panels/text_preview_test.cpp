#include "panels/text_lines.h"
#include "panels/text_preview.h"

#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

using namespace voluta;

namespace {
std::shared_ptr<const std::string> text(std::string s) {
  return std::make_shared<const std::string>(std::move(s));
}

std::shared_ptr<const std::string> numbered(int lines) {
  QString s;
  for (int i = 1; i <= lines; ++i)
    s += QStringLiteral("line %1\n").arg(i);
  return text(s.toStdString());
}
} // namespace

TEST(TextLines, EndsOfLinesAndOfTheText) {
  EXPECT_EQ(panels::TextLines(nullptr).count(), 0u);
  EXPECT_EQ(panels::TextLines(text("")).count(), 0u);
  const panels::TextLines lines(text("a\r\n\nccc\nd"));
  ASSERT_EQ(lines.count(), 4u);
  EXPECT_EQ(lines.line(0), "a");
  EXPECT_EQ(lines.line(1), "");
  EXPECT_EQ(lines.line(2), "ccc");
  EXPECT_EQ(lines.line(3), "d");
  EXPECT_EQ(panels::TextLines(text("a\n")).count(), 1u);
}

TEST(TextLines, EveryLineIsFoundAcrossTheKeptPlaces) {
  const panels::TextLines lines(numbered(1000));
  ASSERT_EQ(lines.count(), 1000u);
  for (std::size_t i = 0; i < 1000; ++i)
    EXPECT_EQ(lines.line(i), QStringLiteral("line %1").arg(i + 1).toStdString());
}

TEST(TextPreview, ShowLineScrollsThereWithoutASignal) {
  panels::TextPreview preview;
  preview.resize(300, 200);
  preview.show();
  preview.setText(numbered(1000));
  QSignalSpy clicked(&preview, &panels::TextPreview::lineClicked);
  preview.showLine(700);
  EXPECT_EQ(preview.currentLine(), 700u);
  EXPECT_LE(preview.verticalScrollBar()->value(), 699);
  EXPECT_GT(preview.verticalScrollBar()->value(), 600);
  const int top = preview.verticalScrollBar()->value();
  preview.showLine(701);
  EXPECT_EQ(preview.verticalScrollBar()->value(), top);
  preview.showLine(5000);
  EXPECT_EQ(preview.currentLine(), 1000u);
  preview.showLine(0);
  EXPECT_EQ(preview.currentLine(), 0u);
  EXPECT_EQ(clicked.size(), 0);
}

TEST(TextPreview, ClickAndKeysSignalTheLine) {
  panels::TextPreview preview;
  preview.resize(300, 200);
  preview.show();
  preview.setText(numbered(100));
  QSignalSpy clicked(&preview, &panels::TextPreview::lineClicked);
  const int height = preview.fontMetrics().height();
  QTest::mouseClick(preview.viewport(), Qt::LeftButton, {}, QPoint(80, 2 * height + 3));
  QTest::keyClick(&preview, Qt::Key_Down);
  QTest::keyClick(&preview, Qt::Key_End);
  ASSERT_EQ(clicked.size(), 3);
  EXPECT_EQ(clicked[0][0].toULongLong(), 3u);
  EXPECT_EQ(clicked[1][0].toULongLong(), 4u);
  EXPECT_EQ(clicked[2][0].toULongLong(), 100u);
}

TEST(TextPreview, FortyMegabytesOpenWithoutACopy) {
  const QByteArray line("  movel(p[0.4000, -0.1042, 0.3121], a=0.5)\n");
  constexpr int kLines = 1'000'000;
  const auto program = text(line.repeated(kLines).toStdString());
  ASSERT_GT(program->size(), 40'000'000u);
  panels::TextPreview preview;
  preview.resize(400, 600);
  preview.show();
  (void)QTest::qWaitForWindowExposed(&preview);
  preview.setText(program);
  preview.repaint();
  preview.showLine(preview.lines().count() - 10);
  preview.repaint();
  EXPECT_EQ(preview.currentLine(), std::size_t{kLines} - 10);
  EXPECT_EQ(preview.lines().text().get(), program.get());
  EXPECT_EQ(preview.lines().count(), std::size_t{kLines});
}
