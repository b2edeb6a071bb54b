#include "files.h"

#include <sys/stat.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

#include <fmt/format.h>

namespace circumball::cli {

namespace {

// A third of the 32-bit address space of WebAssembly, so that text and what is read from it fit
// side by side; the same on every platform, because exit codes are.
constexpr std::size_t kMaxFileBytes = 1u << 30;

struct Closer {
  void operator()(std::FILE* file) const {
    if (file != stdin && file != stdout) std::fclose(file);
  }
};
using File = std::unique_ptr<std::FILE, Closer>;

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
}

std::string name_of(const std::string& path) { return path.substr(folder_of(path).size()); }

bool is_folder(const std::string& path) {
  struct stat status;
  return ::stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

// In blocks, since a pipe or a device has no size to ask for.
bool read_file(const std::string& path, std::string* bytes, std::string* error) {
  if (is_folder(path)) {
    *error = "it is a folder";
    return false;
  }
  const File file(path == "-" ? stdin : std::fopen(path.c_str(), "rb"));
  if (!file) {
    *error = std::strerror(errno);
    return false;
  }
  char block[1 << 16];
  while (const std::size_t count = std::fread(block, 1, sizeof block, file.get())) {
    if (bytes->size() + count > kMaxFileBytes) {
      *error = fmt::format("it is larger than {} bytes", kMaxFileBytes);
      return false;
    }
    bytes->append(block, count);
  }
  if (std::ferror(file.get())) {
    *error = std::strerror(errno);
    return false;
  }
  return true;
}

}  // namespace

bool read_sizing(std::string* size, std::string* error) {
  if (size->empty() || size->front() != '@') return true;
  const std::string path = size->substr(1);
  std::string bytes, why;
  if (!read_file(path, &bytes, &why)) {
    *error = fmt::format("the sizing function '{}' cannot be read: {}", path, why);
    return false;
  }
  while (!bytes.empty() && (bytes.back() == '\n' || bytes.back() == '\r')) bytes.pop_back();
  *size = std::move(bytes);
  return true;
}

ReadResult read_input(const std::string& path, const ReadOptions& options) {
  std::string bytes, error;
  if (!read_file(path, &bytes, &error)) {
    ReadResult result;
    result.defects.push_back(
        {"unreadable", {}, {}, fmt::format("'{}' cannot be read: {}.", path, error), false});
    return result;
  }
  const std::string folder = folder_of(path);
  const Sibling sibling = [&folder](const std::string& name) -> std::optional<std::string> {
    std::string beside, ignored;
    // A sibling lies in the same folder, whatever the file says.
    if (!read_file(folder + name_of(name), &beside, &ignored)) return std::nullopt;
    return beside;
  };
  return read(bytes, name_of(path), path == "-" ? Sibling() : sibling, options);
}

std::string extension_of(const std::string& path) {
  const std::string name = name_of(path);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? std::string() : name.substr(dot);
}

bool parse_destination(const std::string& path, const std::string& format, Destination* destination,
                       std::string* error) {
  destination->path = path;
  destination->extension = path == "-" ? format : extension_of(path);
  if (!destination->extension.empty() && destination->extension[0] != '.') {
    destination->extension.insert(0, 1, '.');
  }
  if (destination->extension.empty()) {
    *error = path == "-" ? "'-o -' needs --format, for example --format json"
                         : fmt::format("'{}' has no extension that says its format", path);
    return false;
  }
  const std::string folder = folder_of(path);
  if (!folder.empty() && !is_folder(folder)) {
    *error = fmt::format("the folder '{}' does not exist", folder);
    return false;
  }
  return true;
}

bool write_file(const std::string& path, const std::string& bytes, std::string* error) {
  std::FILE* file = path == "-" ? stdout : std::fopen(path.c_str(), "wb");
  bool ok = file != nullptr;
  if (ok) {
    ok = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    ok = (file == stdout ? std::fflush(file) : std::fclose(file)) == 0 && ok;
  }
  if (!ok) *error = fmt::format("'{}' cannot be written: {}", path, std::strerror(errno));
  return ok;
}

bool write_files(const Destination& destination, const std::vector<OutputFile>& files,
                 std::string* error) {
  const std::size_t stem_size = destination.path.size() - destination.extension.size();
  for (const OutputFile& file : files) {
    if (destination.path == "-") {
      if (files.size() > 1 && file.extension != destination.extension) continue;
      if (!write_file("-", file.bytes, error)) return false;
    } else {
      const std::string path = destination.path.substr(0, stem_size) + file.extension;
      if (!write_file(path, file.bytes, error)) return false;
    }
  }
  return true;
}

}  // namespace circumball::cli
