// Asks for a file to write.
#pragma once

#include <QString>

class QWidget;

namespace voluta::forms {

// Returns the file that the user chooses; empty: none. A name without an ending gets that of the
// chosen filter before the user is asked whether an existing file is replaced. `filters`:
// "PDF (*.pdf);;HTML (*.html)".
QString saveFile(QWidget* parent, const QString& title, const QString& proposed,
                 const QString& filters);

} // namespace voluta::forms
