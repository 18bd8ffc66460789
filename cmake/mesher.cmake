# creepcontact-mesher, the process that meshes .geo files: alone in being linked to Gmsh, which brings 120 libraries.
creepcontact_find_library(Gmsh gmsh.h gmsh)
creepcontact_find_library(Seccomp seccomp.h seccomp)
creepcontact_program(mesher creepcontact_mesher
                     USES creepcontact_io creepcontact_options Gmsh::Gmsh Seccomp::Seccomp)
set_target_properties(creepcontact_mesher PROPERTIES OUTPUT_NAME creepcontact-mesher)
# Of what comes with creepcontact_io it needs next to nothing.
target_link_options(creepcontact_mesher PRIVATE -Wl,--as-needed)

if(TARGET creepcontact)
  foreach(program IN LISTS creepcontact_programs)
    add_dependencies(${program} creepcontact_mesher)
  endforeach()
endif()
