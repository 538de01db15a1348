#include "labmouse/lab/grading/students.hpp"

#include "labmouse/lab/mice/specs.hpp"
#include "labmouse/lab/mice_files/mice_file.hpp"

namespace labmouse {

ClassResult read_class(const std::string& path, std::string_view text, const ExternalOptions& options) {
  const MiceFileResult file = read_mice_file(text);
  ClassResult result;
  result.problems = file.problems;
  for (const MiceFileEntry& entry : file.mice) {
    SpecResult read = read_specs("mice-file:" + path + ":" + entry.name, options);
    Student& student = result.students.emplace_back();
    student.name = entry.name;
    if (read.error.empty() && !read.contestants.empty())
      student.mouse = std::move(read.contestants.front());
    else
      student.broken = read.error;
  }
  return result;
}

}  // namespace labmouse
