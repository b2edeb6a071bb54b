#ifndef CIRCUMBALL_IO_GEOJSON_H_
#define CIRCUMBALL_IO_GEOJSON_H_

#include "io/json_value.h"

namespace circumball::io {

/// Reads a GeoJSON document (RFC 7946) as line work in the plane; further coordinates of a position
/// are ignored.
void read_geojson(const JsonValue& document, ReadResult& result);

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_GEOJSON_H_
