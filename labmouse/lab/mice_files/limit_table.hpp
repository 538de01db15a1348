// Reads the table `limits` of mice files and of task files.
#pragma once

#include "labmouse/lab/mice_files/file_limits.hpp"
#include "labmouse/lab/text/toml_fields.hpp"

namespace labmouse {

/// The limits in the table under the key `limits` of `table`; none where it has no such key.
FileLimits read_limits(const toml::table& table, TomlFields& fields);

}  // namespace labmouse
