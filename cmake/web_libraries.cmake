# The libraries of a page: zlib and libpng compiled for it from source, and the headers of the others, which are the same
# everywhere, as the system has them.

include(cmake/header_library.cmake)
header_library(web_glm glm)
header_library(web_json nlohmann)
add_library(glm::glm ALIAS web_glm)
add_library(nlohmann_json::nlohmann_json ALIAS web_json)
add_library(Threads::Threads INTERFACE IMPORTED)  # there are none

include(cmake/zlib_and_png.cmake)
zlib_and_png("${web_folder}")
