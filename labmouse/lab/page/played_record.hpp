// Errors of records that the page opens and replays.
#pragma once

#include <string>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/replays/replay.hpp"

namespace labmouse {

/// Why a record with that file name cannot be shown; `error` is empty if it can.
PageFailure failure_of(const std::string& name, OpenedRecord& opened);

}  // namespace labmouse
