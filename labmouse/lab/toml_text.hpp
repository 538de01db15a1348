// TOML from users: parsed, and what is wrong with it told in lines and columns.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "labmouse/maze/formats/format.hpp"

#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace labmouse {

/// A table, or the problem that makes the text none.
struct TomlText {
  toml::table table;
  std::vector<Problem> problems;
};

/// Parses a text of at most 64 KiB.
TomlText parse_toml(std::string_view text);

Problem problem_at(const toml::source_position& place, std::string reason);

/// The problems in the order of the file, as many as are told at once.
std::vector<Problem> in_order(std::vector<Problem> problems);

/// "unknown key 'colur'; did you mean 'colour'?"
std::string unknown_key(const std::string& name, std::span<const std::string_view> known);

}  // namespace labmouse
