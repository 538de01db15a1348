// The kind of a file, found from its text. Messages name it when a user passes the wrong file.
#pragma once

#include <cstdint>
#include <string_view>

namespace labmouse {

enum class FileKind : std::uint8_t {
  unknown,
  maze,
  record,
  results,
  csv,  ///< of a race
  page,
  picture,
  log,
  prior,
  failure_rates,
  junit,
  gradescope,  ///< results of one student for Gradescope
  study,       ///< the scores of a study, as CSV
  sweep,       ///< the means of a sweep, as CSV
  tune         ///< the evaluations of a tuning, as CSV
};

/// The kind of a file of labmouse, or FileKind::unknown. It may still be damaged.
FileKind kind_of_file(std::string_view text);

}  // namespace labmouse
