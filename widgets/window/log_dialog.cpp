#include "window/log_dialog.h"

#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QFontDatabase>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QUrl>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
constexpr int kColumns = 90, kLines = 24;
}

LogDialog::LogDialog(const QString& file, QWidget* parent) : QDialog(parent) {
  setObjectName("logDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Log"));
  auto* place = new QLabel(QDir::toNativeSeparators(file), this);
  place->setTextInteractionFlags(Qt::TextSelectableByMouse);
  place->setWordWrap(true);
  auto* text = new QPlainTextEdit(this);
  text->setObjectName("logText");
  text->setAccessibleName(tr("Log"));
  text->setReadOnly(true);
  text->setLineWrapMode(QPlainTextEdit::NoWrap);
  text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  QFile log(file);
  text->setPlainText(log.open(QIODevice::ReadOnly)
                         ? QString::fromUtf8(log.readAll())
                         : tr("%1 cannot be read: %2.").arg(file, log.errorString()));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* folder = buttons->addButton(tr("Open the folder"), QDialogButtonBox::ActionRole);
  folder->setObjectName("logFolder");
  connect(folder, &QPushButton::clicked, this, [file, place] {
    const QString in = QFileInfo(file).absolutePath();
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(in)))
      place->setText(
          tr("No program on this computer opens the folder %1.").arg(QDir::toNativeSeparators(in)));
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(place);
  column->addWidget(text, 1);
  column->addWidget(buttons);
  const QFontMetrics metrics(text->font());
  resize(kColumns * metrics.averageCharWidth(), kLines * metrics.lineSpacing());
  text->verticalScrollBar()->setValue(text->verticalScrollBar()->maximum());
}

} // namespace voluta::window
