// The figures of a contest: a struct with a member for each, which each world has of its own.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "labmouse/lab/races/value.hpp"

namespace labmouse {

/// What worlds derive the struct of their figures from.
struct Figures {};

/// A figure as stores keep it.
struct StoredFigure {
  Value (*of)(const Figures&);
  /// False where the value is not of the figure's kind.
  bool (*set)(const Value&, Figures&);
  bool by_clock;  ///< a time by the machine's clock: stores keep it apart from results
};

template <class Struct, class Member>
Struct struct_of(Member Struct::*);
template <class Struct, class Member>
Member member_of(Member Struct::*);

/// The figures of a world in the order in which stores keep them.
struct StoredFigures {
  std::shared_ptr<Figures> (*make)() = nullptr;
  std::span<const StoredFigure> all;

  std::vector<Value> values_of(const Figures& figures) const {
    std::vector<Value> values;
    for (const StoredFigure& figure : all) values.push_back(figure.of(figures));
    return values;
  }
  /// Null where the values are not those of such figures.
  std::shared_ptr<const Figures> figures_of(std::span<const Value> values) const {
    bool good = values.size() == all.size();
    std::shared_ptr<Figures> figures = make();
    for (std::size_t i = 0; good && i < all.size(); ++i) good = all[i].set(values[i], *figures);
    return good ? figures : nullptr;
  }
};

template <class Struct, auto... Members>
inline constexpr std::array<StoredFigure, sizeof...(Members)> each_stored = {
    {{[](const Figures& figures) { return value_of(static_cast<const Struct&>(figures).*Members); },
      [](const Value& value, Figures& figures) { return set_to(value, static_cast<Struct&>(figures).*Members); },
      std::is_same_v<decltype(member_of(Members)), ByClock>}...}};

/// These members of a world's struct.
template <class Struct, auto... Members>
inline constexpr StoredFigures stored_figures = {
    []() -> std::shared_ptr<Figures> { return std::make_shared<Struct>(); }, each_stored<Struct, Members...>};

}  // namespace labmouse
