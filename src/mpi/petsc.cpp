#include "petsc.hpp"

#include <fmt/format.h>

#include "creepcontact/base/error.hpp"

namespace creepcontact::mpi {

void check(PetscErrorCode code) {
  if (code == 0) return;
  if (code == PETSC_ERR_MEM) throw SolverError("memory runs out on one of the processes in the multigrid (PETSc)");
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  throw SolverError(fmt::format("PETSc fails: {} (error {})", text != nullptr ? text : "unknown", code));
}

void require_petsc() {
  PetscBool runs = PETSC_FALSE;
  PetscInitialized(&runs);
  if (runs == PETSC_TRUE) return;
  // Signals are the program's own, and files that happen to be in the directory must not set options.
  for (const char* option : {"-no_signal_handler", "-skip_petscrc"})
    check(PetscOptionsSetValue(nullptr, option, "true"));
  check(PetscInitializeNoArguments());
  check(PetscPushErrorHandler(PetscReturnErrorHandler, nullptr));
}

void end_petsc() {
  PetscBool runs = PETSC_FALSE;
  PetscInitialized(&runs);
  if (runs == PETSC_TRUE) PetscFinalize();
}

}  // namespace creepcontact::mpi
