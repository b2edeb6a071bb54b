#ifndef CIRCUMBALL_IO_XML_TAGS_H_
#define CIRCUMBALL_IO_XML_TAGS_H_

#include <cstddef>
#include <string_view>

namespace circumball::io {

/// The tags of an XML document, one after the other: as much of XML as drawings need. Comments,
/// declarations, instructions and text are passed over; entities are left as they are; nothing is
/// copied.
class XmlTags {
 public:
  struct Tag {
    std::string_view name;        ///< without a namespace prefix
    std::string_view attributes;  ///< what stands between the name and the end of the tag
    bool closes = false;          ///< </name>
    bool empty = false;           ///< <name/>
    std::size_t line = 0;         ///< counted from 1
    /// Value of an attribute; empty if it is missing.
    std::string_view attribute(std::string_view key) const;
  };

  explicit XmlTags(std::string_view text) : text_(text) {}
  /// Goes to the next tag; false at the end of the text, or where it is cut off (`truncated`).
  bool next(Tag* tag);
  bool truncated() const { return truncated_; }
  std::size_t line() const { return line_; }

 private:
  /// Passes over everything up to and with `end`.
  bool skip_past(std::string_view end);
  void advance_to(std::size_t position);

  std::string_view text_;
  std::size_t position_ = 0, line_ = 1;
  bool truncated_ = false;
};

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_XML_TAGS_H_
