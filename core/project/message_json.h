// Messages and findings in files, so that they can be told in another language later.
#pragma once

#include "plan/finding.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace voluta::project {

// A row of findings[] in report.json: {stage, kind, where, when, count, reason, remedy, remedyMm,
// blocking, values{}}; a value's unit is the end of its name (areaMm2, angleDeg).
nlohmann::ordered_json findingJson(const plan::Finding& finding);
// Read back from there: told as it was told.
plan::Finding readFinding(const nlohmann::ordered_json& j);

// {fact, values[], program}: the finding to the last digit. Where, when, count and blocking are the
// report's.
nlohmann::ordered_json factJson(const plan::Finding& finding);
// Makes of a finding that readFinding() gave what it was. It stays as it is where this version does
// not know the fact, or knows other values of it.
void readFact(const nlohmann::ordered_json& j, plan::Finding& finding);

// {text, values[]}; a text that this version does not have is kept as its English.
nlohmann::ordered_json messageJson(const base::Message& message);
// Also of a bare string, as files of earlier versions have them.
base::Message readMessage(const nlohmann::ordered_json& j);

nlohmann::ordered_json messagesJson(const std::vector<base::Message>& messages);
std::vector<base::Message> readMessages(const nlohmann::ordered_json& j);

} // namespace voluta::project
