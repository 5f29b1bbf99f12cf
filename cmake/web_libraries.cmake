# The libraries of a page: zlib and libpng compiled for it from source, and the headers of the others, which are the same
# everywhere, as the system has them.

# By links, one folder each: all that the system has would hide what emscripten has.
set(headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${headers}")
function(header_library target folder)
  find_path(${target}_headers ${folder} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(CREATE_LINK "${${target}_headers}/${folder}" "${headers}/${folder}" SYMBOLIC)
  add_library(${target} INTERFACE)
  target_include_directories(${target} SYSTEM INTERFACE "${headers}")
endfunction()
header_library(web_glm glm)
header_library(web_json nlohmann)
add_library(glm::glm ALIAS web_glm)
add_library(nlohmann_json::nlohmann_json ALIAS web_json)
add_library(Threads::Threads INTERFACE IMPORTED)  # there are none

include(cmake/zlib_and_png.cmake)
zlib_and_png("${web_folder}")
