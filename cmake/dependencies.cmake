# Third-party libraries, all of them header-only Debian packages: circumball_json, circumball_command
# (CLI11, fmt), circumball_boost and circumball_eigen. Under Emscripten /usr/include must not be searched (glibc's headers would
# hide musl's): a folder of links to just these libraries stands in for it.
if(EMSCRIPTEN)
  set(CIRCUMBALL_HOST_INCLUDE /usr/include CACHE PATH "Where the host's header-only libraries are")
  set(staged ${CMAKE_BINARY_DIR}/staged-include)
  file(MAKE_DIRECTORY ${staged})
  foreach(name boost eigen3 CLI nlohmann fmt)
    if(EXISTS ${CIRCUMBALL_HOST_INCLUDE}/${name})
      file(CREATE_LINK ${CIRCUMBALL_HOST_INCLUDE}/${name} ${staged}/${name} SYMBOLIC)
    endif()
  endforeach()
  set(host_include ${staged})
else()
  find_path(host_include nlohmann/json.hpp REQUIRED)
endif()

foreach(name json command boost)
  add_library(circumball_${name} INTERFACE)
  if(NOT host_include STREQUAL "/usr/include")
    target_include_directories(circumball_${name} SYSTEM INTERFACE ${host_include})
  endif()
endforeach()
# Debian keeps Eigen in a folder of its own.
add_library(circumball_eigen INTERFACE)
find_path(eigen_include Eigen/SparseCholesky PATHS ${host_include}/eigen3 REQUIRED NO_DEFAULT_PATH
                                                   NO_CMAKE_FIND_ROOT_PATH)
target_include_directories(circumball_eigen SYSTEM INTERFACE ${eigen_include})
target_compile_definitions(circumball_command INTERFACE FMT_HEADER_ONLY)
target_link_libraries(circumball_command INTERFACE circumball_json)
