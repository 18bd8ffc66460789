# Runs on several processes (creepcontact-mpi) need MPI, MUMPS, METIS and PETSc.
find_package(MPI QUIET COMPONENTS C)
find_path(CREEPCONTACT_MUMPS_INCLUDE dmumps_c.h)
find_library(CREEPCONTACT_MUMPS_LIBRARY dmumps)
find_path(CREEPCONTACT_METIS_INCLUDE metis.h)
find_library(CREEPCONTACT_METIS_LIBRARY metis)
# Of Open MPI; of MPICH: MUMPS sends by them, and src/mpi/counting.cpp counts what it sends.
set(mpi_library ${MPI_C_LIBRARIES})
list(POP_FRONT mpi_library mpi_library)
get_filename_component(mpi_libraries "${mpi_library}" DIRECTORY)
find_library(MPI_FORTRAN_LIBRARY NAMES mpi_mpifh mpifort HINTS ${mpi_libraries})
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(PETSC QUIET PETSc)
endif()
set(creepcontact_mpi_found OFF)
if(MPI_C_FOUND AND MPI_FORTRAN_LIBRARY AND CREEPCONTACT_MUMPS_INCLUDE AND CREEPCONTACT_MUMPS_LIBRARY
   AND CREEPCONTACT_METIS_INCLUDE AND CREEPCONTACT_METIS_LIBRARY AND PETSC_FOUND)
  set(creepcontact_mpi_found ON)
endif()
option(CREEPCONTACT_MPI "Build creepcontact-mpi, which runs on several processes (MPI, MUMPS, METIS, PETSc)"
       ${creepcontact_mpi_found})
if(CREEPCONTACT_MPI)
  if(NOT creepcontact_mpi_found)
    message(FATAL_ERROR "CREEPCONTACT_MPI needs MPI, MUMPS, METIS and PETSc "
                        "(Debian: libopenmpi-dev libmumps-dev libmetis-dev libpetsc-real-dev)")
  endif()
  creepcontact_find_library(MUMPS dmumps_c.h dmumps)
  target_link_libraries(MUMPS::MUMPS INTERFACE ${MPI_FORTRAN_LIBRARY})
  creepcontact_find_library(METIS metis.h metis)
  add_library(PETSc::PETSc INTERFACE IMPORTED)  # without the compiler options of its package
  target_include_directories(PETSc::PETSc SYSTEM INTERFACE ${PETSC_INCLUDE_DIRS})
  target_link_libraries(PETSc::PETSc INTERFACE ${PETSC_LINK_LIBRARIES})
endif()
