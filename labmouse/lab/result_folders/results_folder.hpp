// The folder of one race, and of no other.
#pragma once

#include <string>

#include "labmouse/lab/system/descriptor.hpp"

namespace labmouse {

/// A folder that a race writes its results into. While this lives no other race can take it, in no process; the lock
/// goes with the process, however that ends.
class ResultsFolder {
 public:
  /// Takes the folder, and makes it where there is none. What an earlier race left there, results and the records and
  /// pictures of its mice, is removed with `overwrite`, and an error without.
  ResultsFolder(const std::string& path, bool overwrite);
  ResultsFolder(const ResultsFolder&) = delete;
  ResultsFolder& operator=(const ResultsFolder&) = delete;
  ~ResultsFolder();

  /// Why it could not be taken, as a line for the user; empty where it was.
  const std::string& error() const { return error_; }

 private:
  /// Returns what went wrong, or nothing.
  std::string take(const std::string& path, bool overwrite);

  std::string lock_path_;
  Descriptor lock_ = Descriptor::opened(-1);
  std::string error_;
};

}  // namespace labmouse
