// The world that a TOML file names, with its settings.
#pragma once

#include <string>

#include "labmouse/lab/races/world_entry.hpp"
#include "labmouse/lab/text/toml_fields.hpp"

namespace labmouse {

/// A world with the settings that a file chose.
struct NamedWorld {
  const WorldEntry* entry = nullptr;  ///< never null after reading
  WorldSettings settings;
};

/// Reads the text `world` and the table `settings`; the first world if there is no `world`.
NamedWorld read_world(const toml::table& table, TomlFields& fields);

/// Makes the world. A setting that can be a file, such as a robot, is looked for in that folder first.
WorldResult make_world(const NamedWorld& named, const std::string& folder);

/// Whether the setting takes files, such as that of a robot, and there is a file of that path.
bool can_be_file(const WorldSetting& setting, const std::string& path);

/// The path in the folder, if there is such a file; or the name as it stands.
std::string beside(const std::string& folder, const std::string& name);

}  // namespace labmouse
