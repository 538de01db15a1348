// The folder for the results of one race, locked against other races.
#pragma once

#include <string>

#include "labmouse/lab/system/descriptor.hpp"

namespace labmouse {

/// A folder into which a race writes its results. No other race, in any process, can take it while this object lives.
/// The lock ends with the process, even after a crash.
class ResultsFolder {
 public:
  /// Takes the folder and creates it if needed. Files of an earlier race (results, and records and pictures of its
  /// mice) are removed with `overwrite`, and an error without.
  ResultsFolder(const std::string& path, bool overwrite);
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;
  ~ResultsFolder();

  /// Why the folder could not be taken, as a line for the user; empty on success.
  const std::string& error() const { return error_; }

 private:
  /// Returns what went wrong, or nothing.
  std::string take(const std::string& path, bool overwrite);

  std::string lock_path_;
  Descriptor lock_ = Descriptor::opened(-1);
  std::string error_;
};

}  // namespace labmouse
