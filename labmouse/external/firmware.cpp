#include "labmouse/external/firmware.hpp"

#include <filesystem>

#include "labmouse/external/command_line.hpp"
#include "labmouse/external/our_installation.hpp"

namespace labmouse {

std::string firmware_runner() {
  namespace fs = std::filesystem;
  const fs::path here = fs::path(file_of_this_code()).parent_path();
  for (const fs::path& folder : {here, here.parent_path() / "libexec"}) {
    std::string path = (folder / firmware_runner_name).string();
    if (!program_path(path, "").empty()) return path;
  }
  return program_path(firmware_runner_name, "");
}

Launch firmware_launch(const std::string& runner, const std::string& firmware, const std::string& board) {
  const std::filesystem::path path(firmware);
  Launch launch;
  launch.words = {runner, path.filename().string(), board};
  launch.directory = path.parent_path().string();
  launch.owns_directory = true;
  launch.beginning = "the chip was loaded";
  return launch;
}

}  // namespace labmouse
