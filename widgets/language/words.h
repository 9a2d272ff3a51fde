// Texts of core in the language of the window: sentences by Qt's translations (context "Core",
// listed from core's sources by core/texts), numbers as in that language, symbols of units.
#pragma once

#include "base/text.h"

#include <QString>
#include <QStringList>

namespace voluta::language {

QString words(const base::Message& message);
QString words(const base::Value& value);
QString words(base::Text text); // For texts without placeholders
QStringList words(const std::vector<base::Message>& messages);
// With a capital first letter: for labels and names of choices.
QString heading(base::Text text);

} // namespace voluta::language
