// The member `transfer` of a scale: how it takes its colors from the coarser scale before it.
#pragma once

#include "formats/bundle.h"
#include "formats/issues.h"

namespace texbake {

Json transfer_json(const ScaleTransfer& transfer);
/// Of a value that follows the schema.
ScaleTransfer transfer_of(const Json& json);

/// Every scale but the first has a transfer, which fits its scale and the one before it.
void check_transfers(const Bundle& bundle, const std::vector<V2i>& sizes, IssueLog& log);

}  // namespace texbake
