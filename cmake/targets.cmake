# How every target of texbake is compiled, so that the same input gives the same bytes with g++ and clang++.

add_library(texbake_flags INTERFACE)
target_compile_options(texbake_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
  # A fused multiply-add rounds once where two operations round twice: results would depend on the processor.
  -ffp-contract=off)
if(TEXBAKE_SANITIZE)
  target_compile_options(texbake_flags INTERFACE -fsanitize=${TEXBAKE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(texbake_flags INTERFACE -fsanitize=${TEXBAKE_SANITIZE})
endif()
install(TARGETS texbake_flags EXPORT texbake-targets)

# Beside texbake_flags, for code that is not hot: with sanitizers, the optimizer doubles the time that its compilation takes.
add_library(texbake_cold INTERFACE)
if(TEXBAKE_SANITIZE)
  target_compile_options(texbake_cold INTERFACE -O0)
endif()

# With -DCMAKE_UNITY_BUILD=ON ten files of a folder are compiled as one: the headers that they share are read, and the
# templates that they share are made, once. That takes a third of the time when everything is compiled, and longer
# after a change of one file; hence the commands that build everything switch it on, and the presets do not.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 10)
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # A type defined in a .cpp may have members of that file alone; g++ takes the file for a header that others include.
  target_compile_options(texbake_flags INTERFACE -Wno-subobject-linkage)
endif()

# texbake_apart(FILES...): these are compiled by themselves all the same.
function(texbake_apart)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# texbake_library(NAME [public dependencies...]): a static library of every .cpp beside the caller's CMakeLists.txt; of
# headers alone where there is none.
function(texbake_library name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  set(scope PUBLIC)
  if(sources)
    add_library(texbake_${name} STATIC ${sources})
    target_link_libraries(texbake_${name} PRIVATE $<BUILD_INTERFACE:texbake_flags>)
  else()
    set(scope INTERFACE)
    add_library(texbake_${name} INTERFACE)
  endif()
  add_library(texbake::${name} ALIAS texbake_${name})
  set_target_properties(texbake_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(texbake_${name} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/texbake>)
  target_link_libraries(texbake_${name} ${scope} ${ARGN})
  install(TARGETS texbake_${name} EXPORT texbake-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/texbake/${folder}
    FILES_MATCHING PATTERN "*.h")
endfunction()
