# header_library(TARGET FOLDER [FILE]): a library that is headers alone, which are the same everywhere, as this system has them
# in FOLDER. By links, one folder each: all that this system has would hide what the other one has.
set(headers "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${headers}")
function(header_library target folder)
  find_path(${target}_headers ${folder} PATHS /usr/include /usr/local/include NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  file(CREATE_LINK "${${target}_headers}/${folder}" "${headers}/${folder}" SYMBOLIC)
  add_library(${target} INTERFACE)
  target_include_directories(${target} SYSTEM INTERFACE "${headers}")
endfunction()
