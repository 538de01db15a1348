#include "labmouse/lab/page/results.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <set>

#include "labmouse/lab/races/earlier_results.hpp"
#include "labmouse/lab/text/json_fields.hpp"

namespace labmouse {
namespace {

/// Copies an object of results field by field, and checks types.
class Taker {
 public:
  Taker(const ReadJson& from, std::string path) : from_(from), path_(path), fields_(from, std::move(path)) {}

  Taker& texts(std::initializer_list<const char*> keys) {
    for (const char* key : keys) out_[key] = fields_.text(key);
    return *this;
  }
  Taker& numbers(std::initializer_list<const char*> keys) {
    for (const char* key : keys) take(key, [&] { fields_.number(key, -most, most); });
    return *this;
  }
  /// Numbers; null or missing ones become null.
  Taker& numbers_or_null(std::initializer_list<const char*> keys) {
    for (const char* key : keys)
      if (is_null(key))
        out_[key] = nullptr;
      else
        numbers({key});
    return *this;
  }
  Taker& counts(std::initializer_list<const char*> keys) {
    for (const char* key : keys) out_[key] = fields_.whole(key, 0, std::numeric_limits<int>::max());
    return *this;
  }
  Taker& flags(std::initializer_list<const char*> keys) {
    for (const char* key : keys) out_[key] = fields_.flag(key);
    return *this;
  }
  Taker& seed() {
    take("seed", [&] {
      if (!fields_.has("seed") || !from_["seed"].is_number_unsigned())
        wrong("seed", "is not a number from 0 to 2^64 - 1");
    });
    return *this;
  }
  /// The field `interval`: [low, high], or null.
  Taker& interval() {
    out_["interval"] = nullptr;
    if (is_null("interval")) return *this;
    const ReadJson& ends = fields_.list("interval");
    if (ends.size() != 2 || !ends[0].is_number() || !ends[1].is_number())
      wrong("interval", "is not [low, high]");
    else
      out_["interval"] = ends;
    return *this;
  }
  Taker& text_list(const char* key) {
    return list(key, [](const ReadJson& text, const std::string& path, std::string& error) {
      if (!text.is_string()) error = fmt::format("'{}' is not a string", path);
      return Json(text);
    });
  }
  /// A list of objects. `read` converts each, and sets the error text if it is invalid.
  Taker& list(const char* key, const std::function<Json(const ReadJson&, const std::string&, std::string&)>& read) {
    Json list = Json::array();
    for (const ReadJson& each : fields_.list(key)) {
      std::string error;
      list.push_back(read(each, fmt::format("{}{}{}[{}]", path_, path_.empty() ? "" : ".", key, list.size()), error));
      fields_.reject(error);
      if (!fields_.error().empty()) break;
    }
    out_[key] = std::move(list);
    return *this;
  }
  /// All further fields that are plain values, intervals, lists of texts or objects of plain values. Deeper values are
  /// left out.
  Taker& others() {
    if (!from_.is_object()) return *this;
    const auto plain = [](const ReadJson& value) { return value.is_primitive(); };
    const auto text = [](const ReadJson& value) { return value.is_string(); };
    for (const auto& [key, value] : from_.items()) {
      const bool texts = value.is_array() && std::all_of(value.begin(), value.end(), text);
      const bool ends = value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
      if (out_.contains(key) || !(plain(value) || texts || ends || value.is_object())) continue;
      if (!value.is_object()) {
        out_[key] = value;
        continue;
      }
      Json& object = out_[key] = Json::object();
      for (const auto& [name, inner] : value.items())
        if (plain(inner)) object[name] = inner;
    }
    return *this;
  }
  /// Returns the copy, and sets `error`.
  Json done(std::string& error) {
    error = fields_.error();
    return std::move(out_);
  }
  Json& out() { return out_; }
  void wrong(const char* key, const std::string& reason) {
    fields_.reject(fmt::format("'{}{}{}' {}", path_, path_.empty() ? "" : ".", key, reason));
  }

 private:
  static constexpr double most = std::numeric_limits<double>::max();

  bool is_null(const char* key) const { return !fields_.has(key) || from_[key].is_null(); }
  template <class Check>
  void take(const char* key, Check check) {
    check();
    if (fields_.error().empty()) out_[key] = from_[key];
  }

  const ReadJson& from_;
  std::string path_;
  JsonFields fields_;
  Json out_ = Json::object();
};

/// Names of the mazes of a race.
using Names = std::set<std::string>;

Names names_in(const Json& mazes) {
  Names names;
  for (const Json& maze : mazes)
    if (maze.contains("name")) names.insert(maze["name"].get<std::string>());
  return names;
}

void check_maze(const Names& mazes, Taker& taker) {
  if (!mazes.contains(taker.out()["maze"].get<std::string>())) taker.wrong("maze", "is not one of the race's mazes");
}

Json take_contest(const ReadJson& json, const std::string& path, const Names& mazes, std::string& error) {
  Taker taker(json, path);
  taker.texts({"maze", "outcome"}).others();
  check_maze(mazes, taker);
  return taker.done(error);
}

Json take_mouse(const ReadJson& json, const std::string& path, const Names& mazes, std::string& error) {
  Taker taker(json, path);
  taker.texts({"name"}).counts({"runs"}).numbers_or_null({"mean_score", "mean_ratio"}).interval();
  taker.list("results", [&](const ReadJson& each, const std::string& at, std::string& wrong) {
    return take_contest(each, at, mazes, wrong);
  });
  return taker.others().done(error);
}

Json take_maze(const ReadJson& json, const std::string& path, std::string& error) {
  return Taker(json, path).texts({"name"}).counts({"width", "height"}).others().done(error);
}

/// Copies a group of results. Fields that all worlds have are required. Other fields are kept if they are plain; the
/// page uses those that it knows.
Json take_group(const ReadJson& json, const std::string& path, std::string& error) {
  Taker taker(json, path);
  taker.texts({"world", "formula"}).list("mazes", take_maze);
  const Names mazes = names_in(taker.out()["mazes"]);
  taker.list("mice", [&](const ReadJson& each, const std::string& at, std::string& wrong) {
    return take_mouse(each, at, mazes, wrong);
  });
  return taker.others().done(error);
}

Json take_skipped(const ReadJson& json, const std::string& path, std::string& error) {
  return Taker(json, path).texts({"path"}).text_list("reasons").done(error);
}

}  // namespace

std::string read_results(const ReadJson& json, Json& results) {
  const ReadJson grouped = with_groups(json);
  Taker taker(grouped, "");
  taker.texts({"labmouse", "compiler", "processor"}).seed().flags({"stopped"}).list("groups", take_group);
  taker.list("skipped", take_skipped);
  std::string error;
  results = taker.done(error);
  return error;
}

}  // namespace labmouse
