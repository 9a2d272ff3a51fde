// Parts for the tests of the document.
#pragma once

#include "document/document.h"
#include "helpers/loaded_box.h"

#include <memory>
#include <string>

namespace voluta::test {

// A box of 12 triangles that prints in a moment.
inline std::shared_ptr<const project::LoadedPart> boxPart(double side = 8.0,
                                                          const std::string& name = "box.stl") {
  return loadedBox(Eigen::Vector3d::Zero(), {side, side, 4.0}, name);
}

inline int seedOf(const document::Document& document) {
  return document.choices().seed;
}

inline void setSeed(document::Document& document, int seed) {
  project::Choices choices = document.choices();
  choices.seed = seed;
  document.setChoices(choices, QStringLiteral("Change seed"));
}

} // namespace voluta::test
