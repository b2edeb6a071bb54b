#ifndef CIRCUMBALL_CLI_FILES_H_
#define CIRCUMBALL_CLI_FILES_H_

#include <string>
#include <vector>

#include "circumball/io.h"

/// Between the file system and the readers and writers, which know bytes only.
namespace circumball::cli {

/// Reads a file ("-": standard input) and, where its format wants them, the files beside it. A file
/// that cannot be opened or is larger than the address space allows for is a defect like any other.
ReadResult read_input(const std::string& path, const ReadOptions& options = {});

/// A sizing function as it was given: "@FILE" ("@-": standard input) stands for what is in the
/// file, all else for itself. Fails with a sentence in `error`.
bool read_sizing(std::string* size, std::string* error);

/// ".ele" of "out/box.1.ele"; empty if there is none.
std::string extension_of(const std::string& path);

/// Where a result goes: a file, or standard output in the format of `extension`.
struct Destination {
  std::string path;  ///< "-" is standard output
  std::string extension;
};
/// Fails with a sentence in `error` if the path has no extension (for "-": no `format`), or its
/// folder is missing.
bool parse_destination(const std::string& path, const std::string& format, Destination* destination,
                       std::string* error);
/// Writes a family of files beside each other: "box.ele" and "box.node" for "box.ele". On standard
/// output only the member that was asked for appears.
bool write_files(const Destination& destination, const std::vector<OutputFile>& files,
                 std::string* error);
bool write_file(const std::string& path, const std::string& bytes, std::string* error);

}  // namespace circumball::cli

#endif  // CIRCUMBALL_CLI_FILES_H_
