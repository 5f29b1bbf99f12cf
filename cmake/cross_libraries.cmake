# The libraries of a page, and of the core for another processor: zlib and libpng compiled from source, and
# the headers of the others, which are the same everywhere, as the system has them.

include(cmake/header_library.cmake)
header_library(cross_glm glm)
header_library(cross_json nlohmann)
add_library(glm::glm ALIAS cross_glm)
add_library(nlohmann_json::nlohmann_json ALIAS cross_json)

include(cmake/zlib_and_png.cmake)
if(EMSCRIPTEN)
  add_library(Threads::Threads INTERFACE IMPORTED)  # there are none
  zlib_and_png("${web_folder}")
else()
  find_package(Threads REQUIRED)
  zlib_and_png("${NORMALSCOPE_THIRD_PARTY}/portable")
endif()
