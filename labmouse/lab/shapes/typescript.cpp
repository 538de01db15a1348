#include "labmouse/lab/shapes/typescript.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "labmouse/lab/shapes/shapes.hpp"

namespace labmouse {
namespace {

using Kind = Shape::Kind;

/// Characters in a line of a comment.
constexpr std::size_t line_width = 116;

constexpr std::string_view head =
    R"(// What the core (labmouse compiled to WebAssembly) is asked and answers. Cells are [x, y], (0,0) in the south-west;
// lists over cells run by y * width + x.
// Written by scripts/page-types from labmouse/lab/shapes: make changes there.
)";

std::string written(const Shape& shape, const std::string& indent);

std::string comment(const std::string& meaning, const std::string& indent) {
  if (meaning.empty()) return "";
  if (indent.size() + meaning.size() + 7 <= line_width) return fmt::format("{}/** {} */\n", indent, meaning);
  std::string text = indent + "/**\n" + indent + " *";
  std::size_t column = indent.size() + 2;
  for (std::size_t at = 0; at < meaning.size();) {
    const std::size_t end = std::min(meaning.find(' ', at), meaning.size());
    if (column + 1 + end - at > line_width) {
      text += "\n" + indent + " *";
      column = indent.size() + 2;
    }
    text += " " + meaning.substr(at, end - at);
    column += 1 + end - at;
    at = end + 1;
  }
  return text + "\n" + indent + " */\n";
}

/// An object in one line; empty where it is too long or a field has a comment.
std::string short_body(const Shape& object, const std::string& indent) {
  std::string text = "{";
  for (const ShapeField& field : object.fields) {
    if (!field.meaning.empty()) return "";
    text += fmt::format(" {}{}: {};", field.name, field.optional ? "?" : "", written(field.shape, indent));
  }
  text.back() = ' ';
  text += '}';
  return indent.empty() || text.size() > line_width - 30 || text.find('\n') != std::string::npos ? "" : text;
}

std::string body(const Shape& object, const std::string& indent) {
  if (std::string text = short_body(object, indent); !text.empty()) return text;
  std::string text = "{\n";
  for (const ShapeField& field : object.fields) {
    text += comment(field.meaning, indent + "  ");
    text += fmt::format("{}  {}{}: {};\n", indent, field.name, field.optional ? "?" : "",
                        written(field.shape, indent + "  "));
  }
  return text + indent + "}";
}

std::string joined(const std::vector<Shape>& parts, std::string_view between, const std::string& indent) {
  std::string text;
  for (const Shape& part : parts) text += (text.empty() ? "" : std::string(between)) + written(part, indent);
  return text;
}

std::string object_written(const Shape& shape, const std::string& indent) {
  if (shape.fields.empty() && shape.bases.empty()) return "Record<string, never>";
  std::string text;
  for (const std::string& base : shape.bases) text += base + " & ";
  return text + body(shape, indent);
}

std::string list_written(const Shape& each, const std::string& indent) {
  const bool several = each.kind == Kind::either || !each.bases.empty();
  const std::string text = written(each, indent);
  return several ? "(" + text + ")[]" : text + "[]";
}

std::string written(const Shape& shape, const std::string& indent) {
  switch (shape.kind) {
    case Kind::anything:
      return "unknown";
    case Kind::text:
      return "string";
    case Kind::number:
      return "number";
    case Kind::flag:
      return "boolean";
    case Kind::null:
      return "null";
    case Kind::bytes:
      return "Uint8Array";
    case Kind::word:
      return "'" + shape.text + "'";
    case Kind::exactly:
    case Kind::named:
      return shape.text;
    case Kind::list:
      return list_written(shape.parts[0], indent);
    case Kind::tuple:
      return "[" + joined(shape.parts, ", ", indent) + "]";
    case Kind::map:
      return "Record<string, " + written(shape.parts[0], indent) + ">";
    case Kind::object:
      return object_written(shape, indent);
    case Kind::either:
      return joined(shape.parts, " | ", indent);
  }
  return "";
}

std::string declared(const Declaration& declaration) {
  const Shape& shape = declaration.shape;
  const std::string text = "\n" + comment(declaration.meaning, "") + "export ";
  if (shape.kind != Kind::object) return fmt::format("{}type {} = {};\n", text, declaration.name, written(shape, ""));
  std::string bases;
  for (const std::string& base : shape.bases) bases += (bases.empty() ? " extends " : ", ") + base;
  return fmt::format("{}interface {}{} {}\n", text, declaration.name, bases, body(shape, ""));
}

std::string call_written(const CallShape& call) {
  const std::string indent = "    ";
  std::string text = comment(call.meaning, "  ") + fmt::format("  {}: {{\n", call.name);
  text += fmt::format("{}request: {};\n", indent, written(call.request, indent));
  if (call.bytes != CallBytes::none)
    text += fmt::format("{}bytes{}: Uint8Array;\n", indent, call.bytes == CallBytes::optional ? "?" : "");
  return text + fmt::format("{}answer: {};\n  }};\n", indent, written(call.answer, indent));
}

}  // namespace

std::string page_typescript() {
  std::string text(head);
  for (const Declaration& declaration : all_shapes()) text += declared(declaration);
  text +=
      "\n/** Every function of the core: what it is asked and what it answers. `bytes` goes beside the request. */\n";
  text += "export interface Calls {\n";
  for (const CallShape& call : call_shapes()) text += call_written(call);
  return text + "}\n\nexport type CallName = keyof Calls;\n";
}

}  // namespace labmouse
