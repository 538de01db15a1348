// Line protocol between labmouse and an external controller. docs/reference/protocols.md explains it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/contest/controller_code.hpp"
#include "labmouse/controller/pose_estimate.hpp"
#include "labmouse/controller/target.hpp"
#include "labmouse/external/verdict.hpp"
#include "labmouse/mouse/evidence.hpp"

namespace labmouse {

/// The first line of both sides: the protocol and its version.
inline constexpr std::string_view controller_greeting = "labmouse pilot 1";

/// The first line of a controller that answers with speeds in place of duties.
inline constexpr std::string_view speeds_greeting = "labmouse pilot 1 speeds";

/// The first line of a program that offers parts of a controller, for messages.
inline constexpr std::string_view parts_greeting = "labmouse pilot 1 PART...";

/// Largest number of milliseconds for which an answer may have duties.
inline constexpr std::size_t longest_batch = 64;

/// Appends the readings of a tick to a text, as numbers with a blank before each.
void add_sense(const Sense& sense, std::string& text);

/// Parses an answer into duties tick by tick; the first tick has the answer's word. nullopt if it is invalid.
std::optional<std::vector<ControllerTick>> read_duties(std::string_view line);

/// What the pairs of numbers in a controller's answers are.
enum class AnswerUnits : std::uint8_t {
  duties,  ///< of the motors, in parts of ControllerTick::full
  speeds,  ///< speed in mm/s, and turn rate in thousandths of rad/s to the left
};

/// A parsed answer: its ticks, or a verdict if it is invalid.
struct DutiesAnswer {
  std::vector<ControllerTick> ticks;
  std::optional<Verdict> verdict;
};
DutiesAnswer judge_duties(std::string_view line, std::string_view more);

// Parts of the built-in controller.

/// Appends numbers to a text, each with a blank before it, so that they are read back with the same bits: x and y, and
/// a direction as its cosine and sine.
void add_place(const Position& position, const Direction& ahead, std::string& text);
/// The same of a target: its place, speed, acceleration, turn rate and angular acceleration.
void add_target(const Target& target, std::string& text);
/// The same of an estimate: its place, slip angle, speed, turn rate, and the upper triangle of the covariance by rows.
void add_estimate(const PoseEstimate& estimate, std::string& text);

/// The parts that a program offers.
struct OfferedParts {
  bool estimator = false, reader = false, tracker = false;

  friend bool operator==(const OfferedParts&, const OfferedParts&) = default;
};

/// Parses the first line of a program with parts; nullopt if it is invalid or names no part.
std::optional<OfferedParts> read_parts_greeting(std::string_view line);
/// Parse answers of the parts; nullopt if they are invalid.
std::optional<PoseEstimate> read_estimate(std::string_view line);
std::optional<WallEvidence> read_evidence(std::string_view line);
std::optional<Drive> read_part_duties(std::string_view line);

/// A parsed line, or a verdict if it is invalid or a forfeit.
template <class Value>
struct JudgedLine {
  Value value{};
  std::optional<Verdict> verdict;
};
JudgedLine<AnswerUnits> judge_controller_greeting(std::string_view line);
JudgedLine<OfferedParts> judge_parts_greeting(std::string_view line);
JudgedLine<PoseEstimate> judge_estimate(std::string_view line, std::string_view more);
JudgedLine<WallEvidence> judge_evidence(std::string_view line, std::string_view more);
JudgedLine<Drive> judge_part_duties(std::string_view line, std::string_view more);

}  // namespace labmouse
