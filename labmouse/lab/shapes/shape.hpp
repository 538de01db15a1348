// Describes the structure of JSON (a schema). The page's TypeScript types are generated from it, and tests check
// answers against it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace labmouse {

struct ShapeField;

/// The structure of one JSON value.
struct Shape {
  enum class Kind { anything, text, number, flag, null, bytes, word, exactly, named, list, tuple, map, object, either };

  /// Implicit, so that `text` and `number` can be used as shapes.
  Shape(Kind what);  // NOLINT(google-explicit-constructor)
  Shape(Kind what, std::string words, std::vector<Shape> several);

  Kind kind;
  /// The value of a `word` or an `exactly`, or the name of the declaration that `named` refers to.
  std::string text;
  /// The shape of each element of a `list` or `map`, of the elements of a `tuple` in order, or the alternatives of an
  /// `either`.
  std::vector<Shape> parts;
  std::vector<ShapeField> fields;
  /// Names of declarations whose fields an object inherits.
  std::vector<std::string> bases;
};

/// A field of an object.
struct ShapeField {
  std::string name;
  Shape shape;
  /// A description for readers of the answer; empty where the name is enough.
  std::string meaning;
  bool optional = false;
};

inline Shape::Shape(Kind what) : kind(what) {}
inline Shape::Shape(Kind what, std::string words, std::vector<Shape> several)
    : kind(what), text(std::move(words)), parts(std::move(several)) {}

/// A shape with a name.
struct Declaration {
  std::string name, meaning;
  Shape shape;
};

/// Short names and functions to write shapes.
namespace shapes {

constexpr auto anything = Shape::Kind::anything;
constexpr auto text = Shape::Kind::text;
constexpr auto number = Shape::Kind::number;
constexpr auto flag = Shape::Kind::flag;
constexpr auto null = Shape::Kind::null;
/// Binary data, which is sent beside the JSON.
constexpr auto bytes = Shape::Kind::bytes;

inline Shape word(std::string one) { return {Shape::Kind::word, std::move(one), {}}; }
inline Shape exactly(int value) { return {Shape::Kind::exactly, std::to_string(value), {}}; }
/// The shape of the declaration of that name.
inline Shape named(std::string name) { return {Shape::Kind::named, std::move(name), {}}; }
inline Shape list(Shape each) { return {Shape::Kind::list, "", {std::move(each)}}; }
inline Shape tuple(std::vector<Shape> parts) { return {Shape::Kind::tuple, "", std::move(parts)}; }
/// An object with fields of any name.
inline Shape map(Shape each) { return {Shape::Kind::map, "", {std::move(each)}}; }
inline Shape either(std::vector<Shape> parts) { return {Shape::Kind::either, "", std::move(parts)}; }
inline Shape object(std::vector<ShapeField> fields, std::vector<std::string> bases = {}) {
  Shape shape = Shape::Kind::object;
  shape.fields = std::move(fields);
  shape.bases = std::move(bases);
  return shape;
}
inline Shape or_null(Shape shape) { return either({std::move(shape), null}); }
inline Shape words(const std::vector<std::string>& some) {
  Shape any = either({});
  for (const std::string& one : some) any.parts.push_back(word(one));
  return any;
}

inline ShapeField field(std::string name, Shape shape, std::string meaning = {}) {
  return {std::move(name), std::move(shape), std::move(meaning), false};
}
/// A field that may be missing.
inline ShapeField maybe(std::string name, Shape shape, std::string meaning = {}) {
  return {std::move(name), std::move(shape), std::move(meaning), true};
}

}  // namespace shapes

}  // namespace labmouse
