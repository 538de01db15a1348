// The shape of JSON as a value: what may stand where. TypeScript is written from it, and answers are checked against
// it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace labmouse {

struct ShapeField;

/// What may stand at a place.
struct Shape {
  enum class Kind { anything, text, number, flag, null, bytes, word, exactly, named, list, tuple, map, object, either };

  /// From a kind alone, so that `text` and `number` are shapes.
  Shape(Kind what);  // NOLINT(google-explicit-constructor)
  Shape(Kind what, std::string words, std::vector<Shape> several);

  Kind kind;
  /// The one word of a word, the number of `exactly`, and the declaration that a named one refers to.
  std::string text;
  /// What a list and a map have in each place, a tuple in turn, and what may stand where it is one of several.
  std::vector<Shape> parts;
  std::vector<ShapeField> fields;
  /// Declarations whose fields an object has, too.
  std::vector<std::string> bases;
};

struct ShapeField {
  std::string name;
  Shape shape;
  /// A sentence or a few for those who read the answer; empty where the name says it all.
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

/// The words in which shapes are written.
namespace shapes {

constexpr auto anything = Shape::Kind::anything;
constexpr auto text = Shape::Kind::text;
constexpr auto number = Shape::Kind::number;
constexpr auto flag = Shape::Kind::flag;
constexpr auto null = Shape::Kind::null;
/// Goes beside the JSON.
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
