#include "tests/lab/page/shape_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse::test {
namespace {

using Kind = Shape::Kind;

std::string unless(bool good, const std::string& path, std::string_view what) {
  return good ? "" : fmt::format("{} is not {}", path, what);
}

std::string each_mismatch(const ReadJson& json, const Shape& shape, const std::string& path) {
  if (!json.is_array()) return path + " is not a list";
  for (std::size_t i = 0; i < json.size(); ++i)
    if (std::string wrong = mismatch(json[i], shape.parts[0], fmt::format("{}[{}]", path, i)); !wrong.empty())
      return wrong;
  return "";
}

std::string tuple_mismatch(const ReadJson& json, const Shape& shape, const std::string& path) {
  if (!json.is_array() || json.size() != shape.parts.size())
    return fmt::format("{} is not a list of {}", path, shape.parts.size());
  for (std::size_t i = 0; i < json.size(); ++i)
    if (std::string wrong = mismatch(json[i], shape.parts[i], fmt::format("{}[{}]", path, i)); !wrong.empty())
      return wrong;
  return "";
}

std::string map_mismatch(const ReadJson& json, const Shape& shape, const std::string& path) {
  if (!json.is_object()) return path + " is not an object";
  for (const auto& [name, value] : json.items())
    if (std::string wrong = mismatch(value, shape.parts[0], fmt::format("{}.{}", path, name)); !wrong.empty())
      return wrong;
  return "";
}

/// The fields of an object with those of its bases; `open` where a base has fields of any name.
std::vector<ShapeField> all_fields(const Shape& shape, bool& open) {
  std::vector<ShapeField> fields = shape.fields;
  for (const std::string& name : shape.bases) {
    const Shape* base = find_shape(name);
    if (base == nullptr) continue;
    open = open || base->kind == Kind::map;
    const std::vector<ShapeField> more = all_fields(*base, open);
    fields.insert(fields.end(), more.begin(), more.end());
  }
  return fields;
}

std::string object_mismatch(const ReadJson& json, const Shape& shape, const std::string& path) {
  if (!json.is_object()) return path + " is not an object";
  bool open = false;
  const std::vector<ShapeField> fields = all_fields(shape, open);
  for (const ShapeField& field : fields) {
    if (field.shape.kind == Kind::bytes) continue;
    const std::string place = fmt::format("{}.{}", path, field.name);
    const auto found = json.find(field.name);
    if (found == json.end() && !field.optional) return place + " is missing";
    if (found == json.end()) continue;
    if (std::string wrong = mismatch(*found, field.shape, place); !wrong.empty()) return wrong;
  }
  for (const auto& [name, value] : json.items()) {
    const auto is_it = [&wanted = name](const ShapeField& field) { return field.name == wanted; };
    const bool known = std::any_of(fields.begin(), fields.end(), is_it);
    if (!known && !open) return fmt::format("{}.{} is not in its shape", path, name);
  }
  return "";
}

/// Of what is none of several, the reason that lies deepest: there it came closest.
std::string either_mismatch(const ReadJson& json, const Shape& shape, const std::string& path) {
  const auto depth = [](const std::string& reason) { return std::count(reason.begin(), reason.end(), '.'); };
  std::string said = path + " is none of what it may be";
  for (const Shape& part : shape.parts) {
    std::string wrong = mismatch(json, part, path);
    if (wrong.empty()) return "";
    const bool says_little = part.kind == Kind::null || part.kind == Kind::word;
    if (!says_little && depth(wrong) >= depth(said)) said = std::move(wrong);
  }
  return said;
}

std::string named_mismatch(const ReadJson& json, const Shape& shape, const std::string& path) {
  const Shape* found = find_shape(shape.text);
  return found == nullptr ? fmt::format("{}: no shape is named '{}'", path, shape.text) : mismatch(json, *found, path);
}

}  // namespace

std::string mismatch(const ReadJson& json, const Shape& shape, const std::string& path) {
  switch (shape.kind) {
    case Kind::text:
      return unless(json.is_string(), path, "a string");
    case Kind::number:
      return unless(json.is_number(), path, "a number");
    case Kind::flag:
      return unless(json.is_boolean(), path, "true or false");
    case Kind::null:
      return unless(json.is_null(), path, "null");
    case Kind::word:
      return unless(json == shape.text, path, "'" + shape.text + "'");
    case Kind::exactly:
      return unless(json.is_number_integer() && json.dump() == shape.text, path, shape.text);
    case Kind::named:
      return named_mismatch(json, shape, path);
    case Kind::list:
      return each_mismatch(json, shape, path);
    case Kind::tuple:
      return tuple_mismatch(json, shape, path);
    case Kind::map:
      return map_mismatch(json, shape, path);
    case Kind::object:
      return object_mismatch(json, shape, path);
    case Kind::either:
      return either_mismatch(json, shape, path);
    case Kind::anything:
    case Kind::bytes:
      break;
  }
  return "";
}

}  // namespace labmouse::test
