#include "labmouse/lab/store/figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "labmouse/lab/text/json.hpp"

namespace labmouse {
namespace {

std::string hexadecimal(std::string_view bytes) {
  std::string text;
  for (const char byte : bytes) text += fmt::format("{:02x}", static_cast<unsigned char>(byte));
  return text;
}

std::optional<std::string> bytes_of(std::string_view hexadecimal) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string bytes;
  if (hexadecimal.size() % 2 != 0) return std::nullopt;
  for (std::size_t i = 0; i < hexadecimal.size(); i += 2) {
    const auto high = digits.find(hexadecimal[i]), low = digits.find(hexadecimal[i + 1]);
    if (high == std::string_view::npos || low == std::string_view::npos) return std::nullopt;
    bytes += static_cast<char>(high * 16 + low);
  }
  return bytes;
}

/// A text in quotation marks; {"bytes": ...} for invalid UTF-8.
std::string quoted(const std::string& text) {
  std::string json = one_line(Json(text));
  if (ReadJson::parse(json).get_ref<const std::string&>() == text) return json;
  return fmt::format("{{\"bytes\":\"{}\"}}", hexadecimal(text));
}

std::string real_text(double value) {
  if (!std::isfinite(value)) return fmt::format("{{\"real\":\"{}\"}}", value);
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string text_of_figure(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *whole);
  if (const auto* real = std::get_if<double>(&value)) return real_text(*real);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  if (const auto* text = std::get_if<std::string>(&value)) return quoted(*text);
  if (const auto* json = std::get_if<JsonText>(&value)) return fmt::format("{{\"json\":{}}}", quoted(json->text));
  return std::holds_alternative<std::nullptr_t>(value) ? "null" : "[]";
}

/// Reads a text or {"bytes": ...}.
std::optional<std::string> read_text(const ReadJson& json) {
  if (json.is_string()) return json.get<std::string>();
  if (json.is_object() && json.size() == 1 && json.contains("bytes") && json["bytes"].is_string())
    return bytes_of(json["bytes"].get_ref<const std::string&>());
  return std::nullopt;
}

std::optional<Value> read_object(const ReadJson& json) {
  if (json.size() == 1 && json.contains("json")) {
    auto text = read_text(json["json"]);
    return text && !is_too_deep(*text) && ReadJson::accept(*text) ? std::optional<Value>(JsonText{std::move(*text)})
                                                                  : std::nullopt;
  }
  if (json.size() == 1 && json.contains("real")) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (json["real"] == "inf") return infinity;
    if (json["real"] == "-inf") return -infinity;
    if (json["real"] == "nan") return std::numeric_limits<double>::quiet_NaN();
    if (json["real"] == "-nan") return -std::numeric_limits<double>::quiet_NaN();
    return std::nullopt;
  }
  auto text = read_text(json);
  return text ? std::optional<Value>(std::move(*text)) : std::nullopt;
}

std::optional<Value> read_figure(const ReadJson& json) {
  if (json.is_null()) return Value(nullptr);
  if (json.is_boolean()) return Value(json.get<bool>());
  if (json.is_number_float()) return Value(json.get<double>());
  if (json.is_number_integer()) return Value(json.get<std::int64_t>());
  if (json.is_string()) return Value(json.get<std::string>());
  if (json.is_array() && json.empty()) return Value();
  return json.is_object() ? read_object(json) : std::nullopt;
}

}  // namespace

std::string figures_text(std::span<const Value> figures) {
  std::string text = "[";
  for (const Value& figure : figures) text += (text.size() > 1 ? "," : "") + text_of_figure(figure);
  return text + "]";
}

std::optional<std::vector<Value>> read_figures(std::string_view text) {
  const ReadJson json = read_json(text);
  if (!json.is_array()) return std::nullopt;
  std::vector<Value> figures;
  for (const ReadJson& each : json) {
    auto figure = read_figure(each);
    if (!figure) return std::nullopt;
    figures.push_back(std::move(*figure));
  }
  return figures;
}

}  // namespace labmouse
