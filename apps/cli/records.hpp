// Records as the commands take them: from a file, and only if they could have happened.
#pragma once

#include <string>

#include "labmouse/lab/record_file.hpp"

namespace labmouse::cli {

/// The record of a file, which has a maze; throws UsageError where there is none.
RecordFile load_record(const std::string& path);

/// Plays the record in its maze and takes over what comes out. False where it disagrees, which it tells on standard error.
bool re_enact(const std::string& path, RecordFile& file);

}  // namespace labmouse::cli
