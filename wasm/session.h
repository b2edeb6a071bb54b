#ifndef CIRCUMBALL_WASM_SESSION_H_
#define CIRCUMBALL_WASM_SESSION_H_

#include <emscripten/val.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "circumball/mesh.h"
#include "circumball/refine.h"
#include "circumball/trace.h"

/// What the Embind functions share: runs by number, and copies for JavaScript.
namespace circumball {

using emscripten::val;

// A run and what it records. The sink outlives the run that writes to it: members die in reverse
// order.
struct Session {
  Complex input;
  Trace trace;
  std::unique_ptr<Run> run;
};

inline std::map<int, Session>& sessions() {
  static std::map<int, Session> all;
  return all;
}

inline Session* find(int id) {
  const auto found = sessions().find(id);
  return found == sessions().end() ? nullptr : &found->second;
}

template <class T>
val copied(const T* data, std::size_t size) {
  return val(emscripten::typed_memory_view(size, data)).template call<val>("slice");
}
template <class T>
val copied(const std::vector<T>& data) {
  return copied(data.data(), data.size());
}
inline val copied_bytes(const std::string& bytes) {
  return copied(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

template <class Function>
val guarded(const val& fallback, Function function) {
  try {
    return function();
  } catch (...) {
    return fallback;
  }
}

/// `MeshArrays`.
val mesh_arrays(const Mesh& mesh);

}  // namespace circumball

#endif  // CIRCUMBALL_WASM_SESSION_H_
