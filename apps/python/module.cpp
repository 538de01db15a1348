// labmouse._native: the library for Python. What it computes comes from the library; what a user sees first is in
// apps/python/labmouse.
#include <fmt/format.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include <filesystem>
#include <string>

#include "bindings.hpp"
#include "errors.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/version.hpp"

NB_MODULE(_native, module) {
  // What lives in a notebook's own variables when Python ends is no leak.
  nanobind::set_leak_warnings(false);
  module.doc() = "The part of labmouse that is compiled.";
  module.def(
      "version", [] { return std::string(labmouse::version()); }, "The release, and the commit where it is known.");
  labmouse::python::bind_errors(module);
  module.def(
      "write_file",
      [](const std::filesystem::path& path, const std::string& text) {
        const std::string file = path.string();
        if (const auto error = labmouse::write_file(file, text); !error.empty())
          throw labmouse::python::UserError(fmt::format("{}: error: {}", file, error));
      },
      nanobind::arg("path"), nanobind::arg("text"),
      nanobind::sig("def write_file(path: str | os.PathLike[str], text: str) -> None"),
      "Writes a file whole or not at all. Raises Error.");
  labmouse::python::bind_mazes(module);
  labmouse::python::bind_sightings(module);
  labmouse::python::bind_briefings(module);
  labmouse::python::bind_live_strategies(module);
  labmouse::python::bind_races(module);
  labmouse::python::bind_records(module);
  labmouse::python::bind_bounds(module);
  labmouse::python::bind_robots(module);
  labmouse::python::bind_learning(module);
  labmouse::python::bind_studies(module);
}
