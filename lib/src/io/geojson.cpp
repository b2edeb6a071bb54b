#include "io/geojson.h"

#include <array>
#include <optional>
#include <vector>

#include "io/line_work.h"

// GeoJSON: RFC 7946.
namespace circumball::io {
namespace {

class Reader {
 public:
  explicit Reader(LineWork* lines) : lines_(*lines) {}

  /// A geometry, a feature or a collection. Nesting is bounded: the parser has checked the depth.
  bool object(const JsonValue& value) {
    const Json* type = value.find("type");
    const auto* name = type ? type->get_ptr<const std::string*>() : nullptr;
    if (!name) return value.wrong_type("an object with a \"type\"");
    if (*name == "FeatureCollection") return each(value, "features");
    if (*name == "GeometryCollection") return each(value, "geometries");
    if (*name == "Feature") {
      const Json* geometry = value.find("geometry");
      return !geometry ||
             object(value.member(*geometry, "geometry"));  // null: a feature without a place
    }
    const Json* json = value.find("coordinates");
    if (!json) return value.wrong_type("a geometry with \"coordinates\"");
    const JsonValue coordinates = value.member(*json, "coordinates");
    const auto line = [this](const JsonValue& v, std::size_t) { return line_string(v); };
    const auto lines = [&line](const JsonValue& v, std::size_t) { return v.for_each(line); };
    if (*name == "Point") return position(coordinates).has_value();
    if (*name == "MultiPoint")
      return coordinates.for_each(
          [this](const JsonValue& v, std::size_t) { return position(v).has_value(); });
    if (*name == "LineString") return line_string(coordinates);
    if (*name == "MultiLineString" || *name == "Polygon") return coordinates.for_each(line);
    if (*name == "MultiPolygon") return coordinates.for_each(lines);
    return value.fail("unknown-format", in_quotes(*name) + " is not a type of GeoJSON (RFC 7946)");
  }

 private:
  bool each(const JsonValue& value, const char* key) {
    const Json* list = value.find(key);
    if (!list) return value.fail("type", std::string("\"") + key + "\" is missing: add an array");
    return value.member(*list, key).for_each([this](const JsonValue& v, std::size_t) {
      return object(v);
    });
  }

  std::optional<std::uint32_t> position(const JsonValue& value) {
    double x = 0, y = 0;
    if (!value.json().is_array() || value.json().size() < 2) {
      value.wrong_type("a position [x, y]");
      return std::nullopt;
    }
    const bool ok = value.for_each([&](const JsonValue& v, std::size_t k) {
      return k == 0 ? v.number(&x) : k != 1 || v.number(&y);
    });
    if (!ok) return std::nullopt;
    return lines_.vertex(x, y);
  }

  /// Lines from position to position; the last position of a ring repeats the first, which closes
  /// it.
  bool line_string(const JsonValue& value) {
    std::optional<std::uint32_t> last;
    return value.for_each([&](const JsonValue& v, std::size_t) {
      const auto here = position(v);
      if (!here) return false;
      if (last) lines_.segment(*last, *here);
      last = here;
      return true;
    });
  }

  LineWork& lines_;
};

}  // namespace

void read_geojson(const JsonValue& document, ReadResult& result) {
  result.format = "geojson";
  result.complex.hole_rule = HoleRule::kParity;
  LineWork lines(&result.complex);
  if (!Reader(&lines).object(document)) return;
  if (result.complex.vertices.empty())
    fail(result, "empty", "the GeoJSON has no coordinates: add a geometry");
}

}  // namespace circumball::io
