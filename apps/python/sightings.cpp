#include "sightings.hpp"

#include <array>
#include <atomic>

#include "bindings.hpp"
#include "labmouse/grid/cell.hpp"

namespace nb = nanobind;

namespace labmouse::python {
namespace {

constexpr std::size_t readings = max_side;

/// Never freed: the interpreter ends before the static variables of this module are destroyed.
std::array<std::atomic<PyObject*>, readings * readings * readings> made{};
PyObject* sighting_type = nullptr;

}  // namespace

nb::handle sighting_of(const Sighting& seen) {
  const auto place = [](int reading) { return static_cast<std::size_t>(reading); };
  auto& kept = made[(place(seen.left) * readings + place(seen.ahead)) * readings + place(seen.right)];
  if (PyObject* found = kept.load(std::memory_order_acquire)) return found;
  PyObject* fresh = nb::handle(sighting_type)(seen.left, seen.ahead, seen.right).release().ptr();
  PyObject* other = nullptr;
  if (kept.compare_exchange_strong(other, fresh)) return fresh;
  Py_DECREF(fresh);
  return other;
}

void bind_sightings(nb::module_& module) {
  module.def(
      "set_sighting_type", [](nb::type_object type) { sighting_type = type.release().ptr(); }, nb::arg("type"),
      "Sets the class of sightings, called with (left, ahead, right).");
}

}  // namespace labmouse::python
