#include "forms/save_file.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace voluta::forms {

namespace {
// A sentence of Qt, in Qt's translations.
constexpr const char* kReplaceQuestion = "%1 already exists.\nDo you want to replace it?";

// Returns ".pdf" for "PDF (*.pdf)".
QString endingOf(const QString& filter) {
  const qsizetype from = filter.indexOf(QLatin1String("*.")) + 1;
  qsizetype to = from;
  while (to < filter.size() && filter[to] != QLatin1Char(')') && filter[to] != QLatin1Char(' '))
    ++to;
  return from > 0 ? filter.mid(from, to - from) : QString();
}

bool replaces(QWidget* parent, const QString& title, const QString& file) {
  QMessageBox box(
      QMessageBox::Warning, title,
      QCoreApplication::translate("QFileDialog", kReplaceQuestion).arg(QFileInfo(file).fileName()),
      QMessageBox::Yes | QMessageBox::No, parent);
  box.setObjectName("replaceFile");
  box.setDefaultButton(QMessageBox::No);
  return box.exec() == QMessageBox::Yes;
}
} // namespace

QString saveFile(QWidget* parent, const QString& title, const QString& proposed,
                 const QString& filters) {
  QString file = proposed;
  QString filter;
  // The dialog of some desktops asks about the name as it is typed.
  while (!(file = QFileDialog::getSaveFileName(parent, title, file, filters, &filter,
                                               QFileDialog::DontConfirmOverwrite))
              .isEmpty()) {
    if (QFileInfo(file).suffix().isEmpty())
      file += endingOf(filter.isEmpty() ? filters : filter);
    if (!QFileInfo::exists(file) || replaces(parent, title, file))
      break;
  }
  return file;
}

} // namespace voluta::forms
