// labmouse._native: binds the C++ library for the Python package in apps/python/labmouse.
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
  // Variables of a notebook keep objects alive until Python ends; that is not a leak.
  nanobind::set_leak_warnings(false);
  module.doc() = "The compiled part of labmouse.";
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
      "Writes a file completely or not at all. Raises Error if it cannot be written.");
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
  labmouse::python::bind_comparisons(module);
  labmouse::python::bind_seasons(module);
  labmouse::python::bind_real_robots(module);
}
