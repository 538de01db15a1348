// Line protocol between labmouse and an external mouse in the world of steps. docs/reference/protocols.md explains it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "labmouse/mouse/action.hpp"
#include "labmouse/mouse/briefing.hpp"
#include "labmouse/mouse/sighting.hpp"

namespace labmouse {

/// The first line of both sides: the protocol and its version.
inline constexpr std::string_view program_greeting = "labmouse 1";

/// The briefing of an external mouse, in lines from the greeting to `begin`.
std::string briefing_text(const Briefing& briefing);

/// The question of one step, as a line.
std::string question(const Sighting& seen);

/// Parses an answer, a line without its end: `move ROTATION MOVEMENT`, `reset` or `forfeit`; nullopt if it is invalid.
std::optional<Action> read_answer(std::string_view line);

}  // namespace labmouse
