// Failure rates in a file, as `labmouse failure-rates` saves them; and the built-in ones.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/failure_rates.hpp"
#include "labmouse/lab/failure_rates/failure_tally.hpp"

namespace labmouse {

/// The version of the file's format.
inline constexpr int failure_rates_format = 3;

/// What was counted, and of which robot.
struct FailureFile {
  std::string name;           ///< that of the file without its folders and its ending
  std::string robot;          ///< name of the robot
  std::string tables;         ///< hash of its tables
  int edition = 0;            ///< of the physical world
  double noise = 1.0;         ///< scale of the noise
  double search_speed = 0.0;  ///< 0: the robot's own
  std::vector<FailureTally> tallies;
  std::string hash;  ///< of all that is in it
};

/// A file, or why it is none: a line for the user.
struct FoundRates {
  std::optional<FailureFile> file;
  std::string error;
};

/// Reads an untrusted text strictly.
FoundRates read_rates(std::string_view text, const std::string& name);

/// The built-in ones of that name, or those of a file, whose name has a slash or ends in `.json`.
FoundRates find_rates(const std::string& name);

/// The built-in ones of that name and hash, or nothing. A user's file can have the same name and other rates.
std::optional<FailureFile> builtin_rates_of(const std::string& name, std::string_view hash);

/// Estimates the probabilities from the counts. If a class of brightness has few counts, its rates are shrunk towards
/// those of the class under all variations; if these are few, towards those of all classes; then towards those of all
/// manoeuvres.
FailureRates rates_of(const FailureFile& file);

}  // namespace labmouse
