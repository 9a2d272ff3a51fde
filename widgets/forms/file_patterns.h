// The endings of files, for dialogs that choose one.
#pragma once

#include "project/part_formats.h"

#include <QString>

namespace voluta::forms {

// Returns "*.stl *.obj".
inline QString filePatterns(project::NamedFiles files) {
  return QString::fromStdString(project::filePatterns(files));
}

} // namespace voluta::forms
