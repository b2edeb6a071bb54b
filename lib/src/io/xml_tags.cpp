#include "io/xml_tags.h"

#include <algorithm>

namespace circumball::io {
namespace {

constexpr std::string_view kWhite = " \t\r\n";
constexpr std::size_t kEnd = std::string_view::npos;

bool begins(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

}  // namespace

void XmlTags::advance_to(std::size_t position) {
  line_ += static_cast<std::size_t>(
      std::count(text_.begin() + static_cast<std::ptrdiff_t>(position_),
                 text_.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
  position_ = position;
}

bool XmlTags::skip_past(std::string_view end) {
  const std::size_t at = text_.find(end, position_);
  truncated_ = at == kEnd;
  if (!truncated_) advance_to(at + end.size());
  return !truncated_;
}

bool XmlTags::next(Tag* tag) {
  while (true) {
    const std::size_t open = text_.find('<', position_);
    if (open == kEnd) return false;
    advance_to(open);
    const std::string_view rest = text_.substr(position_);
    if (begins(rest, "<!--")) {
      if (!skip_past("-->")) return false;
    } else if (begins(rest, "<![CDATA[")) {
      if (!skip_past("]]>")) return false;
    } else if (begins(rest, "<?")) {
      if (!skip_past("?>")) return false;
    } else if (begins(rest, "<!")) {  // a document type; its own declarations stand in brackets
      const std::size_t end = rest.find_first_of("[>");
      if (!skip_past(end != kEnd && rest[end] == '[' ? "]" : ">")) return false;
      if (end != kEnd && rest[end] == '[' && !skip_past(">")) return false;
    } else {
      break;
    }
  }
  tag->line = line_;
  std::size_t end = position_ + 1;  // of the tag: the next '>' outside quotes
  for (char quote = 0; end < text_.size() && (quote || text_[end] != '>'); ++end) {
    if (quote) {
      if (text_[end] == quote) quote = 0;
    } else if (text_[end] == '"' || text_[end] == '\'') {
      quote = text_[end];
    }
  }
  truncated_ = end >= text_.size();
  if (truncated_) return false;
  std::string_view inside = text_.substr(position_ + 1, end - position_ - 1);
  advance_to(end + 1);
  tag->closes = begins(inside, "/");
  if (tag->closes) inside.remove_prefix(1);
  tag->empty = !inside.empty() && inside.back() == '/';
  if (tag->empty) inside.remove_suffix(1);
  const std::size_t name_end = std::min(inside.find_first_of(kWhite), inside.size());
  tag->name = inside.substr(0, name_end);
  const std::size_t colon = tag->name.find(':');
  if (colon != kEnd) tag->name.remove_prefix(colon + 1);
  tag->attributes = inside.substr(name_end);
  return true;
}

std::string_view XmlTags::Tag::attribute(std::string_view key) const {
  std::string_view rest = attributes;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kWhite), rest.size()));
    const std::size_t equals = rest.find('=');
    if (equals == kEnd) return {};
    std::string_view name = rest.substr(0, equals);
    name = name.substr(0, name.find_first_of(kWhite));
    rest.remove_prefix(equals + 1);
    rest.remove_prefix(std::min(rest.find_first_not_of(kWhite), rest.size()));
    if (rest.empty() || (rest.front() != '"' && rest.front() != '\'')) return {};
    const std::size_t end = rest.find(rest.front(), 1);
    if (end == kEnd) return {};
    if (name == key) return rest.substr(1, end - 1);
    rest.remove_prefix(end + 1);
  }
}

}  // namespace circumball::io
