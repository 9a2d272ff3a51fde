// The state of a page's results.
#pragma once

#include "project/job_stage.h"

#include <QString>
#include <vector>

namespace voluta::document {
class Document;
}

namespace voluta::window {

// In increasing order of importance.
enum class PageState { Nothing, Done, OutOfDate, Differs, Blocked, Running };

QString stateName(PageState state);
// Returns the most important state of the page's stages.
PageState worstState(const document::Document& document, const std::vector<project::Stage>& stages);

} // namespace voluta::window
