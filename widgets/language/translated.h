// Sentences of core by Qt's translations, without anything filled in.
#pragma once

#include "base/text.h"

#include <QString>
#include <optional>

namespace voluta::language {

// Returns the sentence for this count; settings that it names stay in backquotes.
QString translated(base::Text text, std::optional<long long> count = std::nullopt);
// Returns the text with a capital first letter.
QString capitalized(QString text);
// Returns translated() with a capital first letter: for labels and names of choices.
QString translatedHeading(base::Text text);

} // namespace voluta::language
