// The messages of a Qt translation file (.ts), as data.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace voluta::translations {

struct Message {
  QString context;
  QString source;
  QString comment;   // distinguishes equal sources of a context; mostly empty
  QStringList forms; // one, or one per plural form
  bool plural = false;
  bool finished = true;

  QString key() const { return context + QStringLiteral(": ") + source + comment; }
};

// Throws std::runtime_error naming file and line when the file is missing or not well-formed.
std::vector<Message> readTranslationFile(const QString& file);

} // namespace voluta::translations
