#ifndef CIRCUMBALL_CLI_MESSAGES_H_
#define CIRCUMBALL_CLI_MESSAGES_H_

#include <string>
#include <vector>

#include "circumball/types.h"
#include "circumball/verify.h"

/// What the command says to people.
namespace circumball::cli {

/// One line: name, sentence, features and as many coordinates as the complex has.
std::string describe(const Defect& defect, int dimension);
/// Each defect on a line of standard error; true if one of them is not a warning.
bool print_defects(const std::vector<Defect>& defects, int dimension);
/// "error: …" on standard error.
void print_error(const std::string& message);
/// The checks as a table: ok or FAILED, name, bound, observed, detail.
std::string table(const std::vector<Check>& checks);
bool all_ok(const std::vector<Check>& checks);

}  // namespace circumball::cli

#endif  // CIRCUMBALL_CLI_MESSAGES_H_
