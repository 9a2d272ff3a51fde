#include "panels/text_preview.h"

#include "forms/colours.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <algorithm>
#include <limits>

namespace voluta::panels {

namespace {
constexpr int kMargin = 6;
// Longer lines are truncated: programs have none, and one line must not stall a frame.
constexpr std::size_t kLongestShown = 4096;

QString shownText(std::string_view line) {
  QString text =
      QString::fromUtf8(line.data(), static_cast<qsizetype>(std::min(line.size(), kLongestShown)));
  return text.replace(QLatin1Char('\t'), QStringLiteral("    "));
}
} // namespace

TextPreview::TextPreview(QWidget* parent) : QAbstractScrollArea(parent) {
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setFocusPolicy(Qt::StrongFocus);
  viewport()->setBackgroundRole(QPalette::Base);
  viewport()->setCursor(Qt::ArrowCursor);
}

void TextPreview::setText(std::shared_ptr<const std::string> text) {
  lines_ = TextLines(std::move(text));
  current_ = 0;
  adjustBars();
  verticalScrollBar()->setValue(0);
  horizontalScrollBar()->setValue(0);
  viewport()->update();
}

void TextPreview::showLine(std::size_t line) {
  line = std::min(line, lines_.count());
  if (line == current_)
    return;
  current_ = line;
  if (line > 0) {
    const auto first = static_cast<std::size_t>(verticalScrollBar()->value());
    const std::size_t seen = std::max<std::size_t>(visibleLines(), 1);
    if (line - 1 < first || line - 1 >= first + seen) {
      const std::size_t top = line - 1 > seen / 3 ? line - 1 - seen / 3 : 0;
      verticalScrollBar()->setValue(static_cast<int>(top));
    }
  }
  viewport()->update();
}

QSize TextPreview::sizeHint() const {
  return {fontMetrics().averageCharWidth() * 40, lineHeight() * 12};
}

int TextPreview::lineHeight() const {
  return fontMetrics().height();
}

int TextPreview::gutterWidth() const {
  const auto digits = std::to_string(lines_.count()).size();
  return fontMetrics().horizontalAdvance(
             QString(static_cast<qsizetype>(std::max<std::size_t>(digits, 3)), QChar('9'))) +
         2 * kMargin;
}

std::size_t TextPreview::visibleLines() const {
  return static_cast<std::size_t>(std::max(0, viewport()->height() / lineHeight()));
}

void TextPreview::adjustBars() {
  const auto asInt = [](std::size_t n) {
    return static_cast<int>(std::min<std::size_t>(n, std::numeric_limits<int>::max()));
  };
  const std::size_t seen = visibleLines();
  verticalScrollBar()->setPageStep(std::max(1, asInt(seen)));
  verticalScrollBar()->setRange(0, asInt(lines_.count() > seen ? lines_.count() - seen : 0));
  const int wide = asInt(std::min(lines_.longest(), kLongestShown)) *
                   fontMetrics().horizontalAdvance(QChar('m'));
  const int room = viewport()->width() - gutterWidth() - kMargin;
  horizontalScrollBar()->setPageStep(std::max(1, room));
  horizontalScrollBar()->setSingleStep(fontMetrics().averageCharWidth() * 4);
  horizontalScrollBar()->setRange(0, std::max(0, wide - room));
}

void TextPreview::paintEvent(QPaintEvent*) {
  QPainter painter(viewport());
  const QPalette& colours = palette();
  const int height = lineHeight(), gutter = gutterWidth(), width = viewport()->width();
  painter.fillRect(0, 0, gutter, viewport()->height(), colours.color(QPalette::AlternateBase));
  const auto first = static_cast<std::size_t>(verticalScrollBar()->value());
  const std::size_t last = std::min(lines_.count(), first + visibleLines() + 1);
  for (std::size_t i = first; i < last; ++i) {
    const int y = static_cast<int>(i - first) * height;
    const bool current = i + 1 == current_;
    if (current)
      painter.fillRect(0, y, width, height, colours.color(QPalette::Highlight));
    const QColor onHighlight = colours.color(QPalette::HighlightedText);
    painter.setPen(current ? onHighlight : forms::mutedColour(colours));
    painter.drawText(QRect(0, y, gutter - kMargin, height), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(i + 1));
    painter.setPen(current ? onHighlight : colours.color(QPalette::Text));
    painter.setClipRect(gutter, y, width - gutter, height);
    painter.drawText(
        QPointF(gutter + kMargin - horizontalScrollBar()->value(), y + fontMetrics().ascent()),
        shownText(lines_.line(i)));
    painter.setClipping(false);
  }
}

void TextPreview::resizeEvent(QResizeEvent*) {
  adjustBars();
}

void TextPreview::goTo(std::size_t line) {
  if (lines_.count() == 0)
    return;
  showLine(std::clamp<std::size_t>(line, 1, lines_.count()));
  emit lineClicked(current_);
}

void TextPreview::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton)
    return;
  const auto row = static_cast<std::size_t>(event->pos().y() / lineHeight());
  const std::size_t line = static_cast<std::size_t>(verticalScrollBar()->value()) + row + 1;
  if (line <= lines_.count())
    goTo(line);
}

void TextPreview::keyPressEvent(QKeyEvent* event) {
  const std::size_t page = std::max<std::size_t>(visibleLines(), 1);
  const auto back = [this](std::size_t by) { return current_ > by ? current_ - by : 1; };
  if (event->matches(QKeySequence::Copy)) {
    if (current_ > 0)
      QApplication::clipboard()->setText(shownText(lines_.line(current_ - 1)));
    return;
  }
  switch (event->key()) {
  case Qt::Key_Up:
    return goTo(back(1));
  case Qt::Key_Down:
    return goTo(current_ + 1);
  case Qt::Key_PageUp:
    return goTo(back(page));
  case Qt::Key_PageDown:
    return goTo(current_ + page);
  case Qt::Key_Home:
    return goTo(1);
  case Qt::Key_End:
    return goTo(lines_.count());
  default:
    QAbstractScrollArea::keyPressEvent(event);
  }
}

void TextPreview::changeEvent(QEvent* event) {
  QAbstractScrollArea::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
    adjustBars();
}

} // namespace voluta::panels
