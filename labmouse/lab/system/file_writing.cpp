#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "labmouse/lab/system/calls.hpp"
#include "labmouse/lab/system/descriptor.hpp"
#include "labmouse/lab/system/file_problems.hpp"
#include "labmouse/lab/system/files.hpp"
#include "labmouse/lab/system/streams.hpp"

namespace labmouse {
namespace {

namespace fs = std::filesystem;

std::string unwritable(int error_number) { return error_number == 0 ? "" : "cannot write: " + cause_of(error_number); }

/// The file to which a path leads, or why it cannot be written.
struct WriteTarget {
  fs::path path;
  std::optional<fs::perms> permissions;  ///< of the existing file
  bool stream = false;
  std::string error;
};

WriteTarget refused(int error) { return {{}, std::nullopt, false, unwritable(error)}; }

/// The end of a chain of links, which need not exist. Writing changes the target and keeps the links.
fs::path end_of_links(fs::path path) {
  std::error_code error;
  while (fs::is_symlink(fs::symlink_status(path, error))) path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

WriteTarget target_of(const std::string& path) {
  if (path.empty()) return {{}, std::nullopt, false, "the path of the file is empty"};
  if (path.back() == '/') return refused(EISDIR);
  if (descriptor_to_write(path)) return {path, std::nullopt, true, {}};
  std::error_code error;
  if (const fs::path folder = fs::path(path).parent_path(); !folder.empty()) fs::create_directories(folder, error);
  if (error) return refused(error.value());
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status) && error && error != std::errc::no_such_file_or_directory)
    return refused(error.value());  // also for links in a circle
  if (!fs::exists(status)) return {end_of_links(path), std::nullopt, false, {}};
  if (fs::is_directory(status)) return refused(EISDIR);
  if (!fs::is_regular_file(status)) return {path, std::nullopt, true, {}};
  // Check this, because a rename would replace even a read-only file.
  if (const int reason = writable_error(path); reason != 0) return refused(reason);
  return {end_of_links(path), status.permissions() & fs::perms::mask, false, {}};
}

int write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const std::ptrdiff_t count = write_some(descriptor, content.data(), content.size());
    if (count < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

/// Writes a text part by part; after an error it skips the rest.
int write_all(int descriptor, const TextSource& content) {
  int error = 0;
  content([&](std::string_view part) {
    if (error == 0) error = write_all(descriptor, part);
  });
  return error;
}

/// Writes directly into a stream, which a rename must not replace.
int write_through(const std::string& path, const TextSource& content) {
  if (const auto descriptor = descriptor_to_write(path)) return write_all(*descriptor, content);
  Descriptor opened = Descriptor::opened(open_to_write(path));
  if (opened.number() < 0) return errno;
  const int error = write_all(opened.number(), content);
  return error != 0 ? error : opened.close();
}

/// A new temporary file in the target's folder, removed in the destructor unless it was renamed to the target. Its name
/// is short, however long the target's name is.
class Part {
 public:
  explicit Part(const WriteTarget& target)
      : folder_(target.path.parent_path()), file_(Descriptor::opened(make(target.permissions))) {}
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  ~Part() {
    std::error_code unknown;
    if (!path_.empty()) fs::remove(path_, unknown);
  }

  int error() const { return error_; }

  int fill(const TextSource& content) {
    const int error = write_all(file_.number(), content);
    return error != 0 ? error : file_.close();
  }

  int put(const fs::path& place) {
    std::error_code error;
    fs::rename(path_, place, error);
    if (!error) path_.clear();
    return error.value();
  }

 private:
  int make(const std::optional<fs::perms>& permissions) {
    constexpr auto usual = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read |
                           fs::perms::group_write | fs::perms::others_read | fs::perms::others_write;
    static std::atomic<unsigned> parts{0};
    int number = -1;
    // A killed process with the same id may have left such a file.
    do {
      path_ = (folder_ / fmt::format(".labmouse-{}-{}.part", process_number(), parts++)).string();
      number = open_new(path_, permissions.value_or(usual));
    } while (number < 0 && errno == EEXIST);
    if (number < 0) {
      error_ = errno;
      path_.clear();
    } else if (permissions) {
      // Gives it the permissions of the file that it replaces. If that fails, the umask has made them narrower.
      std::error_code failed;
      fs::permissions(path_, *permissions, failed);
    }
    return number;
  }

  fs::path folder_;
  std::string path_;
  int error_ = 0;
  Descriptor file_;
};

int replace(const WriteTarget& target, const TextSource& content) {
  // Blocks signals, so that no temporary file is left behind.
  const Undisturbed undisturbed;
  Part part(target);
  if (part.error() != 0) return part.error();
  const int error = part.fill(content);
  return error != 0 ? error : part.put(target.path);
}

}  // namespace

bool is_same_file(const std::string& path, const std::string& other) {
  const auto descriptor = descriptor_to_write(path), other_descriptor = descriptor_to_write(other);
  if (descriptor || other_descriptor) return descriptor == other_descriptor;
  std::error_code error;
  if (fs::equivalent(path, other, error)) return true;
  const auto place_of = [&error](const std::string& name) {
    const fs::path whole = fs::absolute(end_of_links(name), error);
    const fs::path real = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : real;
  };
  return place_of(path) == place_of(other);
}

std::string write_file(const std::string& path, std::string_view content) {
  return write_file(path, [content](const TextSink& sink) { sink(content); });
}

std::string write_file(const std::string& path, const TextSource& content) {
  const WriteTarget target = target_of(path);
  if (!target.error.empty()) return target.error;
  return unwritable(target.stream ? write_through(path, content) : replace(target, content));
}

std::string check_writable(const std::string& path) {
  const WriteTarget target = target_of(path);
  if (!target.error.empty()) return target.error;
  if (const auto descriptor = descriptor_to_write(path)) return unwritable(writable_error(*descriptor));
  if (target.stream) return "";
  const Undisturbed undisturbed;
  return unwritable(Part(target).error());
}

}  // namespace labmouse
