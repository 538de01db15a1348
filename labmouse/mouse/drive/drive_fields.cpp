#include "labmouse/mouse/drive/drive_fields.hpp"

#include <algorithm>
#include <cassert>

#include "labmouse/mouse/robot/drive_model.hpp"

namespace labmouse {
namespace {

/// Ways and runs lie behind what the routes keep, in memory that each fill of the routes overwrites.
std::size_t bytes_with_ways(Size size, const RouteTables& tables) {
  return std::max(tables.bytes_for(size), tables.kept_bytes_for(size) + SearchField::bytes_for(size));
}

bool has_runs(Size size) { return size.area() <= RunCosts::largest_area; }

std::size_t bytes_of_all(Size size, const RouteTables& tables) {
  const std::size_t bytes = bytes_with_ways(size, tables);
  return has_runs(size) ? std::max(bytes, tables.kept_bytes_for(size) + RunCosts::bytes_for(size)) : bytes;
}

}  // namespace

std::size_t DriveFields::bytes_for(Size size, const DriveModel& model) {
  return bytes_of_all(size, *route_tables_of(model));
}

MemoryLayout DriveFields::layout(Size size, const DriveModel& model) {
  const Tables tables = route_tables_of(model);
  MemoryLayout layout = tables->layout(size);
  layout.push_back({"ways", bytes_with_ways(size, *tables) - tables->bytes_for(size)});
  layout.push_back({"runs", bytes_of_all(size, *tables) - bytes_with_ways(size, *tables)});
  return layout;
}

DriveFields::DriveFields(Size size, const Tables& tables, SearchField ways, std::byte* memory)
    : routes_(size, tables, {memory, tables->bytes_for(size)}), ways_(std::move(ways)) {
  if (has_runs(size)) runs_.emplace(size, std::span(memory + tables->kept_bytes_for(size), RunCosts::bytes_for(size)));
}

DriveFields::DriveFields(Size size, const DriveModel& model, std::span<std::byte> memory)
    : DriveFields(
          size, route_tables_of(model),
          SearchField(size, model.search,
                      memory.subspan(route_tables_of(model)->kept_bytes_for(size), SearchField::bytes_for(size))),
          memory.data()) {
  assert(memory.size() >= bytes_for(size, model));
}

DriveFields DriveFields::in_own_memory(Size size, const DriveModel& model) {
  const Tables tables = route_tables_of(model);
  const std::size_t runs = has_runs(size) ? tables->kept_bytes_for(size) + RunCosts::bytes_for(size) : 0;
  Memory memory(new std::byte[std::max(tables->bytes_for(size), runs)]);
  DriveFields fields(size, tables, SearchField(size, model.search), memory.get());
  fields.own_ = std::move(memory);
  fields.home_.emplace(size, model.search);
  return fields;
}

}  // namespace labmouse
