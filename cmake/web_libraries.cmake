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

set(zlib "${web_folder}/zlib")
file(GLOB zlib_sources "${zlib}/*.c")
list(FILTER zlib_sources EXCLUDE REGEX "/gz[a-z]*\\.c$")  # files
add_library(web_zlib STATIC ${zlib_sources})
target_include_directories(web_zlib SYSTEM PUBLIC "${zlib}")
target_compile_definitions(web_zlib PRIVATE Z_HAVE_UNISTD_H)
add_library(ZLIB::ZLIB ALIAS web_zlib)

set(png "${web_folder}/libpng1.6")
set(png_parts png pngerror pngget pngmem pngpread pngread pngrio pngrtran pngrutil pngset pngtrans pngwio pngwrite
  pngwtran pngwutil)
list(TRANSFORM png_parts REPLACE "(.+)" "${png}/\\1.c" OUTPUT_VARIABLE png_sources)
configure_file("${png}/scripts/pnglibconf.h.prebuilt" "${PROJECT_BINARY_DIR}/libpng/pnglibconf.h" COPYONLY)
add_library(web_png STATIC ${png_sources})
target_include_directories(web_png SYSTEM PUBLIC "${png}" "${PROJECT_BINARY_DIR}/libpng")
target_link_libraries(web_png PUBLIC web_zlib)
add_library(PNG::PNG ALIAS web_png)
