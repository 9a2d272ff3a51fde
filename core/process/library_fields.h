// The editable fields of processes and materials: one table drives form, comparison and checks.
#pragma once

#include "base/parameters.h"
#include "process/library.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace voluta::process {

struct LibraryField {
  base::ParameterSpec spec; // Its key as in the file
  std::function<base::ParameterValue(const LibraryItem&)> get;
  // Precondition: a value of the spec's type.
  std::function<void(LibraryItem&, const base::ParameterValue&)> set;
  // Word for the spec's minimum, which then says that there is no value; empty: there always is.
  base::Text none = {};
};

// Returns the fields of an item in the order of the form. The head's sections have none. The list
// of materials contains the item's own.
std::vector<LibraryField> libraryFields(const LibraryItem& item);

struct FieldProblem {
  std::string key; // Of a field, "head", or empty: of none
  base::Value reason;
};
// Returns the first reason why the item cannot be saved, as its reader reports it.
std::optional<FieldProblem> problemOf(const LibraryItem& item);

struct FieldDifference {
  base::ParameterSpec spec;
  base::Text none; // As of the field
  base::ParameterValue first, second;
};
// Returns the fields that differ, the head as a text. Precondition: of the same shelf.
std::vector<FieldDifference> differences(const LibraryItem& first, const LibraryItem& second);

// Returns e.g. "0, 0.5; 12, 6": height and radius of each section [mm].
std::string headText(const HeadShape& head);

} // namespace voluta::process
