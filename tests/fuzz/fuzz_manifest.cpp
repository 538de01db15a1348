// Any bytes as the manifest of an entry: there is a mouse with a name, authors and a licence, or there are problems.
#include "labmouse/lab/league/entry_folder.hpp"
#include "labmouse/lab/text/printable.hpp"
#include "tests/fuzz/fuzzer.hpp"

namespace labmouse::fuzz {

LABMOUSE_FUZZER(manifest) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  const EntryManifestResult read = read_manifest(text);
  require(read.problems.size() <= most_problems);
  if (!read.problems.empty()) return 0;
  const EntryManifest& entry = read.entry;
  require(!entry.name.empty() && !entry.authors.empty() && !entry.licence.empty());
  require(!entry.kind.empty() && !entry.launch.empty());
  for (const std::string& author : entry.authors) require(!author.empty() && shown(author) == author);
  return 0;
}

}  // namespace labmouse::fuzz
