// The folder of an entry: its manifest `entry.toml`, and its files.
#pragma once

#include <string>
#include <vector>

#include "labmouse/lab/mice_files/mice_file.hpp"

namespace labmouse {

inline constexpr const char* manifest_name = "entry.toml";
inline constexpr std::size_t most_entry_bytes = std::size_t{64} << 20U;
inline constexpr int most_entry_files = 4000;

/// A manifest: a mice file with one mouse, its authors and its licence.
struct EntryManifest {
  std::string name;
  std::vector<std::string> authors;
  std::string licence;
  std::string robot;   ///< that it is made for; may be empty
  std::string kind;    ///< "mouse", "program" ...
  std::string launch;  ///< SPEC, file or command
};

/// A manifest, or the problems of its file.
struct EntryManifestResult {
  EntryManifest entry;
  std::vector<Problem> problems;
};

/// Reads a manifest. Besides the problems of mice files it refuses what would give an entry other conditions than the
/// others have, and paths that lead out of its folder.
EntryManifestResult read_manifest(std::string_view text);

/// Copies the files of an entry into a new folder. It refuses links, pipes and devices, and more files or bytes than an
/// entry may have.
/// @return the error, as a line for the user; empty on success. After an error the new folder may have some files.
std::string copy_entry(const std::string& from, const std::string& to);

/// A file of an entry.
struct EntryFile {
  std::string path;  ///< in the folder of all entries
  std::string content;
};

/// The files of entries that are made of the built-in templates of robots, without the one that only shows how to
/// begin.
std::vector<EntryFile> template_entries();

/// A hash, or the error as a line for the user.
struct FolderHash {
  std::string hash;
  std::string error;
};

/// SHA-256 of the names and contents of all files in the folder and of who may run them, as 64 hexadecimal digits:
/// another one is another mouse. It refuses what copy_entry() refuses, and Python environments.
FolderHash hash_of_folder(const std::string& folder);

}  // namespace labmouse
