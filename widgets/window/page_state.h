// What the results of a page are worth.
#pragma once

#include "project/stage.h"

#include <QString>
#include <vector>

namespace voluta::document {
class Document;
}

namespace voluta::window {

// From the least that has to be told to the most.
enum class PageState { Nothing, Done, OutOfDate, Blocked, Running };

QString stateName(PageState state);
// A page is worth what its stages are worth; the worst counts.
PageState worstState(const document::Document& document, const std::vector<project::Stage>& stages);

} // namespace voluta::window
