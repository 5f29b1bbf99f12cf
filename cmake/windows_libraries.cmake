# The libraries of Windows: GLFW, zlib and libpng from their sources, and the headers of the others, which are the same
# everywhere. All are within the program, which needs nothing but what Windows has.
include(cmake/own_glfw.cmake)

include(cmake/header_library.cmake)
header_library(windows_cli11 CLI)
header_library(windows_glm glm)
header_library(windows_json nlohmann)
add_library(CLI11::CLI11 ALIAS windows_cli11)
add_library(glm::glm ALIAS windows_glm)
add_library(nlohmann_json::nlohmann_json ALIAS windows_json)
find_package(Threads REQUIRED)

include(cmake/zlib_and_png.cmake)
zlib_and_png("${portable_folder}")

# As large a stack as elsewhere. And a path made of narrow text takes it to be UTF-8: see windows_utf8.c.
add_library(windows_utf8 STATIC cmake/windows_utf8.c)
link_libraries(windows_utf8)
add_compile_definitions(UNICODE WIN32_LEAN_AND_MEAN NOMINMAX __USE_MINGW_ANSI_STDIO=1)
add_link_options(-static -s -Wl,--stack,8388608 -Wl,--no-insert-timestamp -Wl,--wrap=mbrtowc -Wl,--undefined=__wrap_mbrtowc)
