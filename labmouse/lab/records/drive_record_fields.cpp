#include "labmouse/lab/records/drive_record_fields.hpp"

#include <cmath>

#include "labmouse/functions/parse_number.hpp"
#include "labmouse/lab/robots/drive_rules_keys.hpp"

namespace labmouse {
namespace {

constexpr std::size_t longest_source = 4096;  // bytes

Heading read_heading(const ReadJson& name, const char* key, JsonFields& fields) {
  for (const Heading heading : all_headings)
    if (name == name_of(heading)) return heading;
  fields.fail(fmt::format("has a '{}' whose heading is not one of north, east, south, west", key));
  return Heading::north;
}

CellSet rows_in(JsonFields& fields, const char* key, Size size) {
  CellSet cells;
  const ReadJson& rows = fields.list(key);
  if (rows.size() != static_cast<std::size_t>(size.height))
    fields.fail(fmt::format("has {} rows, but the maze has {}", rows.size(), size.height));
  for (std::size_t y = 0; y < rows.size() && fields.error().empty(); ++y) {
    const auto bits = rows[y].is_string() ? parse_whole<std::uint64_t>(rows[y].get<std::string>(), 16) : std::nullopt;
    if (!bits) return fields.fail("has a row that is not a hexadecimal number", cells);
    cells.set_row(static_cast<int>(y), *bits);
  }
  return cells;
}

/// The speed of a segment that is no turn.
constexpr double no_speed = -1.0;

std::optional<std::uint16_t> find_turn(const DriveTables& tables, const std::string& name, bool diagonal, double speed,
                                       double end_speed) {
  constexpr double tolerance = 1e-3;  // mm/s; different speeds of one turn differ by more
  const std::vector<DrivenTurn>& turns = tables.turns;
  for (std::size_t i = 0; i < turns.size(); ++i)
    if (name_of(turns[i].turn) == name && begins_diagonal(turns[i].turn) == diagonal &&
        std::abs(turns[i].speed - speed) < tolerance && std::abs(turns[i].end_speed - end_speed) < tolerance)
      return static_cast<std::uint16_t>(i);
  return std::nullopt;
}

void read(const DriveRulesKey& key, JsonFields& fields, Counted& counts) {
  if (!fields.has(key.json_name)) return;
  const std::optional<Counted> named = counted_named(fields.text(key.json_name));
  if (!named) fields.fail("has a 'counts' that this version does not know");
  counts = named.value_or(Counted::run);
}
void read(const DriveRulesKey& key, JsonFields& fields, std::string& value) {
  value = fields.text(key.json_name).substr(0, longest_source);
}
void read(const DriveRulesKey& key, JsonFields& fields, bool& value) { value = fields.flag(key.json_name); }
template <class Number>
void read(const DriveRulesKey& key, JsonFields& fields, Number& value) {
  const std::int64_t low = key.needed ? key.low * units_of<Number> : 0;
  value = static_cast<Number>(fields.long_whole(key.json_name, low, key.high * units_of<Number>));
}

}  // namespace

WallSet walls_in(const ReadJson& json, const char* key, Size size, JsonFields& outer) {
  if (!outer.has(key)) {
    outer.reject(fmt::format("'{}' is missing", key));
    return WallSet();
  }
  JsonFields fields(json[key], key);
  const CellSet north = rows_in(fields, "north", size), east = rows_in(fields, "east", size);
  const WallSet all = WallSet::all(size);
  CellSet outside = north, outside_east = east;
  outside -= all.north();
  outside_east -= all.east();
  if (!outside.empty() || !outside_east.empty()) fields.fail("has walls that the maze does not have");
  outer.reject(fields.error());
  WallSet walls;
  if (!fields.error().empty()) return walls;
  north.for_each([&](Cell cell) { walls.insert({cell, Heading::north}); });
  east.for_each([&](Cell cell) { walls.insert({cell, Heading::east}); });
  return walls;
}

Pose pose_in(JsonFields& fields, const char* key, Size size) {
  const ReadJson& pose = fields.list(key);
  if (pose.size() != 3) return fields.fail(fmt::format("has a '{}' that is not [x, y, heading]", key), Pose());
  return {{fields.whole(pose[0], key, 0, size.width - 1), fields.whole(pose[1], key, 0, size.height - 1)},
          read_heading(pose[2], key, fields)};
}

DriveNode node_in(JsonFields& fields, const char* key, Size size) {
  const ReadJson& node = fields.list(key);
  if (node.size() != 4)
    return fields.fail(fmt::format("has a '{}' that is not [x, y, heading, place]", key), DriveNode());
  DriveNode read = {{fields.whole(node[0], key, 0, size.width - 1), fields.whole(node[1], key, 0, size.height - 1)},
                    read_heading(node[2], key, fields)};
  for (const Place place : all_places)
    if (node[3] == name_of(place)) return read.place = place, read;
  return fields.fail(fmt::format("has a '{}' whose place is not one of centre, edge, left, right", key), read);
}

void read_piece(const ReadJson& json, JsonFields& fields, const DriveTables& tables, DriveSegment& segment) {
  const std::string piece = fields.text("piece");
  if (piece.starts_with('S') || piece.starts_with('D')) {
    segment.units = parse_whole<int>(std::string_view(piece).substr(1)).value_or(-1);
    const bool good = segment.units >= 0 && segment.units <= StraightTimes::longest &&
                      segment.from.diagonal() == piece.starts_with('D');
    if (!good) fields.fail("has a piece that is not a valid straight there");
    return;
  }
  segment.kind = DriveSegment::Kind::turn;
  segment.left = piece.starts_with('L');
  const bool sided = segment.left || piece.starts_with('R');
  const auto speed = [&](const char* key, double otherwise) {
    return json.contains(key) ? json[key].is_number() ? json[key].get<double>() : no_speed : otherwise;
  };
  const double begin = speed("speed", no_speed);
  const auto turn = sided
                        ? find_turn(tables, piece.substr(1), segment.from.diagonal(), begin, speed("end_speed", begin))
                        : std::nullopt;
  if (!turn)
    fields.fail("has a piece that is neither a straight nor a turn that this robot can make there at that speed");
  segment.turn = turn.value_or(0);
}

void read_drive_rules_json(const ReadJson& json, DriveRules& rules, JsonFields& outer) {
  JsonFields fields(json, "rules");
  rules.name = fields.text("name");
  for (const DriveRulesKey& key : drive_rules_keys)
    if (key.in_json_of(rules.counts)) std::visit([&](auto member) { read(key, fields, rules.*member); }, key.member);
  outer.reject(fields.error());
}

}  // namespace labmouse
