// Who races: mice by their SPEC, `name[:key=value]...`, several separated by commas; each may have `NAME=` before it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {

/// Reads one or more mice; a name that stands twice with equal parameters counts once. Reads the files of their priors
/// and mice files. The SPEC of an external mouse or a mice file reaches to the end of the text.
SpecResult read_specs(std::string_view text, const ExternalOptions& options = {});

/// The same of several texts.
SpecResult read_specs(std::span<const std::string> texts, const ExternalOptions& options = {});

/// Reads a SPEC that comes from a file, which somebody else may have written: only built-in mice.
/// External mice and mice files are refused before anything is looked up or started, and priors are read from regular
/// files alone.
SpecResult read_builtin_specs(std::string_view text);

/// The line of a built-in mouse; null for an external mouse and for the oracle.
const BuiltinMouse* entry_of(const Contestant& mouse);

/// Why there is no mouse of that name, with the one that may have been meant.
std::string unknown_mouse(std::string_view name);

/// The mouse of a SPEC once for each value of one of its parameters, in the order of the values; what the SPEC says of
/// that parameter is overridden. Values that are spelled differently and are equal count once. An external mouse has
/// the parameters that its SPEC leaves room for: each `{parameter}` there, and in a mice file in its arguments and
/// variables, becomes the value as it is spelled. Variants do not keep the name that a user gave the mouse.
SpecResult read_variants(std::string_view spec, std::string_view parameter, std::span<const std::string> values,
                         const ExternalOptions& options = {});

/// The one mouse of a SPEC with values for some of its parameters; what the SPEC says of those is overridden.
SpecResult read_variant(std::string_view spec, std::span<const Setting> values);

/// The same of a mouse that was read before; of its files none is read again.
SpecResult read_variant(const Contestant& mouse, std::span<const Setting> values);

/// Whether things go wrong in a world in seconds: then more parameters of a mouse count.
enum class Driving : std::uint8_t { ideal, with_errors };

/// Why these mice cannot race in seconds, with the names of those that can, or which parameter of one has no effect
/// there; empty where they can.
std::string refuse_to_drive(std::span<const Contestant> mice, Driving driving = Driving::ideal);

/// Why a mouse cannot race in steps; empty where it can.
std::string refuse_to_walk(const Contestant& mouse);

/// The settings of such a mouse that count in seconds; those that count there alone only where they are not the
/// defaults, since they are many.
Settings settings_in_seconds(const Contestant& mouse);
/// Those that count in steps.
Settings settings_in_steps(const Contestant& mouse);

/// Every built-in mouse with its defaults.
std::vector<Contestant> all_contestants();

}  // namespace labmouse
