// Records as the page takes them: read, and played again in their maze.
#pragma once

#include <string>

#include "labmouse/lab/page/answers.hpp"
#include "labmouse/lab/replays/replay.hpp"

namespace labmouse {

/// Why a record of that name cannot be shown; its error is empty where it can.
PageFailure failure_of(const std::string& name, OpenedRecord& opened);

}  // namespace labmouse
