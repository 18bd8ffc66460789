# Headers whose parsing takes most of the time of a compilation, parsed once for all targets of the same flags. Sources
# include what they need all the same: -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
set(creepcontact_common_headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span>
    <string> <vector> <fmt/format.h> <fmt/ranges.h>)
if(NOT EXISTS ${CMAKE_BINARY_DIR}/precompiled.cpp)  # written again it would be compiled again
  file(WRITE ${CMAKE_BINARY_DIR}/precompiled.cpp "")
endif()
set(creepcontact_cold_options $<$<NOT:$<CONFIG:Debug>>:$<IF:$<BOOL:${CREEPCONTACT_FUZZ}>,-O0,-O1>>)
# creepcontact_precompiled(name LIBRARIES <more libraries> OPTIONS <more flags> HEADERS <more headers>)
function(creepcontact_precompiled name)
  cmake_parse_arguments(arg "" "" "LIBRARIES;OPTIONS;HEADERS" ${ARGN})
  add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/precompiled.cpp)
  target_compile_options(${name} PRIVATE ${arg_OPTIONS})
  target_link_libraries(${name} PRIVATE creepcontact_options creepcontact_base ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${creepcontact_common_headers} ${arg_HEADERS})
endfunction()

# creepcontact_module(name [COLD] USES <public libraries> PRIVATE_USES <implementation only> [PRECOMPILE <headers of its own>])
# Static library creepcontact_<name> from src/<name>/*.cpp and its subfolders; a module of headers alone becomes an interface
# library. COLD: it reads, writes or prepares; a quick compilation counts for more than quick code. The modules among USES and
# PRIVATE_USES are those that it may include: tests/style reads them here.
function(creepcontact_module name)
  cmake_parse_arguments(arg "COLD" "" "USES;PRIVATE_USES;PRECOMPILE" ${ARGN})
  set(target creepcontact_${name})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp
       ${PROJECT_SOURCE_DIR}/src/${name}/*/*.cpp)
  if(sources)
    add_library(${target} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE creepcontact_options ${arg_PRIVATE_USES})
    if(arg_COLD)
      target_compile_options(${target} PRIVATE ${creepcontact_cold_options})
    endif()
    if(arg_PRECOMPILE)
      target_precompile_headers(${target} PRIVATE ${creepcontact_common_headers} ${arg_PRECOMPILE})
    elseif(NOT name STREQUAL base)
      set(temper hot)
      if(arg_COLD)
        set(temper cold)
      endif()
      target_precompile_headers(${target} REUSE_FROM creepcontact_precompiled_${temper})
    endif()
    if(name IN_LIST CREEPCONTACT_SINGLE_SOURCES)
      set_target_properties(${target} PROPERTIES UNITY_BUILD OFF)
    endif()
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                             $<INSTALL_INTERFACE:include>)
  target_link_libraries(${target} ${scope} ${arg_USES})
  set_property(GLOBAL APPEND PROPERTY CREEPCONTACT_MODULES ${target})
endfunction()

# creepcontact_program(name target USES <libraries>)
# Program from src/<name>/*.cpp, which may include the modules among USES.
function(creepcontact_program name target)
  cmake_parse_arguments(arg "" "" "USES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  add_executable(${target} ${sources})
  target_link_libraries(${target} PRIVATE ${arg_USES})
endfunction()

# creepcontact_plugin(name target USES <modules whose headers it includes> LIBRARIES <libraries>)
# Library from src/<name>/*.cpp that a program loads when it needs it; nothing is linked to it.
function(creepcontact_plugin name target)
  cmake_parse_arguments(arg "" "" "USES;LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  add_library(${target} MODULE ${sources})
  foreach(module IN LISTS arg_USES)
    target_include_directories(${target} PRIVATE $<TARGET_PROPERTY:${module},INTERFACE_INCLUDE_DIRECTORIES>)
  endforeach()
  target_link_libraries(${target} PRIVATE ${arg_LIBRARIES})
  set_target_properties(${target} PROPERTIES PREFIX "" CXX_VISIBILITY_PRESET hidden
                        LIBRARY_OUTPUT_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
endfunction()

# creepcontact_extension(name target USES <libraries> PRIVATE_USES <libraries>)
# Extension module for Python from src/<name>/*.cpp, which may include the modules among them.
function(creepcontact_extension name target)
  cmake_parse_arguments(arg "" "" "USES;PRIVATE_USES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
  pybind11_add_module(${target} MODULE NO_EXTRAS ${sources})
  target_link_libraries(${target} PRIVATE ${arg_USES} ${arg_PRIVATE_USES})
endfunction()
