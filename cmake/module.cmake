# Headers whose parsing takes most of the time of a compilation, parsed once a target. Sources include what they need all
# the same: -D CMAKE_DISABLE_PRECOMPILE_HEADERS=ON builds without.
set(creepcontact_common_headers <algorithm> <array> <cmath> <filesystem> <functional> <map> <memory> <optional> <span>
    <string> <vector> <fmt/format.h> <fmt/ranges.h>)
function(creepcontact_precompile target)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources n_sources)
  if(n_sources GREATER 6)
    target_precompile_headers(${target} PRIVATE ${creepcontact_common_headers} ${ARGN})
  endif()
endfunction()

# creepcontact_module(name USES <public libraries> PRIVATE_USES <implementation only> PRECOMPILE <headers>)
# Static library creepcontact_<name> from src/<name>/*.cpp and its subfolders; a module of headers alone becomes an interface
# library. The modules among USES and PRIVATE_USES are those that it may include: tests/style reads them here.
function(creepcontact_module name)
  cmake_parse_arguments(arg "" "" "USES;PRIVATE_USES;PRECOMPILE" ${ARGN})
  set(target creepcontact_${name})
  file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp
       ${PROJECT_SOURCE_DIR}/src/${name}/*/*.cpp)
  if(sources)
    add_library(${target} STATIC ${sources})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE creepcontact_options ${arg_PRIVATE_USES})
    creepcontact_precompile(${target} ${arg_PRECOMPILE})
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
