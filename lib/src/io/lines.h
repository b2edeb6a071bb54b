#ifndef CIRCUMBALL_IO_LINES_H_
#define CIRCUMBALL_IO_LINES_H_

#include <cstddef>
#include <string_view>

namespace circumball::io {

/// Walks over the lines of a text that hold anything but a comment (from '#' on), and over the
/// words of a line. Words are parted by white space or commas; lines end with LF, CR LF or CR.
/// Nothing is copied.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// Goes to the next line that has a word; false at the end of the text.
  bool next() {
    while (next_ < text_.size()) {
      const std::size_t end = text_.find_first_of("\r\n", next_);
      rest_ = text_.substr(next_, end == std::string_view::npos ? end : end - next_);
      next_ = end == std::string_view::npos ? text_.size() : end + 1;
      if (end != std::string_view::npos && text_[end] == '\r' && next_ < text_.size() &&
          text_[next_] == '\n')
        ++next_;
      ++number_;
      rest_ = rest_.substr(0, rest_.find('#'));
      skip_separators();
      if (!rest_.empty()) return true;
    }
    rest_ = {};
    return false;
  }

  /// The next word of the line; empty at its end.
  std::string_view word() {
    std::size_t n = 0;
    while (n < rest_.size() && !is_separator(rest_[n])) ++n;
    const std::string_view word = rest_.substr(0, n);
    rest_.remove_prefix(n);
    skip_separators();
    return word;
  }

  bool at_end_of_line() const { return rest_.empty(); }
  std::size_t rest_of_line() const { return rest_.size(); }
  std::size_t number() const { return number_; }  ///< of the line, counted from 1
  /// Bytes after the current line: no header may promise more than they can hold.
  std::size_t remaining() const { return text_.size() - next_; }

 private:
  static bool is_separator(char c) {
    return c == ' ' || c == '\t' || c == ',' || c == '\v' || c == '\f';
  }
  void skip_separators() {
    while (!rest_.empty() && is_separator(rest_.front())) rest_.remove_prefix(1);
  }

  std::string_view text_, rest_;
  std::size_t next_ = 0, number_ = 0;
};

}  // namespace circumball::io

#endif  // CIRCUMBALL_IO_LINES_H_
