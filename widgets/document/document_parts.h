// The parts of a document. Private to Document.
#pragma once

#include "document/document.h"

namespace voluta::document {

// Shared by all edits of one part, so that its repaired version applies to all.
struct Document::Source {
  std::shared_ptr<const project::LoadedPart> part;
  QString path;
  bool ready = true;
};

struct Document::Parts {
  std::vector<std::shared_ptr<Source>> items; // one or more, as the choices' items
  ShownStages results = {};                   // while other parts are shown
  std::weak_ptr<Parts> leftBefore = {};       // parts that were left before these, with results
};

} // namespace voluta::document
