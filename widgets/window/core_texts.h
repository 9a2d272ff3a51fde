// Names that core's tables give in English, in the language of the window.
#pragma once

#include "pipeline/remedies.h"
#include "project/platform.h"

#include <QString>
#include <string>
#include <string_view>

namespace voluta::window {

// Labels of modes, growth schemes, platforms and dialects. What is not in the list comes back as it
// is.
QString coreLabel(std::string_view english);
// What a remedy's button says.
struct RemedyTexts {
  QString label, help;
};
RemedyTexts remedyTexts(const pipeline::Offer& offer);
// A platform in words.
QString platformText(const project::Platform& platform);

} // namespace voluta::window
