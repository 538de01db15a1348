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

/// Reads one or more mice, and the mice files and prior files that they name.
/// @param text SPECs, separated by commas. The SPEC of an external mouse or a mice file extends to the end of the text.
/// @param options how external mice are started.
/// @return the mice in the order of the text, duplicates once. Two different mice of the same name are an error.
SpecResult read_specs(std::string_view text, const ExternalOptions& options = {});

/// Reads the mice of several texts.
/// @param texts each as of read_specs() above.
/// @param options how external mice are started.
/// @return the mice of all texts, duplicates once; the error of the first text that has one.
SpecResult read_specs(std::span<const std::string> texts, const ExternalOptions& options = {});

/// Reads SPECs from an untrusted file: only built-in mice. External mice and mice files are refused before anything is
/// looked up or started.
/// @param text SPECs, separated by commas. Their priors are read from regular files only.
/// @return the mice, or the error.
SpecResult read_builtin_specs(std::string_view text);

/// The table entry of a built-in mouse, also of one with external parts.
/// @param mouse any.
/// @return null for an external mouse and for the oracle.
const BuiltinMouse* entry_of(const Contestant& mouse);

/// The error text for an unknown mouse.
/// @param name as the user wrote it.
/// @return one line, with a similar name or the SPEC to write instead, if there is one.
std::string unknown_mouse(std::string_view name);

/// Reads a variant of a mouse for each value of a parameter.
/// @param spec a single mouse. Its name is dropped; only an external mouse of a mice file keeps it, before the value.
/// @param parameter the name of one of its parameters. For an external mouse, each `{parameter}` in its command is
///   replaced by the value; in a mice file also in its arguments and variables.
/// @param values as text; they override the value in the SPEC.
/// @param options how external mice are started.
/// @return the variants in the order of the values, equal values in different spelling once; or the first error.
SpecResult read_variants(std::string_view spec, std::string_view parameter, std::span<const std::string> values,
                         const ExternalOptions& options = {});

/// Reads the single mouse of a SPEC, with other values for some of its parameters.
/// @param spec a built-in mouse. Its name is dropped.
/// @param values they override those of the SPEC.
/// @param options how external parts are started.
/// @return the mouse, or an error: for several mice, an unknown parameter, an invalid value, a mouse without
///   parameters.
SpecResult read_variant(std::string_view spec, std::span<const Setting> values, const ExternalOptions& options = {});

/// The same for a mouse that was read before; its own files are not read again.
/// @param mouse a built-in mouse; its name is dropped.
/// @param values they override those of the mouse. A prior file among them is read.
/// @return the mouse, or an error: for an unknown parameter, an invalid value, a mouse without parameters.
SpecResult read_variant(const Contestant& mouse, std::span<const Setting> values);

/// Whether a world in seconds has errors (failure model, physical): then more parameters have an effect. Only the
/// physical world has a controller whose parts can be replaced.
enum class Driving : std::uint8_t { ideal, with_errors, by_controller };

/// Why these mice cannot race in seconds, or which of their settings has no effect there.
/// @param mice all that enter the race.
/// @param driving what the world is like.
/// @return a message about the first such mouse; empty if all can.
std::string refuse_to_drive(std::span<const Contestant> mice, Driving driving = Driving::ideal);

/// Why a mouse cannot race in steps, or which of its settings has no effect there.
/// @param mouse one that enters the race.
/// @return a message; empty if it can.
std::string refuse_to_walk(const Contestant& mouse);

/// The settings of a mouse that have an effect in seconds.
/// @param mouse any.
/// @return all settings of a mouse that does not race in steps. Of another one, those with an effect in both worlds,
///   and those with an effect in seconds only if they differ from their defaults, because there are many. Empty for
///   external mice and the oracle.
Settings settings_in_seconds(const Contestant& mouse);
/// The settings of a mouse that have an effect in steps.
/// @param mouse any.
/// @return empty for external mice and the oracle.
Settings settings_in_steps(const Contestant& mouse);

/// Every built-in mouse with its defaults, in the order of the table; the oracle is not among them.
std::vector<Contestant> all_contestants();

}  // namespace labmouse
