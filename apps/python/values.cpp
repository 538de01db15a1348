#include "values.hpp"

#include <nanobind/stl/string.h>

namespace nb = nanobind;

namespace labmouse::python {

nb::object read_json(const std::string& text) { return nb::module_::import_("json").attr("loads")(text); }

nb::object object_of(const Value& value) {
  return std::visit(
      [](const auto& held) -> nb::object {
        using ContestOutput = std::decay_t<decltype(held)>;
        if constexpr (std::is_same_v<ContestOutput, std::monostate> || std::is_same_v<ContestOutput, std::nullptr_t>)
          return nb::none();
        else if constexpr (std::is_same_v<ContestOutput, JsonText>)
          return read_json(held.text);
        else if constexpr (std::is_same_v<ContestOutput, std::string>)
          // Names may come from files that are not in UTF-8.
          return nb::steal(PyUnicode_DecodeUTF8(held.data(), static_cast<Py_ssize_t>(held.size()), "replace"));
        else
          return nb::cast(held);
      },
      value);
}

}  // namespace labmouse::python
