// Language and pictures of a proof.
#pragma once

#include "base/text.h"
#include "project/job.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

struct ProofStyle {
  std::shared_ptr<const base::Language> language = std::make_shared<base::Language>(); // never null
  std::string languageCode = "en";                                                     // BCP 47
  // Returns two PNGs: the part, and the part as printed. If empty, the page has no pictures.
  std::function<std::vector<std::string>(const project::Job&)> pictures = {};
};

} // namespace voluta::pipeline
