// Hazards as `labmouse hazards` has counted them, in a file; and those that the program brings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/hazards.hpp"
#include "labmouse/lab/hazards/hazard_tally.hpp"

namespace labmouse {

/// The version of the file's format.
inline constexpr int hazard_format = 2;

/// What was counted, and of which robot.
struct HazardFile {
  std::string name;    ///< that of the file without its folders and its ending
  std::string robot;   ///< name of the robot
  std::string tables;  ///< hash of its tables
  int edition = 0;     ///< of the physical world
  double spread = 1.0;
  double search_speed = 0.0;  ///< 0: the robot's own
  std::vector<HazardTally> tallies;
  std::string hash;  ///< of all that is in it
};

/// A file, or why it is none: a line for the user.
struct FoundHazards {
  std::optional<HazardFile> file;
  std::string error;
};

/// Reads a text, of which nothing is sure, strictly.
FoundHazards read_hazards(std::string_view text, const std::string& name);

/// The built-in ones of that name, or those of a file, whose name has a slash or ends in `.json`.
FoundHazards find_hazards(const std::string& name);

/// Those of that name and hash which the program brings, or nothing: a file of that name may be another one.
std::optional<HazardFile> brought_hazards(const std::string& name, std::string_view hash);

/// How likely all of it is, by what was counted. Where little was counted of a class of luck, what was counted of it
/// under all noises counts, too; where that is little, what was counted of all classes; then that of all manoeuvres.
Hazards hazards_of(const HazardFile& file);

}  // namespace labmouse
