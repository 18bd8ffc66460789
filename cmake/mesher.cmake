# creepcontact-mesher, the process that meshes geometries and reads meshes of other programs: alone in being linked to
# Gmsh, which brings 120 libraries, and to libmedc, without which .med files are refused.
creepcontact_find_library(Gmsh gmsh.h gmsh)
creepcontact_find_library(Seccomp seccomp.h seccomp)
creepcontact_program(mesher creepcontact_mesher
                     USES creepcontact_io creepcontact_options Gmsh::Gmsh Seccomp::Seccomp)
find_path(CREEPCONTACT_Med_INCLUDE med.h)
find_library(CREEPCONTACT_Med_LIBRARY medC)
if(CREEPCONTACT_Med_INCLUDE AND CREEPCONTACT_Med_LIBRARY)
  target_compile_definitions(creepcontact_mesher PRIVATE CREEPCONTACT_HAS_MED)
  target_include_directories(creepcontact_mesher SYSTEM PRIVATE ${CREEPCONTACT_Med_INCLUDE} ${CREEPCONTACT_HDF5_INCLUDE})
  target_link_libraries(creepcontact_mesher PRIVATE ${CREEPCONTACT_Med_LIBRARY})
else()
  message(STATUS "creepcontact-mesher is built without libmedc: it reads no .med files")
endif()
set_target_properties(creepcontact_mesher PROPERTIES OUTPUT_NAME creepcontact-mesher)
# Of what comes with creepcontact_io it needs next to nothing.
target_link_options(creepcontact_mesher PRIVATE -Wl,--as-needed)

if(TARGET creepcontact)
  foreach(program IN LISTS creepcontact_programs)
    add_dependencies(${program} creepcontact_mesher)
  endforeach()
endif()
