// Names that core's tables give in English, in the language of the window.
#pragma once

#include "pipeline/remedies.h"

#include <QString>
#include <string>
#include <string_view>

namespace voluta::window {

// Labels of modes and dialects. What is not in the list comes back as it is.
QString coreLabel(std::string_view english);
// A growth scheme in plain words; of an unknown one the id.
struct GrowthTexts {
  QString label, help;
};
GrowthTexts growthTexts(std::string_view id);
// What a remedy's button says.
struct RemedyTexts {
  QString label, help;
};
RemedyTexts remedyTexts(const pipeline::Offer& offer);
// "fit:0", "disc:80", "rod:5x200", "mesh:FILE" in words.
QString platformText(const std::string& platform);

} // namespace voluta::window
