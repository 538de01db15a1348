// Reads mice from SPECs: `name[:key=value]...[:parts=COMMAND]`, several separated by commas, each with an optional
// `NAME=` before it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "labmouse/lab/mice/contestant.hpp"
#include "labmouse/strategies/builtin_mice.hpp"

namespace labmouse {

/// Reads one or more mice, and the mice files and prior files that they name. Duplicates count once. The SPEC of an
/// external mouse or a mice file extends to the end of the text.
SpecResult read_specs(std::string_view text, const ExternalOptions& options = {});

/// The same for several texts.
SpecResult read_specs(std::span<const std::string> texts, const ExternalOptions& options = {});

/// Reads a SPEC from an untrusted file: only built-in mice. External mice and mice files are refused before anything is
/// looked up or started, and priors are read from regular files only.
SpecResult read_builtin_specs(std::string_view text);

/// The table entry of a built-in mouse; null for an external mouse and for the oracle.
const BuiltinMouse* entry_of(const Contestant& mouse);

/// Error text for an unknown name, with a suggestion of a similar one.
std::string unknown_mouse(std::string_view name);

/// A variant of the mouse for each value of a parameter, in the order of the values; a value in the SPEC is overridden.
/// Equal values in different spelling count once. In a command each `{parameter}` is replaced by the value; in a mice
/// file also in its arguments and variables. Variants lose the name that a user gave the mouse.
SpecResult read_variants(std::string_view spec, std::string_view parameter, std::span<const std::string> values,
                         const ExternalOptions& options = {});

/// The single mouse of a SPEC with values for some of its parameters, which override those of the SPEC.
SpecResult read_variant(std::string_view spec, std::span<const Setting> values, const ExternalOptions& options = {});

/// The same for a mouse that was read before; its own files are not read again.
SpecResult read_variant(const Contestant& mouse, std::span<const Setting> values);

/// Whether a world in seconds has errors (failure model, physical): then more parameters have an effect. Only the
/// physical world has a controller whose parts can be replaced.
enum class Driving : std::uint8_t { ideal, with_errors, by_controller };

/// Why these mice cannot race in seconds, or which parameter has no effect there; empty if they can. The text names
/// mice that can.
std::string refuse_to_drive(std::span<const Contestant> mice, Driving driving = Driving::ideal);

/// Why a mouse cannot race in steps, or which parameter has no effect there; empty if it can.
std::string refuse_to_walk(const Contestant& mouse);

/// The settings of a mouse that have an effect in seconds. If the mouse also races in steps, settings that have an
/// effect in seconds only are included only where they differ from their defaults, because there are many.
Settings settings_in_seconds(const Contestant& mouse);
/// The settings of a mouse that have an effect in steps.
Settings settings_in_steps(const Contestant& mouse);

/// Every built-in mouse with its defaults.
std::vector<Contestant> all_contestants();

}  // namespace labmouse
