#ifndef CIRCUMBALL_WASM_JSON_FACE_H_
#define CIRCUMBALL_WASM_JSON_FACE_H_

#include <string>
#include <vector>

#include "circumball/refine.h"
#include "circumball/types.h"

/// The JSON texts of the typed face (circumball.d.mts).
namespace circumball {

/// `Defect[]`.
std::string defects_json(const std::vector<Defect>& defects);
/// The names of the enumerators of EventKind and Reason, by number.
std::string trace_names_json();
/// Reads `RunOptions`. Fails with a sentence in `error` on text that is not JSON, unknown keys and
/// values of a wrong type; ranges and names of the registry are for Run::create to judge.
bool options_from_json(const std::string& text, Options* options, std::string* error);

}  // namespace circumball

#endif  // CIRCUMBALL_WASM_JSON_FACE_H_
