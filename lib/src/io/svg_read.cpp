#include <algorithm>
#include <array>
#include <vector>

#include "io/formats.h"
#include "io/line_work.h"
#include "io/numbers.h"
#include "io/svg_path.h"
#include "io/xml_tags.h"

// SVG 1.1 as line work (https://www.w3.org/TR/SVG11/): shapes, paths and transforms; styles are
// passed over. What is drawn where the y axis points down has its y negated.
namespace circumball::io {
namespace {

using Tag = XmlTags::Tag;

/// Chords that any drawing may have, beyond one for each of its bytes: a small file of large curves
/// is no danger.
constexpr std::size_t kFreeChords = 50000;

template <std::size_t N>
bool is_one_of(std::string_view name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Elements whose content is not drawn where it stands.
constexpr std::array<std::string_view, 6> kHidden = {"defs",   "clipPath", "mask",
                                                     "marker", "pattern",  "symbol"};
/// Elements that are drawn, but not understood.
constexpr std::array<std::string_view, 4> kIgnored = {"use", "text", "image", "foreignObject"};

/// Walks over a drawing and gives its outlines to a sink. It runs twice: to measure, then to draw
/// with a tolerance that follows from the measure; nothing is stored in between.
class Drawing {
 public:
  Drawing(std::string_view bytes, OutlineSink* sink, ReadResult* result)
      : tags_(bytes), sink_(*sink), result_(*result) {}

  bool draw() {
    Tag tag;
    std::vector<Affine> maps{
        Affine{1, 0, 0, -1, 0, 0}};  // of the open elements; the y axis points up
    std::size_t hidden = 0;  // depth of the outermost open element that is not drawn; 0: none
    bool svg = false;
    while (tags_.next(&tag)) {
      if (tag.closes) {
        if (maps.size() > 1) maps.pop_back();
        if (hidden >= maps.size()) hidden = 0;
        continue;
      }
      svg = svg || tag.name == "svg";
      if (!svg)
        return fail("unknown-format", "the root element is " + in_quotes(tag.name) +
                                          ": among the formats of XML only SVG can be read");
      Affine map = maps.back();
      if (const std::string_view text = tag.attribute("transform"); !text.empty()) {
        const auto transform = parse_transform(text);
        if (!transform)
          return fail("syntax", "the transform " + in_quotes(text) +
                                    " cannot be read: use matrix, " +
                                    "translate, scale, rotate or skew");
        map = compose(map, *transform);
      }
      if (maps.size() > kMaxDepth)
        return fail("too-large", "elements nest deeper than " + std::to_string(kMaxDepth) +
                                     " levels: take groups apart");
      const bool shown =
          hidden == 0 && !is_one_of(tag.name, kHidden) && tag.attribute("display") != "none";
      if (shown && !element(tag, map)) return false;
      if (tag.empty) continue;
      if (!shown && hidden == 0) hidden = maps.size();
      maps.push_back(map);
    }
    if (tags_.truncated())
      return fail("truncated", "the file ends within a tag or a comment: add the rest");
    if (!svg) return fail("unknown-format", "there is no svg element: only SVG can be read of XML");
    if (maps.size() > 1)
      return fail("truncated", "the file ends with " + std::to_string(maps.size() - 1) +
                                   " elements still open: add their closing tags");
    return true;
  }

 private:
  bool fail(const char* name, const std::string& message) {
    return fail_at(result_, tags_.line(), name, message);
  }

  /// A length in user units; `missing` where the attribute is not there. Units other than px are
  /// refused.
  bool length(const Tag& tag, const char* key, double missing, double* value) {
    *value = missing;
    const std::string_view text = tag.attribute(key);
    if (text.empty()) return true;
    const std::size_t n = number_length(text);
    const std::string_view unit = text.substr(n);
    if (n == 0 || !(unit.empty() || unit == "px"))
      return fail("syntax", std::string(key) + "=" + in_quotes(text) +
                                " cannot be read: give a number without a unit");
    *value = *parse_double(text.substr(0, n));
    return true;
  }

  bool element(const Tag& tag, const Affine& map) {
    if (is_one_of(tag.name, kIgnored)) {
      warn(result_, "ignored",
           "line " + std::to_string(tag.line) + ": " + in_quotes(tag.name) +
               " is not line work: convert it to paths to have it");
      return true;
    }
    const bool polygon = tag.name == "polygon";
    if (tag.name == "path" || tag.name == "polyline" || polygon) {
      const std::string_view data = tag.attribute(tag.name == "path" ? "d" : "points");
      const std::size_t understood =
          tag.name == "path" ? draw_path(data, map, sink_) : draw_points(data, polygon, map, sink_);
      if (understood < data.size())
        return fail("syntax", "the data of the " + std::string(tag.name) + " cannot be read from " +
                                  in_quotes(data.substr(understood)) + " on (byte " +
                                  std::to_string(understood) + "): correct it there");
      return true;
    }
    if (tag.name == "line") {
      Point2 a, b;
      if (!length(tag, "x1", 0, &a.x) || !length(tag, "y1", 0, &a.y)) return false;
      if (!length(tag, "x2", 0, &b.x) || !length(tag, "y2", 0, &b.y)) return false;
      sink_.begin(map(a));
      sink_.line(map(b));
      sink_.end(false);
    } else if (tag.name == "rect") {
      Point2 corner;
      double width = 0, height = 0, rx = 0, ry = 0;
      if (!length(tag, "x", 0, &corner.x) || !length(tag, "y", 0, &corner.y)) return false;
      if (!length(tag, "width", 0, &width) || !length(tag, "height", 0, &height)) return false;
      if (!length(tag, "rx", -1, &rx) || !length(tag, "ry", -1, &ry)) return false;
      if (rx < 0) rx = ry;  // either stands for both
      if (ry < 0) ry = rx;
      if (width > 0 && height > 0) draw_rectangle(corner, width, height, rx, ry, map, sink_);
    } else if (tag.name == "circle" || tag.name == "ellipse") {
      Point2 center;
      double rx = 0, ry = 0;
      if (!length(tag, "cx", 0, &center.x) || !length(tag, "cy", 0, &center.y)) return false;
      if (!length(tag, tag.name == "circle" ? "r" : "rx", 0, &rx)) return false;
      if (!length(tag, tag.name == "circle" ? "r" : "ry", 0, &ry)) return false;
      if (rx > 0 && ry > 0) draw_ellipse(center, rx, ry, map, sink_);
    }
    return true;
  }

  XmlTags tags_;
  OutlineSink& sink_;
  ReadResult& result_;
};

}  // namespace

void read_svg(std::string_view bytes, ReadResult& result) {
  result.format = "svg";
  result.complex.hole_rule = HoleRule::kParity;
  Bounds bounds;
  if (!Drawing(bytes, &bounds, &result).draw()) return;
  ReadResult again;  // the same defects and warnings once more
  LineWork lines(&result.complex);
  Flattener flattener(&lines, bounds.extent(), bytes.size() + kFreeChords);
  Drawing(bytes, &flattener, &again).draw();
  if (flattener.exhausted()) {
    fail(result, "too-large",
         "the curves would be cut into more chords than the file has bytes: flatten them, or draw "
         "fewer that span "
         "the whole drawing");
    return;
  }
  if (result.complex.vertices.empty())
    fail(result, "empty", "the drawing has no paths or shapes: convert text and images to paths");
}

}  // namespace circumball::io
