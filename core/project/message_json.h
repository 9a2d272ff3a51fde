// Messages and findings as JSON that can be shown in another language later.
#pragma once

#include "plan/finding.h"

#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace voluta::project {

// Returns a row of findings[] in report.json: {stage, kind, where, when, count, reason, remedy,
// remedyMm, blocking, values{}}. The end of a value's name is its unit (areaMm2, angleDeg).
nlohmann::ordered_json findingJson(const plan::Finding& finding);
// Reads such a row; the texts stay as written.
plan::Finding readFinding(const nlohmann::ordered_json& j);

// Returns {fact, values[], program} and {more} if it stands for further ones: the finding with
// exact values. Place, time, count and blocking are in the report's row.
nlohmann::ordered_json factJson(const plan::Finding& finding);
// Restores the original of a finding that readFinding() returned. Leaves it unchanged if this
// version does not know its kind or has other values for it.
void readFact(const nlohmann::ordered_json& j, plan::Finding& finding);

// Returns {text, values[]}. A text unknown to this version is kept in English.
nlohmann::ordered_json messageJson(const base::Message& message);
// Also accepts a plain string, as in files of earlier versions.
base::Message readMessage(const nlohmann::ordered_json& j);

nlohmann::ordered_json messagesJson(const std::vector<base::Message>& messages);
std::vector<base::Message> readMessages(const nlohmann::ordered_json& j);

} // namespace voluta::project
