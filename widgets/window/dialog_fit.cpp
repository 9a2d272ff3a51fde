#include "window/dialog_fit.h"

#include "window/mnemonics.h"

#include <QColorDialog>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr QSize kFrame(12, 44); // of a window, which is not known before it is shown
constexpr const char* kFitted = "fitted";

QString sizeKey(const QDialog& dialog) {
  return QStringLiteral("dialogs/") + dialog.objectName();
}

// Whether it is the row of buttons, alone or beside others.
bool isButtons(QLayoutItem* item) {
  const auto isBox = [](QLayoutItem* one) {
    return qobject_cast<QDialogButtonBox*>(one->widget()) != nullptr;
  };
  if (const QLayout* row = item->layout())
    for (int i = 0; i < row->count(); ++i)
      if (isBox(row->itemAt(i)))
        return true;
  return isBox(item);
}

bool isOurs(const QDialog* dialog) {
  return dialog && dialog->isWindow() && !qobject_cast<const QMessageBox*>(dialog) &&
         !qobject_cast<const QFileDialog*>(dialog) && !qobject_cast<const QColorDialog*>(dialog);
}
} // namespace

DialogFit::DialogFit(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool DialogFit::eventFilter(QObject* watched, QEvent* event) {
  // After a layout too: texts and buttons change while a dialog is open.
  if (event->type() == QEvent::LayoutRequest ||
      (event->type() == QEvent::Show && !event->spontaneous()))
    if (auto* dialog = qobject_cast<QDialog*>(watched);
        isOurs(dialog) || qobject_cast<QMessageBox*>(watched))
      giveMnemonics(*dialog);
  if (event->type() == QEvent::Show || event->type() == QEvent::Hide)
    if (auto* dialog = qobject_cast<QDialog*>(watched); isOurs(dialog) && !event->spontaneous()) {
      if (event->type() == QEvent::Show)
        fit(*dialog);
      else if (!dialog->objectName().isEmpty())
        QSettings().setValue(sizeKey(*dialog), dialog->size());
    }
  return QObject::eventFilter(watched, event);
}

void DialogFit::fit(QDialog& dialog) {
  if (dialog.property(kFitted).toBool())
    return;
  dialog.setProperty(kFitted, true);
  const QRect screen = dialog.screen()->availableGeometry();
  const QSize room = screen.size() - kFrame;
  const QSize kept =
      dialog.objectName().isEmpty() ? QSize() : QSettings().value(sizeKey(dialog)).toSize();
  const QSize size = kept.isValid() ? kept : dialog.size();
  dialog.ensurePolished();
  const QSize needed = dialog.layout() ? dialog.layout()->totalMinimumSize() : QSize();
  if (needed.width() > room.width() || needed.height() > room.height())
    letScroll(dialog);
  dialog.resize(size.expandedTo(dialog.minimumSizeHint()).boundedTo(room));
  // Beside its window's middle, but on the screen.
  const QWidget* window = dialog.parentWidget() ? dialog.parentWidget()->window() : nullptr;
  const QPoint middle = window ? window->geometry().center() : screen.center();
  const auto within = [](int low, int length, int from, int room) {
    return std::clamp(low, from, std::max(from, from + room - length));
  };
  const QSize framed = dialog.size() + kFrame;
  dialog.move(
      within(middle.x() - framed.width() / 2, framed.width(), screen.x(), screen.width()),
      within(middle.y() - framed.height() / 2, framed.height(), screen.y(), screen.height()));
}

// Moves the content into a scroll area. Buttons at its end stay in sight.
void DialogFit::letScroll(QDialog& dialog) {
  auto* content = new QWidget;
  QLayout* layout = dialog.layout();
  const bool hasButtons = layout->count() > 1 && isButtons(layout->itemAt(layout->count() - 1));
  QLayoutItem* buttons = hasButtons ? layout->takeAt(layout->count() - 1) : nullptr;
  content->setLayout(layout); // Takes it from the dialog, with its widgets
  auto* area = new QScrollArea(&dialog);
  area->setObjectName(QStringLiteral("dialogArea"));
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setWidget(content);
  auto* column = new QVBoxLayout(&dialog);
  column->setContentsMargins(0, 0, 0, buttons ? layout->contentsMargins().bottom() : 0);
  column->addWidget(area, 1);
  if (buttons) {
    auto* row = new QHBoxLayout;
    row->setContentsMargins(layout->contentsMargins().left(), 0, layout->contentsMargins().right(),
                            0);
    if (buttons->layout()) {
      buttons->layout()->setParent(nullptr);
      row->addLayout(buttons->layout());
    } else {
      row->addWidget(buttons->widget());
      delete buttons;
    }
    column->addLayout(row);
  }
  column->activate();
}

} // namespace voluta::window
